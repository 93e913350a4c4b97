// SPDX-License-Identifier: Apache-2.0
//
// One device as the step sees it. It may be asked in the step, have a thread of its own or be replayed from a recording; the step
// does not know which.
#pragma once

#include <swage/abi/device.h>
#include <swage/abi/sight.h>

#include <cstdint>

#include "host/rig.hpp"

namespace swage::step {

/// Effect of the scene on the tool that a device leads, in the device frame D0.
struct ToolForce {
  uint64_t step = 0;
  double time_s = 0;    // simulated
  swage_vec3 force{};   // N at the hand: contact forces times the force scale
  swage_vec3 torque{};  // N m, about the tool's origin
  swage_pose anchor{};  // pose of the hand that matches the tool: behind the hand while a fixed solid or the speed limit holds the tool
  swage_twist anchor_twist{};
  double stiffness = 0, damping = 0;  // N/m, N s/m, between anchor and hand
};

class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// Shows the scene to a device that takes it; once per step, before read(). Replays get nothing. [rt]
  virtual void look(uint64_t, const swage_sight&) noexcept {}
  /// Newest sample; leaves `sample` as it is when there is none. [rt]
  virtual void read(uint64_t step, double time_s, swage_sample& sample) noexcept = 0;
  /// Sends the force that the hand should feel, before any guard. [rt]
  virtual void send(const ToolForce& force) noexcept = 0;
};

/// Shows the scene to a device, if it takes it. [rt]
void show(host::DeviceSlot& slot, uint64_t step, const swage_sight& sight) noexcept;

/// A command without force. time_s: simulated time of the step [s]. [rt]
swage_command no_force(double time_s) noexcept;

/// Asks a LOCKSTEP device in the step. `sample` stays as it was where the device fails, which the guard counts against it. [rt]
void exchange(host::DeviceSlot& slot, uint64_t step, const swage_command& command, swage_sample& sample) noexcept;

/// A LOCKSTEP device without forces: asked in the step, so that a run is bit-reproducible.
class LockstepPort final : public DevicePort {
 public:
  explicit LockstepPort(host::DeviceSlot& slot) : slot_(slot) {}
  void look(uint64_t step, const swage_sight& sight) noexcept override { show(slot_, step, sight); }
  void read(uint64_t step, double time_s, swage_sample& sample) noexcept override {
    exchange(slot_, step, no_force(time_s), sample);
  }
  void send(const ToolForce&) noexcept override {}

 private:
  host::DeviceSlot& slot_;
};

}  // namespace swage::step
