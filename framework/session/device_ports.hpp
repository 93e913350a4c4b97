// SPDX-License-Identifier: Apache-2.0
//
// Devices in a session: on their own threads, or called in the step; forces in both cases through a guard.
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

/// Interface of all ports of a session. Methods without a mark are [any].
class Port : public step::DevicePort {
 public:
  Port(host::DeviceSlot& slot, const ForceLimits& limits) : slot_(slot), guard_(limits) {}
  /// Sets the signals that its device reports. [main] before start()
  void tell(const host::DeviceSignals& signals) { signals_ = signals; }
  const host::DeviceSignals& signals() const noexcept { return signals_; }
  /// Newest values of signals(), NaN where unknown. [rt]
  virtual void told(double* out) const noexcept = 0;
  virtual void start() {}                                                // [main] the device is open
  /// Ends its thread. False: the device has not returned from exchange(); the port, the rig and the watchdog's flag must
  /// live until the process ends. [main]
  virtual bool stop() { return true; }
  void arm() noexcept { arm_.fetch_add(1, std::memory_order_relaxed); }  // enables forces, with a fade-in
  void disarm() noexcept { disarm_.fetch_add(1, std::memory_order_relaxed); }
  /// Force of a cue to add to the next force that is sent, N along the device's y. [rt]
  void set_cue_force(double force) noexcept { cue_force_ = force; }
  ForceFault fault() const noexcept { return guard_.fault(); }
  host::DeviceSlot& slot() const noexcept { return slot_; }
  virtual swage_vec3 force() const noexcept = 0;         // N, last sent
  virtual bool stale() const noexcept { return false; }  // no new sample for kSilence
  /// s since its last sample with all of pose and closure that it has ever given; 0 where its clock is the scene's.
  virtual double lost_s() const noexcept { return 0; }

 protected:
  /// Limits for this device: at most those that it declares.
  static ForceLimits limits(const host::DeviceSlot& slot);
  step::ToolForce with_cue_force(step::ToolForce force) const noexcept {
    force.force.y += cue_force_;
    return force;
  }
  void follow_orders() noexcept;  // applies arm and disarm; on the thread that uses the guard

  host::DeviceSlot& slot_;
  ForceGuard guard_;
  host::DeviceSignals signals_;

 private:
  std::atomic<uint32_t> arm_{0}, disarm_{0};
  uint32_t arm_seen_ = 0, disarm_seen_ = 0;
  double cue_force_ = 0;  // N, used by the step's thread
};

/// A device with its own thread: exchange() may block. Samples and wanted forces are passed in mailboxes.
class IoPort final : public Port {
 public:
  /// `stalled`: true while the step has not returned, when forces must be zero. [main]
  IoPort(host::DeviceSlot& slot, const std::atomic<bool>* stalled);
  ~IoPort() override { stop(); }  // only of a port whose device has returned
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
    int64_t wall_ns = 0;  // time of the last new sample
    int64_t whole_ns = 0; // time of the last new sample with all known values
    uint64_t known = 0;   // those of SWAGE_VALID_POSE, _CLOSURE that it has ever given
    double told[SWAGE_MOST_DEVICE_SIGNALS];
  };
  bool resting(const Given& given, int64_t now, double time_s) noexcept;
  void run();
  swage_command command(const Given& last, double dt, int64_t now) noexcept;

  const std::atomic<bool>* stalled_;
  const double period_;     // s
  int64_t started_ns_ = 0;  // set before the thread starts
  // used by the step's thread: wall and simulated time of the last sample with all known values; end of the forced rest
  int64_t heard_ns_ = 0;
  double heard_s_ = 0, rest_until_ = 0;
  base::SnapshotRing<Wanted> wanted_;
  base::SnapshotRing<Given> given_;
  std::atomic<bool> stop_{false};
  std::promise<void> ended_;
  bool left_ = false;
  std::thread thread_;
};

/// A LOCKSTEP device, called in the step. Its clock is the scene's.
class StepPort final : public Port {
 public:
  /// `forces`: false in real time, as nothing could release the hand if the step hung. [main]
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
