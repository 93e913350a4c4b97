// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One person: a metric over the attempts with its curve, the latest values against the experts, and the attempts themselves.
#pragma once

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTabWidget>
#include <QTableView>
#include <QWidget>
#include <functional>

#include "console/models/attempts_model.hpp"
#include "console/widgets/metric_chart.hpp"

namespace swage::console {

class PersonPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PersonPanel(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  /// `attempts`: of this person, newest first. What was chosen stays chosen where it is still there.
  void show_person(const QString& name, std::vector<record::AttemptRow> attempts);
  AttemptsModel* attempts() { return attempts_; }
  MetricChart* chart() { return chart_; }
  /// What a lesson says about a metric: which way it is better, and what is asked.
  using MetricFinder = std::function<MetricSaid(const QString& lesson_id, const std::string& metric_id)>;
  void set_metric_finder(MetricFinder finder) { finder_ = std::move(finder); }
  /// The keyboard goes to the attempts, the newest chosen: Enter reviews it.
  void focus_attempts();
  QString chosen_attempt() const;  // id; "" for none

 Q_SIGNALS:
  void review(const QString& attempt_id);
  /// An attempt out of a file is wanted.
  void open_file();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_head();
  QWidget* make_curve();
  QWidget* make_attempts();
  void fill_lessons();
  void show_attempts();
  void show_metric();
  void review_current();
  void ask_lesson(MetricSeries& series) const;

  MetricFinder finder_;
  AttemptsModel* attempts_;
  QSortFilterProxyModel* sorted_;
  std::vector<record::AttemptRow> all_;
  QLabel *name_ = nullptr, *summary_ = nullptr, *curve_ = nullptr;
  QComboBox *lesson_ = nullptr, *metric_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QTableView* table_ = nullptr;
  MetricChart* chart_ = nullptr;
  QPushButton* review_ = nullptr;
  QHBoxLayout* attempt_buttons_ = nullptr;
};

}  // namespace swage::console
