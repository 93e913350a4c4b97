// SPDX-License-Identifier: Apache-2.0
//
// Verbs for the jaw sensor: one that simulates it, and those that calibrate a real one. [main]
#pragma once

#include <string>

namespace swage::tools {

struct SimulateSensorOptions {
  std::string link;               // path of a symbolic link to the terminal, "" for none
  std::string script = "breathe";  // "breathe", or a file of rows "s, V"
  std::string serial = "SIM1";
  double rate_hz = 200, seconds = 0;  // seconds 0: until Ctrl-C
  double drift = 0, burst_s = 0;
  unsigned corrupt_each = 0, lose_each = 0;
  double unplug_each_s = 0;  // s between two interruptions of 1 s each, 0: never
  bool grip = false;
};
int simulate_sensor(const SimulateSensorOptions&);

struct CalibrateOptions {
  std::string port, by, serial, name, table, file;
  int bits_per_s = 115200;
  double nominal_mm_per_v = 1;
  int valid_days = 365;
  double a_mm = 0, b_mm = 0, gap_mm = 0;  // geometry of the handle
  double seconds = 0.5;                   // averaging time of one value
  double tip_N = 0.6, ratio = 0.2;        // of a check: force at the tips; its ratio to that at the handle, without a table
  bool force_anyway = false, json = false;
};
/// Calibrates voltage to length: from a table "mm, V", or point by point with the sensor.
int calibrate_displacement(const CalibrateOptions&);
/// Calibrates travel to force: from a table "mm, N", or point by point with the sensor.
int calibrate_force(const CalibrateOptions&);
/// Calibrates force at the handle to force at the tips: from a table "N, N", or point by point with sensor and gauge.
int calibrate_tip(const CalibrateOptions&);
/// Checks the calibration with one force at the tips, measured by a gauge with a real needle.
int calibrate_check(const CalibrateOptions&);
/// Measures the poses open, just closed and squeezed with the sensor.
int calibrate_poses(const CalibrateOptions&);
/// Zeroes the released handle: shifts the stored poses to its rest position, at which the gauge reads 0.
int calibrate_zero(const CalibrateOptions&);
/// Prints the stored calibration.
int calibrate_show(const CalibrateOptions&);

}  // namespace swage::tools
