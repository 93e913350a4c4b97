// SPDX-License-Identifier: Apache-2.0
//
// The whole step of a lesson with a needle held in the jaws, through host and plugins, at a level of the needle's ladder.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run_lesson.hpp"

namespace swage::bench {

/// Processor time of each step while the expert of the basic grasp holds the needle, lifted [ns].
struct HeldSteps {
  std::vector<double> ns;
  uint64_t hash = 0;    // of the last step: runs are the same
  std::string problem;  // why there are none
};
HeldSteps held_steps(const std::string& level, int pieces);
/// That lesson at its start, and the time over which the needle is held [s, of the lesson].
std::unique_ptr<stage::LessonRun> held_lesson(const std::string& level, int pieces);
inline constexpr double kHeldFrom = 7, kHeldUntil = 9;

}  // namespace swage::bench
