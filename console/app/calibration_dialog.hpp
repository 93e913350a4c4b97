// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calibration of a jaw sensor: thirteen lengths and their voltages on a bench, and the fit with the residual of each point; the three poses
// of the needleholder, measured anew in each session; forces of the handle and of the tips, and a check on a gauge. The arithmetic is that
// of `swage calibrate`. Nothing is stored before "Keep".
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
  /// `what`: a row; from kPose: open, closed, squeezed; from kForce: a row of forces; kCheck; kZero. `then`: the next holder of the focus.
  void measure(int what, QWidget* then);
  QPushButton* make_measuring(const QString& text, const char* name, QWidget* parent);
  void poll();
  void measured();
  void read_lengths();
  void read_forces();
  void show_points();
  void show_poses();
  void show_forces();
  void show_tip();  // shows the present force at the tips, by the calibration
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

/// The stored calibrations of jaw sensors, one sentence each, with any defect.
QStringList stored_calibrations();

}  // namespace swage::console
