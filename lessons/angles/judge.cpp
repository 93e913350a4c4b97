// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

namespace swage::lesson_angles {
namespace {

// Bias and JND without a deduction, rad: 2 and 3 deg, within reach of a trained eye with so few answers.
constexpr double kGoodBias = 0.0349, kGoodJnd = 0.0524;

double share(double value, double good, double most) {
  return std::clamp((value - good) / std::max(1e-9, most - good), 0.0, 1.0);
}

}  // namespace

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  if (memory.begun == 0) {
    memory.begun = 1;
    for (TrackState& track : memory.track) track_.begin(track);
    finding.draw = true;
  }
  path_.look(memory.path, look.tip_W, look.time_s);
  const auto stage = static_cast<Stage>(memory.stage);
  const bool over = look.time_s >= memory.until_s;
  if (look.opening > 2 * rules_.closed) memory.armed = 1;
  if (stage == Stage::kShow && over && !finding.draw) {
    memory.stage = static_cast<double>(Stage::kAsk);
    memory.asked_s = look.time_s;
  }
  if (stage == Stage::kAsk) ask(memory, look, finding);
  if (stage == Stage::kTell && over) finding.draw = answers(memory) < rules_.questions;
  decide(memory, look, finding);
  return finding;
}

void Judge::draw(Memory& memory, double random, double time_s) const noexcept {
  double least = HUGE_VAL;
  for (const TrackState& track : memory.track) least = std::min(least, track.count);
  size_t some[kTracks], n = 0;
  for (size_t i = 0; i < kTracks; ++i)
    if (memory.track[i].count == least) some[n++] = i;
  memory.shown =
      static_cast<double>(some[std::min(n - 1, static_cast<size_t>(random * static_cast<double>(n)))]);
  memory.stage = static_cast<double>(Stage::kShow);
  memory.until_s = time_s + rules_.show_time;
}

void Judge::ask(Memory& memory, const Look& look, Finding& finding) const noexcept {
  if (memory.armed == 0 || look.opening > rules_.closed) return;
  memory.armed = 0;
  const double one = (look.tip_W - look.one_W).norm(), other = (look.tip_W - look.other_W).norm();
  if (std::min(one, other) > rules_.reach) return;  // closed away from the marks: no answer
  const bool to_other = other < one;
  const size_t axis = axis_of(memory), shown = static_cast<size_t>(memory.shown);
  finding.answered = true;
  finding.lean = look.lean[axis];
  memory.right = to_other == (finding.lean > 0) ? 1 : 0;
  memory.rights += memory.right;
  memory.answer_s += look.time_s - memory.asked_s;
  Answers::add(memory.axis[axis], finding.lean, to_other, 2 * rules_.start);
  track_.answer(memory.track[shown], to_other == (shown % 2 == 0));
  memory.stage = static_cast<double>(Stage::kTell);
  memory.until_s = look.time_s + rules_.tell_time;
}

void Judge::decide(const Memory& memory, const Look& look, Finding& finding) const noexcept {
  finding.stage = static_cast<Stage>(memory.stage);
  const bool told = finding.stage == Stage::kTell && look.time_s >= memory.until_s;
  if (told && answers(memory) >= rules_.questions) {
    finding.end = End::kPassed;
    for (const AnswersState& axis : memory.axis) {
      if (Answers::jnd(axis) > rules_.max_jnd) finding.end = End::kUnsure;
      if (std::abs(axis.bias) > rules_.max_bias && finding.end == End::kPassed) finding.end = End::kBiased;
    }
  } else if (rules_.ends && look.time_s >= rules_.max_time) {
    finding.end = End::kOutOfTime;
  }
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  finding.draw = false;
  finding.lost = points(memory, look.time_s);
  finding.score = score(memory, finding.lost, finding.end == End::kPassed);
}

Points Judge::points(const Memory& memory, double time_s) const noexcept {
  Points lost;
  lost.time = 15 * std::clamp(time_s / rules_.par_time - 1, 0.0, 1.0);
  for (const AnswersState& axis : memory.axis) {
    lost.bias += 35.0 / kAxes * share(std::abs(axis.bias), kGoodBias, rules_.max_bias);
    lost.jnd += 35.0 / kAxes * share(Answers::jnd(axis), kGoodJnd, rules_.max_jnd);
  }
  return lost;
}

double Judge::score(const Memory& memory, const Points& lost, bool passed) const noexcept {
  // an attempt that did not pass is worth at most 40; guessing scores 0
  const double right = memory.rights / std::max<double>(rules_.questions, answers(memory));
  if (!passed) return 40 * std::max(0.0, 2 * right - 1);
  return std::clamp(100 - lost.sum(), 40.0, 100.0);
}

}  // namespace swage::lesson_angles
