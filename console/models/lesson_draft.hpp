// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A lesson while it is edited: what is changed in the one that it began with, with undo and redo. It stands in a file of its own, a
// lesson like any other, which is there until the edit is over: so it can be built, and nothing is lost where the program ends.
// GUI thread.
#pragma once

#include <QObject>
#include <QUndoStack>

#include "console/models/lessons_model.hpp"
#include "console/models/variant.hpp"

namespace swage::console {

/// An object, a coupling or a device of a lesson.
struct LessonPart {
  enum class Kind { kObject, kCoupling, kDevice };
  Kind kind = Kind::kObject;
  QString name, plugin;
  QStringList between;  // of a coupling: the two objects
};

class LessonDraft : public QObject {
  Q_OBJECT
 public:
  /// `begin`: where the edit begins; its base is the path of the lesson. `file`: that of the draft; one that is there already is of an
  /// edit that was not ended, and is taken up if it began with the same lesson.
  LessonDraft(const Variant& begin, const QString& file, QObject* parent = nullptr);

  const Variant& now() const { return now_; }
  const QString& file() const { return file_; }
  /// What was changed before the program ended is there again; one undo takes it back.
  bool taken_up() const { return taken_up_; }
  bool changed() const { return !(now_ == begin_); }
  bool words_changed() const;
  bool parts_changed() const { return now_.remove != begin_.remove || now_.add != begin_.add; }
  QUndoStack* edits() { return &edits_; }

  void set_title(const QString& title);
  void set_summary(const QString& summary);
  void set_goal(const QString& goal);
  /// All values that differ from the lesson's; `field` names the one that was edited: edits of it that follow each other are one undo.
  void set_values(const QVector<std::pair<std::string, std::string>>& set, const QString& field);
  /// `part` as in a lesson file; it has a name.
  void add_part(LessonPart::Kind kind, const nlohmann::ordered_json& part);
  /// And the couplings that bind it. Returns the names of these.
  QStringList remove_part(const QString& name);

  /// Of the lesson as it is now, in the order of the lesson.
  QVector<LessonPart> parts() const;
  /// "tray", or "tray_2" where that is taken: a name for a part of this plugin.
  QString free_name(const QString& plugin) const;

  /// Writes the draft; the same without its values to `parts_file`, from which a form has their starts. Returns why not, or "".
  QString write() const;
  QString write_parts(const QString& parts_file) const;
  /// The edit is over: the file goes.
  void end() const;

 Q_SIGNALS:
  /// `structure`: other parts than before. `by_undo`: fields do not show it yet.
  void edited(bool structure, bool by_undo);

 private:
  friend class DraftEdit;
  void change(Variant after, const QString& words, const QString& field);
  void put(const Variant& now, bool by_undo);

  Variant begin_, now_;
  QString file_;
  bool taken_up_ = false;
  QUndoStack edits_;
};

}  // namespace swage::console
