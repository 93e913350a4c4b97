// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calibration of a jaw sensor, by hand on a bench: thirteen lengths and their volts, the fit with what is left of each point, then
// the three poses of the needleholder. The same arithmetic as `swage calibrate`.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
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
  QWidget* make_end();
  void connect_sensor();
  void measure(int what);  // a row, or kPose and on: open, closed, squeezed
  void poll();
  void measured();
  void read_lengths();
  void show_points();
  void keep();
  void say(const QString& text, bool bad);

  static constexpr int kPose = 100;
  sensor::Bench bench_;
  sensor::Draft draft_;
  QTimer timer_;
  double seconds_ = 0.5;
  double asked_s_ = 0;  // when the port was opened
  int measuring_ = -1;
  bool named_ = false, filling_ = false;
  QComboBox *port_, *rate_;
  QLineEdit* by_;
  QSpinBox* days_;
  QLabel *sensor_, *verdict_, *said_;
  QTableWidget* table_;
  FitPlot* plot_;
  QPushButton *connect_, *measure_, *clear_, *keep_, *pose_[3];
};

/// What is stored of jaw sensors, one sentence each, with what is wrong with it.
QStringList stored_calibrations();

}  // namespace swage::console
