// SPDX-License-Identifier: Apache-2.0
//
// swage simulate-sensor: simulates a jaw sensor on a pseudo terminal, for trials without hardware.
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "base/clock.hpp"
#include "sensor/sensor_link.hpp"
#include "sensor/simulated_sensor.hpp"
#include "tools/number_table.hpp"
#include "tools/print.hpp"
#include "tools/sensor_verbs.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

volatile sig_atomic_t interrupted = 0;

// voltage of a hand that opens and closes every four seconds, from 2 V open over -1 V just closed to -1.5 V, with some tremor
double breathe(double t) {
  const double turn = 2 * std::numbers::pi * t;
  return 0.25 + 1.75 * std::cos(turn / 4) + 0.005 * std::sin(9 * turn);
}

// linear interpolation between the rows; constant before the first and after the last
double between(const std::vector<std::vector<double>>& rows, double t) {
  const auto after = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row[0] > t; });
  if (after == rows.begin()) return rows.front()[1];
  if (after == rows.end()) return rows.back()[1];
  const auto& a = *(after - 1);
  const auto& b = *after;
  return a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0]);
}

}  // namespace

int simulate_sensor(const SimulateSensorOptions& o) {
  std::vector<std::vector<double>> rows;
  if (o.script != "breathe") {
    if (const std::string wrong = read_number_table(o.script, 2, rows); !wrong.empty()) return problem(wrong);
    for (std::size_t i = 1; i < rows.size(); ++i)
      if (rows[i][0] <= rows[i - 1][0]) return problem(o.script + ": time goes up from row to row; in row " + std::to_string(i + 1) + " it does not.");
  }
  sensor::SimulatedSensor::Options options;
  options.rate_hz = o.rate_hz;
  options.serial = o.serial;
  options.grip = o.grip;
  options.faults = {o.drift, o.burst_s, o.corrupt_each, o.lose_each};
  sensor::SimulatedSensor simulated(options, [&](double t) {
    const double volts = rows.empty() ? breathe(t) : between(rows, t);
    return sensor::SimulatedSensor::Measured{volts, std::max(0.0, -1 - volts) * 10, 0};
  });
  const std::string port = simulated.plug(o.link);
  if (port.empty()) return problem("There is no pseudo terminal" + (o.link.empty() ? std::string(".") : " to be had as " + o.link + "."));
  std::printf("%s\n", port.c_str());
  std::fflush(stdout);

  signal(SIGINT, [](int) { interrupted = 1; });
  signal(SIGTERM, [](int) { interrupted = 1; });
  const double begun = sensor::now_s();
  double next_unplug = o.unplug_each_s > 0 ? begun + o.unplug_each_s : 1e300;
  while (interrupted == 0 && (o.seconds <= 0 || sensor::now_s() < begun + o.seconds)) {
    const double now = sensor::now_s();
    if (now >= next_unplug && simulated.plugged()) simulated.unplug();
    if (now >= next_unplug + 1) {
      if (simulated.plug(o.link).empty()) return problem("The pseudo terminal cannot be made again.");
      next_unplug = now + o.unplug_each_s;
    }
    simulated.tick(now);
    base::sleep_until_ns(base::wall_ns() + 500'000);
  }
  return kPassed;
}

}  // namespace swage::tools
