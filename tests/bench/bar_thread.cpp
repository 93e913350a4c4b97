// SPDX-License-Identifier: Apache-2.0
//
// A thread: what its step costs beside ODE's exact grasp step, how far off the exact elastica it hangs, and what a whole loop costs with
// needle and jaws.
#include <cmath>

#include "bar.hpp"
#include "held_thread.hpp"
#include "ode_grasp_step.hpp"
#include "phases.hpp"
#include "thread_loop.hpp"
#include "timing.hpp"

namespace swage::bench {
namespace {

constexpr int kSteps = 2000;  // that are timed in one go

struct ThreadSteps {
  double median = 0;  // ns
  uint64_t not_converged = 0;
  bool held = false;  // to the end
};
ThreadSteps held_steps(double speed) {
  HeldThread s(Held::kJaws, speed);
  for (int i = 0; i < 300; ++i) s.step();
  std::vector<double> ns;
  for (int i = 0; i < kSteps; ++i) {
    const double begin = cpu_ns();
    s.step();
    ns.push_back(cpu_ns() - begin);
  }
  return {times(ns).median, s.solve->stats().health.not_converged, s.contacts.contact.size() >= 2};
}

/// 18.9 mm of 10-0 nylon held level by one end (heavy elastica, G = 1): how far its free end is from the exact place, over the length;
/// and what a step of it costs [ns].
struct Hanging {
  double error = 0, ns = 0;
};
Hanging hangs(int edges) {
  constexpr double kGravity = 9.80665;
  const double length = std::cbrt(nylon().bending / (nylon().mass * kGravity));
  toolkit::Rod rod(nylon(), std::vector<double>(static_cast<size_t>(edges), length / edges));
  std::vector<double> numbers(toolkit::RodState::size(edges + 1));
  toolkit::RodState s(edges + 1, numbers.data());
  for (int i = 0; i <= edges; ++i) s.x[3 * i] = length / edges * i;
  rod.hold(0);
  rod.clamp(0) = {true, toolkit::Vec3::UnitX(), toolkit::Vec3::UnitY()};
  rod.start(s);
  toolkit::RodLoad load;
  load.h = 1e-3;
  load.gravity = {0, 0, -kGravity};
  for (int i = 0; i < 4000; ++i) rod.step(s, load, 6, 1e-9 * length);
  std::vector<double> ns;
  for (int i = 0; i < kSteps; ++i) {
    const double begin = cpu_ns();
    rod.step(s, load, 6, 1e-9 * length);
    ns.push_back(cpu_ns() - begin);
  }
  const toolkit::Vec3 exact(0.991246, 0, -0.123471);
  return {(s.node(edges) / length - exact).norm(), times(ns).median};
}

/// Lesson 117 with a thread of 99 segments: processor time of the steps in which `counts` holds.
std::vector<double> loop(const char* level, bool (*counts)(const stage::LessonRun&), bool alone = false) {
  const auto lesson = thread_loop(level, alone);
  stage::LessonRun& run = *lesson;
  std::vector<double> ns;
  if (!run.ready()) return ns;
  while (run.verdict().outcome == judge::Outcome::kRunning && run.world().time() < 60) {
    const double begin = cpu_ns();
    run.step();
    const double took = cpu_ns() - begin;
    if (counts(run)) ns.push_back(took);
  }
  return ns;
}

/// Steps of runs that are the same, each at its median over the runs.
Times typical(const std::vector<std::vector<double>>& runs) {
  std::vector<double> medians;
  for (size_t i = 0; i < runs[0].size(); ++i) {
    std::vector<double> ns;
    for (const auto& run : runs) ns.push_back(run[i]);
    medians.push_back(times(ns).median);
  }
  Times none;
  none.mean = none.p999 = kInfinity;
  return medians.empty() ? none : times(medians);
}

}  // namespace

std::vector<Line> bar_thread(const Effort& effort) {
  std::vector<double> ode, still, moved, coarse;
  uint64_t not_converged = 0, lost = 0;
  Hanging fine, few;
  for (int i = 0; i < effort.passes; ++i) {
    ode.push_back(ode_grasp_step());
    const ThreadSteps a = held_steps(0), b = held_steps(3e-3);
    still.push_back(a.median), moved.push_back(b.median);
    lost += !a.held + !b.held;
    not_converged += a.not_converged + b.not_converged;
    coarse.push_back((few = hangs(5)).ns);
  }
  fine = hangs(99);
  const double yardstick = times(ode).median;
  std::vector<Line> lines;
  const auto beside_ode = [&](const char* goal, const char* name, double ours, double high) {
    lines.push_back(std::isnan(yardstick) ? unmeasured(goal, name, high) : ratio(goal, name, ours, yardstick, high));
  };
  beside_ode("G4", "thread of 100 nodes, held still: step over ODE's exact grasp step", times(still).median, 4.3);
  beside_ode("G4", "thread of 100 nodes, held and moved at 3 mm/s: step over ODE's exact grasp step", times(moved).median, 4.3);
  lines.push_back(none("G4", "thread of 100 nodes, held: lost from the grip", static_cast<double>(lost)));
  lines.push_back(none("G4", "thread of 100 nodes, held: steps that did not converge", static_cast<double>(not_converged)));
  lines.push_back(at_most("G4", "18.9 mm held by its end, 100 nodes: off the exact elastica, a tenth of a direct rod's", "L", fine.error, 2.3e-4));
  lines.push_back(at_most("G5", "the same, 5 segments", "L", few.error, 0.01));
  beside_ode("G5", "the same, 5 segments: step over ODE's exact grasp step", times(coarse).median, 0.43);
  lines.push_back(within("G5", "order of that error in the length of a segment, 12 to 24", "1", std::log2(hangs(12).error / hangs(24).error), 1.8, 2.2));

  std::vector<std::vector<double>> alone, rigid, bending;
  for (int i = 0; i < effort.passes; ++i) {
    alone.push_back(loop("rigid", carried, true)), rigid.push_back(loop("rigid", carried));
    bending.push_back(loop("bending", inserted));
  }
  const Times bare = typical(alone), loose = typical(rigid), whole = typical(bending);
  const auto tick = [&](const char* name, double ours, double high, size_t steps) {
    beside_ode("G8", name, ours, high);
    lines.back().note += ", n = " + std::to_string(steps);
  };
  tick("needle, jaws and a thread of 100 nodes: mean step over ODE's exact grasp step", bare.mean, 3.5, alone[0].size());
  tick("needle, jaws and a thread of 100 nodes: p99.9 of a step over ODE's exact grasp step", bare.p999, 10, alone[0].size());
  tick("the same over a tray on which the thread lies: mean", loose.mean, 3.5, rigid[0].size());
  tick("the same over a tray on which the thread lies: p99.9", loose.p999, 10, rigid[0].size());
  tick("bending needle, jaws, tissue and that thread: mean step over ODE's exact grasp step", whole.mean, 7, bending[0].size());
  return lines;
}

}  // namespace swage::bench
