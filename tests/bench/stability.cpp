// SPDX-License-Identifier: Apache-2.0
#include "stability.hpp"

#include "insertion.hpp"
#include "own.hpp"
#include "queries.hpp"

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace swage::bench {
namespace {

using nlohmann::json;

constexpr double kLost = std::numeric_limits<double>::infinity();

/// "values_um" -> 1e6 display units per SI unit.
double scale_of(const std::string& suffix) {
  static const std::pair<const char*, double> kScales[] = {
      {"", 1},           {"_um", 1e6},      {"_mm", 1e3},       {"_ms", 1e3},
      {"_N", 1},         {"_s", 1},         {"_per_m", 1},      {"_g", 1e3},
      {"_kg", 1},        {"_m_per_s", 1},   {"_mm_per_s", 1e3}, {"_deg", 180 / std::numbers::pi},
      {"_rad_per_s", 1}, {"_percent", 100}, {"_kPa", 1e-3}};
  for (const auto& [name, scale] : kScales)
    if (suffix == name) return scale;
  throw std::runtime_error("unknown unit suffix \"" + suffix + "\"");
}

/// Finds `stem` with any unit suffix; true when there.
bool find(const json& j, const std::string& stem, json& value, double& scale) {
  for (const auto& [key, v] : j.items()) {
    if (key.rfind(stem, 0) != 0 || (key.size() > stem.size() && key[stem.size()] != '_')) continue;
    value = v, scale = scale_of(key.substr(stem.size()));
    return true;
  }
  return false;
}

double in_si(const json& j, const std::string& stem, double otherwise) {
  json v;
  double scale = 1;
  return find(j, stem, v, scale) ? v.get<double>() / scale : otherwise;
}

Axis axis(const json& j) {
  Axis a;
  a.label = j.at("label");
  a.low = j.at("axis").at(0), a.high = j.at("axis").at(1);
  a.logarithmic = !j.value("linear", false);
  a.above = j.value("above", "");
  return a;
}

/// Worst slip of a hold in um, or lost.
double slip(const HoldResult& r) { return r.lost_at < 0 ? r.worst : kLost; }

/// How far a ratio that should be 1 is from it.
double off_by(double ratio) { return std::isfinite(ratio) && ratio > 0 ? std::abs(ratio - 1) : kLost; }

Setup setup_of(const StabilityScene& s) {
  Setup setup;
  setup.needle.straight = s.straight;
  setup.needle.wire_diameter = s.wire;
  setup.jaw_mass = s.jaw_mass;
  return setup;
}

/// A hold with something about it swept; NaN when the scenario is none.
double held(const StabilityScene& s, const Method& m, double value) {
  Setup setup = setup_of(s);
  Needle& n = setup.needle;
  constexpr double kOverlap = 1e-6;  // m, a light grasp
  if (s.scenario == "hold") return slip(hold(m, setup, value, s.seconds));
  if (s.scenario == "hold_moving") return slip(hold(m, setup, value, s.seconds, Tool::kMoving));
  if (s.scenario == "hold_noise") return slip(hold(m, setup, kOverlap, s.seconds, Tool::kStill, value));
  if (s.scenario == "hold_late") return slip(hold(m, setup, kOverlap, s.seconds, Tool::kLate, value));
  if (s.scenario == "hold_mass")
    n.density *= value / n.mass();
  else if (s.scenario == "hold_misaligned")
    setup.misaligned = value;
  else if (s.scenario == "hold_at")
    n.held_at = n.arc * (value - 0.5);
  else if (s.scenario == "hold_scale")
    // lengths times `value`: masses grow with its cube, gravity stays, as it does not in another unit
    setup.unit = value, n.density *= value * value * value, setup.gravity /= value;
  else
    return std::numeric_limits<double>::quiet_NaN();
  return slip(hold(m, setup, kOverlap, s.seconds));
}

/// The measure of one scenario at one value of the sweep, SI.
double measure(const StabilityScene& s, const Method& m, double value) {
  if (s.scenario.rfind("hold", 0) == 0) return held(s, m, value);
  const Setup setup = setup_of(s);
  const auto onset = [&](Pull p) { return off_by(pull(m, setup, value, p).onset); };
  if (s.scenario == "pull_axial") return onset(Pull::kAxial);
  if (s.scenario == "pull_about_wire") return onset(Pull::kAboutWire);
  if (s.scenario == "pull_about_normal") return onset(Pull::kAboutNormal);
  if (s.scenario == "shoot_flat") return tunnelled(m, setup, value, Shot::kFlat) / 16.0;
  if (s.scenario == "shoot_edge") return tunnelled(m, setup, value, Shot::kEdge) / 16.0;
  if (s.scenario == "shoot_spin") return tunnelled(m, setup, value, Shot::kSpin) / 16.0;
  if (s.scenario == "close") {
    const CloseResult r = close_on(m, setup, value);
    return r.through ? kLost : r.fastest / value;
  }
  if (s.scenario == "top") {
    const Vec3 w0 = value * Vec3(0.01, 1, 0.01).normalized();
    return top(m, setup, {1e-12, 2e-12, 3e-12}, w0, s.seconds).energy;
  }
  if (s.scenario == "units") return unit_error(m, value);
  if (s.scenario == "repeat") return repeat_error(m, value);
  if (s.scenario == "flip") return off_by(flip_friction(m, value));
  if (s.scenario == "wedge") return off_by(wedge_angle(m, value));
  if (s.scenario == "drag") return drag_ripple(m, value);
  if (s.scenario == "carried") return carried_error(m, value);
  if (s.scenario == "bounce") return bounce_error(m, setup, value, s.restitution, s.radius);
  throw std::runtime_error(s.file + " /scenario: \"" + s.scenario + "\" is unknown");
}

/// One method through the sweep; stops where it broke.
Sweep::Line run_line(const StabilityScene& s, const Method& m) {
  Sweep::Line line{m.family, m.name, {}, false};
  if (s.scenario == "pinch") {
    for (const PinchStage& stage : pinch(m, setup_of(s), s.approach))
      line.points.push_back({stage.grip * s.value_scale, stage.overlap * s.measure_scale});
    constexpr double kLast = 16;  // N
    line.broke = line.points.empty() || line.points.back().first < kLast;
    if (line.broke) line.points.push_back({line.points.empty() ? 1e-3 : 4 * line.points.back().first, kLost});
    return line;
  }
  for (double value : s.values) {
    const double y = measure(s, m, value);
    line.points.push_back({value * s.value_scale, y * s.measure_scale});
    line.broke = !std::isfinite(y);
    if (line.broke) break;
  }
  return line;
}

/// Beyond a mark somewhere up to `range`.
bool exceeds(const StabilityScene& s, const Sweep::Line& line, double mark) {
  for (const auto& [x, y] : line.points)
    if (x <= s.range * s.value_scale * 1.0001 && !(y <= mark)) return true;
  return false;
}
bool exceeds(const StabilityScene& s, const Sweep::Line& line) { return exceeds(s, line, s.pass); }

void read_sweep(const json& sweep, bool quick, StabilityScene& s) {
  json list;
  if (find(sweep, "values", list, s.value_scale)) {
    double scale;
    json few;
    if (quick && find(sweep, "quick", few, scale)) list = few;
    for (double v : list.get<std::vector<double>>()) s.values.push_back(v / s.value_scale);
  } else if (s.scenario != "pinch") {
    throw std::runtime_error("/sweep/values_<unit> is missing");
  }
}

}  // namespace

StabilityScene read_scene(const std::string& file, bool quick) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  StabilityScene s;
  try {
    const json j = json::parse(in);
    s.file = file, s.id = j.at("id"), s.title = j.at("title"), s.scenario = j.at("scenario");
    s.seconds = quick ? j.value("quick_seconds", 1.0) : j.value("seconds", 1.0);
    s.straight = j.value("needle", "") == "straight";
    s.shots = quick ? j.value("quick_shots", s.shots) : j.value("shots", s.shots);
    s.poses = quick ? j.value("quick_poses", 500) : j.value("poses", 10000);
    s.jaw_mass = in_si(j, "jaw", s.jaw_mass);
    s.approach = in_si(j, "approach", 0);
    s.restitution = j.value("restitution", 0.0);
    s.radius = in_si(j, "radius", s.radius);
    s.wire = in_si(j, "wire", s.wire);
    const json& sweep = j.at("sweep");
    read_sweep(sweep, quick, s);
    json pass;
    if (!find(j, "pass", pass, s.measure_scale)) throw std::runtime_error("/pass is missing");
    s.pass = pass.get<double>();
    s.range = in_si(j, "range", s.range);
    s.must_fail = j.at("must_fail").get<std::vector<std::string>>();
    s.open = j.value("open", "");
    s.also = j.value("also", std::vector<std::string>());
    s.also_open = j.value("also_open", "");
    json reach;
    double scale;
    if (find(j, "also_reach", reach, scale)) s.also_reach = reach.get<std::map<std::string, double>>();
    if (s.also_open.empty() != s.also_reach.empty()) throw std::runtime_error("/also_open and /also_reach_<unit> go together");
    s.chart.title = s.id + "  " + s.title;
    s.chart.x = axis(sweep), s.chart.y = axis(j.at("measure"));
    s.chart.pass = s.pass;
    s.chart.range = s.range < 1e300 ? s.range * s.value_scale : 0;
  } catch (const std::exception& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
  return s;
}

namespace {

bool is_default(const Sweep::Line& line) {
  return line.family == "swage" && (line.name == "swage" || line.name == "swage, exact arc");
}
bool must_fail(const StabilityScene& s, const std::string& name) {
  return std::find(s.must_fail.begin(), s.must_fail.end(), name) != s.must_fail.end();
}
bool must_hold(const StabilityScene& s, const std::string& name) {
  return std::find(s.also.begin(), s.also.end(), name) != s.also.end();
}

/// Our default, whoever is expected to fail, and the best peers.
std::vector<Sweep::Line> method_lines(const StabilityScene& s) {
  const bool on_hinge = s.scenario == "pinch" || s.scenario == "flip" || s.scenario == "drag" ||
                        s.scenario.rfind("pull", 0) == 0;
  std::vector<Sweep::Line> lines;
  for (const Method& m : all_methods()) {
    const bool best_peer =
        m.name == "ODE exact, soft contacts" || (m.name == "MuJoCo tuned, welded tool" && !on_hinge);
    if (m.name == "swage" || must_fail(s, m.name) || must_hold(s, m.name) || best_peer)
      lines.push_back(run_line(s, m));
  }
  return lines;
}

/// Every query; the sweep's values are wire diameters (S02) or overlaps (S03).
std::vector<Sweep::Line> query_lines(const StabilityScene& s) {
  std::vector<Sweep::Line> lines;
  for (const Query& q : all_queries(Needle{})) lines.push_back({q.family, q.name, {}, false});
  for (double value : s.values) {
    std::vector<double> measured;
    if (s.scenario == "query_overlap") {
      measured = overlap_errors(value);
    } else {
      Needle n;
      n.wire_diameter = value;
      for (const QueryFigures& f : measure_queries(n, 1, s.poses))
        measured.push_back(static_cast<double>(f.missed + f.invented) / (f.overlapping + f.apart));
    }
    for (size_t q = 0; q < lines.size(); ++q) {
      if (lines[q].broke) continue;
      lines[q].points.push_back({value * s.value_scale, measured[q] * s.measure_scale});
      lines[q].broke = !std::isfinite(measured[q]);
    }
  }
  return lines;
}

/// Our ways of a needle through tissue; no peer has one.
std::vector<Sweep::Line> insertion_lines(const StabilityScene& s) {
  std::vector<Sweep::Line> lines;
  for (const InsertionMethod& m : insertion_methods()) {
    const bool level = m.name.rfind("swage, level", 0) == 0;
    if (m.name != "swage" && !level && !must_fail(s, m.name)) continue;
    Sweep::Line line{m.family, m.name, {}, false};
    for (const double value : s.values) {
      const double y = insertion_error(s.scenario, m.name, value);
      line.points.push_back({value * s.value_scale, y * s.measure_scale});
      line.broke = !std::isfinite(y);
      if (line.broke) break;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// The solver's own questions, by what it is made of; no peer is asked.
std::vector<Sweep::Line> own_lines(const StabilityScene& s) {
  std::vector<Sweep::Line> lines;
  for (const OwnMethod& m : own_methods(s.scenario)) {
    Sweep::Line line{m.family, m.name, {}, false};
    for (const double value : s.values) {
      const double y = m.measure(value, s.shots);
      line.points.push_back({value * s.value_scale, y * s.measure_scale});
      line.broke = !std::isfinite(y);
      if (line.broke) break;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Whether a method of that name can be here: ours always, a peer's when it is compiled in.
bool known_family(const std::string& name) {
  const auto starts = [&](const char* family) { return name.rfind(family, 0) == 0; };
  return starts("swage") || (starts("ODE") && !ode_methods().empty()) ||
         (starts("MuJoCo") && !mujoco_methods().empty()) || (starts("Bullet") && !bullet_methods().empty()) ||
         (starts("FCL") && !fcl_queries(Needle{}).empty());
}

}  // namespace

StabilityResult run_scene(const StabilityScene& s) {
  StabilityResult r;
  r.chart = s.chart;
  r.chart.lines = s.scenario.rfind("query", 0) == 0 ? query_lines(s)
                  : is_insertion(s.scenario)        ? insertion_lines(s)
                  : is_own(s.scenario)              ? own_lines(s)
                                                    : method_lines(s);
  bool rivals = false;  // is any method here that is expected to fail? peers may not be installed
  for (const Sweep::Line& line : r.chart.lines) {
    const bool failed = exceeds(s, line), expected = must_fail(s, line.name);
    rivals = rivals || expected;
    if (is_default(line)) {
      r.ours_passed = !failed;
      if (failed && s.open.empty())
        r.remarks.push_back(s.id + ": our default goes beyond the pass mark in the range a lesson can reach");
      if (!failed && !s.open.empty())
        r.remarks.push_back(s.id + ": holds now; take \"open\" out of " + s.file);
    } else if (must_hold(s, line.name)) {
      if (failed == s.also_open.empty())
        r.remarks.push_back(s.id + ": " + line.name +
                            (failed ? " goes beyond the pass mark" : " holds now; take \"also_open\" out"));
      if (const auto reach = s.also_reach.find(line.name); reach != s.also_reach.end() && exceeds(s, line, reach->second))
        r.remarks.push_back(s.id + ": " + line.name + " goes beyond \"also_reach\", what it is known to come to");
    } else if (failed) {
      r.someone_failed = true;
    } else if (expected) {
      r.remarks.push_back(s.id + ": " + line.name + " was expected to fail and did not");
    }
  }
  std::vector<std::string> named = s.must_fail;
  named.insert(named.end(), s.also.begin(), s.also.end());
  for (const std::string& name : named)
    if (known_family(name) && std::none_of(r.chart.lines.begin(), r.chart.lines.end(),
                                           [&](const auto& l) { return l.name == name; }))
      r.remarks.push_back(s.id + ": no method has the name " + name);
  if (rivals && !r.someone_failed)
    r.remarks.push_back(s.id + ": no method fails here, so nothing shows that the scene can be failed");
  return r;
}

}  // namespace swage::bench
