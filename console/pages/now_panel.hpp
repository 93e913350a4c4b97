// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Right side of the Run page: the present readings, as numbers and over the last ten seconds.
#pragma once

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVector>
#include <QWidget>

#include "console/cues/cue_theme.hpp"
#include "console/models/lesson_facts.hpp"
#include "console/models/reading.hpp"
#include "console/widgets/force_meter.hpp"
#include "console/widgets/live_form.hpp"
#include "console/widgets/trace_plot.hpp"

namespace swage::console {

class CueBadge;

class NowPanel : public QWidget {
  Q_OBJECT
 public:
  explicit NowPanel(QWidget* parent = nullptr);
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  void set_scene(const Reader& reader, const ForceBand& band, const QString& task, const Criteria& criteria);
  /// Before the attempt the criteria are shown; during it the remaining time, and on demand the criteria, in a test as well.
  void set_running(bool running);
  /// In a test the trainee sees neither readings nor phases, which would reveal answers: the task line stays that of the lesson.
  void set_readings_hidden(bool hidden);
  void show_reading(const Reading& reading, double time_s);
  /// Advice beyond the task of the phase, as after a drop; "" for none. Hidden with the readings.
  void set_advice(const QString& words);
  ForceMeter* meter() { return meter_; }
  LiveForm* form() { return form_; }

 private:
  QHBoxLayout* make_time(QWidget* parent);
  QWidget* make_lower();
  QWidget* make_readings(QWidget* parent);
  void show_time(double time_s);
  void show_parts();
  void show_task();
  void show_tension(const Reading& reading, double time_s);
  double tension_N_ = 0, tension_since_s_ = 0;  // maximum of the present interval, and the interval's start
  CueTheme cues_;
  struct Fact {
    QLabel *name, *value;
    CueBadge* badge;
    void set_visible(bool shown) const;
  };
  Fact spot_, tips_, tilt_, tension_, hold_;
  QLabel *phase_, *advice_, *criteria_, *left_, *hidden_;  // phase_: the lesson's task, then the phase of the attempt
  QString task_;
  QPushButton* rules_;  // unfolds the criteria during an attempt
  QWidget *card_, *readings_, *lower_;
  Criteria asked_;
  bool has_scene_ = false, running_ = false, readings_hidden_ = false;
  QLabel* force_name_;
  ForceMeter* meter_;
  void show_fact(const Fact& fact, std::optional<bool> is, QChar filled, const QString& yes,
                 const QString& no);
  QGridLayout* counts_;
  QVector<QLabel*> count_names_, count_values_;
  QVector<QPushButton*> tabs_;  // plots, parameters to adjust
  TracePlot *force_plot_, *tilt_plot_;
  LiveForm* form_;
};

}  // namespace swage::console
