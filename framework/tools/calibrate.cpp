// SPDX-License-Identifier: Apache-2.0
//
// swage calibrate: calibration of a jaw sensor, from a table or with a person who holds the needleholder.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "sensor/bench.hpp"
#include "sensor/calibration_file.hpp"
#include "tools/sentences.hpp"
#include "tools/number_table.hpp"
#include "tools/print.hpp"
#include "tools/sensor_verbs.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using sensor::Calibration;

// a sensor whose voltage is averaged; waits for the result
class Bench {
 public:
  std::string open(const CalibrateOptions& o) {
    if (std::string why = bench_.open(o.port, o.bits_per_s); !why.empty()) return why;
    for (const double until = sensor::now_s() + 4; sensor::now_s() < until && !bench_.known(); pause()) bench_.listen(sensor::now_s());
    return bench_.known() ? "" : say::kSaysNotWho(bench_.port());
  }
  std::string serial() const { return bench_.serial(); }
  std::string name() const { return bench_.name(); }
  std::optional<double> gauge() const { return bench_.gauge(); }

  /// Mean voltage over the next `seconds`. "" or the reason of a failure.
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
  if (path.empty()) return say::kCannotName(serial);
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
  return o.by.empty() ? problem(say::kSayWho()) : kPassed;
}

// quantity of a table, and the instruction for a person
enum class Of { kLength, kHandle, kTip };
constexpr const char* kIntroduction[] = {
    "Draw the sensor to a length, type it in mm, 13 points over 6 mm; an empty line at the end.\n",
    "Close the jaws until they just meet and press Enter; that is travel 0. Then squeeze, type the force at the handle in N for each point, "
    "and an empty line at the end.\n",
    "Close the tips until they just touch the gauge and press Enter. Then squeeze, type the force that the gauge shows in N for each point, "
    "and an empty line at the end.\n"};
constexpr const char* kQuestion[] = {"length in mm:", "force in N:", "force at the tips in N:"};

// length of the sensor at which the jaws touch, m; "" or the reason of a failure
std::string contact_by_hand(const CalibrateOptions& o, Bench& bench, const Calibration& known, const char* question, double& contact) {
  std::string nothing;
  double volts = 0;
  if (!ask(question, nothing)) return say::kNobodyAnswers();
  if (std::string why = bench.mean(o.seconds, volts); !why.empty()) return why;
  contact = known.displacement.length(volts);
  return "";
}

// force at the handle beyond that which closes it, N; the sensor may be mounted either way round
double handle_force(const Calibration& known, double contact, double volts) {
  return known.force.value(std::abs(contact - known.displacement.length(volts))) - known.force.value(0);
}

// rows "mm, V", "mm, N" or "N, N" from a person: one number is typed, the other measured
std::string rows_by_hand(const CalibrateOptions& o, Bench& bench, Of of, const Calibration& known, std::vector<std::vector<double>>& rows) {
  std::printf("%s", kIntroduction[static_cast<int>(of)]);
  double contact = 0;
  if (of != Of::kLength)
    if (std::string why = contact_by_hand(o, bench, known, "just closed", contact); !why.empty()) return why;
  for (std::string text; ask(kQuestion[static_cast<int>(of)], text) && !text.empty();) {
    std::vector<double> typed;
    double volts = 0;
    if (!read_numbers(text, typed) || typed.size() != 1) {
      std::printf("%s\n", say::kTypedNoNumber().c_str());
      continue;
    }
    if (const std::string why = bench.mean(o.seconds, volts); !why.empty()) {
      std::printf("%s\n", why.c_str());
      continue;
    }
    const double mm = 1e3 * std::abs(contact - known.displacement.length(volts));  // whichever way it is mounted
    const double handle = of == Of::kTip ? handle_force(known, contact, volts) : 0;
    rows.push_back(of == Of::kLength ? std::vector<double>{typed[0], volts} : std::vector<double>{of == Of::kTip ? handle : mm, typed[0]});
    std::printf(of == Of::kLength ? "  %.4f V\n" : of == Of::kTip ? "  %.3f N at the handle\n" : "  %.3f mm\n",
                of == Of::kLength ? volts : of == Of::kTip ? handle : mm);
  }
  return "";
}

// the calibration that must come first and is missing, or ""
std::string lacks(Of of, const Calibration& c) {
  if (of != Of::kLength && !c.displacement.valid()) return say::kVoltsFirst();
  return of == Of::kTip && c.force.empty() ? say::kTravelFirst() : "";
}

// reads the rows from a table, or from a person with the sensor
std::string collect(const CalibrateOptions& o, Of of, Calibration& c, std::string& path, std::vector<std::vector<double>>& rows) {
  if (!o.table.empty()) {
    if (std::string wrong = read_number_table(o.table, 2, rows); !wrong.empty()) return wrong;
    if (o.serial.empty()) return say::kWhoseTable();
    return begin(o, o.serial, o.name, c, path);
  }
  Bench bench;
  if (std::string why = bench.open(o); !why.empty()) return why;
  if (std::string why = begin(o, o.serial.empty() ? bench.serial() : o.serial, o.name.empty() ? bench.name() : o.name, c, path); !why.empty())
    return why;
  if (std::string missing = lacks(of, c); !missing.empty()) return missing;
  return rows_by_hand(o, bench, of, c, rows);
}

int not_kept(const std::string& wrong) {
  problem(wrong + say::kNothingKept());
  return kNotPassed;
}

// prints a curve in eleven rows; `scale`: factor of x for the unit shown
void print_curve(const sensor::MonotoneCurve& curve, double scale, const char* unit) {
  std::printf("%12s %10s\n", unit, "N");
  const double last = curve.points().back().x;
  for (int i = 0; i <= 10; ++i) std::printf("%12.3f %10.3f\n", 0.1 * i * scale * last, curve.value(0.1 * i * last));
}

void print_points(const Calibration& c) {
  std::printf("%10s %10s %12s\n", "mm", "V", "residual um");
  for (const auto& p : c.displacement.points)
    std::printf("%10.3f %10.4f %12.1f%s\n", 1e3 * p.length_m, p.volts, 1e6 * p.residual_m, p.used ? "" : "   left out: beyond the stroke");
  std::printf("%s, worst residual %.1f um, rms %.1f um\n",
              say::kSlope(format("%.5f", 1e3 * c.displacement.slope), format("%.4f", 1e3 * c.displacement.offset)).c_str(), 1e6 * c.displacement.worst, 1e6 * c.displacement.rms);
}

}  // namespace

int calibrate_displacement(const CalibrateOptions& o) {
  if (needs_who(o) != kPassed) return kProblem;
  Calibration c;
  std::string path;
  std::vector<std::vector<double>> rows;
  if (const std::string wrong = collect(o, Of::kLength, c, path, rows); !wrong.empty()) return problem(wrong);
  std::vector<sensor::BenchPoint> points;
  for (const auto& row : rows) points.push_back({row[1], 1e-3 * row[0]});
  sensor::FitLimits limits;
  limits.nominal = 1e-3 * o.nominal_mm_per_v;
  sensor::Displacement fit;
  if (const std::string wrong = sensor::fit_displacement(points, limits, fit); !wrong.empty()) {
    return not_kept(wrong);
  }
  c.displacement = fit;
  c.by = o.by;
  c.date = sensor::today();
  c.expires = sensor::days_after(c.date, o.valid_days);
  c.poses = {};  // they refer to the lengths of the former fit
  print_points(c);
  return keep(path, c);
}

int calibrate_force(const CalibrateOptions& o) {
  if (needs_who(o) != kPassed) return kProblem;
  Calibration c;
  std::string path;
  std::vector<std::vector<double>> rows;
  if (std::string wrong = collect(o, Of::kHandle, c, path, rows); !wrong.empty() || !(wrong = lacks(Of::kHandle, c)).empty()) return problem(wrong);
  std::vector<sensor::MonotoneCurve::Point> points;
  for (const auto& row : rows) points.push_back({1e-3 * row[0], row[1]});
  std::string wrong = sensor::check_table_size(points.size());
  if (wrong.empty()) wrong = c.force.set(points);
  if (!wrong.empty()) return not_kept(wrong);
  c.tip = {}, c.check = {};  // they refer to the forces of the former table
  print_curve(c.force, 1e3, "mm");
  return keep(path, c);
}

int calibrate_tip(const CalibrateOptions& o) {
  if (needs_who(o) != kPassed) return kProblem;
  Calibration c;
  std::string path;
  std::vector<std::vector<double>> rows;
  if (std::string wrong = collect(o, Of::kTip, c, path, rows); !wrong.empty() || !(wrong = lacks(Of::kTip, c)).empty()) return problem(wrong);
  std::vector<sensor::MonotoneCurve::Point> points;
  for (const auto& row : rows) points.push_back({row[0], row[1]});
  std::string wrong = sensor::check_table_size(points.size());
  if (wrong.empty()) wrong = sensor::set_tip(points, c.tip);
  if (!wrong.empty()) return not_kept(wrong);
  c.check = {};
  print_curve(c.tip, 1, "N, handle");
  return keep(path, c);
}

int calibrate_check(const CalibrateOptions& o) {
  Bench bench;
  Calibration c;
  std::string path;
  if (const std::string why = bench.open(o); !why.empty()) return problem(why);
  if (const std::string why = begin(o, bench.serial(), "", c, path); !why.empty()) return problem(why);
  if (const std::string missing = lacks(Of::kTip, c); !missing.empty()) return problem(missing);
  double contact = 0, volts = 0;
  if (std::string why = contact_by_hand(o, bench, c, "Close the jaws until they just touch the needle and press Enter (touching).", contact); !why.empty())
    return problem(why + say::kNothingKept());
  std::string nothing;
  if (!ask(format("Squeeze until the gauge shows %.2f N at the tips, hold, and press Enter.", o.tip_N), nothing))
    return problem(say::kNobodyKeeps());
  if (const std::string why = bench.mean(o.seconds, volts); !why.empty()) return problem(why + say::kNothingKept());
  const double handle = handle_force(c, contact, volts);
  c.check = {o.tip_N, c.tip.empty() ? o.ratio * handle : c.tip.value(handle), sensor::today()};
  std::printf("%s\n", say::kTipForces(format("%.3f", c.check.measured), format("%.3f", c.check.wanted)).c_str());
  // a check that fails is kept as well: the user of the calibration is warned
  const std::string wrong = sensor::check_tip(c.check);
  if (!wrong.empty()) problem(wrong);
  const int kept = keep(path, c);
  return kept == kPassed && !wrong.empty() ? kNotPassed : kept;
}

int calibrate_poses(const CalibrateOptions& o) {
  Bench bench;
  Calibration c;
  std::string path;
  if (const std::string why = bench.open(o); !why.empty()) return problem(why);
  if (const std::string why = begin(o, bench.serial(), "", c, path); !why.empty()) return problem(why);
  if (!c.displacement.valid()) return problem(say::kVoltsFirst());
  if (o.a_mm > 0) c.geometry = {1e-3 * o.a_mm, 1e-3 * o.b_mm, 1e-3 * o.gap_mm};
  const sensor::Poses before = c.poses;
  double* const pose[] = {&c.poses.open, &c.poses.closed, &c.poses.squeezed};
  const char* const how[] = {"Let the handle go and press Enter (open).", "Close until the jaws just meet and press Enter (closed).",
                             "Squeeze the handle as far as it goes and press Enter (squeezed)."};
  for (int i = 0; i < 3; ++i) {
    std::string nothing;
    double volts = 0;
    if (!ask(how[i], nothing)) return problem(say::kNobodyKeeps());
    if (const std::string why = bench.mean(o.seconds, volts); !why.empty()) return problem(why + say::kNothingKept());
    *pose[i] = c.displacement.length(volts);
    std::printf("  %.3f mm\n", 1e3 * *pose[i]);
  }
  std::string wrong = sensor::check_poses(c.poses, o.force_anyway ? sensor::Poses{} : before);
  if (wrong.empty()) wrong = sensor::check_geometry(c.geometry, c.poses);
  if (!wrong.empty()) {
    return not_kept(wrong);
  }
  c.poses_date = sensor::today(), c.zero_date.clear();
  return keep(path, c);
}

int calibrate_zero(const CalibrateOptions& o) {
  Bench bench;
  Calibration c;
  std::string path, nothing;
  if (const std::string why = bench.open(o); !why.empty()) return problem(why);
  if (const std::string why = begin(o, bench.serial(), "", c, path); !why.empty()) return problem(why);
  double volts = 0;
  if (!ask("Let the handle go and press Enter (let go).", nothing)) return problem(say::kNobodyKeeps());
  if (const std::string why = bench.mean(o.seconds, volts); !why.empty()) return problem(why + say::kNothingKept());
  const double before = c.poses.open;
  if (const std::string wrong = sensor::set_zero(c.displacement.length(volts), c.poses); !wrong.empty()) return not_kept(wrong);
  std::printf("  %s\n", say::kPosesMoved(format("%.3f", 1e3 * (c.poses.open - before))).c_str());
  c.zero_date = sensor::today();
  c.gauge_zero = bench.gauge().value_or(c.gauge_zero);
  if (bench.gauge()) std::printf("  the gauge reads %.2f N, which is nothing from now on\n", *bench.gauge());
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
                    {"worst", number(c.displacement.worst)}, {"force_points", c.force.points().size()}, {"tip_points", c.tip.points().size()},
                    {"check_date", c.check.date}, {"check_share", number(c.check.known() ? c.check.measured / c.check.wanted - 1 : 0)},
                    {"poses_date", c.poses_date}, {"zero_date", c.zero_date}, {"trouble", trouble}, {"file", path}});
    if (o.json) continue;
    std::printf("%s (%s): %s by %s, until %s; worst residual %.1f um; %zu points of force, %zu at the tips; %s; poses %s\n", printable(c.serial).c_str(),
                printable(c.name).c_str(), c.date.c_str(), printable(c.by).c_str(), c.expires.c_str(), 1e6 * c.displacement.worst,
                c.force.points().size(), c.tip.points().size(),
                c.check.known() ? format("%.2f N checked on %s: %+.0f %%", c.check.wanted, c.check.date.c_str(), 1e2 * (c.check.measured / c.check.wanted - 1)).c_str()
                                : "not checked on a gauge",
                c.poses.known() ? ("of " + c.poses_date).c_str() : "missing: swage calibrate poses");
    if (!trouble.empty()) std::printf("  %s\n", printable(trouble).c_str());
  }
  if (o.json) print(list);
  if (!o.json && list.empty()) std::printf("%s\n", say::kNoneKept(printable(sensor::calibration_folder())).c_str());
  return worst;
}

}  // namespace swage::tools
