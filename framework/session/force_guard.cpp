// SPDX-License-Identifier: Apache-2.0
#include "session/force_guard.hpp"

#include <algorithm>
#include <cmath>

namespace swage::session {

namespace {
// N; below it the tool has no contact. Usual contact force at the hand: 0.05 to 3 N. Larger: the observer forgets
// real energy
constexpr double kTouchForce = 1e-3;
// s without contact after which the stored energy is no longer meaningful (Hannaford, Ryu 2002)
constexpr double kForgetTime = 5e-3;
// m/s; below it damping cannot dissipate energy, and dividing by it would cause vibration
constexpr double kRestSpeed = 1e-4;
constexpr double kTwoPi = 6.283185307179586;

bool finite(const swage_vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
}  // namespace

const char* text(ForceFault fault) {
  switch (fault) {
    case ForceFault::kNone:
      return "none";
    case ForceFault::kNotFinite:
      return "a force or a position was not a number";
    case ForceFault::kTooFast:
      return "the hand was too fast";
    case ForceFault::kLost:
      return "device or scene went silent";
    case ForceFault::kStopped:
      return "stopped";
  }
  return "unknown";
}

void ForceGuard::arm() noexcept {
  gain_ = 0;
  energy_ = 0;
  quiet_time_ = 0;
  fast_ticks_ = 0;
  has_position_ = false;
  v_ = moved_ = applied_ = Vec{};
  fault_.store(ForceFault::kNone, std::memory_order_relaxed);
  armed_.store(true, std::memory_order_relaxed);
}

void ForceGuard::disarm(ForceFault why) noexcept {
  if (!armed()) return;
  gain_ = 0;
  fault_.store(why, std::memory_order_relaxed);
  armed_.store(false, std::memory_order_relaxed);
}

swage_command ForceGuard::tick(const ForceRequest& want, const HandMotion& hand, double dt,
                               double now_s) noexcept {
  swage_command out{};
  out.time_s = now_s - want.age;
  out.anchor.q.w = 1;
  out.deadline_s = now_s;

  // not armed, or invalid input: zero at once
  if (!accept(want, hand)) {
    applied_ = Vec{};
    heat_ -= heat_ * std::min(1.0, dt / limits_.thermal_time);
    return out;
  }
  observe_motion(hand, dt);
  if (!armed()) {
    applied_ = Vec{};
    return out;
  }

  // outdated input: the force goes to zero, no faster than the slew, and fades in again afterwards
  const bool stale = want.age > limits_.stale || hand.age > limits_.stale;
  Vec f = stale ? Vec{} : coupling(want, hand);
  f = passive(f, dt);
  gain_ = stale ? 0 : std::min(1.0, gain_ + dt / limits_.fade_in);
  f = bounded({gain_ * f.x, gain_ * f.y, gain_ * f.z}, dt);

  // the last check before the device
  if (!std::isfinite(f.x) || !std::isfinite(f.y) || !std::isfinite(f.z)) {
    disarm(ForceFault::kNotFinite);
    applied_ = Vec{};
    return out;
  }
  applied_ = f;
  out.force = {f.x, f.y, f.z};
  out.anchor = want.anchor;
  out.anchor_twist = want.anchor_twist;
  out.gain = gain_;
  out.stiffness = gain_ * std::clamp(want.stiffness, 0.0, limits_.max_stiffness);
  out.damping = gain_ * std::clamp(want.damping, 0.0, limits_.max_damping);
  out.deadline_s = stale ? now_s : now_s - want.age + limits_.stale;
  return out;
}

// true when finite and not lost; disarms otherwise
bool ForceGuard::accept(const ForceRequest& want, const HandMotion& hand) noexcept {
  if (!armed()) return false;
  const bool whole = finite(want.force) && finite(want.anchor.p) && finite(want.anchor_twist.v) &&
                     std::isfinite(want.stiffness) && std::isfinite(want.damping) && finite(hand.p) &&
                     (!hand.has_velocity || finite(hand.v));
  if (!whole) {
    disarm(ForceFault::kNotFinite);
  } else if (!(want.age <= limits_.lost) || !(hand.age <= limits_.lost)) {
    disarm(ForceFault::kLost);
  }
  return armed();
}

// position, displacement and filtered velocity of the hand; the velocity guard
void ForceGuard::observe_motion(const HandMotion& hand, double dt) noexcept {
  moved_ = has_position_ ? Vec{hand.p.x - p_.x, hand.p.y - p_.y, hand.p.z - p_.z} : Vec{};
  p_ = {hand.p.x, hand.p.y, hand.p.z};
  has_position_ = true;

  const Vec raw = hand.has_velocity ? Vec{hand.v.x, hand.v.y, hand.v.z}
                                    : Vec{moved_.x / dt, moved_.y / dt, moved_.z / dt};
  const double a = 1 - std::exp(-kTwoPi * limits_.filter_hz * dt);
  v_ = {v_.x + a * (raw.x - v_.x), v_.y + a * (raw.y - v_.y), v_.z + a * (raw.z - v_.z)};

  const double speed = std::sqrt(raw.x * raw.x + raw.y * raw.y + raw.z * raw.z);
  fast_ticks_ = speed > limits_.max_speed ? fast_ticks_ + 1 : 0;
  if (fast_ticks_ >= 3) disarm(ForceFault::kTooFast);
}

// F = force + K (x_a - x_d) + B (v_a - v_d), with K and B bounded
ForceGuard::Vec ForceGuard::coupling(const ForceRequest& want, const HandMotion& hand) const noexcept {
  const double k = std::clamp(want.stiffness, 0.0, limits_.max_stiffness);
  const double b = std::clamp(want.damping, 0.0, limits_.max_damping);
  const swage_vec3 &xa = want.anchor.p, &va = want.anchor_twist.v;
  return {want.force.x + k * (xa.x - hand.p.x) + b * (va.x - v_.x),
          want.force.y + k * (xa.y - hand.p.y) + b * (va.y - v_.y),
          want.force.z + k * (xa.z - hand.p.z) + b * (va.z - v_.z)};
}

// time-domain passivity (Hannaford, Ryu 2002), exact for a force held over the period: E is the energy that the virtual
// side has received from the hand; when it has given more than it received, damping dissipates the difference
ForceGuard::Vec ForceGuard::passive(Vec f, double dt) noexcept {
  const double given = applied_.x * moved_.x + applied_.y * moved_.y + applied_.z * moved_.z;
  energy_ = std::min(limits_.energy_cap, energy_ - given);
  const bool touching = std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z) > kTouchForce;
  quiet_time_ = touching ? 0 : quiet_time_ + dt;
  if (quiet_time_ >= kForgetTime) energy_ = 0;

  const double speed2 = v_.x * v_.x + v_.y * v_.y + v_.z * v_.z;
  if (energy_ >= 0 || speed2 < kRestSpeed * kRestSpeed) return f;
  const double alpha = std::min(limits_.max_dissipation, -energy_ / (dt * speed2));
  dissipated_ += alpha * speed2 * dt;
  return {f.x - alpha * v_.x, f.y - alpha * v_.y, f.z - alpha * v_.z};
}

// limits the magnitude, keeping the direction, then the heat of the motors, then the slew
ForceGuard::Vec ForceGuard::bounded(Vec f, double dt) noexcept {
  const double cold = limits_.continuous_force * limits_.continuous_force;
  if (heat_ > cold) hot_ = true;
  if (heat_ < 0.8 * cold) hot_ = false;
  const double limit = hot_ ? std::min(limits_.max_force, limits_.continuous_force) : limits_.max_force;
  const double size = std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z);
  if (size > limit) f = {f.x * limit / size, f.y * limit / size, f.z * limit / size};

  const Vec change{f.x - applied_.x, f.y - applied_.y, f.z - applied_.z};
  const double step = std::sqrt(change.x * change.x + change.y * change.y + change.z * change.z);
  const double most = limits_.slew * dt;
  if (step > most) {
    const double k = most / step;
    f = {applied_.x + k * change.x, applied_.y + k * change.y, applied_.z + k * change.z};
  }
  heat_ += (f.x * f.x + f.y * f.y + f.z * f.z - heat_) * std::min(1.0, dt / limits_.thermal_time);
  return f;
}

}  // namespace swage::session
