// SPDX-License-Identifier: Apache-2.0
//
// The only way to a haptic device: one guard per device, between what the scene wants and what the hand gets.
//
// Order of operations: finite check, coupling, passivity, gain ramp, magnitude, thermal limit, slew, finite
// check. Frames: everything in the device frame D0. Threads: called by whichever thread exchanges with the
// device, one at a time.
#pragma once

#include <swage/abi/device.h>

#include <atomic>
#include <cstdint>

namespace swage::session {

/// What a device may be given. Normal values are for an arm like the Phantom Desktop: peak 7.9 N, 1.75 N for
/// ever.
struct ForceLimits {
  double max_force = 3.0;  // N, magnitude; above 5 the arm's structure, not the scene, is felt
  double continuous_force =
      1.75;  // N, what the motors bear for ever; more, for longer than `thermal_time`, burns them
  double thermal_time = 10.0;  // s, time constant of the motors
  double slew = 300.0;         // N/s; a contact at 0.2 m/s on 500 N/m needs 100; without it a jump is a blow
  double max_stiffness =
      1000.0;                // N/m, of the coupling; above 2b/T (b: damping of arm and hand) the loop rings
  double max_damping = 5.0;  // N s/m; above f_c T/D (friction, period, encoder step) the encoder is heard
  double max_speed = 1.0;    // m/s, three ticks above it disarm: no hand in a lesson is that fast
  double fade_in = 0.5;      // s, gain from 0 to 1 after arming or a fault
  double stale = 0.020;      // s, older requests or samples mean zero force
  double lost = 0.200;       // s, older requests or samples disarm
  double energy_cap = 2e-3;  // J, what the virtual side may save up; more and it may kick later
  double max_dissipation = 8.0;  // N s/m, strongest damping that passivity control may add
  double filter_hz =
      100.0;  // cut-off of the velocity; lower delays the damping, higher lets encoder steps through
};

/// Why a guard has disarmed. Needs arm() again.
enum class ForceFault : uint32_t { kNone, kNotFinite, kTooFast, kLost, kStopped };
const char* text(ForceFault);

/// What the scene wants.
struct ForceRequest {
  swage_vec3 force{};   // N, contact forces, already scaled to the hand
  swage_pose anchor{};  // pose of the simulated tool
  swage_twist anchor_twist{};
  double stiffness = 0;  // N/m, between anchor and hand; 0: no coupling
  double damping = 0;    // N s/m
  double age = 0;        // s since the step that wants this
};

/// Where the hand is.
struct HandMotion {
  swage_vec3 p{}, v{};        // m, m/s
  bool has_velocity = false;  // else it is taken from the positions
  double age = 0;             // s since it was measured
};

class ForceGuard {
 public:
  explicit ForceGuard(const ForceLimits& limits = {}) : limits_(limits) {}

  void arm() noexcept;                   // from zero, with a new fade-in
  void disarm(ForceFault why) noexcept;  // zero from the next tick on
  bool armed() const noexcept { return armed_.load(std::memory_order_relaxed); }        // [any]
  ForceFault fault() const noexcept { return fault_.load(std::memory_order_relaxed); }  // [any]

  /// One tick of `dt` seconds: what the device may be told. The anchor in the answer, for servos faster than
  /// the step, has bounded stiffness and damping, faded like the force; `now_s` is the host's clock, for its
  /// deadline.
  swage_command tick(const ForceRequest&, const HandMotion&, double dt, double now_s) noexcept;

  double gain() const noexcept { return gain_; }
  double energy() const noexcept { return energy_; }  // J, what the virtual side holds
  double dissipated() const noexcept {
    return dissipated_;
  }  // J, taken out by passivity control; much of it: a bad exercise
  const ForceLimits& limits() const noexcept { return limits_; }

 private:
  struct Vec {
    double x, y, z;
  };
  bool accept(const ForceRequest&, const HandMotion&) noexcept;
  void observe_motion(const HandMotion&, double dt) noexcept;
  Vec coupling(const ForceRequest&, const HandMotion&) const noexcept;
  Vec passive(Vec f, double dt) noexcept;
  Vec bounded(Vec f, double dt) noexcept;

  ForceLimits limits_;
  std::atomic<bool> armed_{false};
  std::atomic<ForceFault> fault_{ForceFault::kNone};
  double gain_ = 0;
  double energy_ = 0, dissipated_ = 0;
  double heat_ = 0;  // N2, smoothed square of the force
  bool hot_ = false;
  double quiet_time_ = 0;  // s without contact
  int fast_ticks_ = 0;
  bool has_position_ = false;
  Vec p_{}, v_{}, moved_{};
  Vec applied_{};  // N, given in the last tick
};

}  // namespace swage::session
