// SPDX-License-Identifier: Apache-2.0
#include "session/watchdog.hpp"

#include <sched.h>
#include <sys/prctl.h>

#include <utility>

#include "base/clock.hpp"

namespace swage::session {

namespace {
// above the step (70), whose plugins it watches: two that never return take both processors of a small machine
constexpr int kWatchPriority = 75;
}  // namespace

Watchdog::Watchdog(std::function<uint64_t()> beats, std::function<void()> hung)
    : Watchdog(std::move(beats), std::move(hung), Settings()) {}

Watchdog::Watchdog(std::function<uint64_t()> beats, std::function<void()> hung, const Settings& settings,
                   std::function<bool()> starved)
    : beats_(std::move(beats)), hung_(std::move(hung)), starved_(std::move(starved)), settings_(settings) {}

Watchdog::~Watchdog() { stop(); }

void Watchdog::start() {
  thread_ = std::thread([this] { run(); });
}

void Watchdog::stop() {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

void Watchdog::run() {
  prctl(PR_SET_NAME, "swage-watchdog");
  prctl(PR_SET_TIMERSLACK, 1UL);
  sched_param param{};
  param.sched_priority = kWatchPriority;
  sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &param);  // where it is refused, the step has none either
  uint64_t seen = beats_();
  int64_t silent_ms = 0, hung_ms = 0;
  bool reported = false;
  while (!stop_.load(std::memory_order_relaxed)) {
    base::sleep_until_ns(base::wall_ns() + settings_.look_ms * 1'000'000);

    // each check counts for no more than its own length, however late it was
    const uint64_t now = beats_();
    // a thread that has not begun yet waits for a processor, and does not hang
    const bool silent = now == seen && now > 0;
    silent_ms = silent ? silent_ms + settings_.look_ms : 0;
    const bool starved = silent && starved_ && starved_();
    hung_ms = !silent ? 0 : starved ? hung_ms : hung_ms + settings_.look_ms;
    reported &= now == seen;
    seen = now;

    const bool stalled = silent_ms >= settings_.stalled_ms;
    if (stalled && !this->stalled()) stalls_.fetch_add(1, std::memory_order_relaxed);
    stalled_.store(stalled, std::memory_order_relaxed);
    if (hung_ms >= settings_.hung_ms && !reported) {
      reported = true;
      hung_();
    }
  }
}

}  // namespace swage::session
