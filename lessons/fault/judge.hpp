// SPDX-License-Identifier: Apache-2.0
//
// Questions about knots, one after another: show, ask, pull, tell. Pure arithmetic on what was seen in one step; meanings and formulas are
// explained in fault.md.
#pragma once

#include "common/watches.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_fault {

using lessons::PathState;
using lessons::PathWatch;
using toolkit::Vec3;

/// What a knot is, in the order of the shapes of its thread and of the places where answers are given.
enum class Knot : int { kSquare, kGranny, kSliding, kLoose, kCount };
inline constexpr size_t kKnots = static_cast<size_t>(Knot::kCount);

/// What is asked of the trainee.
struct Rules {
  int questions = 4;
  int least_right = 3;
  double show_time = 0.7, tell_time = 1;  // s
  double closed = 0.07;                   // rad, 4 deg: between jaws that have answered
  double reach = 0.8e-3;                  // m, the tips must be so near to a place
  double load = 0.1;                      // N, that a knot is to bear
  double hold_time = 0.5;                 // s, for which it is to bear that
  double most_opening = 3e-3;             // m, of the loop: the knot has given way
  double pull_time = 10;                  // s, after which it has, too
  double par_time = 60, max_time = 300;   // s
  bool ends = true;                       // the time limit ends the attempt
};

/// What one step shows.
struct Look {
  double time_s = 0;
  Vec3 tip_W = Vec3::Zero();                 // m, of the hand that answers
  double opening = 0;                        // rad
  Vec3 answer_W[kKnots] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // m
  int knot = 0;                              // which it is, of the question under way
  double tension = 0;                        // N, of its thread
  Vec3 puller_W = Vec3::Zero();              // m, tips of the instrument that pulls
};

enum class Stage { kShow, kAsk, kPull, kTell, kDone };
enum class End { kRunning, kPassed, kWrong, kOutOfTime };

/// What became of a kind of knot when it was pulled last.
struct Pulled {
  double borne = 0;    // N, most
  double opening = 0;  // m, of its loop since it was taut
  double count = 0;    // how often that kind was pulled
};

/// Everything remembered from step to step: doubles only.
struct Memory {
  PathState path;
  double stage = 0, begun = 0;  // Stage; 0 or 1
  double question = 0;          // from 0 on
  double until_s = 0;           // s, end of the present stage
  double asked_s = 0;           // s, when the question was put
  double armed = 0;             // 0 or 1: the jaws were open since
  double right = 0;             // whether the last answer was
  double answers = 0, rights = 0, false_alarms = 0, missed = 0;
  double answer_s = 0;          // s, time taken for all answers
  double taut = 0;              // 0 or 1: the loop under way was drawn taut
  double taut_W[3] = {};        // m, where the instrument was then
  double borne_s = 0;           // s, for which it has borne the load
  double held = 0;              // whether the last one held
  Pulled pulled[kKnots];
};

/// Points of 100 that were lost.
struct Points {
  double time = 0, wrong = 0, missed = 0;
  double sum() const { return time + wrong + missed; }
};

/// What is to be said after one step.
struct Finding {
  Stage stage = Stage::kShow;
  End end = End::kRunning;
  bool next = false;      // a question is put anew, in this step
  bool answered = false;  // in this step
  int answer = 0;         // with `answered`: Knot
  bool pulled = false;    // the pull has ended, in this step
  double result = 0;      // with `pulled`: m, opening of the loop of a knot that held; N, most that one has borne that did not
  double score = 0;       // 0..100, once it has ended
  Points lost;            // likewise, when it was passed
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt) : rules_(rules), path_(dt), dt_(dt) {}

  /// [rt]
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
