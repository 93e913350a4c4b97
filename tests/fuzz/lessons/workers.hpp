// SPDX-License-Identifier: Apache-2.0
//
// Trials in children: one that crashes, hangs or takes too much memory costs itself and is named. [main]
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace swage::fuzz {

/// What came of one trial.
struct Tried {
  bool accepted = false;  // a scene, which was then run
  std::string wrong;      // "" or what should not be
};

struct Failure {
  uint64_t trial = 0;
  std::string what;
};

struct Tally {
  uint64_t trials = 0, accepted = 0;
  std::vector<Failure> failures;  // at most 20, then it ends
};

/// Runs trials 0..n-1, some thousand in each child. A trial has 5 s of processor time and 60 s of the clock, a child 1 GiB.
Tally run_trials(uint64_t n, const std::function<Tried(uint64_t trial)>& trial);

}  // namespace swage::fuzz
