// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A lesson during an edit: the changes to the lesson that the edit began with, with undo and redo. The draft is a lesson file of its
// own until the edit ends, so that it can be built, and nothing is lost when the program ends.
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
  /// `begin`: state at the start; its base is the path of the lesson. `file`: path of the draft; an existing file belongs to an
  /// interrupted edit, which is resumed if it began with the same lesson.
  LessonDraft(const Variant& begin, const QString& file, QObject* parent = nullptr);

  const Variant& now() const { return now_; }
  const QString& file() const { return file_; }
  /// True when an interrupted edit was resumed; one undo reverts its changes.
  bool taken_up() const { return taken_up_; }
  bool changed() const { return !(now_ == begin_); }
  bool words_changed() const;
  bool view_changed() const { return now_.view != begin_.view; }
  bool parts_changed() const { return now_.remove != begin_.remove || now_.add != begin_.add; }
  QUndoStack* edits() { return &edits_; }

  void set_title(const QString& title);
  void set_summary(const QString& summary);
  void set_goal(const QString& goal);
  void set_view(const QString& view);
  /// Sets all values that differ from the lesson's; `field`: the edited one, whose successive edits are undone together.
  void set_values(const QVector<std::pair<std::string, std::string>>& set, const QString& field);
  /// `part`: as in a lesson file, with a name.
  void add_part(LessonPart::Kind kind, const nlohmann::ordered_json& part);
  /// Removes a part and the couplings that refer to it. Returns the names of these couplings.
  QStringList remove_part(const QString& name);

  /// Parts of the lesson with the present changes, in the lesson's order.
  QVector<LessonPart> parts() const;
  /// A free name for a part of this plugin: "tray", or "tray_2" where that is taken.
  QString free_name(const QString& plugin) const;

  /// Writes the draft; and, without its values, to `parts_file`, from which a form reads default values. Returns "" or the error.
  QString write() const;
  QString write_parts(const QString& parts_file) const;
  /// Ends the edit and deletes the file.
  void end() const;

 Q_SIGNALS:
  /// `structure`: the parts changed. `by_undo`: the change came from undo or redo, and fields must be refreshed.
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
