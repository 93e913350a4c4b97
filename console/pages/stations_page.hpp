// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Stations page: the state of all stations, and for the selected one a picture, a message, a lesson, a mark in its record.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include "console/cues/cue_theme.hpp"
#include "console/link/station_link.hpp"
#include "console/models/lessons_model.hpp"
#include "console/models/stations_model.hpp"

namespace swage::console {

class StationsPage : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive the page.
  StationsPage(StationLink* link, LessonsModel* lessons, QWidget* parent = nullptr);
  void set_cues(const CueTheme& cues);
  StationsModel* stations() { return model_; }
  QString chosen() const;  // name of a station, "" for none

 public Q_SLOTS:
  void choose(const QString& station);
  void focus_stations() { table_->setFocus(); }
  void send_words();
  void send_lesson();
  void mark();
  void ask_picture();
  void forget();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* make_list();
  QWidget* make_chosen();
  QWidget* make_empty();
  QWidget* make_picture(QWidget* parent);
  void make_actions(QWidget* parent, QVBoxLayout* body);
  void show_stations();
  void show_chosen();
  void show_sent();
  void show_problem();
  void say(const QString& words);

  StationLink* link_;
  LessonsModel* lessons_;
  StationsModel* model_;
  QTimer age_;  // updates the age of the list, while the server does not answer
  QStackedWidget* stack_ = nullptr;
  QTableView* table_ = nullptr;
  QLabel *count_ = nullptr, *problem_ = nullptr, *empty_ = nullptr, *name_ = nullptr, *facts_ = nullptr, *picture_ = nullptr,
         *said_ = nullptr;
  QLineEdit *words_ = nullptr, *moment_ = nullptr;
  QComboBox* lesson_ = nullptr;
  QListWidget* sent_ = nullptr;
  QPushButton *send_ = nullptr, *give_ = nullptr, *mark_ = nullptr, *look_ = nullptr, *forget_ = nullptr;
  QString pictured_;  // the station whose picture is shown
};

}  // namespace swage::console
