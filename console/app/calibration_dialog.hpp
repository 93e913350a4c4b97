// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calibration of a jaw sensor: thirteen lengths and their volts on a bench, the fit with what is left of each point; the three poses of
// the needleholder, anew in each session; forces of the handle and of the tips, and a check on a gauge. The same arithmetic as
// `swage calibrate`. Nothing is kept before "Keep".
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>

#include "console/cues/ui_theme.hpp"
#include "console/widgets/fit_plot.hpp"
#include "sensor/bench.hpp"

namespace swage::console {

class CalibrationDialog : public QDialog {
  Q_OBJECT
 public:
  explicit CalibrationDialog(const UiTheme& theme, const QString& by, QWidget* parent = nullptr);
  /// s over which a point is averaged.
  void set_seconds(double seconds) { seconds_ = seconds; }
  const sensor::Draft& draft() const { return draft_; }

 Q_SIGNALS:
  void kept();  // a calibration was stored

 private:
  QWidget* make_sensor();
  QWidget* make_points(const UiTheme& theme);
  QWidget* make_poses();
  QWidget* make_forces();
  QWidget* make_end();
  void connect_sensor();
  /// A row; kPose and on: open, closed, squeezed; kForce and on: a row of forces; kCheck; kZero. `then`: where the keyboard goes.
  void measure(int what, QWidget* then);
  QPushButton* make_measuring(const QString& text, const char* name, QWidget* parent);
  void poll();
  void measured();
  void read_lengths();
  void read_forces();
  void show_points();
  void show_poses();
  void show_forces();
  void show_tip();  // what the tips press now, by the calibration
  void keep();
  void say(const QString& text, bool bad);

  static constexpr int kPose = 100, kForce = 200, kCheck = 300, kZero = 400;
  sensor::Bench bench_;
  sensor::Draft draft_;
  QTimer timer_;
  double seconds_ = 0.5;
  double asked_s_ = 0;  // when the port was opened
  int measuring_ = -1;
  QWidget* next_ = nullptr;  // gets the keyboard when the measurement is over
  bool named_ = false, filling_ = false;
  QComboBox *port_, *rate_;
  QLineEdit* by_;
  QSpinBox* days_;
  QLabel *sensor_, *verdict_, *said_, *forces_, *tip_;
  QTabWidget* steps_;
  QTableWidget *table_, *force_table_;
  FitPlot* plot_;
  QPushButton *connect_, *measure_, *clear_, *keep_, *pose_[3], *zero_, *measure_force_, *check_;
};

/// What is stored of jaw sensors, one sentence each, with what is wrong with it.
QStringList stored_calibrations();

}  // namespace swage::console
