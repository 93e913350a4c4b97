// SPDX-License-Identifier: Apache-2.0
//
// Judge of a thread wound about an instrument, and its score. Pure arithmetic on the observations of one step; formulas:
// loop.md.
#pragma once

#include "common/grip.hpp"
#include "common/watches.hpp"

namespace swage::lesson_loop {

using lessons::GripWatch;
using lessons::PathWatch;
using toolkit::Vec3;

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  int turns = 1;
  int sense = 0;                            // 1, -1: right-handed, left-handed about the instrument; 0: either
  double least_draw = 0.1e-3;               // N, least force of the thread on the instrument
  double tension = 20e-3;                   // N, limit
  double force_low = 0.05, force_high = 1;  // N
  double hold_time = 2;                     // s
  double par_time = 20;                     // s
  double max_time = 120;                    // s
  double max_over_time = 2;                 // s
  int max_drops = 2;
  bool ends = true;  // limits end the attempt: of force, time and drops
};

/// Observations of one step.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  bool held = false;
  double force = 0;  // N, of the jaws that hold the thread
  Vec3 tip_W[2] = {Vec3::Zero(), Vec3::Zero()};
  double turns = 0, whole = 0;  // with their sign
  double behind = 0;            // m
  double draw = 0;              // N, of the thread on the instrument
  double tension = 0;           // N, of the thread at the tissue
  double parted = 0, passages = 0;
};

/// State of the judge from step to step: doubles only.
struct Memory {
  lessons::PathState path[2];
  lessons::GripState grip, pull;  // of the jaws; of the thread
  double has = 0;                 // 0 or 1: the thread is held, and its grip force has not ceased since
  double on = 0;                  // 0 or 1: all turns were present in the step before
  double most_turns = 0, slips = 0, drops = 0, passages = 0;
  double held_s = 0, over_s = 0, taut_s = 0;
  double on_s = 0, behind_s = 0;  // s, m s
  double hold_s = 0, best_hold_s = 0, passed = 0;
};

enum class Stage { kTake, kWind, kHold, kDone };
enum class End { kRunning, kPassed, kPassage, kBroken, kDropped, kTooHard, kOutOfTime };

/// Points deducted, of 100.
struct Points {
  double slips = 0, drops = 0, tension = 0, force = 0, time = 0;
  double sum() const { return slips + drops + tension + force + time; }
};

/// Result of the judge for one step.
struct Finding {
  Stage stage = Stage::kTake;
  End end = End::kRunning;
  bool held = false, on = false, too_many = false, taut = false, too_hard = false;
  bool slipped = false, dropped = false;  // in this step
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

 private:
  void follow_hands(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_turns(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void decide(Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, double time_s) const noexcept;
  double counted(const Look& look) const noexcept;

  Rules rules_;
  PathWatch path_;
  GripWatch grip_, pull_;
};

}  // namespace swage::lesson_loop
