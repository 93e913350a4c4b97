// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Forms of the People page: one person, a pasted list with its preview, and the last question before somebody is erased.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>

#include "console/models/roster.hpp"

namespace swage::console {

class PersonDialog : public QDialog {
  Q_OBJECT
 public:
  /// `is_new`: the code can still be chosen. `known`: names that are taken.
  PersonDialog(const RosterLine& person, bool is_new, const QStringList& groups, const QStringList& known, QWidget* parent);
  RosterLine person() const;

 private:
  void check();
  QStringList known_;
  QLineEdit *name_, *code_;
  QComboBox *group_, *hand_;
  QLabel* problem_;
  QPushButton* ok_;
};

class RosterDialog : public QDialog {
  Q_OBJECT
 public:
  RosterDialog(const QStringList& known, QWidget* parent);
  /// The whole list; those that are new are to be added.
  const QVector<RosterLine>& lines() const { return lines_; }
  void set_text(const QString& text) { text_->setPlainText(text); }

 private:
  void read();
  void open_file();
  QStringList known_;
  QVector<RosterLine> lines_;
  QPlainTextEdit* text_;
  QTableWidget* preview_;
  QLabel* says_;
  QPushButton* add_;
};

/// A course for the chosen people or for a group.
class AssignDialog : public QDialog {
  Q_OBJECT
 public:
  /// `courses`: title and id. `group`: name of the group that may be chosen instead; "" for none.
  AssignDialog(const QVector<QPair<QString, QString>>& courses, int people, const QString& group, QWidget* parent);
  QString course() const { return course_->currentData().toString(); }  // id; "": what was assigned is taken back
  bool to_group() const { return whom_->currentIndex() == 1; }
  QString due() const;  // "" or 2030-01-31

 private:
  QComboBox *course_, *whom_;
  QCheckBox* has_due_;
  QDateEdit* due_;
};

class EraseDialog : public QDialog {
  Q_OBJECT
 public:
  /// `files`: in which something of this person will stay.
  EraseDialog(const QString& name, int attempts, const QStringList& files, QWidget* parent);
};

}  // namespace swage::console
