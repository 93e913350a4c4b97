// SPDX-License-Identifier: Apache-2.0
//
// Judge of passing a needle from one gripper to the other, and its score. Pure arithmetic on the observations of one step;
// formulas: pass.md.
#pragma once

#include "common/grip.hpp"
#include "common/watches.hpp"

namespace swage::lesson_pass {

using lessons::DropWatch;
using lessons::GripWatch;
using lessons::PathWatch;
using toolkit::Vec3;

inline constexpr int kHands = 2;

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  double force_low = 0.05, force_high = 1;  // N
  double place_radius = 1e-3;               // m
  double share_time = 0.3;                  // s, held by both
  int passes = 1;
  double hold_time = 2;      // s, by the last one alone
  double par_time = 30;      // s
  double max_time = 180;     // s
  double max_over_time = 2;  // s
  int max_drops = 2;
  double drop_distance = 2e-3, lost_distance = 30e-3;  // m
  bool ends = true;                                    // limits end the attempt: of force, time, drops and reach
};

/// Observations of one step.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  struct Hand {
    bool held = false;
    double force = 0;  // N
    Vec3 tip_W = Vec3::Zero();
  } hand[kHands];
  Vec3 needle_W = Vec3::Zero();
  double place_distance = 0;  // m, of the nearest place of the needle to the place of passing
  double bending = 0;         // moment in the needle over its yield moment
  bool reset = false;         // the needle was reset in this step
};

/// State of the judge from step to step: doubles only.
struct Memory {
  lessons::PathState path[kHands];
  lessons::GripState grip[kHands];
  lessons::DropState drop;
  double begun = 0;             // 0 or 1
  double start[3] = {0, 0, 0};  // m, where the needle lay
  double has[kHands] = {0, 0};  // 0 or 1: the needle is held, and the grip force has not ceased since
  double owner = 0;             // 1 + index of the hand that last held it alone; 0: none yet
  double both_s = 0, place_s = 0;   // s, held by both since the owner held it alone; s, of that at the place
  double passes = 0, snatches = 0, drops = 0, resets = 0;
  double shared_s = 0;                 // s, of all passes
  double error_s = 0, shared_all_s = 0;  // m s and s, over the time in which both held it
  double held_s = 0, over_s = 0, bending = 0;
  double hold_s = 0, best_hold_s = 0, passed = 0;
};

enum class Stage { kTake, kBring, kPass, kHold, kDone };
enum class End { kRunning, kPassed, kDropped, kTooHard, kOutOfTime, kLost };

/// Points deducted, of 100.
struct Points {
  double drops = 0, snatches = 0, force = 0, bending = 0, time = 0;
  double sum() const { return drops + snatches + force + bending + time; }
};

/// Result of the judge for one step.
struct Finding {
  Stage stage = Stage::kTake;
  End end = End::kRunning;
  bool near_place = false, may_let_go = false, held = false;
  bool passed_on = false, snatched = false, dropped = false;  // in this step
  bool too_hard[kHands] = {false, false};
  Points lost;
  double score = 0;
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt) : rules_(rules), path_(dt), drop_(rules.drop_distance), grip_(rules.force_high, dt) {}
  Finding look(Memory& memory, const Look& look) const noexcept;  // [rt]
  const Rules& rules() const { return rules_; }
  const GripWatch& grip() const { return grip_; }
  static double task_time(const Memory& memory, double time_s);

 private:
  void follow_grips(Memory& memory, const Look& look) const noexcept;
  void follow_hands(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_owner(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_hold(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_drop(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void decide(Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, double time_s) const noexcept;

  Rules rules_;
  PathWatch path_;
  DropWatch drop_;
  GripWatch grip_;
};

}  // namespace swage::lesson_pass
