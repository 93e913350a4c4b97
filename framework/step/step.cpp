// SPDX-License-Identifier: Apache-2.0
#include "step/step.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"
#include "host/call_watch.hpp"
#include "host/guard.hpp"
#include "host/services.hpp"
#include "step/division.hpp"

namespace swage::step {

namespace {
// commands of one step; normal is 0 or 1. More wait in their ring for the next step
constexpr std::size_t kMaxCommands = 64;

/// Options with the scene's capacity of contacts.
Options with_room(Options options, const scene::World& world) {
  options.contact.capacity = world.capacity.contacts;
  return options;
}
}  // namespace

void Engine::step() noexcept {
  const host::ScopedRole rt(SWAGE_THREAD_RT);
  stamp_ = base::wall_ns();
  events_.begin(rig_.world.step);

  read();         // newest sample of each device
  command();      // resets, marks, live parameters
  follow();       // tools follow their hands: limited in speed, swept
  move();         // one step; in parts where a chain would move too far in it:
                  //   free_motion()  forces of the objects, then as if nothing touched anything
                  //   detect()       contacts, in a fixed order
                  //   couple()       couplings turn contacts into laws and events
                  //   solve()        contacts and motion, together and implicit
  finish();       // derived quantities and signals
  observe();      // the lesson observes
  guard();        // objects with invalid numbers stand still from here on
  send();         // forces to the hands, through the ports
  publish();      // step number and hash
}

const char* text(Phase phase) {
  constexpr const char* kNames[] = {"read",  "command", "follow",  "free motion", "detect", "couple",
                                    "solve", "finish",  "observe", "guard",       "send",   "publish"};
  return kNames[static_cast<uint32_t>(phase)];
}

Engine::Engine(host::Rig& rig, const Options& options, std::vector<DevicePort*> ports)
    : rig_(rig),
      options_(with_room(options, rig.world)),
      detector_(rig.world, rig.pairs, options_.contact),
      dynamics_(rig.world, options.dynamics),
      events_(rig.script),
      hands_(rig, std::move(ports)),
      writes_(rig.world),
      objects_(rig, hands_, writes_),
      couplings_(rig, objects_, events_, writes_),
      judging_(rig, objects_, events_, writes_),
      chains_(rig.world, detector_) {
  detector_.reserve(contacts_);
  command_.reserve(kMaxCommands);
  instance_ = host::instances(rig);
  for (host::Instance* instance : instance_)
    live_.push_back(static_cast<const swage_live*>(instance->extension(SWAGE_EXT_LIVE)));
  scene::Writer dynamics;
  dynamics_.save(dynamics);
  dynamics_start_.resize(dynamics.size());
  scene::Writer start(dynamics_start_);
  dynamics_.save(start);
  X_end_.reserve(rig.world.X_WB.size());
  if (!rig.world.chain.empty()) begun_.resize(kDivisions);
  for (Begun& begun : begun_)
    begun.state.resize(scene::image_size(rig.world) + dynamics.size() + detector_.image_size());
  // the first reset comes before the loop and its watchdog: it is watched as the other calls on [main] are
  const bool watched = host::CallWatch::enter(host::last_call);
  reset();
  if (watched) host::CallWatch::leave();
}

void Engine::reset() noexcept {
  const host::ScopedRole rt(SWAGE_THREAD_RT);
  detector_.reset(contacts_);
  command_.clear();
  events_.clear();
  hands_.reset();
  objects_.reset();
  couplings_.reset();
  judging_.reset();
  told_short_ = 0;
  scene::Reader start(dynamics_start_);
  dynamics_.restore(start);
  rehash();
}

bool Engine::push(const Command& command) noexcept {
  if (command_.size() == kMaxCommands) return false;
  command_.push_back(command);
  return true;
}

void Engine::done(Phase phase) noexcept {
  // smoothed over 256 steps, so that a person can read it
  const int64_t now = base::wall_ns();
  double& smooth = phase_s_[static_cast<uint32_t>(phase)];
  smooth += (1e-9 * static_cast<double>(now - stamp_) - smooth) / 256;
  stamp_ = now;
}

void Engine::read() noexcept {
  objects_.begin();
  if (hands_.see()) {
    writes_.take();
    hands_.look(judging_.sight(), writes_);
  }
  hands_.read(writes_);
  done(Phase::kRead);
}

void Engine::command() noexcept {
  for (const Command& c : command_) apply(c);
  command_.clear();
  done(Phase::kCommand);
}

void Engine::follow() noexcept {
  hands_.follow();
  done(Phase::kFollow);
}

void Engine::free_motion() noexcept {
  writes_.take();
  objects_.forces();
  objects_.advance();
  dynamics_.free_motion(rig_.world);
  objects_.freeze();
  done(Phase::kFreeMotion);
}

void Engine::detect() noexcept {
  detector_.detect(rig_.world, contacts_);
  done(Phase::kDetect);
}

void Engine::couple() noexcept {
  writes_.take();
  couplings_.resolve(contacts_);
  done(Phase::kCouple);
}

void Engine::solve() noexcept {
  dynamics_.solve(rig_.world, contacts_, objects_.self(), couplings_.ties(), &detector_);
  dynamics_.finish(rig_.world);
  objects_.freeze();
  done(Phase::kSolve);
}

// steps in which the solver fell short are counted; the first of an attempt is an event
void Engine::tell_shortfall() noexcept {
  const uint64_t steps = dynamics_.stats().health.steps;
  if (steps > steps_short_ && told_short_ == 0) {
    told_short_ = 1;
    events_.emit_host(judge::kSolverFellShort, static_cast<double>(rig_.world.step));
  }
  steps_short_ = steps;
}

void Engine::finish() noexcept {
  writes_.take();
  tell_shortfall();
  objects_.finish();
  couplings_.on_solved();
  couplings_.finish(contacts_);
  done(Phase::kFinish);
}

void Engine::observe() noexcept {
  judging_.observe();
  done(Phase::kObserve);
}

void Engine::guard() noexcept {
  objects_.guard();
  judging_.notice_quarantine();
  events_.end();
  done(Phase::kGuard);
}

void Engine::send() noexcept {
  hands_.send(contacts_);
  done(Phase::kSend);
}

void Engine::publish() noexcept {
  ++rig_.world.step;
  rehash();
  done(Phase::kPublish);
}

void Engine::apply(const Command& c) noexcept {
  switch (c.kind) {
    case CommandKind::kResetObject:
      if (c.object >= rig_.objects.size()) return;
      forget_contacts(c.object);
      objects_.reset(c.object);
      couplings_.reset_those_of(c.object);
      events_.emit_host(judge::kObjectReset, c.object);
      return;
    case CommandKind::kMark:
      events_.emit_host(judge::kMomentMarked, c.object);
      return;
    case CommandKind::kLiveParameter:
      live_parameter(c);
      return;
    case CommandKind::kHostEvent:
      if (c.object < judge::kHostEventCount)
        events_.emit_host(static_cast<judge::HostEvent>(c.object), c.number[0]);
      return;
  }
}

// bristles and forces of an object's contacts are invalid after it was reset
void Engine::forget_contacts(uint32_t object) noexcept {
  for (uint32_t p = 0; p < contacts_.of_pair.size(); ++p) {
    const contact::Pair& pair = rig_.pairs[p];
    if (pair.object_a != object && pair.object_b != object) continue;
    const scene::Range range = contacts_.of_pair[p];
    for (uint32_t i = range.first; i < range.first + range.count; ++i) {
      contacts_.contact[i].bristle_W.setZero();
      contacts_.contact[i].f_a_W.setZero();
      contacts_.contact[i].slip = 0;
    }
  }
}

void Engine::live_parameter(const Command& c) noexcept {
  if (c.object >= instance_.size() || !live_[c.object]) return;
  host::Instance& instance = *instance_[c.object];
  if (c.parameter >= instance.values.size()) return;
  swage_value value{};
  std::copy(std::begin(c.number), std::end(c.number), std::begin(value.number));
  host::guarded(instance, host::Call::kChange, rig_.world.step,
                [&] { return live_[c.object]->change(instance.raw, c.parameter, &value); });
}

}  // namespace swage::step
