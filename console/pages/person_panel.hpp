// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One person: a metric over the attempts with its learning curve, the latest values beside the experts', and the attempts themselves.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTabWidget>
#include <QTableView>
#include <QTimer>
#include <QWidget>
#include <functional>

#include "console/models/attempts_model.hpp"
#include "console/models/metric_bars.hpp"
#include "console/widgets/band_bars.hpp"
#include "console/widgets/group_plot.hpp"
#include "console/widgets/metric_chart.hpp"

namespace swage::console {

class PersonPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PersonPanel(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  /// `attempts`: of this person, newest first. The selection is kept where possible.
  void show_person(const QString& name, std::vector<record::AttemptRow> attempts);
  /// Attempts of all selected people, newest first, for the group figure. Called only while it is visible.
  using GroupFinder = std::function<std::vector<record::AttemptRow>(const std::string& lesson_id)>;
  void set_group_finder(GroupFinder finder) { group_ = std::move(finder); }
  void show_group();
  GroupPlot* group() { return group_plot_; }
  AttemptsModel* attempts() { return attempts_; }
  MetricChart* chart() { return chart_; }
  /// Direction and target of a metric in a lesson.
  using MetricFinder = std::function<MetricSaid(const QString& lesson_id, const std::string& metric_id)>;
  void set_metric_finder(MetricFinder finder) { finder_ = std::move(finder); }
  void set_expert_finder(ExpertFinder experts) { experts_ = std::move(experts); }
  BandBars* bars() { return bars_; }
  QString lesson_title() const { return lesson_->currentText(); }
  /// Moves the focus to the attempts and selects the newest: Enter reviews it.
  void focus_attempts();
  QString chosen_attempt() const;  // id; "" for none
  const record::AttemptRow* chosen_row() const;

 Q_SIGNALS:
  void review(const QString& attempt_id);
  /// An attempt from a file is to be opened.
  void open_file();
  /// The selected attempt is to be made void or valid.
  void void_attempt();
  void give_attempt();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void draw_group();
  QWidget* make_head();
  QWidget* make_curve();
  QWidget* make_attempts();
  void fill_lessons();
  void show_attempts();
  void show_metric();
  void review_current();
  void update_buttons();
  void choose_newest();
  std::string only_lesson() const;
  void ask_lesson(MetricSeries& series) const;

  void show_bars();

  MetricFinder finder_;
  ExpertFinder experts_;
  QTimer group_later_;
  GroupFinder group_;
  GroupPlot* group_plot_ = nullptr;
  BandBars* bars_ = nullptr;
  AttemptsModel* attempts_;
  QSortFilterProxyModel* sorted_;
  std::vector<record::AttemptRow> all_;
  std::string shown_id_;  // id of the shown person
  QLabel *name_ = nullptr, *summary_ = nullptr, *curve_ = nullptr;
  QComboBox *lesson_ = nullptr, *metric_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QTableView* table_ = nullptr;
  MetricChart* chart_ = nullptr;
  QPushButton *review_ = nullptr, *void_ = nullptr, *give_ = nullptr;
};

}  // namespace swage::console
