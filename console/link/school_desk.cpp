// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/school_desk.hpp"

#include <QUndoCommand>
#include <algorithm>

#include "console/models/said.hpp"

namespace swage::console {
namespace {

constexpr int kMostUndos = 200;

const std::string kInstructor = "instructor";  // author of every change; the console has no accounts

}  // namespace

class SchoolEdit : public QUndoCommand {
 public:
  SchoolEdit(SchoolDesk* desk, const QString& words, SchoolDesk::Call redo, SchoolDesk::Call undo)
      : QUndoCommand(words), desk_(desk), redo_(std::move(redo)), undo_(std::move(undo)) {}
  void redo() override {
    if (!desk_->call(redo_)) setObsolete(true);
  }
  void undo() override {
    if (!desk_->call(undo_)) setObsolete(true);
  }

 private:
  SchoolDesk* desk_;
  SchoolDesk::Call redo_, undo_;
};

/// Holds the whole course before and after, so that every edit is undone in the same way.
class CourseEdit : public QUndoCommand {
 public:
  CourseEdit(SchoolDesk* desk, const QString& words, record::Course before, record::Course after, int field)
      : QUndoCommand(words), desk_(desk), before_(std::move(before)), after_(std::move(after)), field_(field) {}
  int id() const override { return field_; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto* edit = static_cast<const CourseEdit*>(next);
    if (edit->before_.id != before_.id) return false;
    after_ = edit->after_;
    return true;
  }
  void redo() override { to(after_, before_); }
  void undo() override { to(before_, after_); }

 private:
  // Copies the new id into the other state, so that undo and redo keep the course's identity.
  void to(record::Course& wanted, record::Course& other) {
    const bool removed = &wanted == &before_ ? is_new_ : is_removal_;
    if (!desk_->call([&](record::School& s) { return removed ? s.remove_course(other.id) : s.save_course(wanted); }))
      setObsolete(true);
    if (other.id.empty()) other.id = wanted.id;
  }
  SchoolDesk* desk_;
  record::Course before_, after_;
  int field_;
  bool is_new_ = before_.id.empty(), is_removal_ = after_.id.empty() && !before_.id.empty();
};

SchoolDesk::SchoolDesk(SchoolOpener opener, QObject* parent) : QObject(parent), opener_(std::move(opener)) {
  for (QUndoStack* stack : {&people_, &courses_, &notes_}) stack->setUndoLimit(kMostUndos);
}

// the commands on the stacks refer to this object
SchoolDesk::~SchoolDesk() {
  for (QUndoStack* stack : {&people_, &courses_, &notes_}) stack->clear();
}

record::School* SchoolDesk::school() {
  if (school_) return school_.get();
  std::string error;
  if (opener_) school_ = opener_(error);
  if (school_) return school_.get();
  problem_ = error.empty() ? tr("Nothing is kept: the program was started without a store.") : said_message(error);
  return nullptr;
}

QStringList SchoolDesk::courses_with(const QString& lesson_id) {
  QStringList titles;
  if (school() == nullptr) return titles;
  for (const record::Course& course : school_->courses()) {
    const bool has = std::any_of(course.steps.begin(), course.steps.end(),
                                 [&](const record::CourseStep& step) { return step.lesson_id == lesson_id.toStdString(); });
    if (has && course.archived_utc.empty()) titles += QString::fromStdString(course.title);
  }
  return titles;
}

bool SchoolDesk::call(const Call& what) {
  record::School* s = school();
  why_.clear();
  succeeded_ = s && what(*s);
  if (s && !succeeded_) problem_ = said_message(why_.empty() ? s->error() : why_);
  if (succeeded_)
    Q_EMIT changed();
  else
    Q_EMIT failed(problem_);
  return succeeded_;
}

bool SchoolDesk::push(QUndoStack& stack, const QString& words, Call redo, Call undo) {
  stack.push(new SchoolEdit(this, words, std::move(redo), std::move(undo)));
  return succeeded_;
}

std::string SchoolDesk::group_id(const QString& name) {
  record::School* s = school();
  const std::string wanted = name.trimmed().toStdString();
  if (!s || wanted.empty()) return {};
  for (const record::Group& g : s->groups())
    if (g.name == wanted) return g.id;
  record::Group made;
  made.name = wanted;
  return s->add_group(made) ? made.id : std::string();
}

bool SchoolDesk::add_people(const QVector<RosterLine>& lines) {
  auto people = std::make_shared<std::vector<record::Person>>();
  for (const RosterLine& line : lines) {
    if (line.is != RosterLine::Is::kNew) continue;
    record::Person p;
    p.name = line.name.toStdString();
    p.handedness = line.hand.toStdString();
    p.group_id = group_id(line.group);
    p.code = line.code.toStdString();
    people->push_back(p);
  }
  if (people->empty()) return false;
  const auto remove = [people](record::School& s, size_t n) {
    bool ok = true;
    for (size_t i = n; i-- > 0;) ok = s.remove_person((*people)[i].id) && ok;
    return ok;
  };
  return push(
      people_, tr("Add %n people", nullptr, static_cast<int>(people->size())),
      [this, people, remove](record::School& s) {
        for (size_t i = 0; i < people->size(); ++i) {
          if (s.add_person((*people)[i])) continue;
          why_ = s.error();
          remove(s, i);  // all people or none
          return false;
        }
        return true;
      },
      [people, remove](record::School& s) { return remove(s, people->size()); });
}

bool SchoolDesk::change_person(const record::Person& after) {
  record::School* s = school();
  if (!s) return Q_EMIT failed(problem_), false;
  for (const record::Person& before : s->people()) {
    if (before.id != after.id) continue;
    return push(
        people_, tr("Change %1").arg(QString::fromStdString(before.name)),
        [after](record::School& to) { return to.change_person(after); },
        [before](record::School& to) { return to.change_person(before); });
  }
  return false;
}

bool SchoolDesk::set_void(const QString& attempt_id, bool is_void, const QString& reason) {
  const std::string id = attempt_id.toStdString(), why = reason.toStdString();
  return push(
      people_, is_void ? tr("Void an attempt") : tr("Count an attempt"),
      [=](record::School& s) { return s.set_void(id, is_void, why, kInstructor); },
      [=](record::School& s) { return s.set_void(id, !is_void, "undone", kInstructor); });
}

bool SchoolDesk::give_attempt(const QString& attempt_id, const QString& from_id, const QString& to_id) {
  const std::string id = attempt_id.toStdString(), from = from_id.toStdString(), to = to_id.toStdString();
  return push(
      people_, tr("Give an attempt to a person"),
      [=](record::School& s) { return s.name_attempt(id, to, kInstructor, true); },
      [=](record::School& s) { return s.name_attempt(id, from, kInstructor, true); });
}

bool SchoolDesk::erase_person(const QString& id) {
  const bool erased = call([&](record::School& s) { return s.erase_person(id.toStdString()); });
  if (erased) people_.clear();
  return erased;
}

bool SchoolDesk::change_course(record::Course before, record::Course after, const QString& words, int field) {
  courses_.push(new CourseEdit(this, words, std::move(before), std::move(after), field));
  return succeeded_;
}

bool SchoolDesk::assign(const QString& course_id, const std::vector<std::string>& who, bool to_group, const QString& due) {
  record::School* s = school();
  if (!s) return Q_EMIT failed(problem_), false;
  auto made = std::make_shared<std::vector<record::Assignment>>(), taken = std::make_shared<std::vector<record::Assignment>>();
  for (const record::Assignment& a : s->assignments())
    if (course_id.isEmpty() && a.to_group == to_group && std::find(who.begin(), who.end(), a.who_id) != who.end()) taken->push_back(a);
  for (const std::string& id : who)
    if (!course_id.isEmpty()) made->push_back({"", course_id.toStdString(), id, to_group, "", due.toStdString()});
  const auto give = [](record::School& to, std::vector<record::Assignment>& all) {
    return std::all_of(all.begin(), all.end(), [&](record::Assignment& a) { return to.assign(a); });
  };
  const auto take = [](record::School& from, const std::vector<record::Assignment>& all) {
    return std::all_of(all.begin(), all.end(), [&](const record::Assignment& a) { return from.unassign(a.id); });
  };
  return push(
      people_, tr("Assign a course"), [=](record::School& to) { return take(to, *taken) && give(to, *made); },
      [=](record::School& to) { return take(to, *made) && give(to, *taken); });
}

bool SchoolDesk::publish(const QString& lesson_id, const QString& title, const std::string& text, record::LessonVersion& out) {
  return call([&](record::School& s) { return s.publish_lesson(lesson_id.toStdString(), title.toStdString(), text, out); });
}

bool SchoolDesk::retire(const record::LessonVersion& version, bool retired) {
  return call([&](record::School& s) { return s.retire_lesson(version.digest, retired); });
}

bool SchoolDesk::add_note(record::Note note) {
  auto kept = std::make_shared<record::Note>(std::move(note));
  kept->made_by = kInstructor;
  return push(
      notes_, tr("Add a note"), [kept](record::School& s) { return s.save_note(*kept); },
      [kept](record::School& s) { return s.remove_note(kept->id); });
}

bool SchoolDesk::rate(const std::string& attempt_id, const std::string& item, std::optional<double> points) {
  std::optional<double> before;
  for (const auto& [id, was] : given(attempt_id))
    if (id == item) before = was;
  if (before == points) return true;
  const auto set = [attempt_id, item](record::School& s, std::optional<double> to) {
    record::ObserverRating rating{attempt_id, item, to.value_or(0), "", kInstructor};
    return to ? s.save_rating(rating) : s.remove_rating(attempt_id, item, kInstructor);
  };
  return push(
      notes_, tr("Rate an item"), [set, points](record::School& s) { return set(s, points); },
      [set, before](record::School& s) { return set(s, before); });
}

std::vector<std::pair<std::string, double>> SchoolDesk::given(const std::string& attempt_id) {
  std::vector<std::pair<std::string, double>> out;
  if (record::School* s = school())
    for (const record::ObserverRating& r : s->ratings(attempt_id))
      if (r.made_by == kInstructor) out.emplace_back(r.item, r.points);
  return out;
}

bool SchoolDesk::remove_note(const record::Note& note) {
  auto kept = std::make_shared<record::Note>(note);
  return push(
      notes_, tr("Remove a note"), [kept](record::School& s) { return s.remove_note(kept->id); },
      [kept](record::School& s) { return s.save_note(*kept); });
}

}  // namespace swage::console
