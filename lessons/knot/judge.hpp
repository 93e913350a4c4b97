// SPDX-License-Identifier: Apache-2.0
//
// Judge of a knot tied on two edges of tissue, and its score. Pure arithmetic on the observations of one step; formulas:
// knot.md.
#pragma once

#include "common/grip.hpp"
#include "common/watches.hpp"

namespace swage::lesson_knot {

using lessons::GripWatch;
using lessons::PathWatch;
using toolkit::Vec3;

inline constexpr int kThrows = 6;  // greatest number that swage.coupling.knot reports

/// Throws in their order, each with its turns and their sign.
struct Word {
  double throws = 0;
  double turns[kThrows] = {};

  /// Number of throws, from the first on, that equal those required, or that all equal their mirror image.
  int like(const Word& asked) const;
  /// Whether all throws are those required but the last one, which has fewer turns than required to the same side.
  bool begins_throw_of(const Word& asked) const;
  bool is(const Word& asked) const { return throws == asked.throws && like(asked) == static_cast<int>(asked.throws); }
};

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  Word asked{1, {1}};
  double most_gap = 0.1e-3;                 // m, between the edges
  double most_loop = 7e-3;                  // m, length of thread between the two strands of the first throw
  double most_throw = 2e-3;                 // m, of thread that one strand may take in a throw. Drawn down 8-0 takes 1.2, and is read to two segments of 0.4; with 3 a throw may stand off by 2
  int most_sliding = 0;                     // throws that may slide. 1 of the three of a surgeon's knot: such ones hold 0.1 N as those without do (knot.md)
  double tension = 20e-3;                   // N, limit
  double force_low = 0.05, force_high = 1;  // N
  double most_cut = 0.3e-3;                 // m, by which the thread may cut the tissue
  double hold_time = 1;                     // s
  double par_time = 30;                     // s
  double max_time = 240;                    // s
  double max_over_time = 2;                 // s
  double wrong_time = 10;                   // s, for which a wrong knot may last
  double slack = 5e-3;                      // N, below it a long end is laid down. The bent thread of a knot keeps some mN, a drawn one has 15 and springs
  double retake_time = 15;                  // s, until it is to be held again: the hands take 4 to 7. Shorter, a student who looks for it has dropped it
  bool cut = false;                         // both ends are cut off
  double tail = 3e-3, tail_tolerance = 1e-3;  // m, of each end at the knot
  int max_drops = 2;
  bool ends = true;  // limits end the attempt: of force, time, drops and wrong throws
};

/// Observations of one step.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  double grip[2] = {0, 0};  // N, of the winder and of the holder on the thread
  bool held[2] = {false, false};
  double squeeze = 1e300;      // N, what the winder's hand puts on its jaws; of a gripper that does not tell it, no end is let go of
  double tension_grip = 0;     // N, of the long end beside the jaws that hold it
  Vec3 tip_W[2] = {Vec3::Zero(), Vec3::Zero()};
  double turns = 0;  // about the holder
  Word word;
  bool tangled = false;
  double sliding = 0;        // throws that slide
  double loop = 0, gap = 0;  // m
  double from = 0, to = 0, loosest = 0;  // m: the outermost throw begins and ends there; what one strand takes in the loosest
  double cut_at = -1;        // m from the first end: it was cut there in this step; negative: it was not
  double tension = 0;        // N, the greater of the tensions at the two holes
  double cut = 0, tail = 0;  // m
  bool through = true;       // the thread lies through both edges
  double parted = 0, passages = 0;
};

/// State of the judge from step to step: doubles only.
struct Memory {
  lessons::PathState path[2];
  lessons::GripState grip[2], pull;  // of the jaws; of the thread
  double has[2] = {0, 0};            // 0 or 1: the thread is held, and its grip force has not ceased since
  double let_go = 0, let_go_s = 0, regrasps = 0;  // 0 or 1: the long end was laid down; s, since then; times that it was taken anew
  double long_tension = 0;           // N, of the long end while it was last held
  double unwound_s = 1e3;            // s, since a turn was last on the holder
  double laid = 0;                   // throws that were tied once their turns had left the holder: these can come undone
  double throws = 0, most_like = 0, undone = 0, wrong = 0, is_wrong = 0, drops = 0, passages = 0;
  double held_s = 0, over_s = 0, taut_s = 0;
  double least_gap = 1, cut = 0, tail = 0;  // m
  double hold_s = 0, best_hold_s = 0, wrong_s = 0, passed = 0;
  double cuts = 0, severed = 0, flat = 0, end[2] = {0, 0};  // 1: cut where the knot needs the thread; 1: kept flat once; m: long end and tail, once cut
};

enum class Stage { kTake, kWind, kTail, kDraw, kLay, kHold, kCutEnds, kDone };
enum class End { kRunning, kPassed, kPassage, kBroken, kDrawnOut, kCut, kDropped, kTooHard, kWrong, kOutOfTime, kSevered, kTailShort };

/// Points deducted, of 100.
struct Points {
  double undone = 0, drops = 0, tension = 0, force = 0, cut = 0, tails = 0, time = 0;
  double sum() const { return undone + drops + tension + force + cut + tails + time; }
};

/// Result of the judge for one step.
struct Finding {
  Stage stage = Stage::kTake;
  End end = End::kRunning;
  bool held = false, tied = false, wrong = false, sliding = false, loose = false, together = false, taut = false;
  bool too_hard[2] = {false, false};
  bool dropped = false, undone = false, cut = false;  // in this step; cut: an end, off the knot
  Points lost;
  double score = 0;
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt)
      : rules_(rules), path_(dt), grip_(rules.force_high, dt), pull_(rules.tension, dt) {}
  Finding look(Memory& memory, const Look& look) const noexcept;  // [rt]
  const Rules& rules() const { return rules_; }
  const GripWatch& grip() const { return grip_; }
  const GripWatch& pull() const { return pull_; }
  static double task_time(const Memory& memory, double time_s);
  bool end_good(const Memory& memory, int end) const noexcept;

 private:
  void follow_hands(Memory& memory, const Look& look, Finding& finding) const noexcept;
  bool drops(Memory& memory, const Look& look, bool had) const noexcept;
  void follow_force(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_knot(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_cut(Memory& memory, const Look& look, Finding& finding) const noexcept;
  bool ends_good(const Memory& memory) const noexcept { return !rules_.cut || (end_good(memory, 0) && end_good(memory, 1)); }
  Stage stage(const Memory& memory, const Look& look, const Finding& finding, bool good) const noexcept;
  End end(const Memory& memory, const Look& look) const noexcept;
  void decide(Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, double time_s) const noexcept;

  Rules rules_;
  PathWatch path_;
  GripWatch grip_, pull_;
};

}  // namespace swage::lesson_knot
