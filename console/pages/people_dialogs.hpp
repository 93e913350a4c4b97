// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Dialogs of the People page: one person, a pasted list with its preview, and the confirmation before a person is erased.
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
  /// `is_new`: the code can still be chosen. `known`, `codes`: names and codes already in use.
  PersonDialog(const RosterLine& person, bool is_new, const QStringList& groups, const QStringList& known, const QStringList& codes,
               QWidget* parent);
  RosterLine person() const;

 private:
  void check();
  QStringList known_, codes_;
  QLineEdit *name_, *code_;
  QComboBox *group_, *hand_;
  QLabel* problem_;
  QPushButton* ok_;
};

class RosterDialog : public QDialog {
  Q_OBJECT
 public:
  RosterDialog(const QStringList& known, QWidget* parent);
  /// The whole list, of which the new people are to be added.
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

/// Assigns a course to the chosen people or to a group.
class AssignDialog : public QDialog {
  Q_OBJECT
 public:
  /// `courses`: title and id. `group`: name of a group that may be chosen instead; "" for none.
  AssignDialog(const QVector<QPair<QString, QString>>& courses, int people, const QString& group, QWidget* parent);
  QString course() const { return course_->currentData().toString(); }  // id; "": removes the assignment
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
  /// `files`: files that will still contain data of this person.
  EraseDialog(const QString& name, int attempts, const QStringList& files, QWidget* parent);
};

}  // namespace swage::console
