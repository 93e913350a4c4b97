// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An instructor's changes to people, attempts and courses. Each change is written at once and can be undone; a failed one
// changes nothing and problem() has the reason, as a sentence. There is nothing to save.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <QVector>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "console/models/roster.hpp"
#include "record/school.hpp"

namespace swage::console {

using SchoolOpener = std::function<std::unique_ptr<record::School>(std::string& error)>;

class SchoolDesk : public QObject {
  Q_OBJECT
 public:
  explicit SchoolDesk(SchoolOpener opener, QObject* parent = nullptr);
  ~SchoolDesk() override;

  /// nullptr when the store cannot be changed; problem() has the reason.
  record::School* school();
  const QString& problem() const { return problem_; }
  /// Titles of the courses that contain a lesson, without archived ones.
  QStringList courses_with(const QString& lesson_id);
  QUndoStack* people_edits() { return &people_; }
  QUndoStack* course_edits() { return &courses_; }
  QUndoStack* note_edits() { return &notes_; }

  /// Adds the new people of a list and creates missing groups. One undo reverts all.
  bool add_people(const QVector<RosterLine>& lines);
  bool change_person(const record::Person& after);
  bool set_void(const QString& attempt_id, bool is_void, const QString& reason);
  /// Moves an attempt from one person, usually Guest, to another.
  bool give_attempt(const QString& attempt_id, const QString& from_id, const QString& to_id);
  /// Permanent: it cannot be undone, and clears the undo history of people.
  bool erase_person(const QString& id);
  /// The id of a group of that name, created if missing; "" for no name or on failure.
  std::string group_id(const QString& name);

  /// Creates a course where `before` has no id; removes it where `after` has none. Consecutive edits with the same `field` are
  /// undone together.
  bool change_course(record::Course before, record::Course after, const QString& words, int field = -1);
  /// Assigns a course to people or groups; "" removes their assignment. One undo reverts all. `due`: "" or 2030-01-31.
  bool assign(const QString& course_id, const std::vector<std::string>& who, bool to_group, const QString& due);
  /// Freezes a lesson permanently, as attempts refer to it. False: problem() has the reason.
  bool publish(const QString& lesson_id, const QString& title, const std::string& text, record::LessonVersion& out);
  /// Stops offering a version, or offers it again.
  bool retire(const record::LessonVersion& version, bool retired);
  bool add_note(record::Note note);
  bool remove_note(const record::Note& note);
  /// Sets an instructor's points for an item of a rating scale; no value: removes them.
  bool rate(const std::string& attempt_id, const std::string& item, std::optional<double> points);
  /// The instructor's points of an attempt by item.
  std::vector<std::pair<std::string, double>> given(const std::string& attempt_id);

 Q_SIGNALS:
  void changed();
  void failed(const QString& problem);

 private:
  using Call = std::function<bool(record::School&)>;
  friend class SchoolEdit;
  friend class CourseEdit;
  bool push(QUndoStack& stack, const QString& words, Call redo, Call undo);
  bool call(const Call& what);

  SchoolOpener opener_;
  std::unique_ptr<record::School> school_;
  QString problem_;
  std::string why_;         // error of a call that reverted its own changes afterwards
  bool succeeded_ = false;  // result of the last call
  QUndoStack people_, courses_, notes_;
};

}  // namespace swage::console
