// SPDX-License-Identifier: Apache-2.0
//
// Questions about knots, one after another: show, ask, pull, tell the result. Pure arithmetic on the observations of one step; terms and
// formulas are explained in fault.md.
#pragma once

#include "common/watches.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_fault {

using lessons::PathState;
using lessons::PathWatch;
using toolkit::Vec3;

/// Kinds of knot, in the order of the shapes of the thread and of the places of the answers.
enum class Knot : int { kSquare, kGranny, kSliding, kLoose, kCount };
inline constexpr size_t kKnots = static_cast<size_t>(Knot::kCount);

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  int questions = 4;
  int least_right = 3;
  double show_time = 0.7, tell_time = 1;  // s
  double closed = 0.07;                   // rad, 4 deg: opening below which the jaws answer
  double reach = 0.8e-3;                  // m, greatest distance of the tips from the place of an answer
  double load = 0.1;                      // N, that a sound knot bears
  double hold_time = 0.5;                 // s, for which it bears the load
  double most_opening = 3e-3;             // m, opening of the loop at which a knot has failed
  double pull_time = 10;                  // s, of pulling after which it has failed as well
  double par_time = 60, max_time = 300;   // s
  bool ends = true;                       // the time limit ends the attempt
};

/// Observations of one step.
struct Look {
  double time_s = 0;
  Vec3 tip_W = Vec3::Zero();                 // m, of the hand that answers
  double opening = 0;                        // rad
  Vec3 answer_W[kKnots] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // m
  int knot = 0;                              // Knot of the present question
  double tension = 0;                        // N, of its thread
  Vec3 puller_W = Vec3::Zero();              // m, tips of the instrument that pulls
};

enum class Stage { kShow, kAsk, kPull, kTell, kDone };
enum class End { kRunning, kPassed, kWrong, kOutOfTime };

/// Result of the last pull of a kind of knot.
struct Pulled {
  double borne = 0;    // N, greatest tension
  double opening = 0;  // m, of its loop, from the state in which it was taut
  double count = 0;    // how often that kind was pulled
};

/// State of the judge from step to step: doubles only.
struct Memory {
  PathState path;
  double stage = 0, begun = 0;  // Stage; 0 or 1
  double question = 0;          // from 0 on
  double until_s = 0;           // s, end of the present stage
  double asked_s = 0;           // s, when the question was put
  double armed = 0;             // 0 or 1: the jaws have been open since
  double right = 0;             // 0 or 1: the last answer was right
  double answers = 0, rights = 0, false_alarms = 0, missed = 0;
  double answer_s = 0;          // s, time taken for all answers
  double taut = 0;              // 0 or 1: the loop of the present pull has been taut
  double taut_W[3] = {};        // m, tips of the instrument then
  double borne_s = 0;           // s, for which it has borne the load
  double held = 0;              // 0 or 1: the last knot held
  Pulled pulled[kKnots];
};

/// Points deducted, of 100.
struct Points {
  double time = 0, wrong = 0, missed = 0;
  double sum() const { return time + wrong + missed; }
};

/// Result of the judge for one step.
struct Finding {
  Stage stage = Stage::kShow;
  End end = End::kRunning;
  bool next = false;      // a new question begins in this step
  bool answered = false;  // in this step
  int answer = 0;         // with `answered`: Knot
  bool pulled = false;    // the pull has ended, in this step
  double result = 0;      // with `pulled`: m, opening of the loop if the knot held; N, greatest tension if not
  double score = 0;       // 0..100, once the attempt has ended
  Points lost;            // likewise, of a passed attempt
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt) : rules_(rules), path_(dt), dt_(dt) {}

  /// Judges one step. [rt]
  Finding look(Memory& memory, const Look& look) const noexcept;
  const Rules& rules() const { return rules_; }
  static size_t question(const Memory& memory) { return static_cast<size_t>(memory.question); }

 private:
  void ask(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void pull(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void go_on(Memory& memory, double time_s, Finding& finding) const noexcept;
  void decide(const Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, double time_s) const noexcept;

  Rules rules_;
  PathWatch path_;
  double dt_ = 1e-3;
};

}  // namespace swage::lesson_fault
