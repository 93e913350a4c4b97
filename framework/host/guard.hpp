// SPDX-License-Identifier: Apache-2.0
//
// Every call into a plugin goes through guarded(): an exception, an error, a changed floating-point mode or
// repeated overrun disables the instance, never the session. Cost over a bare call: 5 ns untimed, 50 ns timed.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "host/instance.hpp"

namespace swage::host {

/// Control bits of the floating-point unit (MXCSR and x87), without the sticky flags.
struct FpuMode {
  uint32_t mxcsr = 0, x87 = 0;
  bool operator==(const FpuMode&) const = default;
};

inline FpuMode fpu_mode() noexcept {
#if defined(__x86_64__)
  uint32_t mxcsr;
  uint16_t x87;
  asm volatile("stmxcsr %0" : "=m"(mxcsr));
  asm volatile("fnstcw %0" : "=m"(x87));
  return {mxcsr & ~0x3Fu, x87};  // the low six bits are exception flags, not modes
#else
  return {};
#endif
}

inline void set_fpu_mode([[maybe_unused]] const FpuMode& mode) noexcept {
#if defined(__x86_64__)
  const uint32_t mxcsr = mode.mxcsr;
  const auto x87 = static_cast<uint16_t>(mode.x87);
  asm volatile("ldmxcsr %0" : : "m"(mxcsr));
  asm volatile("fldcw %0" : : "m"(x87));
#endif
}

/// The call that a thread is in. A signal handler reads its own thread's, a watchdog those of registered
/// threads.
struct LastCall {
  std::atomic<const Instance*> instance{nullptr};  // nullptr between calls
  std::atomic<Call> call{Call::kNone};
  std::atomic<uint64_t> step{0};
};
extern thread_local constinit LastCall last_call;

/// Puts the instance in quarantine; the first fault is kept. [any] wait-free
void quarantine(Instance& instance, FaultKind fault, Call call, uint64_t step) noexcept;

/// True when all n numbers are finite.
inline bool finite(const double* data, std::size_t n) noexcept {
  uint64_t worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    // infinity and NaN have an exponent of all ones
    const uint64_t exponent = __builtin_bit_cast(uint64_t, data[i]) & 0x7FF0000000000000ull;
    worst |= static_cast<uint64_t>(exponent == 0x7FF0000000000000ull);
  }
  return worst == 0;
}

/// Checks the output of a call: finite, and no component beyond `limit` in size. False:
/// the instance is in quarantine. [rt]
bool accept(Instance& instance, Call call, uint64_t step, const double* data, std::size_t n,
            double limit) noexcept;

namespace detail {

/// The clocks of one call.
struct Clocks {
  int64_t wall = 0, cpu = 0;  // ns
  int64_t waits = 0;          // voluntary context switches of the thread
};
void start_watch(Watch& watch, uint64_t step, Clocks& begin) noexcept;
/// The fault that follows from the lateness of the last 100 steps; kNone: no fault.
FaultKind stop_watch(Watch& watch, const Clocks& begin) noexcept;

/// The decimal point of the thread's locale; the pointer changes when setlocale is called.
const char* radix() noexcept;
/// Restores the locale in which the last MainCall began.
void restore_locale() noexcept;

/// Scope of a call on [main]: its limit in wall time, and the locale, which it must not change.
class MainCall {
 public:
  explicit MainCall(bool on_main) noexcept;
  ~MainCall();
  MainCall(const MainCall&) = delete;
  MainCall& operator=(const MainCall&) = delete;
  /// False: the call changed the locale, which is restored.
  bool locale_kept() const noexcept;

 private:
  const bool on_main_;
  bool watched_ = false;
};

/// Calls `f` under last_call and catches exceptions. SWAGE_FAULT: it threw. `changed`: fault if it changed the thread's
/// floating-point mode or the program's locale, which are restored.
template <class F>
swage_result contained(Instance& instance, Call call, uint64_t step, F&& f,
                       FaultKind* changed = nullptr) noexcept {
  const FpuMode mode = fpu_mode();
  const char* const point = radix();
  // a signal handler or a watchdog reads here which call is running
  last_call.call.store(call, std::memory_order_relaxed);
  last_call.step.store(step, std::memory_order_relaxed);
  last_call.instance.store(&instance, std::memory_order_release);
  const MainCall main_call(on_main(call));

  // the wrapper catches exceptions inside the plugin; those of a plugin without it are caught here
  swage_result result = SWAGE_OK;
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<F>>) {
      f();
    } else {
      result = f();
    }
  } catch (...) {
    result = SWAGE_FAULT;
  }
  last_call.instance.store(nullptr, std::memory_order_release);
  FaultKind what = FaultKind::kNone;
  if (radix() != point || !main_call.locale_kept()) {
    restore_locale();
    what = FaultKind::kLocale;
  }
  if (fpu_mode() != mode) {
    set_fpu_mode(mode);
    what = FaultKind::kFpuMode;
  }
  if (changed != nullptr) *changed = what;
  return result;
}

}  // namespace detail

/// Calls `f` (a call of one plugin function; swage_result or void) for `instance`. True: its output is valid.
/// False: discard the output, because the plugin said DISCARD, is in quarantine, or was just put there. [any]
/// noexcept, no allocation unless the plugin throws.
template <class F>
bool guarded(Instance& instance, Call call, uint64_t step, F&& f) noexcept {
  if (instance.quarantined.load(std::memory_order_relaxed) != 0) return false;
  const bool timed = instance.watch.budget_ns > 0;
  detail::Clocks begin;
  if (timed) detail::start_watch(instance.watch, step, begin);
  FaultKind changed = FaultKind::kNone;
  const swage_result result = detail::contained(instance, call, step, f, &changed);
  const FaultKind late = timed ? detail::stop_watch(instance.watch, begin) : FaultKind::kNone;

  if (changed != FaultKind::kNone) {
    quarantine(instance, changed, call, step);
  } else if (result < 0) {
    quarantine(instance, result == SWAGE_FAULT ? FaultKind::kFault : FaultKind::kError, call, step);
  } else if (late != FaultKind::kNone) {
    quarantine(instance, late, call, step);
  } else {
    return result != SWAGE_DISCARD;
  }
  return false;
}

}  // namespace swage::host
