// SPDX-License-Identifier: Apache-2.0
#include "session/device_ports.hpp"

#include <sched.h>
#include <sys/prctl.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/clock.hpp"
#include "host/guard.hpp"
#include "host/services.hpp"
#include "session/bounded_call.hpp"
#include "session/sentinel.hpp"

namespace swage::session {

namespace {

// between the step (70) and normal threads: a reader must not delay the step
constexpr int kReaderPriority = 60;
// s without a new sample after which a device counts as silent; normal gaps are one to ten milliseconds
constexpr double kSilence = 0.1;
// s, simulated, without a valid sample for the step, after a hand was away for kSilence by the clock. Above 0.1 the step matches the hand
// as after a clutch (step/hands.cpp); longer would be felt
constexpr double kRest = 0.11;
// values without which a hand that has given them counts as lost
constexpr uint32_t kWhole = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;

double seconds(int64_t ns) { return 1e-9 * static_cast<double>(ns); }

HandMotion motion(const swage_sample& sample, double age) {
  HandMotion hand;
  hand.p = sample.pose.p;
  hand.v = sample.twist.v;
  hand.has_velocity = (sample.valid & SWAGE_VALID_TWIST) != 0;
  hand.age = age;
  return hand;
}

ForceRequest request(const step::ToolForce& force, double age) {
  ForceRequest out;
  out.force = force.force;
  out.anchor = force.anchor;
  out.anchor_twist = force.anchor_twist;
  out.stiffness = force.stiffness;
  out.damping = force.damping;
  out.age = age;
  return out;
}

}  // namespace

ForceLimits Port::limits(const host::DeviceSlot& slot) {
  ForceLimits out;
  out.max_force = std::min(out.max_force, slot.device->max_force);
  out.continuous_force = std::min(out.continuous_force, out.max_force);
  return out;
}

void Port::follow_orders() noexcept {
  const uint32_t disarm = disarm_.load(std::memory_order_relaxed), arm = arm_.load(std::memory_order_relaxed);
  if (disarm != disarm_seen_) guard_.disarm(ForceFault::kStopped);
  if (arm != arm_seen_) guard_.arm();
  disarm_seen_ = disarm;
  arm_seen_ = arm;
}

IoPort::IoPort(host::DeviceSlot& slot, const std::atomic<bool>* stalled)
    : Port(slot, limits(slot)),
      stalled_(stalled),
      period_(1 / (slot.device->rate_hz > 0 ? std::clamp(slot.device->rate_hz, 20.0, 4000.0) : 1000.0)) {}

void IoPort::start() {
  started_ns_ = base::wall_ns();
  thread_ = std::thread([this] {
    run();
    ended_.set_value();
  });
}

bool IoPort::stop() {
  stop_.store(true, std::memory_order_relaxed);
  if (!thread_.joinable()) return !left_;
  if (ended_.get_future().wait_for(std::chrono::duration<double>(driver_limits().exchange)) == std::future_status::ready) {
    thread_.join();
    return true;
  }
  thread_.detach();
  left_ = true;
  leave_behind();
  return false;
}

// one exchange per period; a slower driver sets its own pace
void IoPort::run() {
  prctl(PR_SET_NAME, "swage-device");
  prctl(PR_SET_TIMERSLACK, 1UL);
  sched_param param{};
  param.sched_priority = kReaderPriority;
  sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &param);
  Sentinel::protect_thread();
  host::set_thread_role(SWAGE_THREAD_IO);

  host::Instance& instance = *slot_.instance;
  Given given{};
  given.sample.pose.q.w = 1;
  int64_t last = base::wall_ns(), next = last;
  for (uint64_t n = 0; instance.quarantined.load(std::memory_order_relaxed) == 0; ++n) {
    // the last exchange sets the force to zero
    const bool leaving = stop_.load(std::memory_order_relaxed);
    const int64_t now = base::wall_ns();
    const swage_command out = leaving ? step::no_force(0) : command(given, seconds(now - last), now);
    last = now;
    swage_sample sample = given.sample;
    const bool good = host::guarded(instance, host::Call::kExchange, n,
                                    [&] { return slot_.device->exchange(instance.raw, &out, &sample); });
    if (leaving) return;
    signals_.read(n, given.told);
    if (good && sample.sequence != given.sample.sequence) {
      given.wall_ns = base::wall_ns();
      given.known |= sample.valid & kWhole;
      if ((sample.valid & given.known) == given.known) given.whole_ns = given.wall_ns;
    }
    if (good) given.sample = sample;
    given.force = out.force;
    given_.publish(given);
    next = std::max(next + static_cast<int64_t>(period_ * 1e9), base::wall_ns());
    base::sleep_until_ns(next);
  }
}

swage_command IoPort::command(const Given& last, double dt, int64_t now) noexcept {
  // no force before the device has given a sample and the scene a force
  Wanted wanted;
  const bool ready = last.wall_ns != 0 && wanted_.latest(wanted) != 0;
  if (!(slot_.device->flags & SWAGE_DEVICE_FORCE) || !ready) return step::no_force(seconds(now));
  follow_orders();
  double age = seconds(now - wanted.wall_ns);
  if (stalled_ && stalled_->load(std::memory_order_relaxed)) age = std::max(age, 2 * guard_.limits().stale);
  swage_command out =
      guard_.tick(request(wanted.force, age), motion(last.sample, seconds(now - last.wall_ns)),
                  std::clamp(dt, 1e-4, 0.05), seconds(now));
  out.time_s = wanted.force.time_s;
  return out;
}

void IoPort::read(uint64_t, double time_s, swage_sample& sample) noexcept {
  Given given;
  if (given_.latest(given) == 0) return;
  sample = given.sample;
  // an old sample is invalid: the step holds, and so does a replay, which gets the same samples
  const int64_t now = base::wall_ns();
  if (seconds(now - given.wall_ns) > kSilence || resting(given, now, time_s)) sample.valid = 0;
}

// A hand moves in wall time. Simulated time stands still in a pause, and lags where steps are lost: a hand that the scene has
// not read meanwhile is matched at its tool's place, as the tool would jump otherwise.
bool IoPort::resting(const Given& given, int64_t now, double time_s) noexcept {
  const bool whole = (given.sample.valid & given.known) == given.known;
  if (whole && heard_ns_ != 0 && seconds(now - heard_ns_) >= kSilence) rest_until_ = heard_s_ + kRest;
  if (whole) heard_ns_ = now;
  if (time_s < rest_until_) return true;
  if (whole) heard_s_ = time_s;
  return false;
}

double IoPort::lost_s() const noexcept {
  Given given;
  const bool spoke = given_.latest(given) != 0 && given.whole_ns != 0;
  return seconds(base::wall_ns() - (spoke ? given.whole_ns : started_ns_));
}

void IoPort::send(const step::ToolForce& force) noexcept {
  wanted_.publish({with_cue_force(force), base::wall_ns()});
}

swage_vec3 IoPort::force() const noexcept {
  Given given;
  return given_.latest(given) != 0 ? given.force : swage_vec3{};
}

void IoPort::told(double* out) const noexcept {
  Given given;
  if (given_.latest(given) != 0)
    std::copy_n(given.told, signals_.count(), out);
  else
    std::fill_n(out, signals_.count(), std::numeric_limits<double>::quiet_NaN());
}

bool IoPort::stale() const noexcept {
  Given given;
  return given_.latest(given) == 0 || seconds(base::wall_ns() - given.wall_ns) > kSilence;
}

StepPort::StepPort(host::DeviceSlot& slot, double dt, bool forces)
    : Port(slot, limits(slot)), dt_(dt), forces_(forces && (slot.device->flags & SWAGE_DEVICE_FORCE)) {}

void StepPort::read(uint64_t step, double time_s, swage_sample& sample) noexcept {
  swage_command command = step::no_force(time_s);
  if (forces_) {
    follow_orders();
    command = guard_.tick(request(wanted_, 0), motion(sample, 0), dt_, time_s);
    command.time_s = time_s;
  }
  given_ = command.force;
  step::exchange(slot_, step, command, sample);
  signals_.read(step, told_);
}

}  // namespace swage::session
