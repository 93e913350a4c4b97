// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "bar.hpp"

namespace swage::bench {
namespace {

constexpr double kMicro = 1e6;  // um per m
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Method* find(const std::vector<Method>& methods, const std::string& name) {
  for (const Method& m : methods)
    if (m.name == name) return &m;
  return nullptr;
}

Method ours() { return swage_methods().front(); }

Line at_most(const char* goal, std::string name, const char* unit, double measured, double high) {
  return {goal, std::move(name), unit, measured, -kInfinity, high, true, ""};
}

/// Median of one hold step [ns], after the grasp has settled.
double hold_step_ns(const Method& m, const Setup& s) { return hold(m, s, 1e-6, 0.5).step.median; }

/// Ratio of medians, ours over the peer's, runs interleaved.
Line ratio(const char* goal, const char* name, const Method* peer, double bound, const Effort& effort) {
  Line line = at_most(goal, name, "x", 0, bound);
  if (!peer) {
    line.available = false;
    line.note = "peer not installed: scripts/setup.sh peer, then build again";
    return line;
  }
  std::vector<double> mine, theirs;
  for (int i = 0; i < effort.passes; ++i) {
    mine.push_back(hold_step_ns(ours(), {}));
    theirs.push_back(hold_step_ns(*peer, {}));
  }
  line.measured = times(mine).median / times(theirs).median;
  line.note = std::to_string(std::lround(times(mine).median)) + " ns against " +
              std::to_string(std::lround(times(theirs).median)) + " ns";
  return line;
}

}  // namespace

std::vector<Line> bar_grasp(const Effort& effort) {
  std::vector<Line> lines;
  const auto ode = ode_methods(), mujoco = mujoco_methods();
  lines.push_back(ratio("G2", "hold step over ODE exact with soft contacts",
                        find(ode, "ODE exact, soft contacts"), 0.5, effort));
  lines.push_back(
      ratio("G2", "hold step over MuJoCo tuned", find(mujoco, "MuJoCo tuned, welded tool"), 0.2, effort));

  for (double overlap : {0.1e-6, 1e-6, 5e-6}) {
    const HoldResult r = hold(ours(), {}, overlap, effort.hold_seconds);
    const std::string at = "S04 overlap " + std::to_string(overlap * kMicro).substr(0, 3) + " um: ";
    lines.push_back(at_most("G2", at + "slip", "um", r.lost_at < 0 ? r.worst * kMicro : kInfinity, 0.1));
    lines.push_back(
        at_most("G2", at + "turn", "deg", r.lost_at < 0 ? r.end.turn * kDegrees : kInfinity, 0.01));
  }
  Setup straight;
  straight.needle.straight = true;
  const HoldResult s05 = hold(ours(), straight, 1e-6, effort.hold_seconds);
  lines.push_back(
      at_most("G2", "S05 straight wire: slip", "um", s05.lost_at < 0 ? s05.worst * kMicro : kInfinity, 0.01));
  const HoldResult s06 = hold(ours(), {}, 1e-6, effort.hold_seconds, Tool::kMoving);
  lines.push_back(at_most("G2", "S06 moving 60 deg and 5 mm at 1 Hz: slip", "um",
                          s06.lost_at < 0 ? s06.worst * kMicro : kInfinity, 1.0));
  return lines;
}

std::vector<Line> bar_pinch(const Effort&) {
  std::vector<Line> lines;
  for (double mass : {5e-3, 0.1}) {
    Setup s;
    s.jaw_mass = mass;
    const std::string jaw = mass < 0.01 ? " (5 g jaw)" : " (100 g jaw)";

    // the whole range of grips: held, cost even, overlap small at 1 N
    const auto stages = pinch(ours(), s);
    Line held = {"G3", "pinch 1 mN to 16 N: largest grip held" + jaw,
                 "N",  stages.empty() ? 0 : stages.back().grip,
                 16.0, 20.0,
                 true, ""};
    lines.push_back(held);
    double overlap = kInfinity;
    std::vector<double> ns;
    for (const auto& stage : stages) ns.insert(ns.end(), stage.ns.begin(), stage.ns.end());
    const Times all = times(ns);
    for (const auto& stage : stages)
      if (stage.grip > 0.9 && stage.grip < 1.1) overlap = stage.overlap * kMicro;
    lines.push_back(at_most("G3", "pinch: p99 of a step over the median" + jaw, "x",
                            stages.empty() ? kInfinity : all.p99 / all.median, 2.0));
    lines.push_back(at_most("G3", "overlap at 1 N" + jaw, "um", overlap, 2.0));

    // slip begins at the Coulomb limit
    s.needle.straight = true;
    for (double grip : {1e-3, 1e-2, 0.1, 1.0}) {
      const auto onset = [&](const char* name, Pull direction) {
        const double at = pull(ours(), s, grip, direction).onset;
        lines.push_back(
            {"G3", std::string(name) + " slip onset at " + std::to_string(grip).substr(0, 5) + " N" + jaw,
             "1", at, 0.98, 1.02, true, ""});
      };
      onset("axial", Pull::kAxial);
      onset("about the wire:", Pull::kAboutWire);
      onset("about the jaws' normal:", Pull::kAboutNormal);
    }
  }
  return lines;
}

std::vector<Line> bar_free(const Effort& effort) {
  std::vector<Line> lines;
  const Vec3 I{1e-12, 2e-12, 3e-12};
  const double seconds = effort.hold_seconds;
  // exact half period of the flips, peers of rigid-body texts: T w = 39.109644580 for this inertia and start
  constexpr double kPeriodTimesRate = 39.109644580;
  double cost = 0;
  for (double spin : {10.0, 30.0, 100.0}) {
    const TopResult r = top(ours(), {}, I, spin * Vec3(0.01, 1, 0.01).normalized(),
                            std::max(seconds, 2.1 * kPeriodTimesRate / spin));
    const std::string at = std::to_string(static_cast<int>(spin)) + " rad/s: ";
    lines.push_back(at_most("G6", at + "energy", "1", r.energy, 1e-6));
    lines.push_back(
        at_most("G6", at + "flip period", "1", std::abs(r.period * spin / kPeriodTimesRate - 1), 1e-5));
    cost = r.step.median;
  }
  Line speed = at_most("G6", "free step over MuJoCo RK4", "x", 0, 1.0 / 20);
  const auto mujoco = mujoco_methods();
  if (const Method* peer = find(mujoco, "MuJoCo RK4")) {
    const double theirs = top(*peer, {}, I, 30 * Vec3(0.01, 1, 0.01).normalized(), 2).step.median;
    // both figures contain one reading of the clock, measured here and taken off
    std::vector<double> clock;
    for (int i = 0; i < 10000; ++i) {
      const double a = now_ns();
      clock.push_back(now_ns() - a);
    }
    const double empty = times(clock).median;
    speed.measured = (cost - empty) / (theirs - empty);
    speed.note = std::to_string(std::lround(cost - empty)) + " ns against " +
                 std::to_string(std::lround(theirs - empty)) + " ns";
  } else {
    speed.available = false;
    speed.note = "peer not installed: scripts/setup.sh peer, then build again";
  }
  lines.push_back(speed);
  return lines;
}

std::vector<Line> bar_tunnel(const Effort&) {
  std::vector<Line> lines;
  const std::pair<Shot, const char*> shots[] = {
      {Shot::kFlat, "flat"}, {Shot::kEdge, "edge on"}, {Shot::kSpin, "spinning 100 rad/s"}};
  for (const auto& [shot, name] : shots) {
    int through = 0;
    for (double v : {0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0}) through += tunnelled(ours(), {}, v, shot);
    lines.push_back(
        at_most("G7", std::string("S13 shots through a jaw to 2 m/s, ") + name, "of 112", through, 0));
  }
  for (double v : {0.01, 0.1, 0.5, 1.0}) {
    const CloseResult r = close_on(ours(), {}, v);
    const std::string at = "S14 closing at " + std::to_string(v).substr(0, 4) + " m/s: ";
    lines.push_back(at_most("G7", at + "through", "of 1", r.through, 0));
    lines.push_back(at_most("G7", at + "needle's speed over the jaw's", "x", r.fastest / v, 2.0));
  }
  return lines;
}

}  // namespace swage::bench
