// SPDX-License-Identifier: Apache-2.0
//
// Run: the end of an attempt, in numbers and sentences; also where a plugin causes it.
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "host/services.hpp"
#include "host/units.hpp"
#include "session/run.hpp"
#include "session/sentences.hpp"
#include "step/limits.hpp"

namespace swage::session {

namespace {

using base::Severity;

// exit status when a plugin does not return (sysexits: internal software error)
constexpr int kExitHung = 70;

const char* text(Ending ending) {
  switch (ending) {
    case Ending::kStopped:
      return "stopped";
    case Ending::kTimeLimit:
    case Ending::kLessonTimeLimit:
      return "time.limit";
    case Ending::kHandEnded:
      return "hand.ended";
    case Ending::kVoid:
      return "host.quarantined";
    case Ending::kImpossible:
      return "host.impossible";
    default:
      return "";
  }
}

std::string impossible_text(double force) {
  return say::kPressed(host::format_quantity(std::round(force), "N"), host::format_quantity(step::kMaxContactForce, "N"));
}

// the plugin whose own time or sleep made it late until it was in quarantine, "" for none: then it is the machine
std::string who_was_late(const host::Rig& rig) {
  for (const host::Instance* instance : host::instances(rig)) {
    const host::FaultKind fault = instance->fault.load();
    if (instance->quarantined.load() != 0 &&
        (fault == host::FaultKind::kLate || fault == host::FaultKind::kWaited || fault == host::FaultKind::kStalled))
      return instance->name + " (" + instance->plugin_id + ")";
  }
  return "";
}

// the plugin whose primitives were left out, and the first of them
std::string not_drawn_text(const host::Rig& rig, const base::DrawingHealth& visuals) {
  const host::Instance& on = *rig.objects[visuals.object].instance;
  const host::Instance& by = visuals.coupling == base::kNoCoupling ? on : *rig.couplings[visuals.coupling].instance;
  return say::kNotDrawn(visuals.faulty, by.name + " (" + by.plugin_id + ")", on.name, base::visual_member(visuals.member), visuals.index,
                        base::visual_kind(visuals.kind));
}

}  // namespace

Result Run::make_result(Ending ending) const {
  Result out;
  if (recorder_) out.attempt_id = recorder_->attempt_id();
  out.problems = problems_;
  if (ending == Ending::kNone) return out;

  const judge::Verdict& verdict = engine_->verdict();
  out.outcome = verdict.outcome;
  if (ending == Ending::kVerdict && verdict.reason < rig_->script.events.size())
    out.reason = rig_->script.events[verdict.reason].id;
  if (ending != Ending::kVerdict) {
    out.outcome = ending == Ending::kLessonTimeLimit ? judge::Outcome::kFailed : judge::Outcome::kAborted;
    out.reason = text(ending);
  }
  if (engine_->quarantined() > 0) {
    out.outcome = judge::Outcome::kVoid;
    out.reason = text(Ending::kVoid);
  }
  if (ending == Ending::kImpossible) {
    out.outcome = judge::Outcome::kVoid;
    out.problems.push_back({Severity::kError, rig_->descriptor_path, impossible_text(loop_->hardest())});
  }
  out.score = out.outcome == judge::Outcome::kVoid ? 0 : verdict.score;
  out.steps = engine_->world().step;
  out.simulated_s = engine_->world().time();
  out.hash = engine_->hash();
  for (std::size_t i = 0; i < rig_->script.metrics.size(); ++i) {
    const judge::Name& name = rig_->script.metrics[i];
    out.metrics.push_back({name.id, name.unit, name.doc, verdict.metric[i]});
  }
  out.health = loop_->health();
  if (knot_test_) knot_test_->tell(out);
  tell_circumstances(out);
  return out;
}

// Reports circumstances that distort the numbers: time ran slower than the hand's, or forces were off.
void Run::tell_circumstances(Result& out) const {
  // one omitted step in twenty is not perceptible, and occurs on every busy machine
  constexpr double kSlow = 0.95;
  const double made = static_cast<double>(out.health.executed), lost = static_cast<double>(out.health.dropped);
  if (made + lost > 0) out.speed = made / (made + lost);
  out.forces_off_s = loop_->forces_off_s();
  const auto tenths = [](double s) { return host::format_number(0.1 * std::round(10 * s)); };
  if (realtime() && out.speed < kSlow) {
    const std::string who = who_was_late(*rig_), left = tenths(lost * rig_->world.dt);
    const long percent = std::lround(1e2 * out.speed);
    out.problems.push_back({Severity::kWarning, "loop", who.empty() ? say::kTooSlow(percent, left) : say::kTooSlowBy(percent, who, left)});
  }
  if (out.health.visuals.faulty > 0) out.problems.push_back({Severity::kWarning, "drawing", not_drawn_text(*rig_, out.health.visuals)});
  if (out.forces_off_s > 0) out.problems.push_back({Severity::kWarning, "forces", say::kForcesOff(tenths(out.forces_off_s))});
}

record::AttemptEnd Run::make_end(const Result& result) const {
  record::AttemptEnd end;
  end.outcome = result.outcome;
  end.reason = result.reason;
  end.score = result.score;
  end.simulated_s = result.simulated_s;
  end.is_void = result.outcome == judge::Outcome::kVoid;
  for (const Result::Metric& m : result.metrics) end.metric.push_back(m.value);
  end.health = result.health;
  end.forces_off_s = result.forces_off_s;
  return end;
}

void Run::save_void(const char* reason) {
  if (!recorder_) return;
  record::AttemptEnd end;
  end.outcome = judge::Outcome::kVoid;
  end.reason = reason;
  end.is_void = true;
  end.simulated_s = static_cast<double>(loop_->steps()) * rig_->world.dt;
  end.metric.assign(rig_->script.metrics.size(), std::nan(""));
  recorder_->finish(end);
}

void Run::ended_by_plugin(const host::LastCall& call, const char* cause) {
  Sentinel::write(call, cause);
  if (Run* run = current_.exchange(nullptr)) run->save_void("host.ended");
}

// On the watchdog's thread, while the step thread hangs in a call: saves the existing data, and ends the program with the
// name of the plugin. A slow disk or a suspended machine is no hang.
void Run::hung() {
  const host::LastCall* last = last_call_.load();
  const host::Instance* culprit = last ? last->instance.load(std::memory_order_acquire) : nullptr;
  if (!culprit && !realtime()) return;
  if (last) Sentinel::write(*last, "hang");
  const std::string who = culprit ? std::string(host::text(last->call.load())) + "() of \"" + culprit->name +
                                        "\" (" + culprit->plugin_id + " " + culprit->plugin_version + ")"
                                  : "the step itself";
  const uint64_t step = loop_->steps();
  save_void("host.hung");
  std::fprintf(stderr, "swage: %s\n", say::kHung(step, who).c_str());
  std::fflush(stderr);
  _exit(kExitHung);
}

}  // namespace swage::session
