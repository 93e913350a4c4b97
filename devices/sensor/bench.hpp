// SPDX-License-Identifier: Apache-2.0
//
// Measurement of means with a jaw sensor that a bench or a person holds still, and the calibration made from them: shared
// by `swage calibrate` and the console. Never blocks: the caller polls listen(). [main]
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sensor/calibration.hpp"
#include "sensor/sensor_link.hpp"

namespace swage::sensor {

class Bench {
 public:
  /// Opens a port; "" as the port: the only serial adapter. Returns "" or the reason, as a sentence.
  std::string open(const std::string& port, int bits_per_s);
  void close() { link_.close(); }
  bool plugged() const { return link_.plugged(); }
  /// Takes the measurements that have arrived.
  void listen(double now_s);
  bool known() const { return !link_.info("serial").empty(); }  // its serial number has arrived
  std::string serial() const { return link_.info("serial"); }
  std::string name() const { return link_.info("name"); }
  const std::string& port() const { return port_; }
  std::optional<double> volts() const { return volts_; }  // the newest measurement, V

  /// Begins a mean over the next `seconds` by the times of the measurements, not of their arrival: a busy machine reads them late and
  /// all the same reads enough. A sensor that says nothing ends it 3 s later.
  void begin(double now_s, double seconds);
  bool measuring() const { return measuring_; }
  /// After its end: "" and the mean, or the reason why there is none, as a sentence.
  std::string mean(double& volts) const;
  /// Mean of a force gauge on the handle over the same time, N; nothing without a gauge.
  std::optional<double> gauge() const { return n_gauge_ > 0 ? std::optional(sum_gauge_ / n_gauge_) : std::nullopt; }

 private:
  SensorLink link_;
  std::string port_;
  std::optional<double> volts_;
  bool measuring_ = false, beyond_ = false;
  double seconds_ = 0, until_s_ = 0, first_s_ = -1, last_s_ = -1;  // first, last: times of the measurements
  double sum_ = 0, low_ = 0, high_ = 0;
  double sum_gauge_ = 0;
  int n_ = 0, n_gauge_ = 0;
};

/// A calibration in progress: rows of a bench, the fit of the measured ones, the three poses of a session.
class Draft {
 public:
  struct Row {
    double length_m = 0;
    std::optional<double> volts;
  };
  static constexpr int kRows = 13;
  static constexpr double kStep = 0.5e-3;  // m: 13 points over 6 mm

  Draft();
  std::vector<Row>& rows() { return rows_; }
  const std::vector<Row>& rows() const { return rows_; }
  FitLimits limits;  // nominal 1 mm/V
  std::string serial, name, by;
  int valid_days = 365;
  std::array<std::optional<double>, 3> pose_volts;  // open, just closed, squeezed
  std::optional<double> zero_volts, zero_gauge_N;  // of a released handle, where the stored poses are kept; N, of its gauge
  /// One force on the handle, as entered, with the volts measured at it; and, where a gauge was between the tips, the force there.
  struct ForceRow {
    std::optional<double> handle_N, tip_N, volts;
  };
  static constexpr std::size_t kForceRows = 11;
  std::array<ForceRow, kForceRows> force_rows;
  std::optional<double> check_volts;  // at kCheckForce at the tips

  /// Fits what is measured so far; "" or the reason why there is no fit. The rows of `fit().points` are sorted by length.
  std::string refit();
  const Displacement& fit() const { return fit_; }
  /// The fit, or the stored one while no length has been measured: new poses and forces of a session need no bench.
  const Displacement& in_use() const { return fit_.valid() || !stored_ || any_length() ? fit_ : stored_->displacement; }
  /// Tables of forces from the rows, over the travel from just closed; "" or the reason why there are none.
  std::string forces(Calibration& out) const;
  /// The force at the tips [N] by the calibration for these volts, and the message of check_tip; nothing without a table of forces.
  std::optional<TipCheck> tip_check(double volts, const std::string& today) const;
  /// Starts from the stored calibration of this sensor: geometry and tables of forces are kept, and its poses reveal another handle.
  std::string begin_from(const std::string& path);
  /// True when the stored poses may get a new zero: they exist, and neither a length nor a pose has been measured since.
  bool may_zero() const;
  /// The calibration as it would be saved now; "" or the reason why it cannot be.
  std::string finish(const std::string& today, Calibration& out) const;

 private:
  bool any_length() const;
  std::optional<double> closed_length() const;  // m, length of the sensor where the jaws just meet
  std::vector<Row> rows_;
  Displacement fit_;
  std::optional<Calibration> stored_;
};

}  // namespace swage::sensor
