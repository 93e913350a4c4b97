// SPDX-License-Identifier: Apache-2.0
//
// The ladder of the needle: how right each level is about bending, and what a step of a grasp with it costs.
#include <cmath>

#include "charts.hpp"
#include "lesson_step.hpp"
#include "timing.hpp"
#include "tools/needle_bench.hpp"
#include "test_places.hpp"

namespace swage::bench {
namespace {

/// A level of the ladder; the bench of the needle clamps two thirds of its pieces.
struct Level {
  const char* name;   // of the chart
  const char* level;  // of the needle
  int asked, pieces;  // as the lesson says it, and how many there are
};
constexpr Level kLevels[] = {{"rigid", "rigid", 12, 0},
                             {"bending, 4, 8 and 12 pieces", "bending", 4, 4},
                             {"bending, 4, 8 and 12 pieces", "bending", 8, 8},
                             {"bending, 4, 8 and 12 pieces", "bending", 12, 12},
                             {"reference, 48 pieces", "reference", 12, 48}};

std::vector<double> costs(bool quick) {
  std::vector<std::vector<double>> medians(std::size(kLevels));
  for (int round = 0; round < (quick ? 1 : 5); ++round)
    for (size_t i = 0; i < std::size(kLevels); ++i) {
      const HeldSteps run = held_steps(kLevels[i].level, kLevels[i].asked);
      if (!run.problem.empty()) throw std::runtime_error(run.problem);
      medians[i].push_back(times(run.ns).median);
    }
  std::vector<double> out;
  for (auto& each : medians) out.push_back(times(each).median);
  return out;
}

/// Error of one figure of the bench against its closed form, or against the beam in strips where that says more.
Scatter ladder(bool quick, const char* title, const char* error, size_t figure, bool closed_form) {
  tools::NeedleModel needle;
  const std::string wrong = tools::read_needle(SWAGE_SOURCE_DIR "/resources/needles/micro_100.json", needle);
  if (!wrong.empty()) throw std::runtime_error(wrong);
  Scatter c;
  c.title = title;
  c.x = {error, 1e-4, 2, true, "exact", "does not bend"};
  c.y = {"median processor time of a step of the lesson, ns", 1e3, 1e6, true, "", ""};
  const std::vector<double> cost = costs(quick);
  for (size_t i = 0; i < std::size(kLevels); ++i) {
    const Level& l = kLevels[i];
    double off = 1;  // a rigid one bends nothing
    if (l.pieces > 0) {
      const tools::NeedleFigure f = tools::bench_needle(needle, l.pieces, 1e-3)[figure];
      off = std::abs(closed_form ? f.bending_error() : f.bending / f.reference - 1);
    }
    c.marks.push_back({"swage", l.name, off, cost[i], l.pieces > 0 ? std::to_string(l.pieces) : ""});
  }
  return c;
}

}  // namespace

Scatter chart_bend(bool quick) {
  return ladder(quick,
                "The needle's levels: tip of a 100 um needle clamped two thirds back, 1 mN at its point",
                "error of the deflection against P L^3 / 3 EI", 0, true);
}

Scatter chart_keep(bool quick) {
  return ladder(quick, "The needle's levels: bent by a right angle and let go",
                "error of the springback against a beam of 60 cells and strips", 3, false);
}

}  // namespace swage::bench
