// SPDX-License-Identifier: Apache-2.0
//
// Devices as the session runs them: on threads of their own, or asked in the step; forces in both cases through a guard.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <future>
#include <thread>

#include "base/snapshot_ring.hpp"
#include "host/device_signals.hpp"
#include "host/rig.hpp"
#include "session/force_guard.hpp"
#include "step/device_port.hpp"

namespace swage::session {

/// What every port of a session can tell and be told. Methods without a mark are [any].
class Port : public step::DevicePort {
 public:
  Port(host::DeviceSlot& slot, const ForceLimits& limits) : slot_(slot), guard_(limits) {}
  /// What its device tells of itself from now on. [main] before start()
  void tell(const host::DeviceSignals& signals) { signals_ = signals; }
  const host::DeviceSignals& signals() const noexcept { return signals_; }
  /// Newest values of signals(), NaN where nothing is known. [rt]
  virtual void told(double* out) const noexcept = 0;
  virtual void start() {}                                                // [main] the device is open
  /// Ends its thread. False: the device has not come back from exchange(); the port, the rig and the watchdog's flag have to
  /// stay for the rest of the process. [main]
  virtual bool stop() { return true; }
  void arm() noexcept { arm_.fetch_add(1, std::memory_order_relaxed); }  // forces may flow, after a fade-in
  void disarm() noexcept { disarm_.fetch_add(1, std::memory_order_relaxed); }
  /// What a cue adds to the next force that is sent, N along the device's y. [rt]
  void set_cue_force(double force) noexcept { cue_force_ = force; }
  ForceFault fault() const noexcept { return guard_.fault(); }
  host::DeviceSlot& slot() const noexcept { return slot_; }
  virtual swage_vec3 force() const noexcept = 0;         // N, last given
  virtual bool stale() const noexcept { return false; }  // no new sample for a while
  /// s since it last gave everything that it ever gave of pose and closure; 0 where its clock is the scene's.
  virtual double lost_s() const noexcept { return 0; }

 protected:
  /// Limits for this device: never above what it says it bears.
  static ForceLimits limits(const host::DeviceSlot& slot);
  step::ToolForce with_cue_force(step::ToolForce force) const noexcept {
    force.force.y += cue_force_;
    return force;
  }
  void follow_orders() noexcept;  // takes arm and disarm over; on the thread that uses the guard

  host::DeviceSlot& slot_;
  ForceGuard guard_;
  host::DeviceSignals signals_;

 private:
  std::atomic<uint32_t> arm_{0}, disarm_{0};
  uint32_t arm_seen_ = 0, disarm_seen_ = 0;
  double cue_force_ = 0;  // N, of the step's thread
};

/// A device with a thread of its own: exchange() may block. Samples and wanted forces cross in mailboxes.
class IoPort final : public Port {
 public:
  /// `stalled`: the step has not come back; forces must go. [main]
  IoPort(host::DeviceSlot& slot, const std::atomic<bool>* stalled);
  ~IoPort() override { stop(); }  // only of a port whose device has come back
  void start() override;
  bool stop() override;
  void read(uint64_t step, double time_s, swage_sample& sample) noexcept override;
  void send(const step::ToolForce& force) noexcept override;
  swage_vec3 force() const noexcept override;
  bool stale() const noexcept override;
  double lost_s() const noexcept override;
  void told(double* out) const noexcept override;

 private:
  struct Wanted {
    step::ToolForce force;
    int64_t wall_ns = 0;
  };
  struct Given {
    swage_sample sample;
    swage_vec3 force;
    int64_t wall_ns = 0;  // when a new sample last came
    int64_t whole_ns = 0; // when one last came that was whole
    uint64_t known = 0;   // SWAGE_VALID_POSE, _CLOSURE that it has ever given
    double told[SWAGE_MOST_DEVICE_SIGNALS];
  };
  bool resting(const Given& given, int64_t now, double time_s) noexcept;
  void run();
  swage_command command(const Given& last, double dt, int64_t now) noexcept;

  const std::atomic<bool>* stalled_;
  const double period_;     // s
  int64_t started_ns_ = 0;  // before the thread
  // when the step last heard it whole, by the clock and in s simulated; until when it rests. Of the step's thread
  int64_t heard_ns_ = 0;
  double heard_s_ = 0, rest_until_ = 0;
  base::SnapshotRing<Wanted> wanted_;
  base::SnapshotRing<Given> given_;
  std::atomic<bool> stop_{false};
  std::promise<void> ended_;
  bool left_ = false;
  std::thread thread_;
};

/// A LOCKSTEP device, asked in the step. Its clock is the scene's.
class StepPort final : public Port {
 public:
  /// `forces`: false where nobody could release the hand if the step hung, i.e. in real time. [main]
  StepPort(host::DeviceSlot& slot, double dt, bool forces);
  void look(uint64_t step, const swage_sight& sight) noexcept override { step::show(slot_, step, sight); }
  void read(uint64_t step, double time_s, swage_sample& sample) noexcept override;
  void send(const step::ToolForce& force) noexcept override { wanted_ = with_cue_force(force); }
  swage_vec3 force() const noexcept override { return given_; }
  void told(double* out) const noexcept override { std::copy_n(told_, signals_.count(), out); }

 private:
  const double dt_;
  const bool forces_;
  step::ToolForce wanted_;
  swage_vec3 given_{};
  double told_[SWAGE_MOST_DEVICE_SIGNALS] = {};
};

}  // namespace swage::session
