// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The People page: all people, those who need attention first, and below the selected one. Changes go through the desk (PeopleEdits), files are
// written by PeopleFiles.
#pragma once

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QWidget>

#include "console/link/school_desk.hpp"
#include "console/link/store_link.hpp"
#include "console/models/people_model.hpp"
#include "console/pages/people_edits.hpp"
#include "console/pages/people_files.hpp"
#include "console/pages/person_panel.hpp"

namespace swage::console {

class PeoplePage : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the page.
  PeoplePage(StoreLink* link, SchoolDesk* desk, QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme) { person_->set_theme(theme); }
  PeopleModel* people() { return people_; }
  PersonPanel* person() { return person_; }
  AttemptsModel* attempts() { return person_->attempts(); }
  MetricChart* chart() { return person_->chart(); }
  PeopleFiles* files() { return files_; }
  QString chosen() const;  // id of the selected person, "" for none

 public Q_SLOTS:
  /// Reads the store again; keeps the selected person and lesson if they still exist.
  void refresh();
  void select_person(const QString& name);
  /// Moves the focus to the table of people, where Enter shows the attempts of one.
  void focus_people() { table_->setFocus(); }

 Q_SIGNALS:
  void run_lesson();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_people();
  QWidget* make_empty();
  void add_buttons(QHBoxLayout* row, QWidget* parent);
  void fold_head();
  void fill_groups();
  void look();
  void show_empty(const QString& words);
  void show_count();
  void show_chosen();
  std::vector<std::string> all_chosen() const;
  std::vector<record::AttemptRow> attempts_of(const std::vector<std::string>& people, const std::string& lesson);
  const std::vector<record::AttemptRow>& experts_at(const std::string& lesson, const std::vector<std::string>& experts);
  void choose(const QString& id);
  void choose_too(const std::vector<std::string>& ids);

  void report_group();

  StoreLink* link_;
  SchoolDesk* desk_;
  QTimer watch_;  // polls for changes by other programs
  PeopleModel* people_;
  QSortFilterProxyModel* sorted_;
  std::vector<record::AttemptRow> of_experts_;  // at one lesson, read on first use
  std::string lesson_read_;
  bool filling_ = false;  // while true, changes of rows do not update the panel; it is updated once at the end
  QStackedWidget* stack_ = nullptr;
  QTableView* table_ = nullptr;
  PersonPanel* person_ = nullptr;
  PeopleEdits* edits_ = nullptr;
  PeopleFiles* files_ = nullptr;
  QBoxLayout *head_ = nullptr, *buttons_ = nullptr;
  QLabel *empty_ = nullptr, *count_ = nullptr, *problem_ = nullptr;
  QComboBox* group_ = nullptr;
  QHash<QString, QString> groups_;  // name by id
  QVector<QPushButton*> of_person_;  // buttons that need a selected person
};

}  // namespace swage::console
