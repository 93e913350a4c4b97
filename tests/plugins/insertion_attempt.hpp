// SPDX-License-Identifier: Apache-2.0
//
// An attempt at the insertion lesson as its judge sees it, told by a test.
#pragma once

#include <cmath>

#include "lessons/insertion/judge.hpp"

namespace swage::lesson_insertion {

/// An attempt told step by step. The mark is in the origin, the tissue below it; the needle is 4 mm long.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) {
    now.length = 4e-3;
    now.point_W = now.needle_W = Vec3(0, 0, 5e-3);
  }
  Finding go(int n = 1) {
    Finding finding;
    for (int i = 0; i < n; ++i) {
      now.time_s = 1e-3 * step++;
      finding = judge.look(memory, now);
      now.entered = now.exited = now.passed = now.deflected = false;
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  void hold(double force = 0.6) {
    now.held = true;
    now.force = force;
    now.grip_s = 0.6;
  }
  Finding enter(const Vec3& at = Vec3::Zero(), double angle = 0) {
    now.entered = now.in_tissue = true;
    now.entry_W = at;
    now.angle = angle;
    now.cosine = std::sin(angle);
    now.s = 0;
    now.wound = now.area_ratio = 1;
    return go();
  }
  /// Drives on to s in n steps at an angle [rad].
  Finding drive(double s, int n, double angle) {
    now.angle = angle;
    now.cosine = std::sin(angle);
    const double from = now.s;
    Finding finding;
    for (int i = 1; i <= n; ++i) {
      now.s = from + (s - from) * i / n;
      finding = go();
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  /// In, half through, let go, taken again by the point and drawn out of the entry: the needle is through with the next look.
  void stitch() {
    hold();
    enter();
    drive(0.5, 50, 0);
    now.exited = true;
    go();
    now.held = false;
    go();
    hold();
    now.grip_s = 0.1;
    go();
    now.passed = true;
  }

  Judge judge;
  Memory memory;
  Look now;
  int step = 0;
};

}  // namespace swage::lesson_insertion
