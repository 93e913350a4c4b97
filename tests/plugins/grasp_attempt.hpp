// SPDX-License-Identifier: Apache-2.0
//
// An attempt at a grasp, told to its judge step by step.
#pragma once

#include "lessons/grasp/judge.hpp"

namespace swage::lesson_grasp {

/// An attempt told step by step.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) {}

  /// n steps as `now` says; returns the last finding.
  Finding go(int n = 1) {
    Finding finding;
    for (int i = 0; i < n; ++i) {
      now.time_s = 1e-3 * step++;
      finding = judge.look(memory, now);
      now.touched = now.taken = false;
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  Finding take(double s, double reach, double force) {
    now.touched = now.taken = now.held = true;
    now.opening = 0.01;
    now.s = s;
    now.tip_reach = reach;
    now.force = force;
    return go();
  }
  void let_go() {
    now.held = false;
    now.force = 0;
    now.opening = 0.2;
  }

  Judge judge;
  Memory memory;
  Look now;
  int step = 0;
};

}  // namespace swage::lesson_grasp
