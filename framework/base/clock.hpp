// SPDX-License-Identifier: Apache-2.0
//
// Wall and processor time. Deadlines are in wall time; a plugin's slowness is measured in its processor time. Neither may affect
// the results of a step.
#pragma once

#include <time.h>

#include <cstdint>

namespace swage::base {

inline int64_t clock_ns(clockid_t id) noexcept {
  timespec t;
  clock_gettime(id, &t);
  return int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

/// Monotonic wall time, about 30 ns per call. [any]
inline int64_t wall_ns() noexcept { return clock_ns(CLOCK_MONOTONIC); }

/// Processor time of the calling thread: a system call, about 0.3 us. [any]
inline int64_t cpu_ns() noexcept { return clock_ns(CLOCK_THREAD_CPUTIME_ID); }

/// Sleeps until an absolute time of wall_ns(); continues after a signal. [io], and [rt] between two
/// steps only
inline void sleep_until_ns(int64_t deadline) noexcept {
  const timespec t{deadline / 1'000'000'000, deadline % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) != 0) {
  }
}

}  // namespace swage::base
