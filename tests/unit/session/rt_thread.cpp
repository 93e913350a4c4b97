// SPDX-License-Identifier: Apache-2.0
#include "session/rt_thread.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/clock.hpp"

namespace swage::session {
namespace {

constexpr double kPeriod = 1e-3;

void hold_up(int64_t ns) { base::sleep_until_ns(base::wall_ns() + ns); }

TEST(RtThread, KeepsItsRateOverTime) {
  int ticks = 0;
  RtThread thread(Lateness::kCatchUp, kPeriod, [&](const RtThread::Tick&) { return ++ticks < 300; });
  const int64_t start = base::wall_ns();
  thread.start([](const RtGrant&) {});
  thread.join();
  const int64_t took = base::wall_ns() - start;
  EXPECT_GE(took, 300'000'000);  // no tick comes early, whatever was made up for or dropped
  EXPECT_EQ(thread.beats(), 300u);
  EXPECT_EQ(thread.stats().wall.total(), 300u);
}

TEST(RtThread, SaysWhatTheSystemGranted) {
  RtGrant grant;
  RtThread thread(Lateness::kDrop, kPeriod, [](const RtThread::Tick&) { return false; });
  thread.start([&](const RtGrant& g) { grant = g; });
  thread.join();
  EXPECT_FALSE(grant.sentence.empty());
  if (!grant.fifo || !grant.locked) {
    EXPECT_NE(grant.sentence.find("limits"), std::string::npos) << grant.sentence;
  }
}

// held up for 20 periods once: Drop executes none of them, CatchUp four, and both tell how many were lost
TEST(RtThread, DropsWhatItMissed) {
  int ticks = 0;
  uint64_t lost = 0;
  RtThread thread(Lateness::kDrop, kPeriod, [&](const RtThread::Tick& t) {
    lost += t.lost;
    if (++ticks == 10) hold_up(20'000'000);
    return ticks < 30;
  });
  thread.start([](const RtGrant&) {});
  thread.join();
  EXPECT_GE(thread.stats().dropped, 18u);
  EXPECT_EQ(lost, thread.stats().dropped);
  EXPECT_GE(thread.stats().overrun, 1u);
  EXPECT_EQ(thread.stats().own_overrun, 0u);  // it slept: not its own doing
}

TEST(RtThread, MakesUpForAtMostFour) {
  std::vector<int64_t> when;
  RtThread thread(Lateness::kCatchUp, kPeriod, [&](const RtThread::Tick&) {
    when.push_back(base::wall_ns());
    if (when.size() == 10) hold_up(20'000'000);
    return when.size() < 40;
  });
  thread.start([](const RtGrant&) {});
  thread.join();
  EXPECT_GE(thread.stats().dropped, 12u);
  // right after the stall: a burst that is shorter than the same ticks would be at their rate
  EXPECT_LT(when[13] - when[10], 3'000'000);
}

TEST(RtThread, BlamesTheStepForItsOwnProcessorTime) {
  int ticks = 0;
  RtThread thread(Lateness::kDrop, kPeriod, [&](const RtThread::Tick&) {
    const int64_t end = base::cpu_ns() + 2'000'000;
    while (base::cpu_ns() < end) {
    }
    return ++ticks < 5;
  });
  thread.start([](const RtGrant&) {});
  thread.join();
  EXPECT_GE(thread.stats().own_overrun, 4u);
  EXPECT_GE(thread.stats().cpu.quantile(0.5), 2'000'000u);
}

TEST(RtThread, LockstepKnowsNoClock) {
  int ticks = 0;
  RtThread thread(Lateness::kLockstep, kPeriod, [&](const RtThread::Tick&) { return ++ticks < 10000; });
  const int64_t start = base::wall_ns();
  thread.start([](const RtGrant&) {});
  thread.join();
  EXPECT_EQ(ticks, 10000);
  EXPECT_LT(base::wall_ns() - start, 5'000'000'000);  // at its rate it would take ten seconds
  EXPECT_EQ(thread.stats().overrun, 0u);
}

}  // namespace
}  // namespace swage::session
