// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QString>
#include <QStringList>
#include <QVector>

namespace swage::console {

/// What the list says about one lesson file.
struct LessonEntry {  // in the words of the file
  QString path, id, title, summary, goal;
  QString reset_label, reset_tip;  // of the button that puts the work back; "": the program's own
  QStringList hands;    // the names ("as") under which its devices can be chosen, first choice first
  bool mirror = false;  // made for the left hand
  QString problem;      // what is wrong with it first, file and line; "" for a lesson that reads well
  bool other = false;   // JSON of another format than a lesson's
};

/// Reads a lesson file and what it is based on. Plugins and their parameters are not looked at.
LessonEntry read_lesson(const QString& path);

/// Where lesson files are: SWAGE_LESSON_PATH, the user's data folder, the install's share/swage/lessons, and
/// the source tree that the program was built in.
QStringList lesson_folders();

/// The lessons of some folders, in the order of their file names.
class LessonsModel : public QAbstractListModel {
  Q_OBJECT
 public:
  /// Display role, kSummary and kGoal are in the language of the window; kTitle is as the file says it, for what is kept.
  enum Role { kPath = Qt::UserRole, kId, kTitle, kSummary, kGoal, kHands, kMirror, kProblem, kResetLabel, kResetTip };

  using QAbstractListModel::QAbstractListModel;
  void set_folders(const QStringList& folders);
  /// Adds one file in front unless it is already there; in place of another with its id. Returns its row.
  int add_file(const QString& path);
  /// Reads a file again that has changed.
  void read_again(int row);
  /// The list without one: its file is not touched.
  void remove(int row);
  int row_of(const QString& path_or_id) const;
  const LessonEntry& at(int row) const { return entries_[row]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  QVector<LessonEntry> entries_;
};

}  // namespace swage::console
