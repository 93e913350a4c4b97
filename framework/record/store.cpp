// SPDX-License-Identifier: Apache-2.0
#include "record/store.hpp"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "record/attempt_heads.hpp"
#include "record/attempt_metrics.hpp"
#include "record/identity.hpp"
#include "record/journal.hpp"
#include "record/schema.hpp"
#include "record/roster.hpp"
#include "record/seal.hpp"
#include "record/transfer.hpp"

namespace swage::record {
namespace {

// Stores before version 4 can be read, too; they have neither names nor decisions.
constexpr int kSchool = 4;
constexpr int kRatings = 6;  // before it nobody could rate an attempt

// Values that change when a list of attempts changes. Reads no recording.
constexpr const char* kDigest =
    "SELECT COUNT(*), COALESCE(MAX(started_utc), ''), COALESCE(MAX(ended_utc), ''),"
    " COALESCE(SUM(CASE WHEN state = 'running' THEN 1 ELSE 0 END), 0) + COALESCE(SUM(is_void), 0),"
    " (SELECT COUNT(*) FROM person)";
constexpr const char* kSchoolDigest =
    ", (SELECT COUNT(*) FROM ruling), (SELECT COUNT(*) FROM note), (SELECT COALESCE(MAX(changed_utc), '') FROM roster),"
    " (SELECT COALESCE(MAX(changed_utc), '') FROM course)";
constexpr const char* kRatingDigest = ", (SELECT COUNT(*) FROM rating), (SELECT COALESCE(MAX(made_utc), '') FROM rating)";

class SqlStore final : public Store {
 public:
  SqlStore(std::unique_ptr<Database> db, std::string where, bool read_only)
      : db_(std::move(db)), where_(std::move(where)), read_only_(read_only), school_(schema_version(*db_) >= kSchool),
        ratings_(schema_version(*db_) >= kRatings), heads_(*db_, school_), metrics_(*db_) {}

  std::string trouble() const override { return trouble_; }
  bool read_only() const override { return read_only_; }

  bool changed() override {
    begin();
    if (!db_->on_postgres()) {
      const std::vector<Row> version = rows("PRAGMA data_version");
      const int64_t now = version.empty() ? -1 : integer(version[0][0]);
      if (now == std::exchange(data_version_, now) && now >= 0) return false;
    }
    std::vector<Row> now = rows(std::string(kDigest) + (school_ ? kSchoolDigest : "") + (ratings_ ? kRatingDigest : "") + " FROM attempt");
    if (now == digest_) return !trouble_.empty();
    digest_ = std::move(now);
    return true;
  }

  std::string damage() override {
    begin();
    if (db_->on_postgres()) return "";
    std::string out = foreign_tables(*db_, false);
    const std::vector<Row> found = rows("PRAGMA quick_check(1)");
    const std::vector<Row> orphans = rows("PRAGMA foreign_key_check");
    const std::string seals = schema_version(*db_) >= 3 ? broken_seals(*db_) : "";
    if (out.empty() && !trouble_.empty()) return trouble_;
    if (out.empty() && (found.empty() || text(found[0][0]) != "ok"))
      out = found.empty() ? "It cannot be checked." : text(found[0][0]) + ".";
    if (out.empty()) out = seals;
    if (out.empty() && !orphans.empty()) out = "Pieces of attempts are there without what they belong to.";
    return out.empty() ? "" : "The store " + shown(where_) + " is damaged: " + out;
  }

  std::vector<Person> people() override {
    begin();
    std::vector<Person> out;
    for (const Row& r : rows(select_people(school_))) out.push_back(person_from(r));
    sort_by_name(out);
    return out;
  }

  Person person(const std::string& name) override {
    begin();
    if (!write(*db_, {Kind::kPerson, {make_id(), name, utc_now()}})) complain();
    const std::string why = trouble_;
    const std::vector<Person> all = people();
    const auto called = [&](std::string Person::*what) {
      return std::find_if(all.begin(), all.end(), [&](const Person& p) { return p.*what == name; });
    };
    auto found = called(&Person::code);
    if (found == all.end()) found = called(&Person::name);
    if (found != all.end()) return *found;
    if (trouble_.empty()) trouble_ = why;
    return {};
  }

  std::vector<AttemptRow> attempt_heads(const std::string& person_id, const std::string& lesson_id) override {
    begin();
    if (!heads_.renew()) complain();
    std::vector<AttemptRow> out;
    std::copy_if(heads_.all().begin(), heads_.all().end(), std::back_inserter(out), [&](const AttemptRow& a) {
      return (person_id.empty() || a.person_id == person_id) && (lesson_id.empty() || a.lesson_id == lesson_id);
    });
    return out;
  }

  std::vector<AttemptRow> attempts(const std::string& person_id, const std::string& lesson_id) override {
    begin();
    Row values;
    const std::string which = condition(person_id, lesson_id, values);
    std::vector<AttemptRow> out = heads(which, values);
    if (!metrics_.fill(out, which, values)) complain();
    return out;
  }

  bool attempt(const std::string& id, AttemptRow& out) override {
    begin();
    const std::vector<Row> found = rows(select_attempts(school_) + " WHERE a.attempt_id = ?", {id});
    if (found.empty()) return false;
    out = attempt_from(found[0]);
    for (const Row& r : rows("SELECT name, unit, value FROM metric WHERE attempt_id = ? ORDER BY seq", {id}))
      out.metrics.push_back({text(r[0]), text(r[1]), real(r[2])});
    return true;
  }

  std::vector<EventRow> events(const std::string& attempt_id) override {
    begin();
    std::vector<EventRow> out;
    const char* sql =
        "SELECT step, t_us, owner, body, value FROM event WHERE attempt_id = ? ORDER BY step, seq";
    for (const Row& r : rows(sql, {attempt_id}))
      out.push_back({static_cast<uint64_t>(integer(r[0])), 1e-6 * static_cast<double>(integer(r[1])),
                     text(r[2]), text(r[3]), real(r[4])});
    return out;
  }

  int recover() override {
    begin();
    if (read_only_) return 0;
    // on a shared server a machine can only know which of its own programs run
    std::string sql =
        "SELECT a.attempt_id, a.dt_s FROM attempt a JOIN session s ON s.session_id = a.session_id"
        " WHERE a.state = 'running'";
    Row values;
    if (db_->on_postgres()) {
      sql += " AND s.station = ?";
      values.push_back(station());
    }
    int recovered = 0;
    for (const Row& r : rows(sql, values))
      if (!is_recording(where_, text(r[0])) && recover_one(text(r[0]), real(r[1]))) ++recovered;
    constexpr int kAtOnce = 200;  // under a second
    if (trouble_.empty()) seal_unsealed(*db_, kAtOnce);
    return recovered;
  }

  bool add_grade(const Grade& g, std::string& error) override {
    begin();
    const bool done = db_->run(
        "INSERT INTO grade (grade_id, attempt_id, graded_utc, app_version, plugins, identical, outcome, reason, score,"
        " metrics) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        {make_id(), g.attempt_id, utc_now(), std::string(SWAGE_VERSION), to_json(g.plugins), int64_t{g.identical},
         g.outcome, g.reason, g.score, metrics_json(g.metrics)});
    if (!done) error = "The grade cannot be kept: " + db_->error() + "." + remedy(where_, db_->trouble());
    return done;
  }

  std::vector<Grade> grades(const std::string& attempt_id) override {
    begin();
    std::vector<Grade> out;
    for (const Row& r : rows("SELECT graded_utc, app_version, plugins, identical, outcome, reason, score, metrics"
                             " FROM grade WHERE attempt_id = ? ORDER BY graded_utc DESC, grade_id DESC",
                             {attempt_id})) {
      Grade g;
      g.attempt_id = attempt_id;
      g.graded_utc = text(r[0]);
      g.app_version = text(r[1]);
      from_json(text(r[2]), g.plugins);
      g.identical = integer(r[3]) != 0;
      g.outcome = text(r[4]);
      g.reason = text(r[5]);
      g.score = real(r[6]);
      metrics_from_json(text(r[7]), g.metrics);
      out.push_back(std::move(g));
    }
    return out;
  }

  bool export_attempt(const std::string& id, const std::string& file, std::string& error) override {
    return write_attempt_file(*db_, id, file, error);
  }
  bool import_attempt(const std::string& file, std::string& id, std::string& error) override {
    return read_attempt_file(*db_, file, id, error);
  }

 private:
  // omits conditions that are not needed: the server then uses the index of the person
  static std::string condition(const std::string& person_id, const std::string& lesson_id, Row& values) {
    std::string which = " WHERE 1 = 1";
    if (!person_id.empty()) which += " AND s.person_id = ?", values.push_back(person_id);
    if (!lesson_id.empty()) which += " AND a.exercise = ?", values.push_back(lesson_id);
    return which;
  }

  std::vector<AttemptRow> heads(const std::string& which, const Row& values) {
    std::vector<AttemptRow> out;
    for (const Row& r :
         rows(select_attempts(school_) + which + " ORDER BY a.started_utc DESC, a.attempt_id DESC", values))
      out.push_back(attempt_from(r));
    return out;
  }

  void begin() { trouble_.clear(); }

  void complain() {
    if (trouble_.empty())
      trouble_ = "The store " + shown(where_) + " cannot be read or written as it should: " + db_->error() + "." +
                 remedy(where_, db_->trouble());
  }

  std::vector<Row> rows(std::string_view sql, const Row& values = {}) {
    std::vector<Row> out = db_->rows(sql, values);
    if (db_->trouble() != Trouble::kNone) complain();
    return out;
  }

  // the committed steps give its duration
  bool recover_one(const std::string& id, double dt) {
    double simulated = 0;
    for (const Row& r : rows("SELECT t0_us, n FROM chunk WHERE attempt_id = ? AND stream = 'hash'"
                             " ORDER BY seq DESC LIMIT 1",
                             {id}))
      simulated = 1e-6 * static_cast<double>(integer(r[0])) + dt * static_cast<double>(integer(r[1]));
    const bool done = db_->run(
        "UPDATE attempt SET state = 'recovered', outcome = ?, simulated_s = ?"
        " WHERE attempt_id = ? AND state = 'running'",
        {std::string(judge::text(judge::Outcome::kAborted)), simulated, id});
    if (!done) complain();
    return done;
  }

  std::unique_ptr<Database> db_;
  const std::string where_;
  const bool read_only_;
  const bool school_;   // the tables of version 4 exist
  const bool ratings_;  // the table of version 6 exists
  AttemptHeads heads_;
  AttemptMetrics metrics_;
  std::string trouble_;
  int64_t data_version_ = -1;
  std::vector<Row> digest_;
};

std::string place(const std::string& where) { return where.empty() ? Store::default_path() : where; }

std::unique_ptr<Store> open_writing(const std::string& path, std::string& error, Trouble& why) {
  std::unique_ptr<Database> db = open_store(path, error, &why);
  if (!db) return nullptr;
  merge_journals(*db, path);
  return std::make_unique<SqlStore>(std::move(db), path, false);
}

}  // namespace

std::unique_ptr<Store> Store::open(const std::string& where, std::string& error) {
  Trouble why = Trouble::kNone;
  return open_writing(place(where), error, why);
}

std::unique_ptr<Store> Store::open_to_read(const std::string& where, std::string& error) {
  std::unique_ptr<Database> db = open_for_reading(place(where), error);
  if (!db) return nullptr;
  return std::make_unique<SqlStore>(std::move(db), place(where), true);
}

std::unique_ptr<Store> Store::open_as_allowed(const std::string& where, std::string& error) {
  Trouble why = Trouble::kNone;
  std::unique_ptr<Store> store = open_writing(place(where), error, why);
  if (store || why != Trouble::kReadOnly) return store;
  return open_to_read(where, error);
}

std::string Store::default_path() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && data[0] == '/') return std::string(data) + "/swage/attempts.db";
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] != '/') {
    // a service or cron job has no HOME, but its user has a home folder
    const passwd* user = getpwuid(geteuid());
    home = user != nullptr ? user->pw_dir : nullptr;
  }
  if (home == nullptr || home[0] != '/' || home[1] == '\0') return "";
  return std::string(home) + "/.local/share/swage/attempts.db";
}

}  // namespace swage::record
