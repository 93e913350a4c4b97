// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>

namespace swage::lesson_fault {
namespace {

// Tension from which on a loop is taut, N.
constexpr double kTaut = 1e-3;
// Share of the load that counts as borne: the pulling hand approaches the load and stays a little below it.
constexpr double kBorne = 0.95;

}  // namespace

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  path_.look(memory.path, look.tip_W, look.time_s);
  if (memory.begun == 0) memory.begun = 1, memory.until_s = look.time_s + rules_.show_time, finding.next = true;
  if (look.opening > 2 * rules_.closed) memory.armed = 1;
  const auto stage = static_cast<Stage>(memory.stage);
  if (stage == Stage::kShow && look.time_s >= memory.until_s) {
    memory.stage = static_cast<double>(Stage::kAsk);
    memory.asked_s = look.time_s;
  }
  if (stage == Stage::kAsk) ask(memory, look, finding);
  if (stage == Stage::kPull) pull(memory, look, finding);
  if (stage == Stage::kTell && look.time_s >= memory.until_s && memory.answers < rules_.questions) go_on(memory, look.time_s, finding);
  decide(memory, look, finding);
  return finding;
}

void Judge::ask(Memory& memory, const Look& look, Finding& finding) const noexcept {
  if (memory.armed == 0 || look.opening > rules_.closed) return;
  memory.armed = 0;
  const auto distance = [&](size_t i) { return (look.tip_W - look.answer_W[i]).norm(); };
  size_t nearest = 0;
  for (size_t i = 1; i < kKnots; ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  if (distance(nearest) > rules_.reach) return;  // closed away from the places: no answer
  finding.answered = true;
  finding.answer = static_cast<int>(nearest);
  const bool sound = look.knot == static_cast<int>(Knot::kSquare), said_sound = finding.answer == static_cast<int>(Knot::kSquare);
  memory.right = finding.answer == look.knot ? 1 : 0;
  memory.answers += 1;
  memory.rights += memory.right;
  memory.false_alarms += sound && !said_sound;
  memory.missed += !sound && said_sound;
  memory.answer_s += look.time_s - memory.asked_s;
  memory.stage = static_cast<double>(Stage::kPull);
  memory.until_s = look.time_s + rules_.pull_time;
  memory.taut = memory.borne_s = memory.held = 0;
  Pulled& pulled = memory.pulled[static_cast<size_t>(look.knot)];
  pulled = {0, 0, pulled.count + 1};
}

void Judge::pull(Memory& memory, const Look& look, Finding& finding) const noexcept {
  Pulled& pulled = memory.pulled[static_cast<size_t>(look.knot)];
  pulled.borne = std::max(pulled.borne, look.tension);
  Eigen::Map<Vec3> taut_W(memory.taut_W);
  if (memory.taut == 0 && look.tension >= kTaut) memory.taut = 1, taut_W = look.puller_W;
  // both strands of the loop follow the instrument
  if (memory.taut != 0) pulled.opening = std::max(pulled.opening, 2 * (look.puller_W - taut_W).norm());
  memory.borne_s = look.tension >= kBorne * rules_.load ? memory.borne_s + dt_ : 0;
  const bool held = memory.borne_s >= rules_.hold_time;
  if (!held && pulled.opening < rules_.most_opening && look.time_s < memory.until_s) return;
  memory.held = held ? 1 : 0;
  finding.pulled = true;
  finding.result = held ? pulled.opening : pulled.borne;
  memory.stage = static_cast<double>(Stage::kTell);
  memory.until_s = look.time_s + rules_.tell_time;
}

void Judge::go_on(Memory& memory, double time_s, Finding& finding) const noexcept {
  memory.question += 1;
  memory.stage = static_cast<double>(Stage::kShow);
  memory.until_s = time_s + rules_.show_time;
  finding.next = true;
}

void Judge::decide(const Memory& memory, const Look& look, Finding& finding) const noexcept {
  finding.stage = static_cast<Stage>(memory.stage);
  const bool told = finding.stage == Stage::kTell && look.time_s >= memory.until_s;
  if (told && memory.answers >= rules_.questions) finding.end = memory.rights >= rules_.least_right ? End::kPassed : End::kWrong;
  else if (rules_.ends && look.time_s >= rules_.max_time) finding.end = End::kOutOfTime;
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  finding.next = false;
  finding.lost = points(memory, look.time_s);
  // an attempt that did not pass is worth at most 40; guessing one of four scores 0
  const double share = memory.rights / rules_.questions;
  finding.score = finding.end == End::kPassed ? std::clamp(100 - finding.lost.sum(), 40.0, 100.0) : 40 * std::max(0.0, (4 * share - 1) / 3);
}

Points Judge::points(const Memory& memory, double time_s) const noexcept {
  Points lost;
  const double other = memory.answers - memory.rights - memory.missed;
  lost.wrong = 15 * other;
  lost.missed = 25 * memory.missed;
  lost.time = 15 * std::clamp(time_s / rules_.par_time - 1, 0.0, 1.0);
  return lost;
}

}  // namespace swage::lesson_fault
