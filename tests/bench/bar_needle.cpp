// SPDX-License-Identifier: Apache-2.0
//
// The needle that bends: what its step costs, what its bench measures, and that it is held as Coulomb says.
#include <algorithm>

#include "bar.hpp"
#include "lesson_step.hpp"
#include "tools/needle_bench.hpp"
#include "test_places.hpp"

namespace swage::bench {
namespace {

constexpr const char* kGoal = "needle";

Method bending() {
  for (const Method& m : swage_methods())
    if (m.name == "swage, bending needle") return m;
  throw std::runtime_error("no method bends its needle");
}

/// Whole steps of the basic grasp while the needle is held, its levels in turn. The run is the same every time: medians step by
/// step leave out what the machine does meanwhile.
void cost(std::vector<Line>& lines, int passes) {
  struct Level {
    const char* name;
    int pieces;
    std::vector<std::vector<double>> runs = {};
    Times step = {};
  };
  std::vector<Level> levels = {{"rigid", 12}, {"bending", 8}, {"bending", 12}};
  for (int pass = 0; pass < passes; ++pass)
    for (Level& l : levels) {
      HeldSteps run = held_steps(l.name, l.pieces);
      if (!run.problem.empty()) throw std::runtime_error(run.problem);
      l.runs.push_back(std::move(run.ns));
    }
  for (Level& l : levels) {
    std::vector<double> medians;
    for (size_t i = 0; i < l.runs[0].size(); ++i) {
      std::vector<double> ns;
      for (const auto& run : l.runs) ns.push_back(run[i]);
      medians.push_back(times(ns).median);
    }
    l.step = times(medians);
  }
  for (size_t i = 1; i < levels.size(); ++i) {
    const std::string pieces = std::to_string(levels[i].pieces) + " pieces";
    lines.push_back(ratio(kGoal, "held: step of " + pieces + " over the rigid one's", levels[i].step.median,
                          levels[0].step.median, 2));
    lines.push_back(at_most(kGoal, "held: p99 of a step of " + pieces + " over its median", "x",
                            levels[i].step.p99 / levels[i].step.median, 2));
  }
}

/// The needle bench on 100 um wire, 12 pieces, jaws of 0.5 mm. The closed forms of moment and springback leave out hardening and
/// the turn of the arm, so there the reference beam is the measure as well.
void figures(std::vector<Line>& lines) {
  tools::NeedleModel needle;
  const std::string wrong = tools::read_needle(SWAGE_SOURCE_DIR "/resources/needles/micro_100.json", needle);
  if (!wrong.empty()) throw std::runtime_error(wrong);
  const auto all = tools::bench_needle(needle, 12, 0.5e-3);
  const auto error = [&](size_t i, double bound) {
    lines.push_back(at_most(kGoal, all[i].name + ": error", "1", std::abs(all[i].bending_error()), bound));
  };
  const auto off_reference = [&](size_t i, double bound) {
    lines.push_back(at_most(kGoal, all[i].name + ": off the reference beam", "1",
                            std::abs(all[i].bending / all[i].reference - 1), bound));
  };
  error(0, 0.01);
  error(1, 0.09);
  error(2, 0.25);
  off_reference(2, 0.1);
  error(3, 0.35);
  off_reference(3, 0.1);
  error(4, 0.02);
  error(5, 0.05);
}

/// A straight needle that bends, pinched: where it slips and twists, and what it bears for long.
void held(std::vector<Line>& lines, const Effort& effort) {
  const Method method = bending();
  Setup s;
  s.needle.straight = true;
  for (const auto& [name, direction] : {std::pair{"slip along the wire", Pull::kAxial},
                                        {"twist about the wire", Pull::kAboutWire},
                                        {"twist about the jaws' normal", Pull::kAboutNormal}}) {
    const PullResult r = pull(method, s, 0.6, direction);
    lines.push_back(at_most(kGoal, std::string(name) + " at 0.6 N: onset off Coulomb's and the patch law's",
                            "1", std::abs(r.onset - 1), 0.02));
    const double more = creep(method, s, 0.6, direction, 1 / 1.2, effort.hold_seconds);
    const double less = creep(method, s, 0.6, direction, 1 / 0.8, 2);
    const std::string time = std::to_string(static_cast<int>(effort.hold_seconds)) + " s";
    lines.push_back(at_most(kGoal, std::string(name) + ": creep in " + time + ", 20 % more grip than needed",
                            "um", more * kMicro, 0.1));
    lines.push_back(within(kGoal, std::string(name) + ": way in 2 s, 20 % less grip than needed", "um",
                           less * kMicro, 20, kInfinity));
  }
}

}  // namespace

std::vector<Line> bar_needle(const Effort& effort) {
  std::vector<Line> lines;
  cost(lines, std::max(3, effort.passes));
  figures(lines);
  held(lines, effort);
  return lines;
}

}  // namespace swage::bench
