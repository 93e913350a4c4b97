// SPDX-License-Identifier: Apache-2.0
#include "session/bounded_call.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>
#include <memory>
#include <thread>
#include <utility>

#include "session/sentinel.hpp"

namespace swage::session {

namespace {
std::atomic<int> behind{0};
}

bool bounded_call(std::function<void()> work, double limit_s) {
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> end = done->get_future();
  std::thread thread([work = std::move(work), done] {
    Sentinel::protect_thread();
    work();
    done->set_value();
  });
  if (end.wait_for(std::chrono::duration<double>(limit_s)) == std::future_status::ready) {
    thread.join();
    return true;
  }
  thread.detach();
  leave_behind();
  return false;
}

DriverLimits& driver_limits() noexcept {
  static DriverLimits limits;
  return limits;
}

void leave_behind() noexcept { behind.fetch_add(1, std::memory_order_relaxed); }
int left_behind() noexcept { return behind.load(std::memory_order_relaxed); }

int end_program(int code) {
  if (left_behind() == 0) return code;
  std::fflush(nullptr);
  _exit(code);
}

}  // namespace swage::session
