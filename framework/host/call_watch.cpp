// SPDX-License-Identifier: Apache-2.0
#include "host/call_watch.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "base/clock.hpp"

namespace swage::host {

namespace {

constexpr int64_t kLook = 20'000'000;  // ns between two checks

std::atomic<const LastCall*> running{nullptr};
// counts beginnings and ends of calls: odd during a call
std::atomic<uint64_t> turn{0};
std::atomic<double> limit_of_call{CallWatch::kLimit};
std::atomic<bool> is_off{false};
std::atomic<CallWatch::Handler> handler{nullptr};
std::atomic<pid_t> watched_pid{0};  // a forked child has no watch until its first call

// names the call, lets the handler close the record, and ends the process; returns if the call has just returned
void end(const LastCall& call, const char* cause, const char* what) {
  const Instance* instance = call.instance.load(std::memory_order_acquire);
  if (instance == nullptr) return;
  if (const CallWatch::Handler tell = handler.load()) tell(call, cause);
  std::fprintf(stderr,
               "swage: %s() of \"%.200s\" (%.200s %.50s) %s. Start in safe mode to leave out every plugin that did not come "
               "with Swage.\n",
               text(call.call.load(std::memory_order_relaxed)), instance->name.c_str(), instance->plugin_id.c_str(),
               instance->plugin_version.c_str(), what);
  std::fflush(stderr);
  _exit(CallWatch::kExit);
}

void hung(const LastCall& call) {
  char what[100];
  std::snprintf(what, sizeof what, "has not come back for %g s, and the program cannot go on", limit_of_call.load());
  end(call, "hang", what);
}

// on the thread that called exit()
void on_exit() {
  if (!is_off.load()) end(last_call, "exit", "ended the program");
}

void watch() {
  for (;;) {
    uint64_t now = turn.load(std::memory_order_acquire);
    if (now % 2 == 0) {
      turn.wait(now);
      continue;
    }
    // the same call at so many checks in succession
    const auto looks = static_cast<int64_t>(limit_of_call.load() * 1e9) / kLook;
    for (int64_t i = 0; i < looks && turn.load(std::memory_order_acquire) == now; ++i)
      base::sleep_until_ns(base::wall_ns() + kLook);
    const LastCall* call = running.load(std::memory_order_acquire);
    if (turn.load(std::memory_order_acquire) == now && call != nullptr) hung(*call);
  }
}

}  // namespace

void CallWatch::on_end(Handler tell) noexcept { handler.store(tell); }
void CallWatch::set_limit(double seconds) noexcept { limit_of_call.store(seconds); }
void CallWatch::off() noexcept { is_off.store(true); }

void CallWatch::guard_exit() noexcept { std::atexit(on_exit); }

bool CallWatch::enter(const LastCall& call) noexcept {
  if (is_off.load(std::memory_order_relaxed)) return false;
  const LastCall* nobody = nullptr;
  if (!running.compare_exchange_strong(nobody, &call, std::memory_order_acq_rel)) return false;
  try {
    static const bool registered = (guard_exit(), true);
    static_cast<void>(registered);
    if (watched_pid.exchange(getpid()) != getpid()) std::thread(watch).detach();
  } catch (...) {
    // no thread could be started for the watch: the calls continue unwatched
  }
  turn.fetch_add(1, std::memory_order_release);
  turn.notify_one();
  return true;
}

void CallWatch::leave() noexcept {
  turn.fetch_add(1, std::memory_order_release);
  running.store(nullptr, std::memory_order_release);
}

}  // namespace swage::host
