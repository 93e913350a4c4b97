// SPDX-License-Identifier: Apache-2.0
//
// The only path to a haptic device: one guard per device, between the force of the scene and that on the hand.
//
// Order of operations: finite check, coupling, passivity, gain ramp, magnitude, thermal limit, slew, finite
// check. Frames: everything in the device frame D0. Threads: the thread that exchanges with the
// device, one at a time.
#pragma once

#include <swage/abi/device.h>

#include <atomic>
#include <cstdint>

namespace swage::session {

/// Limits of a device. Usual values are for an arm like the Phantom Desktop: peak 7.9 N, 1.75 N
/// continuous.
struct ForceLimits {
  double max_force = 3.0;  // N, magnitude; above 5 the arm's own structure is felt
  double continuous_force =
      1.75;  // N, continuous limit of the motors; more, for longer than `thermal_time`, burns them
  double thermal_time = 10.0;  // s, time constant of the motors
  double slew = 300.0;         // N/s; a contact at 0.2 m/s on 500 N/m needs 100; without this limit a jump is felt as a blow
  double max_stiffness =
      1000.0;                // N/m, of the coupling; above 2b/T (b: damping of arm and hand) the loop vibrates
  double max_damping = 5.0;  // N s/m; above f_c T/D (friction, period, encoder step) the encoder steps are felt
  double max_speed = 1.0;    // m/s, three ticks above it disarm: faster than any hand in a lesson
  double fade_in = 0.5;      // s, gain from 0 to 1 after arming or a fault
  double stale = 0.020;      // s, older requests or samples mean zero force
  double lost = 0.200;       // s, older requests or samples disarm
  double energy_cap = 2e-3;  // J, limit of the energy stored by the virtual side; with more it may release a jolt later
  double max_dissipation = 8.0;  // N s/m, largest damping that passivity control may add
  double filter_hz =
      100.0;  // cut-off of the velocity; lower delays the damping, higher passes encoder steps
};

/// Cause for which a guard has disarmed. It needs arm() again.
enum class ForceFault : uint32_t { kNone, kNotFinite, kTooFast, kLost, kStopped };
const char* text(ForceFault);

/// Force of the scene, and virtual coupling to the simulated tool.
struct ForceRequest {
  swage_vec3 force{};   // N, contact forces, already scaled to the hand
  swage_pose anchor{};  // pose of the simulated tool
  swage_twist anchor_twist{};
  double stiffness = 0;  // N/m, between anchor and hand; 0: no coupling
  double damping = 0;    // N s/m
  double age = 0;        // s since the step that computed this
};

/// Motion of the hand.
struct HandMotion {
  swage_vec3 p{}, v{};        // m, m/s
  bool has_velocity = false;  // else the velocity is computed from positions
  double age = 0;             // s since it was measured
};

class ForceGuard {
 public:
  explicit ForceGuard(const ForceLimits& limits = {}) : limits_(limits) {}

  void arm() noexcept;                   // from zero, with a new fade-in
  void disarm(ForceFault why) noexcept;  // zero from the next tick on
  bool armed() const noexcept { return armed_.load(std::memory_order_relaxed); }        // [any]
  ForceFault fault() const noexcept { return fault_.load(std::memory_order_relaxed); }  // [any]

  /// One tick of `dt` seconds: the command for the device. Its anchor, for servos faster than
  /// the step, has bounded stiffness and damping, faded like the force; `now_s` is the host's time, for the command's
  /// deadline.
  swage_command tick(const ForceRequest&, const HandMotion&, double dt, double now_s) noexcept;

  double gain() const noexcept { return gain_; }
  double energy() const noexcept { return energy_; }  // J, stored by the virtual side
  double dissipated() const noexcept {
    return dissipated_;
  }  // J, dissipated by passivity control; a large value shows a bad exercise
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
