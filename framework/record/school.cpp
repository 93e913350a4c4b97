// SPDX-License-Identifier: Apache-2.0
#include "record/school.hpp"

#include <algorithm>
#include <cmath>

#include "record/identity.hpp"
#include "record/item_ratings.hpp"
#include "record/journal.hpp"
#include "record/roster.hpp"
#include "record/schema.hpp"
#include "record/seal.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

Group group_from(const Row& r) { return {text(r[0]), text(r[1]), text(r[2]), text(r[3])}; }

class SqlSchool final : public School {
 public:
  SqlSchool(std::unique_ptr<Database> db, std::string where) : db_(std::move(db)), where_(std::move(where)) {}
  const std::string& error() const override { return error_; }

  std::vector<Person> people() override {
    std::vector<Person> out;
    for (const Row& r : rows(select_people(true))) out.push_back(person_from(r));
    sort_by_name(out);
    return out;
  }

  bool add_person(Person& p) override {
    if (!may_be_called(p)) return false;
    const bool given = !p.code.empty();
    if (given && !rows("SELECT 1 FROM person WHERE pseudonym = ?", {p.code}).empty())
      return fail(say::kCodeTaken(p.code));
    while (p.code.empty()) {
      const std::string code = make_code();
      if (rows("SELECT 1 FROM person WHERE pseudonym = ?", {code}).empty()) p.code = code;
    }
    if (p.id.empty()) p.id = make_id();
    if (p.created_utc.empty()) p.created_utc = utc_now();
    return change([&] {
      return db_->run("INSERT INTO person (person_id, pseudonym, created_utc) VALUES (?, ?, ?)", {p.id, p.code, p.created_utc}) &&
             put_roster(p);
    });
  }

  bool change_person(const Person& p) override {
    if (rows("SELECT 1 FROM person WHERE person_id = ?", {p.id}).empty())
      return fail(say::kPersonGone());
    return may_be_called(p) && change([&] { return put_roster(p); });
  }

  bool remove_person(const std::string& id) override {
    if (!rows("SELECT 1 FROM session WHERE person_id = ? LIMIT 1", {id}).empty())
      return fail(say::kHasAttempts());
    return change([&] {
      return db_->run("DELETE FROM assignment WHERE to_group = 0 AND who_id = ?", {id}) &&
             db_->run("DELETE FROM person WHERE person_id = ?", {id});
    });
  }

  bool find_person(const std::string& who, Person& out) override {
    const std::vector<Person> all = people();
    // a code is unique; a name may have been another person's before
    for (const auto what : {&Person::code, &Person::name})
      for (const Person& p : all)
        if (p.*what == who) {
          out = p;
          return true;
        }
    return error_.empty() && fail(say::kNobody(who));
  }

  bool erase_person(const std::string& id) override {
    if (rows("SELECT 1 FROM person WHERE person_id = ?", {id}).empty())
      return error_.empty() && fail(say::kPersonGone());
    for (const Row& r : rows("SELECT a.attempt_id FROM attempt a JOIN session s ON s.session_id = a.session_id"
                             " WHERE s.person_id = ? AND a.state = 'running'",
                             {id}))
      if (is_recording(where_, text(r[0]))) return fail(say::kIsRunning());
    if (!change([&] { return erase_rows(*db_, id); })) return false;
    forget_deleted(*db_);
    return true;
  }

  std::vector<ExportedFile> exported_files(const std::string& person_id) override {
    std::vector<ExportedFile> out;
    for (const Row& r : rows("SELECT file, station, kind, made_utc, whole FROM exported WHERE person_id = ? ORDER BY export_id",
                             {person_id}))
      out.push_back({text(r[0]), text(r[1]), text(r[2]), text(r[3]), integer(r[4]) != 0});
    return out;
  }

  bool log_export(const std::vector<std::string>& ids, const std::string& kind, const std::string& file) override {
    return change([&] {
      const int64_t whole = ids.size() == 1;
      for (const std::string& id : ids)
        if (!db_->run("INSERT INTO exported (export_id, whole, person_id, kind, file, station, made_utc)"
                      " VALUES (?, ?, ?, ?, ?, ?, ?)",
                      {make_id(), whole, id, kind, file, station(), utc_now()}))
          return false;
      return true;
    });
  }

  std::vector<Group> groups() override {
    std::vector<Group> out;
    for (const Row& r : rows("SELECT group_id, name, created_utc, archived_utc FROM people_group ORDER BY position, group_id"))
      out.push_back(group_from(r));
    return out;
  }

  bool add_group(Group& g) override {
    if (g.name.empty()) return fail(say::kNeedsGroupName());
    for (const Group& other : groups())
      if (other.name == g.name && other.id != g.id) return fail(say::kGroupTaken(g.name));
    if (g.id.empty()) g.id = make_id();
    if (g.created_utc.empty()) g.created_utc = utc_now();
    return change([&] {
      return db_->run("INSERT INTO people_group (group_id, position, name, created_utc, archived_utc)"
                      " SELECT w.id, w.place, w.name, w.made, w.archived FROM (SELECT CAST(? AS TEXT) AS id,"
                      " (SELECT COUNT(*) FROM people_group) AS place, CAST(? AS TEXT) AS name, CAST(? AS TEXT) AS made,"
                      " CAST(? AS TEXT) AS archived) w",
                      {g.id, g.name, g.created_utc, g.archived_utc});
    });
  }

  bool change_group(const Group& g) override {
    if (g.name.empty()) return fail(say::kNeedsGroupName());
    return change([&] {
      return db_->run("UPDATE people_group SET name = ?, archived_utc = ? WHERE group_id = ?", {g.name, g.archived_utc, g.id});
    });
  }

  bool remove_group(const std::string& id) override {
    return change([&] {
      return db_->run("UPDATE roster SET group_id = '', changed_utc = ? WHERE group_id = ?", {utc_now(), id}) &&
             db_->run("DELETE FROM assignment WHERE to_group = 1 AND who_id = ?", {id}) &&
             db_->run("DELETE FROM people_group WHERE group_id = ?", {id});
    });
  }

  bool publish_lesson(const std::string& lesson_id, const std::string& title, const std::string& body,
                      LessonVersion& out) override {
    const std::string digest = lesson_digest(body);
    if (lesson(digest, out)) return true;
    if (!error_.empty()) return false;
    const std::vector<Row> last = rows("SELECT COALESCE(MAX(number), 0) FROM lesson_version WHERE lesson_id = ?", {lesson_id});
    if (last.empty()) return false;
    out = {make_id(), digest, lesson_id, title, body, utc_now(), "", static_cast<uint32_t>(integer(last[0][0]) + 1)};
    return change([&] {
      return db_->run("INSERT INTO lesson_version (version_id, digest, lesson_id, title, body, frozen_utc, retired_utc, number)"
                      " VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING",
                      {out.id, out.digest, out.lesson_id, out.title, out.text, out.frozen_utc, out.retired_utc,
                       int64_t{out.number}});
    });
  }

  std::vector<LessonVersion> lessons(bool with_text) override {
    return versions(with_text, " ORDER BY frozen_utc DESC, version_id DESC", {});
  }
  bool lesson(const std::string& digest, LessonVersion& out) override {
    std::vector<LessonVersion> found = versions(true, " WHERE digest = ?", {digest});
    if (found.empty()) return false;
    out = std::move(found[0]);
    return true;
  }
  bool retire_lesson(const std::string& digest, bool retired) override {
    return change([&] {
      return db_->run("UPDATE lesson_version SET retired_utc = ? WHERE digest = ?", {retired ? utc_now() : std::string(), digest});
    });
  }

  std::vector<Course> courses() override {
    std::vector<Course> out;
    std::string wrong;
    for (const Row& r : rows("SELECT course_id, title, body, created_utc, changed_utc, published_utc, archived_utc FROM course")) {
      Course c;
      std::string why;
      if (!from_json(text(r[2]), c, why) && wrong.empty()) wrong = say::kBadCourse(text(r[1]), why);
      if (!why.empty()) continue;
      c.id = text(r[0]);
      c.created_utc = text(r[3]);
      c.changed_utc = text(r[4]);
      c.published_utc = text(r[5]);
      c.archived_utc = text(r[6]);
      out.push_back(std::move(c));
    }
    if (!wrong.empty()) fail(wrong);
    std::sort(out.begin(), out.end(), [](const Course& a, const Course& b) { return a.title != b.title ? a.title < b.title : a.id < b.id; });
    return out;
  }

  bool save_course(Course& c) override {
    const std::string body = to_json(c);
    Course read;
    std::string why;
    if (!from_json(body, read, why)) return fail(why);
    if (c.id.empty()) c.id = make_id();
    if (c.created_utc.empty()) c.created_utc = utc_now();
    c.changed_utc = utc_now();
    return change([&] {
      return db_->run("INSERT INTO course (course_id, title, body, created_utc, changed_utc, published_utc, archived_utc)"
                      " VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT (course_id) DO UPDATE SET title = excluded.title,"
                      " body = excluded.body, changed_utc = excluded.changed_utc, published_utc = excluded.published_utc,"
                      " archived_utc = excluded.archived_utc",
                      {c.id, c.title, body, c.created_utc, c.changed_utc, c.published_utc, c.archived_utc});
    });
  }

  bool remove_course(const std::string& id) override {
    return change([&] { return db_->run("DELETE FROM course WHERE course_id = ?", {id}); });
  }

  std::vector<Assignment> assignments() override {
    std::vector<Assignment> out;
    for (const Row& r : rows("SELECT assignment_id, course_id, who_id, to_group, made_utc, due_utc FROM assignment"
                             " ORDER BY assignment_id"))
      out.push_back({text(r[0]), text(r[1]), text(r[2]), integer(r[3]) != 0, text(r[4]), text(r[5])});
    return out;
  }
  bool assign(Assignment& a) override {
    const char* there = a.to_group ? "SELECT 1 FROM people_group WHERE group_id = ?" : "SELECT 1 FROM person WHERE person_id = ?";
    if (rows(there, {a.who_id}).empty())
      return error_.empty() && fail(a.to_group ? say::kGroupGone() : say::kPersonGone());
    if (rows("SELECT 1 FROM course WHERE course_id = ?", {a.course_id}).empty())
      return error_.empty() && fail(say::kCourseGone());
    if (a.id.empty()) a.id = make_id();
    if (a.made_utc.empty()) a.made_utc = utc_now();
    return change([&] {
      return db_->run("INSERT INTO assignment (assignment_id, to_group, course_id, who_id, made_utc, due_utc)"
                      " VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (assignment_id) DO UPDATE SET due_utc = excluded.due_utc",
                      {a.id, int64_t{a.to_group}, a.course_id, a.who_id, a.made_utc, a.due_utc});
    });
  }
  bool unassign(const std::string& id) override {
    return change([&] { return db_->run("DELETE FROM assignment WHERE assignment_id = ?", {id}); });
  }

  std::vector<Note> notes(const std::string& attempt_id) override {
    std::vector<Note> out;
    for (const Row& r : rows("SELECT note_id, step, t_us, made_utc, made_by, body FROM note WHERE attempt_id = ?"
                             " ORDER BY t_us, note_id",
                             {attempt_id}))
      out.push_back({text(r[0]), attempt_id, static_cast<uint64_t>(integer(r[1])), 1e-6 * static_cast<double>(integer(r[2])),
                     text(r[3]), text(r[4]), text(r[5])});
    return out;
  }

  bool save_note(Note& n) override {
    if (n.text.empty()) return fail(say::kNeedsWords());
    if (!has_attempt(n.attempt_id)) return false;
    if (n.id.empty()) n.id = make_id();
    if (n.made_utc.empty()) n.made_utc = utc_now();
    return change([&] {
      return db_->run("INSERT INTO note (note_id, attempt_id, step, t_us, made_utc, made_by, body) VALUES (?, ?, ?, ?, ?, ?, ?)"
                      " ON CONFLICT (note_id) DO UPDATE SET step = excluded.step, t_us = excluded.t_us, body = excluded.body",
                      {n.id, n.attempt_id, static_cast<int64_t>(n.step), static_cast<int64_t>(n.time_s * 1e6 + 0.5), n.made_utc,
                       n.made_by, n.text});
    });
  }
  bool remove_note(const std::string& id) override {
    return change([&] { return db_->run("DELETE FROM note WHERE note_id = ?", {id}); });
  }
  std::vector<ObserverRating> ratings(const std::string& id) override { return ratings_from(id, rows(kSelectRatings, {id})); }
  bool save_rating(ObserverRating& r) override {
    if (r.item.empty() || !std::isfinite(r.points)) return fail(say::kNeedsPoints());
    if (r.made_utc.empty()) r.made_utc = utc_now();
    return has_attempt(r.attempt_id) && change([&] { return write_rating(*db_, r); });
  }
  bool remove_rating(const std::string& attempt_id, const std::string& item, const std::string& by) override {
    return change([&] { return db_->run("DELETE FROM rating WHERE attempt_id = ? AND item = ? AND made_by = ?", {attempt_id, item, by}); });
  }

  std::vector<Ruling> rulings(const std::string& attempt_id) override {
    std::vector<Ruling> out;
    for (const Row& r : rows("SELECT ruling_id, made_utc, made_by, reason, kind FROM ruling WHERE attempt_id = ?"
                             " ORDER BY ruling_id DESC",
                             {attempt_id}))
      out.push_back({text(r[0]), attempt_id, text(r[1]), text(r[2]), text(r[3]), static_cast<Ruling::Kind>(integer(r[4]))});
    return out;
  }

  bool set_void(const std::string& attempt_id, bool is_void, const std::string& reason, const std::string& by) override {
    if (reason.empty()) return fail(say::kNeedsReason());
    return has_attempt(attempt_id) &&
           change([&] { return rule(attempt_id, is_void ? Ruling::Kind::kVoid : Ruling::Kind::kCounts, reason, by); });
  }

  bool name_attempt(const std::string& attempt_id, const std::string& person_id, const std::string& by, bool even_if_named) override;

 private:
  bool fail(std::string sentence) {
    error_ = std::move(sentence);
    return false;
  }

  bool complain() {
    return fail("The store " + shown(where_) + " cannot be read or written as it should: " + db_->error() + "." +
                remedy(where_, db_->trouble()));
  }

  std::vector<Row> rows(std::string_view sql, const Row& values = {}) {
    error_.clear();
    std::vector<Row> out = db_->rows(sql, values);
    if (db_->trouble() != Trouble::kNone) complain();
    return out;
  }

  // runs `what` in a transaction: all or nothing
  template <class Do>
  bool change(const Do& what) {
    error_.clear();
    if (db_->begin() && what() && db_->commit()) return true;
    complain();
    db_->rollback();
    return false;
  }

  bool may_be_called(const Person& p) {
    if (p.name.empty()) return fail(say::kNeedsName());
    if (p.handedness != "" && p.handedness != "left" && p.handedness != "right")
      return fail(say::kNoHandedness(p.handedness));
    for (const Person& other : people())
      if (other.id != p.id && (other.name == p.name || other.code == p.name) && other.archived_utc.empty())
        return fail(say::kNameTaken(p.name));
    return error_.empty();
  }

  bool put_roster(const Person& p) {
    return db_->run("INSERT INTO roster (person_id, display_name, handedness, group_id, archived_utc, changed_utc)"
                    " VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (person_id) DO UPDATE SET display_name = excluded.display_name,"
                    " handedness = excluded.handedness, group_id = excluded.group_id, archived_utc = excluded.archived_utc,"
                    " changed_utc = excluded.changed_utc",
                    {p.id, p.name, p.handedness, p.group_id, p.archived_utc, utc_now()});
  }

  std::vector<LessonVersion> versions(bool with_text, const std::string& which, const Row& values) {
    std::vector<LessonVersion> out;
    const std::string body = with_text ? "body" : "''";
    for (const Row& r : rows("SELECT version_id, digest, lesson_id, title, " + body +
                                 ", frozen_utc, retired_utc, number FROM lesson_version" + which,
                             values))
      out.push_back({text(r[0]), text(r[1]), text(r[2]), text(r[3]), text(r[4]), text(r[5]), text(r[6]),
                     static_cast<uint32_t>(integer(r[7]))});
    return out;
  }

  bool has_attempt(const std::string& id) {
    if (!rows("SELECT 1 FROM attempt WHERE attempt_id = ?", {id}).empty()) return true;
    return error_.empty() && fail(say::kNoAttempt(id));
  }

  bool rule(const std::string& attempt_id, Ruling::Kind kind, const std::string& reason, const std::string& by) {
    return db_->run("INSERT INTO ruling (ruling_id, attempt_id, kind, made_utc, made_by, reason) VALUES (?, ?, ?, ?, ?, ?)",
                    {make_id(), attempt_id, static_cast<int64_t>(kind), utc_now(), by, reason});
  }

  std::unique_ptr<Database> db_;
  const std::string where_;
  std::string error_;
};

// Moves the attempt to a new session of the same station and time; its rows now contain another code, so it is sealed again.
bool SqlSchool::name_attempt(const std::string& attempt_id, const std::string& person_id, const std::string& by,
                             bool even_if_named) {
  const std::vector<Row> found =
      rows("SELECT p.pseudonym, s.session_id, p.person_id, a.state FROM attempt a JOIN session s ON s.session_id = a.session_id"
           " JOIN person p ON p.person_id = s.person_id WHERE a.attempt_id = ?",
           {attempt_id});
  const std::vector<Row> to = rows("SELECT pseudonym FROM person WHERE person_id = ?", {person_id});
  if (found.empty()) return has_attempt(attempt_id);
  if (to.empty()) return error_.empty() && fail(say::kPersonGone());
  const std::string from = text(found[0][0]), session = make_id();
  if (text(found[0][2]) == person_id) return true;
  if (text(found[0][3]) == "running") return fail(say::kStillRunning(attempt_id));
  if (from != kGuest && !even_if_named)
    return fail(say::kNoGuest(attempt_id, from));
  return change([&] {
    return db_->run("INSERT INTO session (session_id, person_id, station, app_version, started_utc)"
                    " SELECT CAST(? AS TEXT), CAST(? AS TEXT), station, app_version, started_utc FROM session WHERE session_id = ?",
                    {session, person_id, text(found[0][1])}) &&
           db_->run("UPDATE attempt SET session_id = ? WHERE attempt_id = ?", {session, attempt_id}) &&
           rule(attempt_id, Ruling::Kind::kNamed, from + " -> " + text(to[0][0]), by) && seal_attempt(*db_, attempt_id);
  });
}

}  // namespace

std::unique_ptr<School> School::open(const std::string& where, std::string& error) {
  const std::string path = where.empty() ? Store::default_path() : where;
  std::unique_ptr<Database> db = open_store(path, error);
  if (!db) return nullptr;
  merge_journals(*db, path);
  return std::make_unique<SqlSchool>(std::move(db), path);
}

}  // namespace swage::record
