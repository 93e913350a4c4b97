// SPDX-License-Identifier: Apache-2.0
//
// One trial in a process of its own, with limits.
#pragma once

#include <functional>
#include <string>

namespace swage::record::test {

struct Ended {
  std::string said;       // what the trial returned
  std::string wrong;      // "" unless it crashed, hung or took too much memory
  double seconds = 0;     // wall
  double megabytes = 0;   // largest resident size
};

/// Runs `trial` in a child. The limits: 5 s of its own processor time and 60 s of wall time, so that a busy machine accuses nobody;
/// 1 GB resident.
Ended run_trial(const std::function<std::string()>& trial);

/// How many trials of each kind: SWAGE_FUZZ_TRIALS, or some dozen.
int trials();

}  // namespace swage::record::test
