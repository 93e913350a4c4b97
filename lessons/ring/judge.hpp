// SPDX-License-Identifier: Apache-2.0
//
// Judge of a ring carried along a wire and over posts: progress, touches and score. Pure arithmetic on the observations of one
// step; terms and formulas are explained in ring.md.
#pragma once

#include "common/grip.hpp"
#include "common/measures.hpp"
#include "common/watches.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_ring {

using lessons::DropState;
using lessons::DropWatch;
using lessons::GripState;
using lessons::GripWatch;
using lessons::PathState;
using lessons::PathWatch;
using toolkit::Vec3;

inline constexpr int kMostPosts = 4;

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  double course_low = 0, course_high = 1;  // of the wire, 0..1
  int posts = 1;
  double force_high = 1;    // N
  double par_time = 40;     // s
  double max_time = 180;    // s
  double max_over_time = 2; // s
  int max_touches = 10;
  int max_drops = 2;
  double drop_distance = 2e-3;   // m
  double lost_distance = 30e-3;  // m
  bool ends = true;              // limits end the attempt: of force, time, touches, drops and reach
};

/// Nearest place of a wire or post to the ring's centre.
struct Line {
  double s = 0;         // 0..1 along the line; 1 is the top of a post
  double distance = 0;  // m, from the ring's centre
  double cosine = 0;    // 0..1, of the angle between the ring's axis and the line
};

/// Observations of one step.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  bool held = false, taken = false;  // taken: event of this step
  double force = 0;                  // N, of the grip
  double touch = 0;                  // N, sum of the forces of all watched couplings
  Vec3 tip_W = Vec3::Zero(), ring_W = Vec3::Zero();  // m
  double ring_radius = 1e-3, wire_length = 1e-2;     // m
  Line wire, post;                                   // post: the next one
};

/// State of the judge from step to step: doubles only.
struct Memory {
  PathState path;
  DropState drop;
  GripState grip;
  lessons::TremorState tremor;
  double begun = 0;             // 0 or 1
  double start[3] = {0, 0, 0};  // m
  double wire_end[3] = {0, 0, 0};  // m, where the course of the wire ends
  double grasps = 0, drops = 0, touches = 0;
  double lifted = 0;                        // 0 or 1: the ring has come clear of the wire, or has moved along it
  double touching = 0, untouched_s = 0;     // 0 or 1; s
  double touch_s = 0, carried_s = 0;        // s
  double touch_peak = 0;                    // N
  double over_s = 0;                        // s, held with too much force
  double first_s = -1, last_s = 0;          // place on the wire when it was first held; in the last step
  double travel = 0, off2 = 0, tilt2 = 0;   // m; m3, rad2 m: integrals over the travel
  double reached = 0;                       // 0..1 of the course
  double free = 0;                          // 0 or 1: the ring is off the free end
  double posts = 0, over_post = 0, rest_s = 0;  // posts done; 0 or 1; s, let go over the last post
  double passed = 0;
};

enum class Stage { kTake, kCarry, kPost, kDone };
enum class End { kRunning, kPassed, kTouched, kDropped, kTooHard, kOutOfTime, kLost };

/// Points deducted, of 100.
struct Points {
  double touches = 0, touch_time = 0, drops = 0, force = 0, time = 0;
  double sum() const { return touches + touch_time + drops + force + time; }
};

/// Result of the judge for one step.
struct Finding {
  Stage stage = Stage::kTake;
  End end = End::kRunning;
  bool carried = false, touching = false, too_hard = false, over_post = false;
  bool touched = false, dropped = false, post_done = false;  // in this step
  double score = 0;                                          // 0..100, once the attempt has ended
  Points lost;                                               // likewise, of a passed attempt
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt);

  /// Judges one step. [rt]
  Finding look(Memory& memory, const Look& look) const noexcept;
  const Rules& rules() const { return rules_; }
  const GripWatch& grip() const { return grip_; }
  /// Whether a line passes through the ring's hole.
  static bool threaded(const Line& line, double ring_radius);

 private:
  void follow_touch(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_wire(Memory& memory, const Look& look) const noexcept;
  void follow_posts(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void follow_ring(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void decide(Memory& memory, const Look& look, Finding& finding) const noexcept;
  double progress(const Memory& memory) const;

  Rules rules_;
  PathWatch path_;
  DropWatch drop_;
  GripWatch grip_;
  lessons::TremorWatch tremor_;
};

inline double task_time(const Memory& memory, double time_s) {
  return memory.path.set_off_s < 0 ? 0 : time_s - memory.path.set_off_s;
}
inline double touch_share(const Memory& m) { return m.carried_s > 0 ? m.touch_s / m.carried_s : 0; }
inline double over_share(const Memory& m) { return m.grip.held_s > 0 ? m.over_s / m.grip.held_s : 0; }
inline double by_way(const Memory& m, double square) { return m.travel > 0 ? std::sqrt(square / m.travel) : 0; }

}  // namespace swage::lesson_ring
