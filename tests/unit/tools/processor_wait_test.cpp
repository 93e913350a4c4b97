// SPDX-License-Identifier: Apache-2.0
//
// What the validator leaves out when it tells a device that is slow from a machine that is busy.
#include "tools/processor_wait.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <time.h>

#include <atomic>
#include <thread>

#include "base/clock.hpp"

namespace swage::tools {
namespace {

bool stay_on_one_processor() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<size_t>(sched_getcpu()), &one);
  return sched_setaffinity(0, sizeof one, &one) == 0;
}

// Two threads on one processor: what the one with less right to it does not run, it waits.
TEST(ProcessorWait, IsWhatABusyMachineTakes) {
  std::atomic<bool> ready{false}, stop{false};
  int64_t wall = 0, ran = 0, waited = 0;
  std::thread patient([&] {
    ASSERT_TRUE(stay_on_one_processor());
    std::thread busy([&] {  // on the same processor
      ready = true;
      while (!stop) {
      }
    });
    while (!ready) sched_yield();
    const sched_param none{};
    ASSERT_EQ(sched_setscheduler(0, SCHED_IDLE, &none), 0);
    const int64_t wall0 = base::wall_ns(), ran0 = base::cpu_ns(), waited0 = processor_wait_ns();
    while (base::wall_ns() - wall0 < 300'000'000) {
    }
    wall = base::wall_ns() - wall0, ran = base::cpu_ns() - ran0, waited = processor_wait_ns() - waited0;
    stop = true;
    busy.join();
  });
  patient.join();
  EXPECT_GT(waited, wall / 4);
  EXPECT_NEAR(static_cast<double>(waited + ran), static_cast<double>(wall), 0.2 * static_cast<double>(wall));
}

// A device that blocks is slow on any machine.
TEST(ProcessorWait, IsNotWhatAThreadSleeps) {
  const int64_t wall0 = base::wall_ns() - processor_wait_ns();
  const timespec pause{0, 150'000'000};
  nanosleep(&pause, nullptr);
  EXPECT_GT(base::wall_ns() - processor_wait_ns() - wall0, 140'000'000);
}

}  // namespace
}  // namespace swage::tools
