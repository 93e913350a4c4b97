// SPDX-License-Identifier: Apache-2.0
//
// The step thread's work around a step: commands in, snapshots, events and records out, and the end of an attempt.
#pragma once

#include <swage/abi/device.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/spsc_ring.hpp"
#include "judge/host_events.hpp"
#include "judge/verdict.hpp"
#include "record/recorder.hpp"
#include "session/cue_force.hpp"
#include "session/device_ports.hpp"
#include "session/rt_thread.hpp"
#include "snapshot/channel.hpp"
#include "step/step.hpp"

namespace swage::session {

/// Cause of the end of an attempt.
enum class Ending : uint32_t { kNone, kVerdict, kStopped, kTimeLimit, kLessonTimeLimit, kHandEnded, kVoid, kImpossible };

class Loop {
 public:
  struct Settings {
    bool realtime = true;
    bool start_paused = false;
    double max_time_s = 0;                  // limit of the caller; 0: none
    double lesson_max_time_s = 0;           // limit of the lesson; 0: none
    std::vector<CuePulse> cue_pulses = {};  // pulses of the cues that the lesson allows to be felt
  };

  /// `recorder` may be nullptr. All arguments outlive the loop. [main]
  Loop(host::Rig& rig, step::Engine& engine, std::vector<Port*> ports, record::Recorder* recorder,
       const Settings& settings);

  /// One period. False: the attempt is over. [rt]
  bool tick(const RtThread::Tick& tick, const LoopStats& stats) noexcept;

  // --- called from outside; one caller at a time each
  bool command(const step::Command& command) { return command_in_.try_push(command); }  // [main]
  void pause(bool on) { paused_.store(on, std::memory_order_relaxed); }                 // [main]
  void stop() { stop_.store(true, std::memory_order_relaxed); }                         // [any]
  void pointer(const swage_pointer& p, int64_t due_ns) { pointer_in_.try_push({p, due_ns}); }  // [one thread]
  void grant(bool realtime) { realtime_granted_ = realtime; }  // [rt] before the first tick

  bool latest(snapshot::Snapshot& out) const { return channel_.latest(out); }  // [any]
  bool next_event(judge::Event& out) { return event_out_.try_pop(out); }       // [one reader]
  bool finished() const { return finished_.load(std::memory_order_acquire); }  // [any]
  uint64_t steps() const { return steps_.load(std::memory_order_relaxed); }    // [any] executed so far

  // --- valid once finished
  Ending ending() const { return ending_; }
  double hardest() const { return hardest_; }  // N, greatest force at one contact
  const snapshot::LoopHealth& health() const { return out_->health; }
  /// How often a port's hand was lost, and for how long the lesson waited for it, s.
  uint32_t times_lost(std::size_t port) const { return lost_[port].times; }
  double seconds_lost(std::size_t port) const { return lost_[port].seconds + lost_[port].longest_now; }
  /// Simulated seconds in which a device that gives forces was switched off by its guard.
  double forces_off_s() const { return static_cast<double>(forceless_steps_) * rig_.world.dt; }

 private:
  void listen(const RtThread::Tick& tick) noexcept;
  void take_command(const step::Command& command) noexcept;
  void take_pointer() noexcept;
  void send_cue_force() noexcept;
  void watch_hands() noexcept;
  void tell(judge::HostEvent event, double value) noexcept;
  void tell_not_drawn() noexcept;
  uint32_t listen_to_devices(double* signal, uint32_t n) const noexcept;
  void keep(const LoopStats& stats) noexcept;
  void show(const LoopStats& stats) noexcept;
  void feel() noexcept;
  Ending judge() const noexcept;
  bool end(Ending ending, const LoopStats& stats) noexcept;

  host::Rig& rig_;
  step::Engine& engine_;
  const std::vector<Port*> ports_;
  record::Recorder* const recorder_;
  const Settings settings_;

  base::SpscRing<step::Command> command_in_;
  struct PointerInput {
    swage_pointer state;
    int64_t due_ns;  // of base::wall_ns()
  };
  base::SpscRing<PointerInput> pointer_in_;
  swage_pointer pointer_{0, 0, 0, 0, 0, 0, {1, 0, 0, 0}};  // of the present step
  PointerInput waiting_pointer_{};  // taken from pointer_in_, and not yet due
  bool pointer_waits_ = false;
  base::SpscRing<judge::Event> event_out_;
  snapshot::Channel channel_;
  std::unique_ptr<snapshot::Snapshot> out_;
  record::StepRecord record_;
  std::vector<ForceFault> fault_seen_;
  CueForce cue_force_;

  struct Lost {
    uint32_t times = 0;
    double seconds = 0;      // total
    double longest_now = 0;  // of the present loss; 0: not lost
  };
  std::vector<Lost> lost_;  // of each port
  bool hand_lost_ = false;
  uint64_t waited_ = 0;  // ticks

  std::atomic<bool> paused_, stop_{false}, finished_{false};
  std::atomic<uint64_t> steps_{0};
  bool forces_on_ = false;
  bool told_not_drawn_ = false;
  bool realtime_granted_ = false;
  uint64_t lost_events_ = 0;
  uint64_t forceless_steps_ = 0;
  double hardest_ = 0;  // N
  Ending ending_ = Ending::kNone;
};

}  // namespace swage::session
