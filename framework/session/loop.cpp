// SPDX-License-Identifier: Apache-2.0
#include "session/loop.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"
#include "judge/host_events.hpp"
#include "step/limits.hpp"
#include "swage/abi/lesson_card.h"

namespace swage::session {

namespace {

// limits of the input between two steps; usual are 0 to 2 per step, and behind an input that waits for its time a second of a mouse
constexpr std::size_t kCommands = 64, kPointers = 1024;
// events until the console fetches them; at 60 frames a second and 5 events per step that is a whole second
constexpr std::size_t kEvents = 8192;
// cues of the scene that may be felt: by the lesson file, and by the channels of each cue
std::vector<bool> felt(const snapshot::SceneCard& card) {
  std::vector<bool> out;
  for (const uint32_t channels : card.cue_channels)
    out.push_back((card.cues & channels & SWAGE_CHANNEL_FORCE) != 0);
  return out;
}
// steps between two snapshots: 250 a second in real time; a run without real time is rarely displayed
constexpr uint64_t kShowRealtime = 4, kShowFastest = 64;
// commands taken in one step; the others wait
constexpr int kCommandsPerStep = 16;
// ns that a paused run without real time sleeps between two polls
constexpr int64_t kPausedSleep = 1'000'000;  // ns
// s without a complete sample after which the lesson waits for a hand, and below which the hand is back. A tracker that is covered
// for a moment does not stop a lesson
constexpr double kHandLost = 0.5, kHandBack = 0.1;

}  // namespace

Loop::Loop(host::Rig& rig, step::Engine& engine, std::vector<Port*> ports, record::Recorder* recorder,
           const Settings& settings)
    : rig_(rig),
      engine_(engine),
      ports_(std::move(ports)),
      recorder_(recorder),
      settings_(settings),
      command_in_(kCommands),
      pointer_in_(kPointers),
      event_out_(kEvents),
      out_(std::make_unique<snapshot::Snapshot>()),
      fault_seen_(ports_.size(), ForceFault::kNone),
      cue_force_(rig.script, felt(rig.card), settings.cue_pulses, rig.objects.size()),
      lost_(ports_.size()),
      paused_(settings.start_paused) {
  engine_.fill(*out_);
  channel_.publish(*out_);
}

bool Loop::tick(const RtThread::Tick& tick, const LoopStats& stats) noexcept {
  if (stop_.load(std::memory_order_relaxed)) return end(Ending::kStopped, stats);

  // a paused scene exerts no force; the step that reports a lost hand is still done
  const bool waits = hand_lost_;
  const bool asked = paused_.load(std::memory_order_relaxed);
  if (settings_.realtime && !asked) watch_hands();
  const bool paused = asked || (waits && hand_lost_);
  if (forces_on_ == paused) {
    for (Port* port : ports_) paused ? port->disarm() : port->arm();
    forces_on_ = !paused;
  }
  if (paused) {
    if (!settings_.realtime) base::sleep_until_ns(base::wall_ns() + kPausedSleep);
    if (out_->paused == 0 || (hand_lost_ && ++waited_ % kShowFastest == 0)) show(stats);
    return true;
  }

  listen(tick);
  take_pointer();
  engine_.step();
  send_cue_force();
  feel();
  keep(stats);
  const Ending now = judge();
  return now == Ending::kNone || end(now, stats);
}

// takes commands of people, and reports on the step's own thread
void Loop::listen(const RtThread::Tick& tick) noexcept {
  step::Command command;
  for (int i = 0; i < kCommandsPerStep && command_in_.try_pop(command); ++i) take_command(command);
  if (tick.lost > 0) tell(judge::kTimeLost, static_cast<double>(tick.lost));
  tell_not_drawn();
  bool forceless = false;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    const ForceFault fault = ports_[i]->fault();
    forceless |= fault != ForceFault::kNone && fault != ForceFault::kStopped;
    if (fault == fault_seen_[i]) continue;
    fault_seen_[i] = fault;
    if (fault != ForceFault::kNone && fault != ForceFault::kStopped)
      tell(judge::kForceStopped, static_cast<double>(static_cast<uint32_t>(fault)));
  }
  forceless_steps_ += forceless;
}

void Loop::tell(judge::HostEvent event, double value) noexcept {
  step::Command command;
  command.kind = step::CommandKind::kHostEvent;
  command.object = event;
  command.number[0] = value;
  take_command(command);
}

// tells once that what a plugin draws is left out
void Loop::tell_not_drawn() noexcept {
  const base::DrawingHealth& visuals = out_->health.visuals;
  if (visuals.faulty == 0 || std::exchange(told_not_drawn_, true)) return;
  const std::size_t coupling = rig_.objects.size() + visuals.coupling;
  tell(judge::kNotDrawn, static_cast<double>(visuals.coupling == base::kNoCoupling ? visuals.object : coupling));
}

// A hand without valid samples holds in the step; after half a second the lesson waits for it.
void Loop::watch_hands() noexcept {
  bool any = false;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    Lost& lost = lost_[i];
    const double now = ports_[i]->lost_s();
    if (lost.longest_now == 0 && now > kHandLost) {
      ++lost.times;
      tell(judge::kHandLost, static_cast<double>(i));
    } else if (lost.longest_now > 0 && now < kHandBack) {
      tell(judge::kHandBack, lost.longest_now);
      lost.seconds += lost.longest_now;
      lost.longest_now = 0;
    }
    const bool gone = lost.longest_now > 0 || now > kHandLost;
    if (gone && now > lost.longest_now) lost.longest_now = now;
    any |= gone && now >= kHandBack;
  }
  hand_lost_ = any;
}

void Loop::take_command(const step::Command& command) noexcept {
  if (!engine_.push(command) || !recorder_) return;
  record::CommandRecord out;
  out.step = engine_.world().step;
  out.kind = static_cast<uint32_t>(command.kind);
  out.object = command.object;
  out.parameter = command.parameter;
  std::copy(std::begin(command.number), std::end(command.number), std::begin(out.number));
  recorder_->command(out);
}

// Movements add up, all other values are the newest. A key that was pressed is down for at least one step: its release waits for the
// next step, or a short stroke would never be seen. A movement keeps the buttons, modifiers and keys under which it was made: what
// changes them waits, too, or a drag would lose its end to the release behind it.
void Loop::take_pointer() noexcept {
  swage_pointer& now = pointer_;
  now.dx = now.dy = now.wheel = 0;
  const swage_pointer before = now;
  PointerInput next = waiting_pointer_;
  while (std::exchange(pointer_waits_, false) || pointer_in_.try_pop(next)) {
    swage_pointer& p = next.state;
    const bool early = next.due_ns != 0 && base::wall_ns() < next.due_ns;
    const bool short_key = (now.keys & ~before.keys & ~p.keys) != 0;
    const bool short_button = (now.buttons & ~before.buttons & ~p.buttons) != 0;
    const bool moved = now.dx != 0 || now.dy != 0 || now.wheel != 0;
    const bool other = now.buttons != p.buttons || now.modifiers != p.modifiers || now.keys != p.keys;
    if (early || short_key || short_button || (moved && other)) {
      waiting_pointer_ = next;
      pointer_waits_ = true;
      break;
    }
    p.dx += now.dx;
    p.dy += now.dy;
    p.wheel += now.wheel;
    now = p;
  }
  engine_.point(now);
}

// a cue that has come on is felt with the forces of the next step
void Loop::send_cue_force() noexcept {
  const double force = cue_force_.tick(engine_.verdict(), rig_.world.dt);
  for (Port* port : ports_) port->set_cue_force(force);
}

void Loop::feel() noexcept {
  for (const contact::Contact& c : engine_.contacts().contact) hardest_ = std::max(hardest_, c.f_a_W.norm());
}

// writes the device signals after the n signals of the scene; returns the new number
uint32_t Loop::listen_to_devices(double* signal, uint32_t n) const noexcept {
  for (const Port* port : ports_) {
    port->told(signal + n);
    n += port->signals().count();
  }
  return n;
}

// publishes records, events and snapshot of the last step
void Loop::keep(const LoopStats& stats) noexcept {
  steps_.store(engine_.world().step, std::memory_order_relaxed);
  for (const judge::Event& e : engine_.events()) {
    lost_events_ += !event_out_.try_push(e);
    if (recorder_) recorder_->event(e);
  }
  if (recorder_) {
    const auto& samples = engine_.samples();
    const auto& signals = engine_.world().signal;
    record_.step = engine_.world().step - 1;
    record_.hash = engine_.hash();
    record_.n_device = static_cast<uint32_t>(std::min<std::size_t>(samples.size(), snapshot::kMaxDevices));
    record_.n_signal = static_cast<uint32_t>(std::min<std::size_t>(signals.size(), snapshot::kMaxSignals));
    std::copy_n(samples.begin(), record_.n_device, record_.sample);
    std::copy_n(signals.begin(), record_.n_signal, record_.signal);
    record_.n_signal = listen_to_devices(record_.signal, record_.n_signal);
    recorder_->step(record_);
  }
  const uint64_t every = settings_.realtime ? kShowRealtime : kShowFastest;
  if (engine_.world().step % every == 0) show(stats);
}

void Loop::show(const LoopStats& stats) noexcept {
  snapshot::Snapshot& s = *out_;
  engine_.fill(s);
  s.n_signal = listen_to_devices(s.signal, s.n_signal);
  s.paused = paused_.load(std::memory_order_relaxed) || hand_lost_;
  for (uint32_t i = 0; i < s.n_device; ++i) {
    s.device[i].force = ports_[i]->force();
    s.device[i].stale = ports_[i]->stale();
  }
  snapshot::LoopHealth& h = s.health;
  stats.fill(h);
  h.executed = engine_.world().step;
  h.lost_events = lost_events_ + engine_.lost_events();
  h.lost_records = recorder_ ? recorder_->dropped() : 0;
  std::copy_n(engine_.phase_s(), snapshot::kPhases, h.phase_s);
  h.realtime = realtime_granted_;
  h.quarantined = engine_.quarantined();
  h.solver = engine_.stats().health;
  channel_.publish(s);
}

// Checks for the end. A quarantine voids the attempt but lets it run to its end, unless nothing is left that could end it.
Ending Loop::judge() const noexcept {
  if (hardest_ > step::kMaxContactForce) return Ending::kImpossible;
  if (engine_.verdict().outcome != judge::Outcome::kRunning) return Ending::kVerdict;
  const double time = engine_.world().time();
  if (settings_.lesson_max_time_s > 0 && time >= settings_.lesson_max_time_s) return Ending::kLessonTimeLimit;
  if (settings_.max_time_s > 0 && time >= settings_.max_time_s) return Ending::kTimeLimit;
  if (engine_.quarantined() > 0) {
    const host::Instance* lesson = rig_.lesson.instance.get();
    const bool no_judge = lesson && lesson->quarantined.load(std::memory_order_relaxed) != 0;
    if (no_judge || !settings_.realtime) return Ending::kVoid;
  }
  if (engine_.hand_gone()) return engine_.quarantined() > 0 ? Ending::kVoid : Ending::kHandEnded;
  return Ending::kNone;
}

bool Loop::end(Ending ending, const LoopStats& stats) noexcept {
  for (Port* port : ports_) port->disarm();
  ending_ = ending;
  show(stats);
  finished_.store(true, std::memory_order_release);
  return false;
}

}  // namespace swage::session
