// SPDX-License-Identifier: Apache-2.0
//
// An attempt at a knot as its judge sees it, told step by step.
#pragma once

#include <initializer_list>

#include "lessons/knot/judge.hpp"

namespace swage::lesson_knot {

inline Word word(std::initializer_list<double> turns) {
  Word out;
  for (const double t : turns) out.turns[static_cast<size_t>(out.throws++)] = t;
  return out;
}

/// An attempt told step by step, with both ends held.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) {
    now.gap = 0.4e-3;
    hold(0.3);
  }
  Finding go(int n) {
    Finding finding;
    for (int i = 0; i < n; ++i) {
      now.time_s = 1e-3 * step++;
      finding = judge.look(memory, now);
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  void hold(double force) {
    for (int i = 0; i < 2; ++i) now.grip[i] = force, now.held[i] = force > 0;
  }
  /// Tied, drawn down, edges together; of a thread of 30 mm.
  void tie(const Word& tied) {
    now.word = tied, now.loop = 5e-3, now.gap = 0.02e-3, now.tension = 4e-3;
    now.loosest = 1.5e-3, now.from = 12e-3, now.to = 20e-3;
  }
  /// Cuts the thread there [m], in one step.
  Finding cut(double at) {
    now.cut_at = at;
    const Finding finding = go(1);
    now.cut_at = -1, now.parted += 1;
    return finding;
  }

  Judge judge;
  Memory memory;
  Look now;
  int step = 0;
};

}  // namespace swage::lesson_knot
