// SPDX-License-Identifier: Apache-2.0
//
// Single stitches that are cut off one thread, one after another: where each of them ends on both sides. All places are lengths of thread
// from the needle on, so that the entry of a stitch is farther than its exit. Header-only, pure, [rt].
#pragma once

#include <algorithm>
#include <cmath>

namespace swage::lesson_insertion {

/// Doubles only.
struct CutState {
  double began = 0;             // 0 or 1: the thread has gone in for the present stitch
  double end = 0;               // m: where the present stitch ends beyond its entry; 0: nothing is known yet
  double at = 0, next = 0;      // m: where it was cut beyond its exit; where the thread on the needle ends since; 0: not yet
  double tail = 0, entry_tail = 0;  // m: its thread beyond the exit, and before the entry
  double cuts = 0, astray = 0;  // how often the thread was cut; and where it should not be
  double least = 0, most = 0;   // m, of the tails of finished stitches
  double off = 0;               // m, the tail farthest from what is asked
};

struct CutWatch {
  /// `length`, `entry`, `exit` [m] of thread from the needle; `in`: its leading end is in the tissue. True when the needle was cut off a
  /// stitch that is not through: it cannot be finished any more.
  static bool look(CutState& s, double length, double entry, double exit, bool in, bool through, bool parted, double at) noexcept {
    if (s.end <= 0) s.end = length;
    if (in) s.began = 1;
    bool severed = false;
    if (parted) {
      s.cuts += 1;
      const bool tail = s.began != 0 && at > entry && at < s.end;
      const bool beyond = s.began != 0 && through && at < exit;
      if (tail) s.end = at;
      if (beyond) s.at = std::max(s.at, at), s.next = s.next > 0 ? std::min(s.next, at) : at;
      severed = s.began != 0 && !through && at < entry;
      if (!tail && !beyond) s.astray += 1;
    }
    s.entry_tail = s.end - entry;
    s.tail = s.at > 0 ? exit - s.at : 0;
    return severed;
  }
  static void finish(CutState& s, double asked) noexcept {
    for (const double tail : {s.entry_tail, s.tail}) {
      s.least = s.least > 0 ? std::min(s.least, tail) : tail;
      s.most = std::max(s.most, tail);
      s.off = std::max(s.off, std::abs(tail - asked));
    }
  }
  static void go_on(CutState& s) noexcept {
    s.end = s.next;
    s.began = s.at = s.next = s.tail = s.entry_tail = 0;
  }
  /// Of 100: up to 10 for the tail that is farthest off, where half of what is allowed costs none, and 10 for each cut astray.
  static double points(const CutState& s, double tolerance) noexcept {
    return 10 * std::clamp(2 * s.off / tolerance - 1, 0.0, 1.0) + 10 * s.astray;
  }
};

}  // namespace swage::lesson_insertion
