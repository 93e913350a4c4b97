// SPDX-License-Identifier: Apache-2.0
//
// Times of short calls, told as medians and percentiles. A figure of this folder is a ratio inside one run,
// or stands beside the machine's own hiccups (hiccups()).
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <vector>

namespace swage::bench {

inline double now_ns() {
  using namespace std::chrono;
  return static_cast<double>(duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count());
}

/// Processor time of this thread: what percentiles of one method are taken from, because the system may take the processor
/// away in the middle of a step. Reading it costs about 0.3 us, which is part of what it shows.
inline double cpu_ns() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

struct Times {
  double mean = 0, median = 0, p90 = 0, p99 = 0, p999 = 0, max = 0;  // ns
};

inline Times times(std::vector<double> ns) {
  Times t;
  if (ns.empty()) return t;
  std::sort(ns.begin(), ns.end());
  for (double x : ns) t.mean += x / static_cast<double>(ns.size());
  const auto at = [&](double q) {
    return ns[std::min(ns.size() - 1, static_cast<size_t>(q * static_cast<double>(ns.size())))];
  };
  t.median = at(0.5), t.p90 = at(0.9), t.p99 = at(0.99), t.p999 = at(0.999), t.max = ns.back();
  return t;
}

/// What one reading of now_ns() costs.
inline double clock_ns() {
  std::vector<double> ns;
  for (int i = 0; i < 10000; ++i) {
    const double a = now_ns();
    ns.push_back(now_ns() - a);
  }
  return times(ns).median;
}

/// Keeps the compiler from dropping a result.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "r,m"(value) : "memory");
}

/// How noisy this machine is right now: a thread that only reads the clock, and the gaps it sees.
struct Hiccups {
  double seconds = 0;
  double lost_share = 0;  // of the time, in gaps over 50 us
  double worst_us = 0;
  uint64_t over_50us = 0, over_1ms = 0;
};

inline Hiccups hiccups(double seconds) {
  Hiccups h;
  h.seconds = seconds;
  const double start = now_ns();
  double last = start, lost = 0;
  while (last - start < seconds * 1e9) {
    const double now = now_ns();
    const double gap_us = (now - last) * 1e-3;
    if (gap_us > 50) ++h.over_50us, lost += gap_us;
    if (gap_us > 1000) ++h.over_1ms;
    h.worst_us = std::max(h.worst_us, gap_us);
    last = now;
  }
  h.lost_share = lost * 1e-6 / seconds;
  return h;
}

}  // namespace swage::bench
