// SPDX-License-Identifier: Apache-2.0
//
// Questions about angles, one after another: show, ask, tell the result. Pure arithmetic on the observations of one step; terms and
// formulas are explained in angles.md.
#pragma once

#include <swage/units.hpp>

#include "common/watches.hpp"
#include "staircase.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_angles {

using lessons::PathState;
using lessons::PathWatch;
using toolkit::Vec3;

/// Across the line of sight, and along it.
enum class Axis : size_t { kSide, kDepth, kCount };
inline constexpr size_t kAxes = static_cast<size_t>(Axis::kCount), kTracks = 2 * kAxes;

/// Requirements on the trainee, from the parameters of the lesson.
struct Rules {
  int questions = 40;                                // at most half of them about one axis
  double start = 16 * kDegree, least = 1 * kDegree;  // rad: first lean, smallest step
  double show_time = 0.7, tell_time = 0.5;           // s
  double closed = 0.07;                              // rad, 4 deg: opening below which the jaws answer
  double reach = 1.6e-3;                             // m, greatest distance of the tips from the mark of an answer
  double max_bias = 10 * kDegree;                    // rad
  double max_jnd = 8 * kDegree;                      // rad
  double par_time = 150;                             // s
  double max_time = 600;                             // s
  bool ends = true;                                  // the time limit ends the attempt
};

/// Observations of one step.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  Vec3 tip_W = Vec3::Zero();                          // m
  double opening = 0;                                 // rad
  double lean[kAxes] = {};                            // rad, true lean of the shown object
  Vec3 one_W = Vec3::Zero(), other_W = Vec3::Zero();  // m, where the two answers are given
};

enum class Stage { kShow, kAsk, kTell, kDone };
enum class End { kRunning, kPassed, kBiased, kUnsure, kOutOfTime };

/// State of the judge from step to step: doubles only.
struct Memory {
  PathState path;
  TrackState track[kTracks];
  AnswersState axis[kAxes];
  double begun = 0, stage = 0;   // 0 or 1; Stage
  double shown = 0;              // which track
  double until_s = 0;            // s, end of the present stage
  double asked_s = 0;            // s, when the question was put
  double armed = 0;              // 0 or 1: the jaws have been open since
  double rights = 0, right = 0;  // number of right answers; 0 or 1, the last one
  double answer_s = 0;           // s, time taken for all answers
};

/// Points deducted, of 100, for the time, the bias and
/// the just-noticeable difference.
struct Points {
  double time = 0, bias = 0, jnd = 0;
  double sum() const { return time + bias + jnd; }
};

struct Finding {
  Stage stage = Stage::kShow;
  End end = End::kRunning;
  bool draw = false;      // the next question is to be drawn
  bool answered = false;  // in this step
  double lean = 0;        // rad, with `answered`: the true lean
  double score = 0;       // 0..100, once the attempt has ended
  Points lost;            // likewise, of a passed attempt
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt) : rules_(rules), path_(dt), track_(rules.start, rules.least) {}

  /// Judges one step. [rt]
  Finding look(Memory& memory, const Look& look) const noexcept;
  /// Draws the next question with a number 0 <= random < 1, from the tracks that were shown least. [rt]
  void draw(Memory& memory, double random, double time_s) const noexcept;
  const Rules& rules() const { return rules_; }

  static size_t axis_of(const Memory& memory) { return static_cast<size_t>(memory.shown) / 2; }
  /// Lean of the object to be shown, rad, positive to the other side.
  static double lean_of(const Memory& memory) {
    const auto shown = static_cast<size_t>(memory.shown);
    return (shown % 2 == 0 ? 1 : -1) * memory.track[shown].level;
  }
  static double answers(const Memory& memory) { return memory.axis[0].n + memory.axis[1].n; }

 private:
  void ask(Memory& memory, const Look& look, Finding& finding) const noexcept;
  void decide(const Memory& memory, const Look& look, Finding& finding) const noexcept;
  Points points(const Memory& memory, double time_s) const noexcept;
  double score(const Memory& memory, const Points& lost, bool passed) const noexcept;

  Rules rules_;
  PathWatch path_;
  Track track_;
};

}  // namespace swage::lesson_angles
