// SPDX-License-Identifier: Apache-2.0
#include "session/rt_thread.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "base/clock.hpp"

namespace swage::session {

namespace {

// above normal threads and serial readers (60), below the watchdog (75) and a haptic servo (80); otherwise a reader
// could delay the step
constexpr int kFifoPriority = 70;
// bytes of stack touched before the first step; a page first touched within a step costs a fault of 1 to 50
// us
constexpr std::size_t kStack = 256 * 1024;
// steps caught up in one wake-up; with more, a moving hand lags behind
constexpr int64_t kCatchUp = 4;

__attribute__((noinline)) void touch_stack() {
  volatile char page[kStack];
  for (std::size_t i = 0; i < kStack; i += 1024) page[i] = 0;
  static_cast<void>(page[0]);
}

// pages are locked when they are touched: locking whole reservations would load gigabytes of graphics
// mappings
bool lock_memory() {
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  if (!unlimited && geteuid() != 0) return false;
  return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

std::string sentence(const RtGrant& grant) {
  const std::string remedy =
      " Steps may come late under load. To allow it, give your group the limits \"rtprio 80\" and \"memlock "
      "unlimited\" "
      "in /etc/security/limits.d and log in again.";
  if (grant.fifo && grant.locked) return "Real time: priority 70, memory locked.";
  if (grant.fifo) return "Real-time priority 70, but the system refused to lock memory." + remedy;
  if (grant.nice < 0)
    return "Best effort at nice " + std::to_string(grant.nice) + ": the system refused real-time priority." +
           remedy;
  return "Best effort: the system refused real-time priority." + remedy;
}

}  // namespace

RtGrant make_punctual() {
  RtGrant grant;
  touch_stack();
  // the default slack of 50 us would be added to every sleep of a normal thread
  prctl(PR_SET_TIMERSLACK, 1UL);
  sched_param param{};
  param.sched_priority = kFifoPriority;
  grant.fifo = sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &param) == 0;
  if (!grant.fifo) {
    const auto self = static_cast<id_t>(syscall(SYS_gettid));
    if (setpriority(PRIO_PROCESS, self, -11) == 0) grant.nice = -11;
  }
  grant.locked = lock_memory();
  grant.sentence = sentence(grant);
  return grant;
}

void LoopStats::fill(snapshot::LoopHealth& health) const {
  health.late = late;
  health.overrun = overrun;
  health.own_overrun = own_overrun;
  health.dropped = dropped;
  health.worst_wake_s = 1e-9 * static_cast<double>(wake.max());
  health.worst_step_s = 1e-9 * static_cast<double>(wall.max());
  health.mean_step_cpu_s = 1e-9 * cpu.mean();
  health.p99_step_cpu_s = 1e-9 * static_cast<double>(cpu.quantile(0.99));
  health.p999_step_cpu_s = 1e-9 * static_cast<double>(cpu.quantile(0.999));
}

RtThread::RtThread(Lateness lateness, double period_s, Work work)
    : lateness_(lateness), period_(static_cast<int64_t>(period_s * 1e9 + 0.5)), work_(std::move(work)) {}

RtThread::~RtThread() { join(); }

void RtThread::join() {
  if (thread_.joinable()) thread_.join();
}

void RtThread::start(std::function<void(const RtGrant&)> ready) {
  thread_ = std::thread([this, ready = std::move(ready)] {
    prctl(PR_SET_NAME, "swage-step");
    tid_.store(static_cast<pid_t>(syscall(SYS_gettid)), std::memory_order_relaxed);
    if (lateness_ == Lateness::kLockstep) {
      ready(RtGrant{false, false, 0, "No clock: as fast as possible."});
      run_lockstep();
    } else {
      ready(make_punctual());
      run_clocked();
    }
  });
}

// one timed tick; overruns count by wall time, own overruns by processor time
bool RtThread::one(const Tick& tick, int64_t deadline) {
  beats_.fetch_add(1, std::memory_order_relaxed);
  const int64_t wall0 = base::wall_ns(), cpu0 = base::cpu_ns();
  const bool go_on = work_(tick);
  const int64_t cpu = base::cpu_ns() - cpu0, wall1 = base::wall_ns();
  stats_.cpu.add(cpu);
  stats_.wall.add(wall1 - wall0);
  if (wall1 > deadline + period_) {
    ++stats_.overrun;
    stats_.own_overrun += cpu > period_;
  }
  return go_on;
}

void RtThread::run_lockstep() {
  while (one({}, INT64_MAX / 2)) {
  }
}

Timeline::Due Timeline::wake(int64_t now_ns) noexcept {
  const int64_t behind = std::max<int64_t>(0, (now_ns - deadline_) / period_);
  const int64_t extra = lateness_ == Lateness::kCatchUp ? std::min(behind, kCatchUp) : 0;
  deadline_ += (behind - extra) * period_;
  return {1 + extra, static_cast<uint64_t>(behind - extra)};
}

void RtThread::run_clocked() {
  Timeline line(lateness_, period_, base::wall_ns());
  for (;;) {
    base::sleep_until_ns(line.deadline());
    const int64_t now = base::wall_ns(), late = now - line.deadline();
    stats_.wake.add(late);
    stats_.late += late > period_ / 2;

    Timeline::Due due = line.wake(now);
    stats_.dropped += due.lost;
    for (int64_t i = 0; i < due.steps; ++i) {
      if (!one({i == 0 ? due.lost : 0}, line.deadline())) return;
      line.stepped();
    }
  }
}

}  // namespace swage::session
