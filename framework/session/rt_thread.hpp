// SPDX-License-Identifier: Apache-2.0
//
// The thread of the step: once per millisecond at absolute deadlines, with the real-time scheduling that the system
// grants.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "base/histogram.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::session {

/// Reaction to missed deadlines.
enum class Lateness : uint32_t {
  kCatchUp,   // no force device: up to four further steps at once, then drops the rest
  kDrop,      // force device present: one step, so that old poses of the hand are never replayed as forces
  kLockstep,  // no clock: as fast as possible, bitwise reproducible
};

/// Scheduling and memory locking granted by the system.
struct RtGrant {
  bool fifo = false;    // SCHED_FIFO 70
  bool locked = false;  // memory cannot be paged out
  int nice = 0;
  std::string sentence;  // for people; names the remedy when a request was refused
};

/// Makes the calling thread as punctual as the system allows. Never fails; returns what was granted. [the thread
/// itself]
RtGrant make_punctual();

/// Statistics of the loop. Written by the loop, read by the loop's own tick.
struct LoopStats {
  base::Histogram wake, wall, cpu;  // ns: lateness of waking, length of a tick, its processor time
  uint64_t late = 0, overrun = 0, own_overrun = 0, dropped = 0;
  void fill(snapshot::LoopHealth& health) const;
};

/// Deadlines one period apart, and the treatment of missed ones: caught up, or lost. Every period is counted as one of
/// the two. Uses no clock. [the loop's thread]
class Timeline {
 public:
  struct Due {
    int64_t steps = 1;  // to do now, at once
    uint64_t lost = 0;  // deadlines lost before them
  };
  Timeline(Lateness lateness, int64_t period_ns, int64_t now_ns)
      : lateness_(lateness), period_(period_ns), deadline_(now_ns + period_ns) {}

  int64_t deadline() const noexcept { return deadline_; }  // ns, of the next step
  /// After waking at `now_ns`, not before the deadline; deadline() is then that of the first due step.
  Due wake(int64_t now_ns) noexcept;
  void stepped() noexcept { deadline_ += period_; }

 private:
  const Lateness lateness_;
  const int64_t period_;  // ns
  int64_t deadline_;      // ns
};

/// Runs `tick` until it returns false. Not restartable.
class RtThread {
 public:
  struct Tick {
    uint64_t lost = 0;  // deadlines dropped since the last tick
  };
  /// Called once per period on the thread. [rt] Must not throw.
  using Work = std::function<bool(const Tick&)>;

  RtThread(Lateness lateness, double period_s, Work work);
  ~RtThread();  // joins

  /// `ready` runs on the new thread with the system's grant, before the first tick. [main]
  void start(std::function<void(const RtGrant&)> ready);
  void join();
  /// Increases with every wake-up, also in a pause: the heartbeat for the watchdog. [any]
  uint64_t beats() const noexcept { return beats_.load(std::memory_order_relaxed); }
  /// Thread id, 0 before the thread has begun. [any]
  pid_t tid() const noexcept { return tid_.load(std::memory_order_relaxed); }
  /// [rt]
  const LoopStats& stats() const noexcept { return stats_; }

 private:
  void run_clocked();
  void run_lockstep();
  bool one(const Tick& tick, int64_t deadline);

  const Lateness lateness_;
  const int64_t period_;  // ns
  Work work_;
  std::thread thread_;
  std::atomic<uint64_t> beats_{0};
  std::atomic<pid_t> tid_{0};
  LoopStats stats_;
};

}  // namespace swage::session
