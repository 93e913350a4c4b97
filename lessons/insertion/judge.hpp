// SPDX-License-Identifier: Apache-2.0
//
// Judge of an insertion: when it is good, when it is complete, and its score. Pure arithmetic on the observations of one step;
// terms and formulas are explained in insertion.md.
#pragma once

#include <swage/units.hpp>

#include "common/grip.hpp"
#include "common/watches.hpp"
#include "far.hpp"
#include "stitch.hpp"
#include "stray.hpp"
#include "suture.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_insertion {

using lessons::DropState;
using lessons::DropWatch;
using lessons::GripState;
using lessons::GripWatch;
using lessons::PathState;
using lessons::PathWatch;
using toolkit::Vec3;

enum class Task : int {
  kInsert,  // in at the mark and along the arc until enough of the needle is in the tissue
  kStitch,  // and out, let go, taken on the other side, and pulled through
};

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  Task task = Task::kInsert;
  double tolerance = 0.3e-3;       // m, entry from the mark
  double in_angle = 15 * kDegree;  // rad, greatest deviation that counts as perpendicular
  double least_in_angle = 0.5;     // share of the travel that must be within in_angle
  double drive = 0.35;             // share of the needle to be driven in
  double max_wound = 6;            // distance of the wound's edge from the first puncture, over the wire's radius
  double force_high = 1.5;         // N
  double par_time = 30;            // s
  double max_time = 300;           // s
  int max_drops = 2;
  int max_deflections = 5;
  double drop_distance = 3e-3;   // m
  double lost_distance = 30e-3;  // m, from the mark
  int stitches = 1;             // required number
  bool exit_mark = false;       // there is a mark of the exit
  bool ends = true;             // limits end the attempt: of time, wound, drops, punctures and reach
  double region_low = 0, region_high = 0;  // where the needle should be held, 0 point .. 1 swage; both 0: anywhere
  double tip_low = 0, tip_high = 0.3e-3;   // m, required tip overhang past the needle
  SutureRules suture;
  FarRules far;
};

/// Observations of one step. The pierce.* signals under short names.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  bool held = false;
  double force = 0;                                    // N
  double grip_s = 0;                                   // where the jaws hold the needle, 0 point .. 1 swage
  double tip_reach = 0;                                // m, of the tips past the needle
  double tilt_axis = 0, tilt_plane = 0;                // rad, of the needle in the jaws
  double bending = 0;                                  // moment in the needle over its yield moment; 0 for a rigid one
  Vec3 tip_W = Vec3::Zero(), needle_W = Vec3::Zero();  // m
  double length = 0;                                   // m, of the needle
  Vec3 target_W = Vec3::Zero(), normal_W = Vec3::UnitZ(), point_W = Vec3::Zero();
  Vec3 exit_target_W = Vec3::Zero();                                        // m
  bool touching = false;                                                    // the point presses on the tissue, or is in it
  bool in_tissue = false;                                                   // the needle is in its track
  bool entered = false, exited = false, passed = false, deflected = false;  // events of this step
  double angle = 0, cosine = 0;                                             // rad, 1
  double s = 0;                 // place of the needle at the surface, 0 at the point
  double exit_angle = 0;        // rad, with `exited`
  Vec3 entry_W = Vec3::Zero();  // m
  double arc_error = 0;         // m, distance of the entry from the needle's centre line
  Hole hole;                    // with `entered` and `exited`
  bool needle_astray = false;   // the needle touches the tissue outside the task's region
  bool jaws_astray = false;     // a jaw is in the tissue
  double diameter = 100e-6;     // m, of the wire
  double wound = 0, area_ratio = 0, swept = 0, below = 0, pull = 0;  // 1, 1, m2, m, N
  double wound_wide = 0, exit_wound = 0;  // 1: wound from its own centre; wound of the exit, 0 before
  SutureLook suture;
  FarLook far;
};

/// Rotation of the needle in the jaws by the tissue (thesis 5.2.3), from the first touch in a hold on: doubles only.
struct TwistState {
  double from = 0, axis = 0, plane = 0;  // 0 or 1: touched in this hold; rad, the tilts at that touch
  double told = 0, most = 0;             // 0 or 1: there is a value; rad, the greatest rotation
};

/// State of the judge from step to step: doubles only.
struct Memory {
  PathState path;
  DropState drop;
  GripState grip;
  double begun = 0;
  double drops = 0, entries = 0, deflections = 0, missed = 0;
  double deflected_s = -1e3;                   // s, when the last deflection was counted
  double entry_distance = 0, entry_angle = 0;  // m, rad, of the last entry
  double worst_entry = 0, worst_wound = 0;     // m, 1: of finished stitches
  double worst_exit = 0;                       // 1, exit wound of finished stitches
  double wall = 0;                             // m, thickness of the tissue at the entry
  double exit_angle = 0, exit_distance = 0;    // rad, m, of the last exit
  double last_s = 0, tracked = 0;              // tracked: last_s is of this track
  double travel = 0, travel_in = 0;            // m, travel of the needle through its entry; of that, within in_angle
  double angle2 = 0, arc2 = 0;                 // rad2 m, m3: integrals over the travel
  double inside_s = 0, cosine_s = 0;           // s
  double pull_s = 0;                           // N s
  double reach_s = 0, bending = 0;             // m s; 1, the greatest
  double deepest = 0;                          // greatest share of the needle inside
  TwistState twist;
  double reached = 0;                          // 0 or 1: the jaws have reached the tissue, and the needle was not taken further back since
  double exited = 0, let_go = 0, retaken = 0, through = 0;
  StitchState stitch;
  StrayState stray;
  SutureState suture;
  FarState far;
};

enum class Stage { kTake, kAim, kDrive, kRelease, kRetake, kPull, kDone, kCross, kCutOff, kRegrasp, kDraw };
enum class End {
  kRunning, kPassed, kDropped, kMissed, kTorn, kDeflected, kOutOfTime, kLost, kOffAngle, kPulledOff, kTailLost, kStep, kCount
};

/// Grade of the grasp before the entry: position and tips right or wrong.
enum class Grip { kNone, kWrong, kTipsOnly, kPointOnly, kGood };

/// Points deducted, of 100.
struct Points {
  double wound = 0, angle = 0, entry = 0, bending = 0, refused = 0, drops = 0, suture = 0, time = 0;
  double even = 0, bites = 0, oblique = 0, loops = 0, tension = 0;  // of several stitches; of a thread
  double step = 0, tails = 0;                                            // of two edges; of stitches that are cut off
  double exit = 0;                                                       // of the exit wound
  double sum() const {
    return wound + angle + entry + bending + refused + drops + suture + time + even + bites + oblique + loops + tension + step + tails + exit;
  }
};

/// Result of the judge for one step.
struct Finding {
  Stage stage = Stage::kTake;
  End end = End::kRunning;
  Grip grip = Grip::kNone;                     // kNone also where no region is required
  bool near = false;                           // the point is at the place of the entry
  bool exit_near = false;                      // the exit is at its mark
  bool angle_good = false, angle_off = false;  // in the tissue
  bool stuck = false;                          // the needle was let go in the tissue, where it should not be
  bool torn = false;                           // the wound is larger than careful hands leave
  bool too_hard = false;
  bool dropped = false, missed = false;  // in this step
  bool far_first = false;                // in this step: the point entered the far edge without the near one
  bool stitched = false;                 // in this step: a stitch is complete, and another one is required
  bool swage_held = false;               // grasped where the thread is swaged in
  bool cut_off = false;                  // in this step: the thread was cut
  double cut_tail = 0;                   // with `cut_off`: m of thread that are left beyond the exit
  bool damaged = false;                  // in this step: such a grasp begins
  bool taut = false;                     // the tension of the thread is above its limit
  bool loop_good = false;                // the loop has the required length
  double score = 0;                      // 0..100, once the attempt has ended
  Points lost;                           // likewise, of a passed attempt
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt);

  /// Judges one step. [rt]
  Finding look(Memory& memory, const Look& look) const noexcept;
  const Rules& rules() const { return rules_; }
  const GripWatch& grip() const { return grip_; }

 private:
  void follow_entry(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_far(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_stitch(Memory& memory, const Look& look, Finding& finding) const noexcept;
  static void count_deflection(Memory& memory, const Look& look, bool deflected) noexcept;
  static void follow_twist(TwistState& twist, const Look& look) noexcept;
  void integrate(Memory& memory, const Look& look) const noexcept;
  void follow_needle(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_jaws(Memory& memory, const Look& look) const noexcept;
  Stage stage(const Memory& memory, const Look& look) const noexcept;
  Grip how_held(const Look& look) const noexcept;
  void decide(const Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, const Look& look) const noexcept;
  double score(const Memory& memory, const Points& lost, bool passed) const noexcept;

  Rules rules_;
  PathWatch path_;
  DropWatch drop_;
  GripWatch grip_;
};

/// Whether a part of the needle is in the tissue or in the far edge.
inline bool inside(const Look& look) { return look.in_tissue || look.far.in_tissue; }
/// The wound where the needle came out of the outer surface, 0 before: that of the far edge where there is one.
inline double exit_wound(const Look& look, const FarRules& far) { return far.there ? look.far.exit_wound : look.exit_wound; }
/// The greater wound of the two edges.
inline double wound(const Look& look) { return std::max(look.wound, look.far.wound); }

/// Time since the hand set off, s.
inline double task_time(const Memory& memory, double time_s) {
  return memory.path.set_off_s < 0 ? 0 : time_s - memory.path.set_off_s;
}
/// Root mean square of the deviation angle, weighted by travel, rad; arc_rms: of the distance from the needle's arc, m.
inline double angle_rms(const Memory& m) { return m.travel > 0 ? std::sqrt(m.angle2 / m.travel) : 0; }
/// Share of the needle's travel through its entry within in_angle; 1 before any travel.
inline double in_angle_share(const Memory& m) { return m.travel > 0 ? m.travel_in / m.travel : 1; }
inline double arc_rms(const Memory& m) { return m.travel > 0 ? std::sqrt(m.arc2 / m.travel) : 0; }

}  // namespace swage::lesson_insertion
