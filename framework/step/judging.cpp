// SPDX-License-Identifier: Apache-2.0
#include "step/judging.hpp"

#include <algorithm>

#include "host/guard.hpp"
#include "scene/view.hpp"
#include "step/limits.hpp"

namespace swage::step {

namespace {
judge::Owned owned(const scene::Range& range) { return {range.first, range.count}; }
}  // namespace

Judging::Judging(host::Rig& rig, const Objects& objects, Events& events, WriteGuard& writes)
    : rig_(rig), objects_(objects), events_(events), writes_(writes), instance_(host::instances(rig)) {
  const host::LessonSlot& l = rig.lesson;
  referee_.prepare(rig.script, owned(l.metric), owned(l.cue), owned(l.event), owned(l.phase),
                   static_cast<uint32_t>(rig.objects.size()));
  seen_.reserve(2 * Events::kCapacity);
  known_bad_.resize(instance_.size());
}

void Judging::reset() noexcept {
  referee_.clear();
  const host::LessonSlot& slot = rig_.lesson;
  if (!slot.lesson) return;
  double* state = rig_.world.plugin_state.data() + slot.state.first;
  host::guarded(*slot.instance, host::Call::kReset, rig_.world.step,
                [&] { slot.lesson->reset(slot.instance->raw, state); });
}

std::size_t Judging::image_size() const {
  scene::Writer count;
  save(count);
  return count.size();
}

void Judging::save(scene::Writer& out) const noexcept {
  const judge::Verdict& v = referee_.verdict();
  out.put(uint64_t{static_cast<uint32_t>(v.outcome)} << 32 | v.reason);
  out.put(uint64_t{v.phase});
  out.put(v.score);
  out.put(v.finished_step);
  out.put(v.metric);
  out.put(v.mark_p_W);
  for (const uint32_t cue : v.object_cue) out.put(uint64_t{cue});
  for (const uint32_t cue : v.mark_cue) out.put(uint64_t{cue});
}

bool Judging::restore(scene::Reader& in) noexcept {
  judge::Verdict& v = referee_.saved();
  uint64_t end = 0, phase = 0;
  in.get(end);
  in.get(phase);
  in.get(v.score);
  in.get(v.finished_step);
  in.get(v.metric);
  in.get(v.mark_p_W);
  const auto cues = [&in](std::vector<uint32_t>& list) {
    for (uint32_t& cue : list) {
      uint64_t word = 0;
      in.get(word);
      cue = static_cast<uint32_t>(word);
    }
  };
  cues(v.object_cue);
  cues(v.mark_cue);
  v.outcome = static_cast<judge::Outcome>(end >> 32);
  v.reason = static_cast<uint32_t>(end);
  v.phase = static_cast<uint32_t>(phase);
  return in.ok();
}

void Judging::notice_quarantine() noexcept {
  for (std::size_t i = 0; i < instance_.size(); ++i) {
    if (known_bad_[i] || instance_[i]->quarantined.load(std::memory_order_relaxed) == 0) continue;
    known_bad_[i] = 1;
    ++bad_count_;
    events_.emit_host(judge::kInstanceQuarantined, static_cast<double>(i));
  }
}

void Judging::observe() noexcept {
  notice_quarantine();

  // all events since the lesson last observed
  seen_.clear();
  for (const judge::Event& e : events_.late()) seen_.push_back({e.event, 0, e.value});
  for (const judge::Event& e : events_.list()) seen_.push_back({e.event, 0, e.value});
  events_.observe();
  if (rig_.lesson.lesson) ask_lesson();
}

swage_sight Judging::sight() noexcept {
  refresh_view();
  const std::vector<swage_vec3>& mark = referee_.verdict().mark_p_W;
  return {sizeof(swage_sight), static_cast<uint32_t>(mark.size()), &view_, mark.data()};
}

void Judging::refresh_view() noexcept { view_ = scene::view(rig_.world, objects_.views(), seen_); }

void Judging::ask_lesson() noexcept {
  const host::LessonSlot& slot = rig_.lesson;
  const scene::World& world = rig_.world;
  refresh_view();
  const swage_verdict* verdict = referee_.begin(world.step);
  double* state = rig_.world.plugin_state.data() + slot.state.first;
  host::Instance& instance = *slot.instance;
  host::guarded(instance, host::Call::kObserve, world.step,
                [&] { return slot.lesson->observe(instance.raw, &view_, verdict, state); });
  writes_.check(instance, host::Call::kObserve);
  if (!host::accept(instance, host::Call::kObserve, world.step, state, slot.state.count, kAnyNumber))
    std::fill_n(state, slot.state.count, 0.0);
  for (const judge::Event& e : referee_.events()) events_.emit_own(e.event, e.value);
  if (referee_.mistakes() > 0)
    host::quarantine(instance, host::FaultKind::kError, host::Call::kObserve, world.step);
}

}  // namespace swage::step
