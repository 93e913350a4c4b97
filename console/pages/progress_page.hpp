// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Progress page: people, a person's attempts with their verdicts, and one metric over the attempts.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "console/models/attempts_model.hpp"
#include "console/models/people_model.hpp"
#include "console/widgets/metric_chart.hpp"

namespace swage::console {

/// How the store is opened: record::Store::open, or a test double. nullptr and `error` on failure.
using StoreOpener = std::function<std::unique_ptr<record::Store>(std::string& error)>;

class ProgressPage : public QWidget {
  Q_OBJECT
 public:
  explicit ProgressPage(StoreOpener opener, QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  PeopleModel* people() { return people_; }
  AttemptsModel* attempts() { return attempts_; }
  MetricChart* chart() { return chart_; }
  /// nullptr before the first refresh() and where nothing is kept. Whoever looks at an attempt keeps its store open.
  std::shared_ptr<record::Store> store() { return store_; }
  /// What a lesson says about a metric: which way it is better, and what is asked.
  using MetricFinder = std::function<MetricSaid(const QString& lesson_id, const std::string& metric_id)>;
  void set_metric_finder(MetricFinder finder) { finder_ = std::move(finder); }

 public Q_SLOTS:
  /// Reads the store again; keeps the person and the lesson when they are still there.
  void refresh();
  /// The keyboard goes to the attempts, the newest chosen: Enter reviews it.
  void focus_attempts();
  void select_person(const QString& name);

 Q_SIGNALS:
  void run_lesson();
  void review(const QString& attempt_id);
  /// An attempt out of a file is wanted.
  void open_file();
  /// Attempts of a program that ended unexpectedly were brought to an end.
  void recovered(int attempts);

 private:
  QWidget* make_people();
  QWidget* make_person();
  QWidget* make_empty();
  bool open();
  bool reads();
  void look();
  void show_person();
  void show_attempts();
  void show_metric();
  void review_current();
  void ask_lesson(MetricSeries& series) const;

  StoreOpener opener_;
  MetricFinder finder_;
  std::shared_ptr<record::Store> store_;
  bool broken_ = false;  // the last reading of the store failed: the next one opens it again
  QTimer watch_;         // what other programs write
  PeopleModel* people_;
  AttemptsModel* attempts_;
  QSortFilterProxyModel* sorted_;
  std::vector<record::AttemptRow> all_;
  QStackedWidget* stack_ = nullptr;
  QListView* people_view_ = nullptr;
  QLabel *name_ = nullptr, *summary_ = nullptr, *empty_ = nullptr;
  QComboBox *lesson_ = nullptr, *metric_ = nullptr;
  QTableView* table_ = nullptr;
  MetricChart* chart_ = nullptr;
  QLabel* curve_ = nullptr;
  QPushButton* review_ = nullptr;
};

}  // namespace swage::console
