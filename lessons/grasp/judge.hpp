// SPDX-License-Identifier: Apache-2.0
//
// Judge of a grasp: when it is good, when a hold is complete, and its score. Pure arithmetic on the observations of one step; the
// terms and formulas are explained in grasp.md.
#pragma once

#include <algorithm>

#include "common/grip.hpp"
#include "common/measures.hpp"
#include "common/watches.hpp"
#include "target.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_grasp {

using lessons::DropState;
using lessons::DropWatch;
using lessons::GripState;
using lessons::GripWatch;
using lessons::PathState;
using lessons::PathWatch;
using toolkit::Quat;
using toolkit::Vec3;

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  double region_low = 0.5, region_high = 0.75;  // along the needle, 0 point .. 1 swage
  double tip_low = -0.2e-3, tip_high = 2e-3;    // m, allowed tip overhang past the needle
  bool tips_needed = false;
  double max_tilt = 0;                        // rad, of axis and plane; 0: any
  double force_low = 0.05, force_high = 1.0;  // N
  double lift = 0;                            // m
  double hold_time = 3;                       // s
  double par_time = 20;                       // s
  double max_time = 120;                      // s
  double max_over_time = 2;                   // s
  int max_drops = 2;
  double drop_distance = 2e-3;   // m
  double max_wrong_time = 20;    // s, 0: no limit
  bool ends = true;              // limits end the attempt: of force, time, drops and reach
  double lost_distance = 30e-3;  // m
  TargetRules target;
};

/// Observations of one step.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  bool held = false, touched = false, taken = false;  // the last two: events of this step
  bool reset = false;                                 // likewise: the needle was reset
  double force = 0;                                   // N
  double s = 0;                                       // 0 point .. 1 swage
  double tip_reach = 0;                               // m
  double tilt_axis = 0, tilt_plane = 0;               // rad
  double balance = 0;
  double opening = 0;                                  // rad, between the jaws
  double bending = 0;                                  // moment in the needle over its yield moment
  Vec3 tip_W = Vec3::Zero(), needle_W = Vec3::Zero();  // m
  Quat q_WN = Quat::Identity();
  double target_distance = 0;  // m, of the nearest place of the needle to the target
};

/// State of the judge from step to step: doubles only.
struct Memory {
  PathState path;
  DropState drop;
  GripState grip;
  double begun = 0;             // 0 or 1
  double start[3] = {0, 0, 0};  // m, where the needle lay
  double taken[3] = {0, 0, 0};  // m, where it was when it was grasped: open jaws may have pushed it there
  double tries = 0, grasps = 0, good_grasps = 0, regrasps = 0, drops = 0;
  double spot_error_sum = 0;                                   // along the needle, 0..1
  double reach_s = 0, axis_s = 0, plane_s = 0, balance_s = 0;  // integrals over the held time
  double over_s = 0, over_dose = 0;                            // s, N s
  double hold_s = 0, best_hold_s = 0, holding = 0;             // s, s, 0 or 1
  double touch_q[4] = {1, 0, 0, 0};                            // orientation of the needle at the last touch
  double snap_wait_s = 0, snap_sum = 0;                        // s, rad
  double engaged = 0;                                          // 0 or 1: touched, and not dropped since
  double tried = 0, least_opening = 0;  // 0 or 1: this closing of the jaws is counted; rad, smallest opening since then
  double wrong_s = 0;                   // s, of the present wrong grasp
  double resets = 0, bending = 0, passed = 0;
  double touched_s = -1;                   // s, when it was first touched; -1: not yet
  double phase_s[7] = {0, 0, 0, 0, 0, 0, 0};  // s, by Stage
  double lifted_s = 0, timid_s = 0;     // s, held and lifted; s, of that with less than the least force
  lessons::SpreadState spread;          // of the force in that time
  lessons::IdleState idle;
  lessons::TremorState tremor;
  TargetState target;
};

/// Grade of a grasp: position and tips right or wrong.
enum class Grade { kNone, kWrong, kTipsOnly, kPointOnly, kTilted, kGood };
/// kRegrasp: held outside the region, reported in practice only. kDropped: the needle lies where it fell.
enum class Stage { kApproach, kGrasp, kCarry, kHold, kDone, kRegrasp, kDropped };
enum class End { kRunning, kPassed, kDropped, kTooHard, kOutOfTime, kWrongGrasp, kLost, kLeftTarget };

/// Points deducted, of 100.
struct Points {
  double tries = 0, drops = 0, hold = 0, force = 0, tilt = 0, bending = 0, time = 0;
  double sum() const { return tries + drops + hold + force + tilt + bending + time; }
};

/// Result of the judge for one step.
struct Finding {
  Grade grade = Grade::kNone;
  Stage stage = Stage::kApproach;
  End end = End::kRunning;
  bool too_hard = false;
  bool near_target = false;                                      // within its radius
  bool dropped = false, hold_began = false, hold_broke = false;  // in this step
  double score = 0;                                              // 0..100, once the attempt has ended
  Points lost;                                                   // likewise, of a passed attempt
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt);

  /// Judges one step. [rt]
  Finding look(Memory& memory, const Look& look) const noexcept;

  bool in_region(double s) const { return s >= rules_.region_low && s <= rules_.region_high; }
  /// Whether the tilt in the jaws is within max_tilt; during a hold a tenth more is allowed.
  bool square(const Memory& memory, const Look& look) const;
  bool tilted(const Memory& memory, const Look& look) const;
  bool in_tips(double reach) const { return reach >= rules_.tip_low && reach <= rules_.tip_high; }
  /// Distance from the region along the needle, 0 inside, 0..1.
  double spot_error(double s) const;
  const Rules& rules() const { return rules_; }
  const GripWatch& grip() const { return grip_; }

 private:
  void begin(Memory& memory, const Look& look) const noexcept;
  void count(Memory& memory, const Look& look) const noexcept;
  void integrate(Memory& memory, const Look& look) const noexcept;
  void follow_drop(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_hold(Memory& memory, const Look& look, Finding& finding) const noexcept;
  bool grasped_well(const Memory& memory, const Look& look, const Finding& finding) const noexcept;
  void measure(Memory& memory, const Look& look, const Finding& finding) const noexcept;
  void decide(Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, double time_s) const noexcept;
  double score(const Memory& memory, const Points& lost, bool passed) const noexcept;

  Rules rules_;
  PathWatch path_;
  DropWatch drop_;
  GripWatch grip_;
  Target target_;
  lessons::IdleWatch idle_;
  lessons::TremorWatch tremor_;
};

/// Time since the hand set off, s.
inline double task_time(const Memory& memory, double time_s) {
  return memory.path.set_off_s < 0 ? 0 : time_s - memory.path.set_off_s;
}
/// Time from then until the jaws first touched the needle, s.
inline double approach_time(const Memory& memory) {
  return memory.path.set_off_s < 0 ? 0 : std::max(0.0, memory.touched_s - memory.path.set_off_s);
}
/// Integral over the held time, divided by it; 0 before the first hold.
inline double mean(const Memory& memory, double integral) {
  return memory.grip.held_s > 0 ? integral / memory.grip.held_s : 0;
}

}  // namespace swage::lesson_grasp
