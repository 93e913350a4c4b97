// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <map>
#include <string>

#include "console/cues/ui_theme.hpp"
#include "console/models/lesson_facts.hpp"
#include "console/widgets/parts.hpp"
#include "session/session.hpp"

namespace swage::console {

/// How the attempt ended: passed or not, why in plain words, what cost points, and the numbers: those that matter first, the
/// rest on demand.
class ResultPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPanel(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  /// `readings_open`: the trainee's screen showed the readings of this test.
  void show_result(const session::Result& result, const snapshot::SceneCard& card, bool kept, bool readings_open = false);
  /// A caveat on how the shown attempt was made, as a sentence; "" adds none.
  void add_remark(const QString& words);
  /// The end of a demonstration: nothing was judged.
  void show_seen(const session::Result& result);
  /// The lesson's targets by the ids of its metrics, SI, for the next result: what exceeds its upper limit is shown among the first numbers.
  void set_targets(const std::map<std::string, MetricTarget>& targets) { targets_ = targets; }
  void set_can_go_on(bool next) { next_->setEnabled(next); }
  /// How far the person is with this lesson in a course; "" without one.
  void set_course(const QString& words);
  /// What the lesson asks, to be read beside what was reached.
  void set_criteria(const Criteria& asked);
  QString outcome() const { return outcome_->text(); }
  QString reason() const { return reason_->text(); }

 Q_SIGNALS:
  void again();
  void next();
  void review(const QString& attempt_id);
  void progress();

 private:
  void add_outcome(const Card& card);
  void add_points(const Card& card);
  QList<QPushButton*> add_buttons(const Card& card);
  void add_more(const Card& card);
  void add_criteria(const Card& card);
  void clear();
  void add_line(QGridLayout* to, const QString& name, const QString& value, const QString& doc);
  /// Upper limit of a metric; infinite where the lesson says none.
  double most(const std::string& metric) const;
  void add_metrics(const session::Result& result, const snapshot::SceneCard& card);
  void add_ratings(const session::Result& result);
  void show_notes(const session::Result& result);
  void announce();
  void paint_outcome();
  UiTheme theme_;
  judge::Outcome state_ = judge::Outcome::kRunning;
  QString attempt_;
  std::map<std::string, MetricTarget> targets_;
  QString points_title(const session::Result& result, const std::string& id) const;
  QLabel *outcome_, *reason_, *kept_, *course_, *problems_, *points_heading_;
  QGridLayout *metrics_, *points_, *more_;
  QLabel* criteria_;
  QWidget* more_box_;
  QPushButton *more_button_, *review_, *next_;
};

/// Why an attempt ended, in words: the doc of the event, or the event's id made readable.
QString reason_text(const std::string& reason, const judge::Script& script);

}  // namespace swage::console
