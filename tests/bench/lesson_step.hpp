// SPDX-License-Identifier: Apache-2.0
//
// The whole step of a lesson with a needle held in the jaws, through host and plugins, at a level of the needle's ladder.
#pragma once

#include <string>
#include <vector>

namespace swage::bench {

/// Processor time of each step while the expert of the basic grasp holds the needle, lifted [ns].
struct HeldSteps {
  std::vector<double> ns;
  uint64_t hash = 0;    // of the last step: runs are the same
  std::string problem;  // why there are none
};
HeldSteps held_steps(const std::string& level, int pieces);

}  // namespace swage::bench
