// SPDX-License-Identifier: Apache-2.0
//
// The thread that is swaged to the needle: grasps at the swage, tension of the thread, damage to the tissue, and length of the tail and
// of loops. Header-only, pure, [rt].
#pragma once

#include <algorithm>
#include <cmath>

#include "tails.hpp"

namespace swage::lesson_insertion {

struct SutureRules {
  bool there = false;             // the lesson names one
  double swage_zone = 0.5e-3;     // m, from the needle's blunt end: not to be grasped
  double tail = 0;                // m, required at the entry; 0: the thread need not be drawn through
  double tail_tolerance = 1e-3;   // m
  double loop = 0;                // m, required length between a bite and the one before it; 0: likewise
  double loop_tolerance = 0.5e-3; // m
  double tail_time = 0.5;         // s, for which tail and loop must keep their length
  double tension = 0;             // N at the swage, limit; 0: not required
  bool cut = false;               // each stitch is cut off its thread; `tail` is asked for on both sides then
};

/// Observations of one step.
struct SutureLook {
  double tension = 0;                           // N, at the swage
  bool pulled_off = false, through = false;     // events: the thread came out of the needle; all of it went through the tissue
  double state = 0, tail = 0, cut = 0, back = 0;             // pull.*: 1, m, m, m
  double pull = 0;                                           // N, of the thread where it comes out of the tissue, at least 0
  double loop = 0, loop_least = 0, loop_most = 0;            // pull.*: m
  // where stitches are cut off, m along the thread from the needle: its length, the last entry and the last exit
  double length = 0, entry = 0, exit = 0;
  bool parted = false;                                       // event: it was cut
  double parted_at = 0;                                      // m, likewise
};

struct SutureState {
  double peak = 0;                 // N
  double grasps = 0, grasped = 0;  // at the swage: how often, and now
  double pull_s = 0;               // N s
  double tail = 0, cut = 0, back = 0;  // m
  double loop_least = 0, loop_most = 0;  // m
  double drawn = 0;                // 1: the thread has been in the tissue
  double right_s = 0;              // s, for which tail and loop have had their length
  double off = 0, lost = 0;        // 1: pulled off the needle; 1: all through, or its tail is too short
  CutState cut_off;
};

struct SutureWatch {
  /// True in the step in which the swage is grasped. `grip_s`: where the needle is held, 0 at the point; `length`: m, of the needle.
  /// `through`: the needle is, and was taken on the other side.
  static bool look(const SutureRules& rules, SutureState& s, const SutureLook& look, bool held, double grip_s, double length,
                   double dt, bool through = false) noexcept {
    if (!rules.there) return false;
    const bool at_swage = held && (1 - grip_s) * length < rules.swage_zone;
    const bool begins = at_swage && s.grasped == 0;
    s.grasped = at_swage ? 1 : 0;
    if (begins) s.grasps += 1;
    s.peak = std::max(s.peak, look.tension);
    s.pull_s += look.pull * dt;
    s.cut = look.cut, s.back = look.back;
    if (look.pulled_off) s.off = 1;
    if (look.state > 0) s.drawn = 1, s.tail = look.tail;
    if (rules.cut) return follow_cut(rules, s, look, through, dt), begins;
    const bool short_tail = rules.tail > 0 && look.state > 0 && look.tail < rules.tail - rules.tail_tolerance;
    if (look.through || short_tail) s.lost = 1;
    constexpr double kOut = 2;
    if (look.state >= kOut) s.loop_least = look.loop_least, s.loop_most = look.loop_most;
    const bool tail = rules.tail <= 0 || std::abs(look.tail - rules.tail) <= rules.tail_tolerance;
    const bool loop = rules.loop <= 0 || std::abs(look.loop - rules.loop) <= rules.loop_tolerance;
    const bool right = look.state >= kOut && tail && loop;
    s.right_s = right ? s.right_s + dt : 0;
    return begins;
  }
  /// Whether the thread is drawn through as far as required.
  static bool drawn(const SutureRules& rules, const SutureState& s) noexcept {
    return (rules.tail <= 0 && rules.loop <= 0) || s.right_s >= rules.tail_time;
  }
  /// Drawn through, and cut off where that is asked for.
  static bool done(const SutureRules& rules, const SutureState& s) noexcept {
    return drawn(rules, s) && (!rules.cut || (s.cut_off.at > 0 && s.cut_off.tail <= rules.tail + rules.tail_tolerance));
  }
  /// A stitch is done: its tails are kept.
  static void finish(const SutureRules& rules, SutureState& s) noexcept {
    if (rules.cut) CutWatch::finish(s.cut_off, rules.tail);
  }
  /// Another one is asked for: it begins with what is left on the needle.
  static void go_on(const SutureRules& rules, SutureState& s) noexcept {
    if (rules.cut) s.right_s = 0, CutWatch::go_on(s.cut_off);
  }
  /// Range of the loops of a running suture over their required length.
  static double unlike_loops(const SutureRules& rules, const SutureState& s) noexcept {
    return rules.loop > 0 ? (s.loop_most - s.loop_least) / rules.loop : 0;
  }
  /// Excess of the peak tension over its limit, as a share of the limit.
  static double over_tension(const SutureRules& rules, const SutureState& s) noexcept {
    return rules.tension > 0 ? std::max(0.0, s.peak / rules.tension - 1) : 0;
  }
  /// Points deducted, of 100: 15 for each grasp at the swage.
  static double points(const SutureState& s) noexcept { return 15 * s.grasps; }

 private:
  static void follow_cut(const SutureRules& rules, SutureState& s, const SutureLook& look, bool through, double dt) noexcept {
    const bool severed = CutWatch::look(s.cut_off, look.length, look.entry, look.exit, look.state == 1, through, look.parted, look.parted_at);
    if (severed) s.lost = 1;
    if (s.cut_off.began == 0) return;
    s.tail = s.cut_off.end - look.entry;
    const double least = rules.tail - rules.tail_tolerance;
    if (s.tail < least || (s.cut_off.at > 0 && s.cut_off.tail < least)) s.lost = 1;
    const bool right = look.state >= 2 && look.exit > 0 && std::abs(s.tail - rules.tail) <= rules.tail_tolerance;
    s.right_s = right ? s.right_s + dt : 0;
  }
};

}  // namespace swage::lesson_insertion
