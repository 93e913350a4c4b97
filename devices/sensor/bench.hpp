// SPDX-License-Identifier: Apache-2.0
//
// A jaw sensor that is asked for means while a bench or a person holds it still, and what the answers make of its calibration: shared
// by `swage calibrate` and the console. Never waits: who asks calls listen() again and again. [main]
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
  /// "" as the port: the only serial adapter that there is. "" or why not, as a sentence.
  std::string open(const std::string& port, int bits_per_s);
  void close() { link_.close(); }
  bool plugged() const { return link_.plugged(); }
  /// Takes what has come.
  void listen(double now_s);
  bool known() const { return !link_.info("serial").empty(); }  // it has said who it is
  std::string serial() const { return link_.info("serial"); }
  std::string name() const { return link_.info("name"); }
  const std::string& port() const { return port_; }
  std::optional<double> volts() const { return volts_; }  // the newest measurement, V

  /// A mean from now on, over so many seconds.
  void begin(double now_s, double seconds);
  bool measuring() const { return measuring_; }
  /// Once it is over: "" and the mean, or why there is none, as a sentence.
  std::string mean(double& volts) const;
  /// Of a gauge on the handle over the same time, N; nothing without one.
  std::optional<double> gauge() const { return n_gauge_ > 0 ? std::optional(sum_gauge_ / n_gauge_) : std::nullopt; }

 private:
  SensorLink link_;
  std::string port_;
  std::optional<double> volts_;
  bool measuring_ = false, beyond_ = false;
  double until_s_ = 0, sum_ = 0, low_ = 0, high_ = 0;
  double sum_gauge_ = 0;
  int n_ = 0, n_gauge_ = 0;
};

/// A calibration while it is made: rows of a bench, the fit of those that are measured, the three poses of a session.
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
  std::optional<double> zero_volts, zero_gauge_N;  // of a handle that is let go, where the stored poses stay; of its gauge
  /// One force of the handle, typed, with the volts at which it was; and, where a gauge was between the tips, the force there.
  struct ForceRow {
    std::optional<double> handle_N, tip_N, volts;
  };
  static constexpr std::size_t kForceRows = 11;
  std::array<ForceRow, kForceRows> force_rows;
  std::optional<double> check_volts;  // at kCheckForce at the tips

  /// The fit of what is measured so far; "" or why there is none. The rows of `fit().points` are in the order of their length.
  std::string refit();
  const Displacement& fit() const { return fit_; }
  /// The fit, or the stored one while no length has been measured: poses and forces of a session need no bench.
  const Displacement& in_use() const { return fit_.valid() || !stored_ || any_length() ? fit_ : stored_->displacement; }
  /// Tables of forces from the rows, over the travel from just closed; "" or why there are none.
  std::string forces(Calibration& out) const;
  /// N at the tips that the calibration makes of these volts, and the sentence of check_tip; nothing without a table of forces.
  std::optional<TipCheck> tip_check(double volts, const std::string& today) const;
  /// What is stored of this sensor is where a new one begins: geometry and table of forces stay, and poses tell another handle apart.
  std::string begin_from(const std::string& path);
  /// The stored poses may be given a new zero: they are there, and neither a length nor a pose has been measured since.
  bool may_zero() const;
  /// Everything that is known now, as it would be kept; "" or why it cannot be.
  std::string finish(const std::string& today, Calibration& out) const;

 private:
  bool any_length() const;
  std::optional<double> closed_length() const;  // m, of the sensor where the jaws just meet
  std::vector<Row> rows_;
  Displacement fit_;
  std::optional<Calibration> stored_;
};

}  // namespace swage::sensor
