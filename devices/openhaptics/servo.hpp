// SPDX-License-Identifier: Apache-2.0
//
// The callback of the OpenHaptics scheduler at 1 kHz: reads the arm, and closes the loop on the command that passed the host's force
// guard. SI in the interface, the library's units (mm, rad, N) inside.
#pragma once

#include <swage/abi/device.h>

#include <atomic>
#include <cstdint>

#include "hd.hpp"
#include "mailbox.hpp"
#include "toolkit/math.hpp"

namespace swage::openhaptics {

using toolkit::Pose;
using toolkit::Vec3;

/// State of the arm.
struct Measured {
  uint64_t ticks = 0;
  double time_s = 0;  // CLOCK_MONOTONIC
  Pose X_DS;          // stylus in the device's frame, m
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();
  uint32_t buttons = 0;
  double force = 0;   // N, as commanded last
};

/// Command that passed the guard, for a hand at p with velocity v.
struct Wanted {
  Vec3 force = Vec3::Zero(), p = Vec3::Zero(), v = Vec3::Zero();
  double stiffness = 0, damping = 0;  // N/m, N s/m
  double deadline_s = 0;              // CLOCK_MONOTONIC; zero force after it
};

class Servo {
 public:
  /// `most` [N]: upper limit of the force, for any command.
  void start(const Hd* hd, unsigned device, double most);
  /// The callback for the scheduler.
  static unsigned tick(void* self) { return static_cast<Servo*>(self)->run(); }
  /// Stops the force; the callback ends itself after ten ticks without force. [any]
  void leave() noexcept { leaving_.store(true, std::memory_order_relaxed); }
  bool gone() const noexcept { return gone_.load(std::memory_order_acquire); }
  /// Code of the error by which the arm was lost, or by which it lost its forces; 0: none. [any]
  unsigned lost() const noexcept { return lost_.load(std::memory_order_relaxed); }
  unsigned forceless() const noexcept { return forceless_.load(std::memory_order_relaxed); }

  Mailbox<Measured> measured;
  Mailbox<Wanted> wanted;

 private:
  unsigned run() noexcept;
  Measured read() noexcept;
  Vec3 force(const Measured& now, double dt) noexcept;
  void hear_errors() noexcept;

  const Hd* hd_ = nullptr;
  unsigned device_ = kBadHandle;
  double most_ = 0;
  uint64_t ticks_ = 0;
  int quiet_ = 0;      // ticks without force, while leaving
  double last_s_ = 0;
  Vec3 applied_ = Vec3::Zero();
  Wanted want_;
  std::atomic<bool> leaving_{false}, gone_{false};
  std::atomic<unsigned> lost_{0}, forceless_{0};
};

double now_s() noexcept;

}  // namespace swage::openhaptics
