// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What an instructor changes about people, attempts and courses. Each change is written at once and can be undone; what failed has
// changed nothing and is said in a sentence. There is nothing to save.
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

  /// nullptr where nothing can be changed, and problem() says why.
  record::School* school();
  const QString& problem() const { return problem_; }
  /// Titles of the courses that have a lesson, without archived ones.
  QStringList courses_with(const QString& lesson_id);
  QUndoStack* people_edits() { return &people_; }
  QUndoStack* course_edits() { return &courses_; }
  QUndoStack* note_edits() { return &notes_; }

  /// The new ones of a list; groups that are not there yet are made. One undo takes all back.
  bool add_people(const QVector<RosterLine>& lines);
  bool change_person(const record::Person& after);
  bool set_void(const QString& attempt_id, bool is_void, const QString& reason);
  /// Gives an attempt of one person, usually Guest, to another.
  bool give_attempt(const QString& attempt_id, const QString& from_id, const QString& to_id);
  /// For good: there is no undo, and what was done before cannot be undone any more.
  bool erase_person(const QString& id);
  /// The id of a group of that name, made where there is none; "" for no name or on failure.
  std::string group_id(const QString& name);

  /// A new course where `before` has no id; removed where `after` has none. Edits with the same `field` that follow each other are
  /// one undo.
  bool change_course(record::Course before, record::Course after, const QString& words, int field = -1);
  /// Gives people, or groups, a course; "" takes what they were given. One undo takes all back. `due`: "" or 2030-01-31.
  bool assign(const QString& course_id, const std::vector<std::string>& who, bool to_group, const QString& due);
  /// Freezes a lesson; for good, as attempts refer to it. False: problem() says why.
  bool publish(const QString& lesson_id, const QString& title, const std::string& text, record::LessonVersion& out);
  /// No longer offered, or offered again.
  bool retire(const record::LessonVersion& version, bool retired);
  bool add_note(record::Note note);
  bool remove_note(const record::Note& note);
  /// An instructor's points for an item of a rating scale; nothing: taken back.
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
  std::string why_;         // of a call that has cleaned up since
  bool succeeded_ = false;  // the last call
  QUndoStack people_, courses_, notes_;
};

}  // namespace swage::console
