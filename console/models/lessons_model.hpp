// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QString>
#include <QStringList>
#include <QVector>

namespace swage::console {

/// List entry of one lesson file.
struct LessonEntry {  // in the language of the file
  QString path, id, title, summary, goal;
  QString reset_label, reset_tip;  // of the reset button; "": the program's own
  QStringList hands;    // the names ("as") of its selectable devices, first choice first
  bool mirror = false;  // made for the left hand
  QString problem;      // its first error with file and line; "" for a valid lesson
  bool other = false;   // JSON of a format other than a lesson's
};

/// Reads a lesson file and its bases. Plugins and their parameters are not checked.
LessonEntry read_lesson(const QString& path);

/// Folders of lesson files: SWAGE_LESSON_PATH, the user's data folder, the install's share/swage/lessons, and
/// the source tree that the program was built in.
QStringList lesson_folders();

/// Path of the first lesson file of this name in these folders or below them, "" where there is none.
QString lesson_file(const QString& name);

/// The lessons of several folders, in the order of their file names.
class LessonsModel : public QAbstractListModel {
  Q_OBJECT
 public:
  /// Display role, kSummary and kGoal are in the language of the window; kTitle is that of the file, for records.
  enum Role { kPath = Qt::UserRole, kId, kTitle, kSummary, kGoal, kHands, kMirror, kProblem, kResetLabel, kResetTip };

  using QAbstractListModel::QAbstractListModel;
  void set_folders(const QStringList& folders);
  /// Inserts a file at the front unless it is in the list; it replaces a lesson of the same id. Returns its row.
  int add_file(const QString& path);
  /// Reads a changed file again.
  void read_again(int row);
  /// Removes a row; its file is not changed.
  void remove(int row);
  int row_of(const QString& path_or_id) const;
  const LessonEntry& at(int row) const { return entries_[row]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  QVector<LessonEntry> entries_;
};

}  // namespace swage::console
