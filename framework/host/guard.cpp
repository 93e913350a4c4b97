// SPDX-License-Identifier: Apache-2.0
#include "host/guard.hpp"

#include <langinfo.h>
#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <clocale>
#include <cmath>
#include <cstring>

#include "base/clock.hpp"
#include "host/call_watch.hpp"
#include "toolkit/wide.hpp"

namespace swage::host {

thread_local constinit LastCall last_call;

namespace {

constexpr uint64_t kWindow = 100;            // steps over which lateness is counted
constexpr int kBadge = 5, kQuarantine = 20;  // limits of late steps in the window
// ns over the budget while it is investigated: a plugin that sleeps a third of a second per step is stopped before twenty such steps
constexpr int64_t kMostExcess = 250'000'000;

// voluntary context switches of the calling thread: a system call, about 0.3 us
int64_t waits() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nvcsw;
}

// the locale at the beginning of calls on [main]; a plain array, because a step must be able to restore it
char locale_now[512] = "C";

// number of late steps in the last kWindow; the window is 64 + 36 bits
int late_count(const Watch& watch) {
  return std::popcount(watch.late[0]) + std::popcount(watch.late[1] & ((uint64_t{1} << (kWindow - 64)) - 1));
}

// moves the window forward by `steps`
void shift(Watch& watch, uint64_t steps) {
  if (steps >= 128) {
    watch.late[0] = watch.late[1] = 0;
  } else if (steps >= 64) {
    watch.late[1] = watch.late[0] << (steps - 64);
    watch.late[0] = 0;
  } else if (steps > 0) {
    watch.late[1] = (watch.late[1] << steps) | (watch.late[0] >> (64 - steps));
    watch.late[0] <<= steps;
  }
}

void begin_step(Watch& watch, uint64_t step) {
  shift(watch, step > watch.step ? step - watch.step : 1);
  watch.badge.store(late_count(watch) >= kBadge ? 1 : 0, std::memory_order_relaxed);
  watch.step = step;
  watch.wall_ns = watch.cpu_ns = watch.waited_ns = 0;
  watch.investigated = step < watch.investigate_until;
  if (!watch.investigated) watch.excess_ns = 0;
}

}  // namespace

void quarantine(Instance& instance, FaultKind fault, Call call, uint64_t step) noexcept {
  FaultKind none = FaultKind::kNone;
  if (!instance.fault.compare_exchange_strong(none, fault, std::memory_order_relaxed)) return;
  instance.fault_call.store(call, std::memory_order_relaxed);
  instance.quarantine_step.store(step, std::memory_order_relaxed);
  instance.quarantined.store(1, std::memory_order_release);
}

namespace {

/// The sum of the absolute values of n numbers, in whatever order; NaN where one of them is.
template <class V>
[[gnu::always_inline]] inline double sum_of_sizes(const double* data, std::size_t n) noexcept {
  typedef long long Bits __attribute__((vector_size(8 * V::n)));
  const auto size = [data](std::size_t i) __attribute__((always_inline)) {
    V v;
    v.load(data + i);
    // all bits but the sign
    return V{__builtin_bit_cast(decltype(v.x), __builtin_bit_cast(Bits, v.x) & 0x7FFFFFFFFFFFFFFF)};
  };
  constexpr std::size_t kSums = 4;  // independent: no addition waits for the one before
  V sum[kSums] = {};
  std::size_t i = 0;
  for (; i + kSums * V::n <= n; i += kSums * V::n)
    for (std::size_t k = 0; k < kSums; ++k) sum[k].x += size(i + k * V::n).x;
  const V all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  double total = 0;
  for (; i < n; ++i) total += std::abs(data[i]);
  for (int k = 0; k < V::n; ++k) total += all.x[k];
  return total;
}
SWAGE_FOURS double sum_of_sizes_by_fours(const double* data, std::size_t n) noexcept {
  return sum_of_sizes<toolkit::Fours>(data, n);
}

}  // namespace

bool accept(Instance& instance, Call call, uint64_t step, const double* data, std::size_t n,
            double limit) noexcept {
  // one pass without branches for the usual case: absolute values with a sum no larger than the limit
  if ((toolkit::has_fours() ? sum_of_sizes_by_fours(data, n) : sum_of_sizes<toolkit::Twos>(data, n)) <= limit) return true;

  // NaN fails every comparison
  const auto sound = [&](double x) { return std::abs(x) <= limit; };
  if (std::all_of(data, data + n, sound)) return true;
  quarantine(instance, finite(data, n) ? FaultKind::kTooLarge : FaultKind::kNotFinite, call, step);
  return false;
}

namespace detail {

void start_watch(Watch& watch, uint64_t step, Clocks& begin) noexcept {
  if (watch.step != step) begin_step(watch, step);
  // these clocks are system calls: they are read only while an instance is investigated
  if (watch.investigated) {
    begin.waits = waits();
    begin.cpu = base::cpu_ns();
  }
  begin.wall = base::wall_ns();
}

FaultKind stop_watch(Watch& watch, const Clocks& begin) noexcept {
  const int64_t spent = base::wall_ns() - begin.wall;
  watch.wall_ns += spent;
  if (spent > watch.worst_wall_ns.load(std::memory_order_relaxed))
    watch.worst_wall_ns.store(spent, std::memory_order_relaxed);
  const bool over_before = watch.wall_ns - spent > watch.budget_ns;
  const int64_t own_before = watch.cpu_ns + watch.waited_ns;
  if (watch.investigated) {
    const int64_t cpu = base::cpu_ns() - begin.cpu;
    watch.cpu_ns += cpu;
    // time for which the instance waits voluntarily counts; time for which the machine delays it does not
    if (!watch.may_wait && waits() > begin.waits) watch.waited_ns += std::max<int64_t>(0, spent - cpu);
  }
  if (watch.wall_ns <= watch.budget_ns) return FaultKind::kNone;

  // over the budget by the wall clock: investigate; by its own time: late
  watch.investigate_until = watch.step + kWindow;
  if (!watch.investigated) return FaultKind::kNone;
  const int64_t own = watch.cpu_ns + watch.waited_ns;
  const bool guilty = own > watch.budget_ns;
  if (guilty) watch.excess_ns += own - std::max(own_before, watch.budget_ns);
  if (guilty && (watch.late[0] & 1) == 0) {
    watch.late[0] |= 1;
    watch.late_steps.fetch_add(1, std::memory_order_relaxed);
  } else if (!guilty && !over_before) {
    watch.preempted.fetch_add(1, std::memory_order_relaxed);
  }
  const int count = late_count(watch);
  if (count >= kBadge) watch.badge.store(1, std::memory_order_relaxed);
  if (!guilty) return FaultKind::kNone;
  if (watch.excess_ns > kMostExcess) return FaultKind::kStalled;
  if (count < kQuarantine) return FaultKind::kNone;
  return watch.waited_ns > watch.cpu_ns ? FaultKind::kWaited : FaultKind::kLate;
}

const char* radix() noexcept { return nl_langinfo(RADIXCHAR); }

void restore_locale() noexcept { std::setlocale(LC_ALL, locale_now); }

MainCall::MainCall(bool on_main) noexcept : on_main_(on_main) {
  if (!on_main_) return;
  watched_ = CallWatch::enter(last_call);
  const char* now = std::setlocale(LC_ALL, nullptr);
  if (now != nullptr && std::strlen(now) < sizeof locale_now) std::strcpy(locale_now, now);
}

MainCall::~MainCall() {
  if (watched_) CallWatch::leave();
}

bool MainCall::locale_kept() const noexcept {
  if (!on_main_) return true;
  const char* now = std::setlocale(LC_ALL, nullptr);
  return now == nullptr || std::strcmp(now, locale_now) == 0;
}

}  // namespace detail

}  // namespace swage::host
