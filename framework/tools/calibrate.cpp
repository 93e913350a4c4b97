// SPDX-License-Identifier: Apache-2.0
//
// swage calibrate: what a jaw sensor's volts mean, asked of a bench or of a person with the needleholder in the hand.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "sensor/bench.hpp"
#include "sensor/calibration_file.hpp"
#include "tools/number_table.hpp"
#include "tools/print.hpp"
#include "tools/sensor_verbs.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using sensor::Calibration;

// a sensor that is asked for means, and waited for
class Bench {
 public:
  std::string open(const CalibrateOptions& o) {
    if (std::string why = bench_.open(o.port, o.bits_per_s); !why.empty()) return why;
    for (const double until = sensor::now_s() + 4; sensor::now_s() < until && !bench_.known(); pause()) bench_.listen(sensor::now_s());
    return bench_.known() ? "" : bench_.port() + " does not say who it is. Is it a sensor that speaks JAW1, and powered?";
  }
  std::string serial() const { return bench_.serial(); }
  std::string name() const { return bench_.name(); }

  /// Mean volts from now on. "" or why not.
  std::string mean(double seconds, double& volts) {
    for (bench_.begin(sensor::now_s(), seconds); bench_.measuring(); pause()) bench_.listen(sensor::now_s());
    return bench_.mean(volts);
  }

 private:
  static void pause() { base::sleep_until_ns(base::wall_ns() + 2'000'000); }
  sensor::Bench bench_;
};

bool ask(const std::string& question, std::string& answer) {
  std::printf("%s ", question.c_str());
  std::fflush(stdout);
  return static_cast<bool>(std::getline(std::cin, answer));
}

// the stored calibration of this sensor, or an empty one with its name
std::string begin(const CalibrateOptions& o, const std::string& serial, const std::string& name, Calibration& c, std::string& path) {
  path = o.file.empty() ? sensor::calibration_path(serial) : o.file;
  if (path.empty()) return "\"" + serial + "\" cannot name a file. Give a serial number of letters, digits, - _ and . with --serial.";
  if (std::FILE* there = std::fopen(path.c_str(), "re")) {
    std::fclose(there);
    if (std::string wrong = sensor::load_calibration(path, c); !wrong.empty()) return wrong;
  }
  c.serial = serial;
  if (!name.empty()) c.name = name;
  return "";
}

int keep(const std::string& path, const Calibration& c) {
  if (const std::string wrong = sensor::save_calibration(path, c); !wrong.empty()) return problem(wrong);
  std::printf("Kept in %s\n", printable(path).c_str());
  return kPassed;
}

int needs_who(const CalibrateOptions& o) {
  return o.by.empty() ? problem("Say who calibrates, with --by.") : kPassed;
}

// rows "mm, V" or "mm, N" from a person: the one is typed, the other measured
std::string rows_by_hand(const CalibrateOptions& o, Bench& bench, bool force, const Calibration& known,
                         std::vector<std::vector<double>>& rows) {
  std::printf(force ? "Close the jaws until they just meet and press Enter; that is travel 0. Then squeeze, type the force at the handle "
                      "in N for each point, and an empty line at the end.\n"
                    : "Draw the sensor to a length, type it in mm, 13 points over 6 mm; an empty line at the end.\n");
  double contact = 0;
  if (force) {
    std::string nothing;
    double volts = 0;
    if (!ask("just closed", nothing)) return "Nobody answers.";
    if (std::string why = bench.mean(o.seconds, volts); !why.empty()) return why;
    contact = known.displacement.length(volts);
  }
  for (std::string text; ask(force ? "force in N:" : "length in mm:", text) && !text.empty();) {
    std::vector<double> typed;
    double volts = 0;
    if (!read_numbers(text, typed) || typed.size() != 1) {
      std::printf("That is no number.\n");
      continue;
    }
    if (const std::string why = bench.mean(o.seconds, volts); !why.empty()) {
      std::printf("%s\n", why.c_str());
      continue;
    }
    const double mm = 1e3 * std::abs(contact - known.displacement.length(volts));  // whichever way it is mounted
    rows.push_back(force ? std::vector<double>{mm, typed[0]} : std::vector<double>{typed[0], volts});
    std::printf(force ? "  %.3f mm\n" : "  %.4f V\n", force ? mm : volts);
  }
  return "";
}

// where the numbers come from: a table, or a person with the sensor
std::string collect(const CalibrateOptions& o, bool force, Calibration& c, std::string& path, std::vector<std::vector<double>>& rows) {
  if (!o.table.empty()) {
    if (std::string wrong = read_number_table(o.table, 2, rows); !wrong.empty()) return wrong;
    if (o.serial.empty()) return "Say whose table this is: the sensor's serial number with --serial.";
    return begin(o, o.serial, o.name, c, path);
  }
  Bench bench;
  if (std::string why = bench.open(o); !why.empty()) return why;
  if (std::string why = begin(o, o.serial.empty() ? bench.serial() : o.serial, o.name.empty() ? bench.name() : o.name, c, path); !why.empty())
    return why;
  if (force && !c.displacement.valid()) return "Its volts have no meaning yet. First: swage calibrate displacement.";
  return rows_by_hand(o, bench, force, c, rows);
}

void print_points(const Calibration& c) {
  std::printf("%10s %10s %12s\n", "mm", "V", "residual um");
  for (const auto& p : c.displacement.points)
    std::printf("%10.3f %10.4f %12.1f%s\n", 1e3 * p.length_m, p.volts, 1e6 * p.residual_m, p.used ? "" : "   left out: beyond the stroke");
  std::printf("%.5f mm/V, %.4f mm at 0 V, worst residual %.1f um, rms %.1f um\n", 1e3 * c.displacement.slope,
              1e3 * c.displacement.offset, 1e6 * c.displacement.worst, 1e6 * c.displacement.rms);
}

}  // namespace

int calibrate_displacement(const CalibrateOptions& o) {
  if (needs_who(o) != kPassed) return kProblem;
  Calibration c;
  std::string path;
  std::vector<std::vector<double>> rows;
  if (const std::string wrong = collect(o, false, c, path, rows); !wrong.empty()) return problem(wrong);
  std::vector<sensor::BenchPoint> points;
  for (const auto& row : rows) points.push_back({row[1], 1e-3 * row[0]});
  sensor::FitLimits limits;
  limits.nominal = 1e-3 * o.nominal_mm_per_v;
  sensor::Displacement fit;
  if (const std::string wrong = sensor::fit_displacement(points, limits, fit); !wrong.empty()) {
    problem(wrong + " Nothing is kept.");
    return kNotPassed;
  }
  c.displacement = fit;
  c.by = o.by;
  c.date = sensor::today();
  c.expires = sensor::days_after(c.date, o.valid_days);
  c.poses = {};  // in lengths of the fit before
  print_points(c);
  return keep(path, c);
}

int calibrate_force(const CalibrateOptions& o) {
  if (needs_who(o) != kPassed) return kProblem;
  Calibration c;
  std::string path;
  std::vector<std::vector<double>> rows;
  if (const std::string wrong = collect(o, true, c, path, rows); !wrong.empty()) return problem(wrong);
  if (!c.displacement.valid()) return problem("Its volts have no meaning yet. First: swage calibrate displacement.");
  std::vector<sensor::MonotoneCurve::Point> points;
  for (const auto& row : rows) points.push_back({1e-3 * row[0], row[1]});
  if (const std::string wrong = c.force.set(points); !wrong.empty()) {
    problem(wrong + " Nothing is kept.");
    return kNotPassed;
  }
  std::printf("%10s %10s\n", "mm", "N");
  for (double mm = 0; mm <= 1e3 * points.back().x + 1e-9; mm += 100 * points.back().x) std::printf("%10.3f %10.3f\n", mm, c.force.value(1e-3 * mm));
  return keep(path, c);
}

int calibrate_poses(const CalibrateOptions& o) {
  Bench bench;
  Calibration c;
  std::string path;
  if (const std::string why = bench.open(o); !why.empty()) return problem(why);
  if (const std::string why = begin(o, bench.serial(), "", c, path); !why.empty()) return problem(why);
  if (!c.displacement.valid()) return problem("Its volts have no meaning yet. First: swage calibrate displacement.");
  if (o.a_mm > 0) c.geometry = {1e-3 * o.a_mm, 1e-3 * o.b_mm, 1e-3 * o.gap_mm};
  const sensor::Poses before = c.poses;
  double* const pose[] = {&c.poses.open, &c.poses.closed, &c.poses.squeezed};
  const char* const how[] = {"Let the handle go and press Enter (open).", "Close until the jaws just meet and press Enter (closed).",
                             "Squeeze the handle as far as it goes and press Enter (squeezed)."};
  for (int i = 0; i < 3; ++i) {
    std::string nothing;
    double volts = 0;
    if (!ask(how[i], nothing)) return problem("Nobody answers; nothing is kept.");
    if (const std::string why = bench.mean(o.seconds, volts); !why.empty()) return problem(why + " Nothing is kept.");
    *pose[i] = c.displacement.length(volts);
    std::printf("  %.3f mm\n", 1e3 * *pose[i]);
  }
  std::string wrong = sensor::check_poses(c.poses, o.force_anyway ? sensor::Poses{} : before);
  if (wrong.empty()) wrong = sensor::check_geometry(c.geometry, c.poses);
  if (!wrong.empty()) {
    problem(wrong + " Nothing is kept.");
    return kNotPassed;
  }
  c.poses_date = sensor::today();
  return keep(path, c);
}

int calibrate_show(const CalibrateOptions& o) {
  auto list = nlohmann::ordered_json::array();
  int worst = kPassed;
  for (const std::string& path : sensor::calibration_files()) {
    Calibration c;
    const std::string wrong = sensor::load_calibration(path, c);
    if (!wrong.empty()) {
      worst = problem(wrong);
      continue;
    }
    if (!o.serial.empty() && c.serial != o.serial) continue;
    const std::string trouble = sensor::calibration_trouble(c, "", sensor::today());
    list.push_back({{"serial", c.serial}, {"name", c.name}, {"date", c.date}, {"by", c.by}, {"expires", c.expires},
                    {"worst", number(c.displacement.worst)}, {"force_points", c.force.points().size()},
                    {"poses_date", c.poses_date}, {"trouble", trouble}, {"file", path}});
    if (o.json) continue;
    std::printf("%s (%s): %s by %s, until %s; worst residual %.1f um; %zu points of force; poses %s\n", printable(c.serial).c_str(),
                printable(c.name).c_str(), c.date.c_str(), printable(c.by).c_str(), c.expires.c_str(), 1e6 * c.displacement.worst,
                c.force.points().size(), c.poses.known() ? ("of " + c.poses_date).c_str() : "missing: swage calibrate poses");
    if (!trouble.empty()) std::printf("  %s\n", printable(trouble).c_str());
  }
  if (o.json) print(list);
  if (!o.json && list.empty()) std::printf("No calibration is kept in %s\n", printable(sensor::calibration_folder()).c_str());
  return worst;
}

}  // namespace swage::tools
