// SPDX-License-Identifier: Apache-2.0
//
// Questions about angles, one after another: show, ask, tell. Pure arithmetic on what was seen in one step; meanings and formulas
// are explained in angles.md.
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

/// What is asked of the trainee.
struct Rules {
  int questions = 40;                                // at most half of them about one axis
  double start = 16 * kDegree, least = 1 * kDegree;  // rad: first lean, smallest step
  double show_time = 0.7, tell_time = 0.5;           // s
  double closed = 0.07;                              // rad, 4 deg: between jaws that have answered
  double reach = 1.6e-3;                             // m, the tips must be so near to a mark
  double max_bias = 10 * kDegree;                    // rad
  double max_jnd = 8 * kDegree;                      // rad
  double par_time = 150;                             // s
  double max_time = 600;                             // s
  bool ends = true;                                  // the time limit ends the attempt
};

/// What one step shows.
struct Look {
  double time_s = 0, dt_s = 1e-3;
  Vec3 tip_W = Vec3::Zero();                          // m
  double opening = 0;                                 // rad
  double lean[kAxes] = {};                            // rad, of what is shown, as it really is
  Vec3 one_W = Vec3::Zero(), other_W = Vec3::Zero();  // m, where the two answers are given
};

enum class Stage { kShow, kAsk, kTell, kDone };
enum class End { kRunning, kPassed, kBiased, kUnsure, kOutOfTime };

/// Everything remembered from step to step: doubles only.
struct Memory {
  PathState path;
  TrackState track[kTracks];
  AnswersState axis[kAxes];
  double begun = 0, stage = 0;   // 0 or 1; Stage
  double shown = 0;              // which track
  double until_s = 0;            // s, end of the present stage
  double asked_s = 0;            // s, when the question was put
  double armed = 0;              // 0 or 1: the jaws were open since
  double rights = 0, right = 0;  // right answers; whether the last one was
  double answer_s = 0;           // s, time taken for all answers
};

/// What is to be said after one step.
/// Points of 100 that were lost.
struct Points {
  double time = 0, bias = 0, jnd = 0;
  double sum() const { return time + bias + jnd; }
};

struct Finding {
  Stage stage = Stage::kShow;
  End end = End::kRunning;
  bool draw = false;      // the next question is to be drawn
  bool answered = false;  // in this step
  double lean = 0;        // rad, with `answered`: what it was
  double score = 0;       // 0..100, once it has ended
  Points lost;            // likewise, when it was passed
};

class Judge {
 public:
  Judge() = default;
  Judge(const Rules& rules, double dt) : rules_(rules), path_(dt), track_(rules.start, rules.least) {}

  /// [rt]
  Finding look(Memory& memory, const Look& look) const noexcept;
  /// Draws the next question with a number 0 <= random < 1, from the tracks that were shown least. [rt]
  void draw(Memory& memory, double random, double time_s) const noexcept;
  const Rules& rules() const { return rules_; }

  static size_t axis_of(const Memory& memory) { return static_cast<size_t>(memory.shown) / 2; }
  /// How far what is to be shown leans to the other side, rad.
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
