// SPDX-License-Identifier: Apache-2.0
#include "bar.hpp"

namespace swage::bench {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

const Method* find(const std::vector<Method>& methods, const std::string& name) {
  for (const Method& m : methods)
    if (m.name == name) return &m;
  return nullptr;
}

Method ours() { return swage_methods().front(); }

/// Median of one hold step [ns], after the grasp has settled.
double hold_step_ns(const Method& m, const Setup& s) { return hold(m, s, 1e-6, 0.5).step.median; }

/// Ratio of medians, ours over the peer's, runs interleaved.
Line hold_ratio(const char* name, const Method* peer, double bound, const Effort& effort) {
  if (!peer) return unmeasured("G2", name, bound);
  std::vector<double> mine, theirs;
  for (int i = 0; i < effort.passes; ++i) {
    mine.push_back(hold_step_ns(ours(), {}));
    theirs.push_back(hold_step_ns(*peer, {}));
  }
  return ratio("G2", name, times(mine).median, times(theirs).median, bound);
}

double slip_um(const HoldResult& r) { return r.lost_at < 0 ? r.worst * kMicro : kInfinity; }

struct NamedNeedle {
  std::string name;
  Needle needle;
};
/// The ends of the range that must behave alike: 1/4 to 5/8 of a circle, 50 to 150 um.
std::vector<NamedNeedle> other_needles() {
  std::vector<NamedNeedle> all;
  for (const auto& [eighths, wire, chord] :
       {std::tuple{2, 50e-6, 3e-3}, {4, 70e-6, 3e-3}, {5, 100e-6, 4e-3}, {3, 150e-6, 6e-3}}) {
    Needle n;
    n.arc = eighths * std::numbers::pi / 4, n.wire_diameter = wire, n.chord = chord;
    all.push_back(
        {std::to_string(eighths) + "/8 circle, " + std::to_string(std::lround(wire * kMicro)) + " um", n});
  }
  return all;
}

}  // namespace

std::vector<Line> bar_grasp(const Effort& effort) {
  std::vector<Line> lines;
  const auto ode = ode_methods(), mujoco = mujoco_methods();
  lines.push_back(hold_ratio("hold step over ODE exact with soft contacts",
                             find(ode, "ODE exact, soft contacts"), 0.5, effort));
  lines.push_back(
      hold_ratio("hold step over MuJoCo tuned", find(mujoco, "MuJoCo tuned, welded tool"), 0.2, effort));

  for (double overlap : {0.1e-6, 1e-6, 5e-6}) {
    const HoldResult r = hold(ours(), {}, overlap, effort.hold_seconds);
    const std::string at = "S04 overlap " + std::to_string(overlap * kMicro).substr(0, 3) + " um: ";
    lines.push_back(at_most("G2", at + "slip", "um", slip_um(r), 0.1));
    lines.push_back(
        at_most("G2", at + "turn", "deg", r.lost_at < 0 ? r.end.turn * kDegrees : kInfinity, 0.01));
  }
  Setup straight;
  straight.needle.straight = true;
  lines.push_back(at_most("G2", "S05 straight wire: slip", "um",
                          slip_um(hold(ours(), straight, 1e-6, effort.hold_seconds)), 0.01));
  lines.push_back(at_most("G2", "S06 moving 60 deg and 5 mm at 1 Hz: slip", "um",
                          slip_um(hold(ours(), {}, 1e-6, effort.hold_seconds, Tool::kMoving)), 1.0));
  for (const auto& [name, needle] : other_needles()) {
    Setup s;
    s.needle = needle;
    lines.push_back(at_most("G2", "S04 " + name + ": slip", "um",
                            slip_um(hold(ours(), s, 1e-6, effort.hold_seconds / 6)), 0.1));
  }
  return lines;
}

namespace {

/// Held over the whole range of grips, at an even cost, with a small overlap at 1 N.
void range_of_grips(std::vector<Line>& lines, const Setup& s, const std::string& jaw, int passes) {
  auto stages = pinch(ours(), s);
  // the run is the same every time: medians step by step leave out what the machine does meanwhile
  std::vector<std::vector<PinchStage>> runs(1, stages);
  while (static_cast<int>(runs.size()) < std::max(9, passes)) runs.push_back(pinch(ours(), s));
  for (size_t k = 0; k < stages.size(); ++k)
    for (size_t i = 0; i < stages[k].ns.size(); ++i) {
      std::vector<double> ns;
      for (const auto& run : runs) ns.push_back(run[k].ns[i]);
      stages[k].ns[i] = times(ns).median;
    }
  lines.push_back(within("G3", "pinch 1 mN to 16 N: largest grip held" + jaw, "N",
                         stages.empty() ? 0 : stages.back().grip, 16, 20));
  double overlap = kInfinity;
  std::vector<double> ns;
  for (const auto& stage : stages) {
    ns.insert(ns.end(), stage.ns.begin(), stage.ns.end());
    if (stage.grip > 0.9 && stage.grip < 1.1) overlap = stage.overlap * kMicro;
  }
  const Times all = times(ns);
  lines.push_back(at_most("G3", "pinch: p99 of a step over the median" + jaw, "x",
                          stages.empty() ? kInfinity : all.p99 / all.median, 2.0,
                          std::to_string(std::lround(all.p99)) + " ns against " +
                              std::to_string(std::lround(all.median)) + " ns"));
  lines.push_back(at_most("G3", "overlap at 1 N" + jaw, "um", overlap, 2.0));
}

/// Slip begins at the limit of the faces as they stand (coulomb.hpp), and not before.
void slip_onsets(std::vector<Line>& lines, const Setup& s, double grip, const std::string& jaw) {
  const std::string at = " at " + std::to_string(grip).substr(0, 5) + " N" + jaw;
  for (const auto& [name, direction] : {std::pair{"axial", Pull::kAxial},
                                        {"about the wire:", Pull::kAboutWire},
                                        {"about the jaws' normal:", Pull::kAboutNormal}}) {
    const PullResult r = pull(ours(), s, grip, direction);
    lines.push_back(within("G3-slip", std::string(name) + " slip onset" + at, "1", r.onset, 0.98, 1.02,
                           "creep at half of it " + std::to_string(r.creep * kMicro).substr(0, 6) + " um"));
  }
}

}  // namespace

std::vector<Line> bar_pinch(const Effort& effort) {
  std::vector<Line> lines;
  for (double mass : {5e-3, 0.1}) {
    Setup s;
    s.jaw_mass = mass;
    const std::string jaw = mass < 0.01 ? " (5 g jaw)" : " (100 g jaw)";
    range_of_grips(lines, s, jaw, effort.passes);
  }
  for (const auto& [name, needle] : other_needles()) {
    Setup s;
    s.needle = needle;
    range_of_grips(lines, s, " (" + name + ")", effort.passes);
  }
  return lines;
}

std::vector<Line> bar_slip(const Effort&) {
  std::vector<Line> lines;
  for (double mass : {5e-3, 0.1}) {
    Setup s;
    s.jaw_mass = mass;
    s.needle.straight = true;
    for (double grip : {1e-3, 1e-2, 0.1, 1.0}) slip_onsets(lines, s, grip, mass < 0.01 ? " (5 g jaw)" : " (100 g jaw)");
  }
  for (const auto& [name, needle] : other_needles()) {
    Setup s;
    s.needle = needle;
    s.needle.straight = true;
    slip_onsets(lines, s, 0.1, " (" + name + ")");
  }
  return lines;
}

std::vector<Line> bar_creep(const Effort& effort) {
  std::vector<Line> lines;
  Setup s;
  s.needle.straight = true;
  for (const auto& [name, direction] : {std::pair{"pulled along: ", Pull::kAxial},
                                        {"twisted about itself: ", Pull::kAboutWire},
                                        {"twisted about the jaws' normal: ", Pull::kAboutNormal}}) {
    // 1 N of grip; the load is what 1 / 1.2 or 1 / 0.8 of it would bear at most
    const double more = creep(ours(), s, 1.0, direction, 1 / 1.2, effort.hold_seconds);
    const double less = creep(ours(), s, 1.0, direction, 1 / 0.8, 2);
    const std::string time = std::to_string(static_cast<int>(effort.hold_seconds)) + " s";
    lines.push_back(at_most("grasp", std::string(name) + "creep in " + time + ", 20 % more grip than needed",
                            "um", more * kMicro, 0.1));
    lines.push_back(within("grasp", std::string(name) + "way in 2 s, 20 % less grip than needed", "um",
                           less * kMicro, 20, kInfinity));
  }
  return lines;
}

namespace {

/// Both figures contain one reading of the clock, measured here and taken off. Runs interleaved.
Line free_ratio(const Vec3& inertia, const Effort& effort) {
  const char* name = "free step over MuJoCo RK4";
  constexpr double kBound = 1.0 / 20;
  const auto mujoco = mujoco_methods();
  const Method* peer = find(mujoco, "MuJoCo RK4");
  if (!peer) return unmeasured("G6", name, kBound);
  const Vec3 w0 = 30 * Vec3(0.01, 1, 0.01).normalized();
  std::vector<double> mine, theirs;
  for (int i = 0; i < effort.passes; ++i) {
    mine.push_back(top(ours(), {}, inertia, w0, 2).step.median);
    theirs.push_back(top(*peer, {}, inertia, w0, 2).step.median);
  }
  const double clock = clock_ns();
  return ratio("G6", name, times(mine).median - clock, times(theirs).median - clock, kBound);
}

}  // namespace

std::vector<Line> bar_free(const Effort& effort) {
  std::vector<Line> lines;
  const Vec3 I{1e-12, 2e-12, 3e-12};
  // exact half period of the flips, reference problem 8.2: T w = 39.109644580 for this inertia and start
  constexpr double kPeriodTimesRate = 39.109644580;
  for (double spin : {10.0, 30.0, 100.0}) {
    const Vec3 w0 = spin * Vec3(0.01, 1, 0.01).normalized();
    const TopResult r = top(ours(), {}, I, w0, std::max(effort.hold_seconds, 2.1 * kPeriodTimesRate / spin));
    const std::string at = std::to_string(static_cast<int>(spin)) + " rad/s: ";
    lines.push_back(at_most("G6", at + "energy", "1", r.energy, 1e-6));
    lines.push_back(
        at_most("G6", at + "flip period", "1", std::abs(r.period * spin / kPeriodTimesRate - 1), 1e-5));
    const TopResult tumbling = top(ours(), {}, Needle{}.inertia(), w0, effort.hold_seconds);
    lines.push_back(at_most("G6", at + "energy, the needle tumbling", "1", tumbling.energy, 1e-6));
  }
  lines.push_back(free_ratio(I, effort));
  return lines;
}

std::vector<Line> bar_tunnel(const Effort&) {
  std::vector<Line> lines;
  const std::pair<Shot, const char*> shots[] = {
      {Shot::kFlat, "flat"}, {Shot::kEdge, "edge on"}, {Shot::kSpin, "spinning 100 rad/s"}};
  for (const auto& [shot, name] : shots) {
    int through = 0;
    for (double v : {0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0}) through += tunnelled(ours(), {}, v, shot);
    lines.push_back(none("G7", std::string("S13 shots through a jaw to 10 m/s, ") + name, through, "of 144"));
  }
  for (double v : {0.01, 0.1, 0.5, 1.0}) {
    const CloseResult r = close_on(ours(), {}, v);
    const std::string at = "S14 closing at " + std::to_string(v).substr(0, 4) + " m/s: ";
    lines.push_back(none("G7", at + "through", r.through));
    lines.push_back(at_most("G7", at + "needle's speed over the jaw's", "x", r.fastest / v, 2.0));
  }
  return lines;
}

}  // namespace swage::bench
