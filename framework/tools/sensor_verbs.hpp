// SPDX-License-Identifier: Apache-2.0
//
// Verbs for the jaw sensor: one that simulates it, and those that calibrate a real one. [main]
#pragma once

#include <string>

namespace swage::tools {

struct SimulateSensorOptions {
  std::string link;               // name at which it can be found, "" for that of the terminal
  std::string script = "breathe";  // "breathe", or a file of rows "s, V"
  std::string serial = "SIM1";
  double rate_hz = 200, seconds = 0;  // 0: until Ctrl-C
  double drift = 0, burst_s = 0;
  unsigned corrupt_each = 0, lose_each = 0;
  double unplug_each_s = 0;  // s between two unplugs of a second each, 0: never
  bool grip = false;
};
int simulate_sensor(const SimulateSensorOptions&);

struct CalibrateOptions {
  std::string port, by, serial, name, table, file;
  int bits_per_s = 115200;
  double nominal_mm_per_v = 1;
  int valid_days = 365;
  double a_mm = 0, b_mm = 0, gap_mm = 0;  // geometry of the handle
  double seconds = 0.5;                   // for which one value is averaged
  double tip_N = 0.6, ratio = 0.2;        // of a check: force at the tips, and per force at the handle where no table tells it
  bool force_anyway = false, json = false;
};
/// Volts to length: from a table "mm, V", or point by point with the sensor.
int calibrate_displacement(const CalibrateOptions&);
/// Travel to force: a table "mm, N", or point by point with the sensor.
int calibrate_force(const CalibrateOptions&);
/// Force at the handle to force at the tips: a table "N, N", or point by point with sensor and gauge.
int calibrate_tip(const CalibrateOptions&);
/// One force at the tips, on a gauge with a real needle, against the calibration.
int calibrate_check(const CalibrateOptions&);
/// Open, just closed, squeezed: with the sensor.
int calibrate_poses(const CalibrateOptions&);
/// The handle let go: the stored poses move to where it rests, and a gauge reads nothing there.
int calibrate_zero(const CalibrateOptions&);
/// What is stored.
int calibrate_show(const CalibrateOptions&);

}  // namespace swage::tools
