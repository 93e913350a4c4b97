// SPDX-License-Identifier: Apache-2.0
//
// Replay of a recorded attempt: same samples, same commands, same bits.
#include <memory>
#include <vector>

#include "record/recorder.hpp"
#include "session/knot_test.hpp"
#include "session/playback.hpp"
#include "session/sentences.hpp"
#include "session/session.hpp"

namespace swage::session {

namespace {

// One hash does not tell which part of the scene differs; but the signals can be compared instance by instance.
std::string who_differs(const host::Rig& rig, const float* recorded) {
  const auto differs = [&](const host::Range& range) {
    for (uint32_t i = range.first; i < range.first + range.count; ++i)
      if (static_cast<float>(rig.world.signal[i]) != recorded[i]) return true;
    return false;
  };
  std::string out;
  const auto add = [&](const host::Instance& instance) {
    out += (out.empty() ? "the signals of \"" : ", \"") + instance.name + "\"";
  };
  for (const host::ObjectSlot& slot : rig.objects)
    if (differs(slot.signal)) add(*slot.instance);
  for (const host::CouplingSlot& slot : rig.couplings)
    if (differs(slot.signal)) add(*slot.instance);
  return out.empty() ? "" : out + " differ";
}

// the step from which a plugin was in quarantine: its misbehaviour, and the time at which the guard stopped it, are not reproducible
uint64_t void_from(const record::Recording& recording) {
  for (const judge::Event& e : recording.events) {
    if (e.event >= recording.info.script.events.size()) continue;
    if (recording.info.script.events[e.event].id == "host.quarantined") return e.step;
  }
  return ~uint64_t{0};
}

// verdict of the lesson after the steps done
Result verdict_of(const Playback& again) {
  const judge::Verdict& said = again.engine().verdict();
  const judge::Script& script = again.rig().script;
  Result out;
  out.outcome = said.outcome;
  if (said.reason < script.events.size()) out.reason = script.events[said.reason].id;
  out.score = said.score;
  out.steps = again.at();
  out.simulated_s = again.engine().world().time();
  for (std::size_t i = 0; i < script.metrics.size(); ++i) {
    const judge::Name& name = script.metrics[i];
    out.metrics.push_back({name.id, name.unit, name.doc, said.metric[i]});
  }
  return out;
}

/// Steps the recording again and compares. `to_the_end`: goes on where the bits differ. nullptr where the scene cannot be built.
std::unique_ptr<Playback> step_again(const record::Recording& recording, const std::vector<std::string>& plugin_dirs, Replay& out, Problems& problems,
                                     bool to_the_end) {
  out = {};
  std::unique_ptr<Playback> again = Playback::open(recording, plugin_dirs, problems);
  if (!again) return nullptr;
  const host::Rig& rig = again->rig();
  const std::size_t signals = recording.info.script.signals.size();
  const uint64_t last = void_from(recording);
  for (const host::Instance* i : host::instances(rig)) out.plugins.emplace_back(i->plugin_id, i->plugin_version);
  for (std::size_t i = 0; i < recording.step.size(); ++i) {
    if (i >= again->count()) {
      out.reason = say::kNotRecorded(i);
      return again;
    }
    if (i >= last) {
      out.reason = say::kQuarantined(last);
      break;
    }
    again->step();
    ++out.steps;
    if (again->first_difference() > i) continue;
    out.first_difference = i;
    if (rig.world.signal.size() <= signals) out.reason = who_differs(rig, &recording.signal[signals * i]);
    out.verdict = verdict_of(*again);
    if (!to_the_end) return again;
    while (again->step()) {
    }
    out.verdict = verdict_of(*again);
    return again;
  }
  out.identical = true;
  out.verdict = verdict_of(*again);
  return again;
}

}  // namespace

bool replay(const record::Recording& recording, const std::vector<std::string>& plugin_dirs, Replay& out, Problems& problems) {
  return step_again(recording, plugin_dirs, out, problems, false) != nullptr;
}

bool judge_again(const record::Recording& recording, const std::vector<std::string>& plugin_dirs, const std::string& pull_lesson, Replay& out,
                 Problems& problems) {
  const std::unique_ptr<Playback> again = step_again(recording, plugin_dirs, out, problems, true);
  if (!again) return false;
  if (out.verdict.metrics.empty() || !KnotTest::wanted(again->rig(), again->engine().verdict())) return true;
  KnotTest pull(again->rig(), again->engine().world(), pull_lesson, plugin_dirs);
  while (pull.step(1000)) continue;
  pull.tell(out.verdict);
  return true;
}

}  // namespace swage::session
