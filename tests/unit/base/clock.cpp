// SPDX-License-Identifier: Apache-2.0
#include "base/clock.hpp"

#include <gtest/gtest.h>

namespace swage::base {
namespace {

// sleeping passes wall time but hardly any processor time; it never wakes early
TEST(Clock, SleepPassesWallTimeNotProcessorTime) {
  const int64_t wall = wall_ns(), cpu = cpu_ns();
  sleep_until_ns(wall + 20'000'000);
  EXPECT_GE(wall_ns() - wall, 20'000'000);
  EXPECT_LT(cpu_ns() - cpu, 10'000'000);
}

TEST(Clock, WorkPassesProcessorTime) {
  const int64_t cpu = cpu_ns();
  volatile double x = 1;
  while (cpu_ns() - cpu < 1'000'000) x = x * 1.0000001;
  EXPECT_GE(cpu_ns() - cpu, 1'000'000);
}

}  // namespace
}  // namespace swage::base
