// SPDX-License-Identifier: Apache-2.0
#include "judge/referee.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swage::judge {

namespace {
// limit of the events of a lesson in one step; usual are 0 to 3; further ones are dropped and count as the lesson's
// mistake
constexpr std::size_t kMaxEventsPerStep = 64;
}  // namespace

void Referee::prepare(const Script& script, Owned metric, Owned cue, Owned event, Owned phase,
                      uint32_t object_count) {
  metric_ = metric;
  cue_ = cue;
  event_ = event;
  phase_ = phase;
  verdict_.metric.resize(script.metrics.size());
  verdict_.object_cue.resize(object_count);
  verdict_.mark_cue.resize(script.marks.size());
  verdict_.mark_p_W.resize(script.marks.size());
  mark_start_.clear();
  for (const Script::Mark& m : script.marks) mark_start_.push_back(m.mark.p_W);
  events_.reserve(kMaxEventsPerStep);

  table_.struct_size = sizeof table_;
  table_.host_data = this;
  table_.cue = on_cue;
  table_.mark = on_mark;
  table_.metric = on_metric;
  table_.event = on_event;
  table_.phase = on_phase;
  table_.finish = on_finish;
  clear();
}

void Referee::clear() noexcept {
  verdict_.outcome = Outcome::kRunning;
  verdict_.reason = SWAGE_NONE;
  verdict_.phase = SWAGE_NONE;
  verdict_.score = 0;
  verdict_.finished_step = 0;
  std::fill(verdict_.metric.begin(), verdict_.metric.end(), std::numeric_limits<double>::quiet_NaN());
  std::fill(verdict_.object_cue.begin(), verdict_.object_cue.end(), SWAGE_NONE);
  std::fill(verdict_.mark_cue.begin(), verdict_.mark_cue.end(), SWAGE_NONE);
  std::copy(mark_start_.begin(), mark_start_.end(), verdict_.mark_p_W.begin());
  events_.clear();
  mistakes_ = 0;
}

const swage_verdict* Referee::begin(uint64_t step) noexcept {
  step_ = step;
  events_.clear();
  return &table_;
}

void Referee::finish(Outcome outcome, double score, uint32_t reason, uint64_t step) noexcept {
  if (verdict_.outcome != Outcome::kRunning) return;
  verdict_.outcome = outcome;
  verdict_.score = std::clamp(score, 0.0, 100.0);
  verdict_.reason = reason;
  verdict_.finished_step = step;
}

bool Referee::owns(const Owned& range, uint32_t index) noexcept {
  const bool inside = index < range.count;
  mistakes_ += !inside;
  return inside;
}

void Referee::on_cue(const swage_verdict* table, uint32_t object, uint32_t cue) {
  Referee& r = self(table);
  if (object >= r.verdict_.object_cue.size()) {
    ++r.mistakes_;
  } else if (cue == SWAGE_NONE) {
    r.verdict_.object_cue[object] = SWAGE_NONE;
  } else if (r.owns(r.cue_, cue)) {
    r.verdict_.object_cue[object] = r.cue_.first + cue;
  }
}

void Referee::on_mark(const swage_verdict* table, uint32_t mark, uint32_t cue, const swage_vec3* p_W) {
  Referee& r = self(table);
  if (mark >= r.verdict_.mark_cue.size()) {
    ++r.mistakes_;
    return;
  }
  if (cue == SWAGE_NONE) {
    r.verdict_.mark_cue[mark] = SWAGE_NONE;
  } else if (r.owns(r.cue_, cue)) {
    r.verdict_.mark_cue[mark] = r.cue_.first + cue;
  }
  if (!p_W) return;
  if (std::isfinite(p_W->x) && std::isfinite(p_W->y) && std::isfinite(p_W->z)) {
    r.verdict_.mark_p_W[mark] = *p_W;
  } else {
    ++r.mistakes_;
  }
}

void Referee::on_metric(const swage_verdict* table, uint32_t metric, double value) {
  Referee& r = self(table);
  if (!r.owns(r.metric_, metric)) return;
  if (std::isfinite(value)) {
    r.verdict_.metric[r.metric_.first + metric] = value;
  } else {
    ++r.mistakes_;
  }
}

void Referee::on_event(const swage_verdict* table, uint32_t event, double value) {
  Referee& r = self(table);
  if (!r.owns(r.event_, event)) return;
  if (r.events_.size() < r.events_.capacity()) {
    r.events_.push_back({r.step_, r.event_.first + event, 0, value});
  } else {
    ++r.mistakes_;
  }
}

void Referee::on_phase(const swage_verdict* table, uint32_t phase) {
  Referee& r = self(table);
  if (r.owns(r.phase_, phase)) r.verdict_.phase = r.phase_.first + phase;
}

void Referee::on_finish(const swage_verdict* table, int32_t passed, double score, uint32_t reason) {
  Referee& r = self(table);
  if (!std::isfinite(score) || (reason != SWAGE_NONE && reason >= r.event_.count)) {
    ++r.mistakes_;
    return;
  }
  r.finish(passed ? Outcome::kPassed : Outcome::kFailed, score,
           reason == SWAGE_NONE ? SWAGE_NONE : r.event_.first + reason, r.step_);
}

}  // namespace swage::judge
