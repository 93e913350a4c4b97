// SPDX-License-Identifier: Apache-2.0
#include "session/rt_thread.hpp"

#include <gtest/gtest.h>

#include <utility>

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

// deadlines at 10, 20, 30...
TEST(Timeline, EveryPeriodIsSteppedOrLost) {
  Timeline line(Lateness::kCatchUp, 10, 0);
  const auto wake = [&](int64_t now) {
    const Timeline::Due due = line.wake(now);
    for (int64_t i = 0; i < due.steps; ++i) line.stepped();
    return std::pair(due.steps, due.lost);
  };
  EXPECT_EQ(wake(10), std::pair(int64_t{1}, uint64_t{0}));  // in time
  EXPECT_EQ(wake(29), std::pair(int64_t{1}, uint64_t{0}));  // late, but not by a whole period
  EXPECT_EQ(wake(65), std::pair(int64_t{4}, uint64_t{0}));  // three are made up for
  EXPECT_EQ(line.deadline(), 70);
  EXPECT_EQ(wake(275), std::pair(int64_t{5}, uint64_t{16}));  // four are, the rest is let go
  EXPECT_EQ(line.deadline(), 280);
}

TEST(Timeline, WithAForceDeviceNothingIsMadeUpFor) {
  Timeline line(Lateness::kDrop, 10, 0);
  const Timeline::Due due = line.wake(45);
  EXPECT_EQ(due.steps, 1);
  EXPECT_EQ(due.lost, 3u);
  EXPECT_EQ(line.deadline(), 40);
}

// held up for 20 periods once: as many are lost, and told
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
  int ticks = 0;
  RtThread thread(Lateness::kCatchUp, kPeriod, [&](const RtThread::Tick&) {
    if (++ticks == 10) hold_up(20'000'000);
    return ticks < 40;
  });
  thread.start([](const RtGrant&) {});
  thread.join();
  // 19 missed at least; up to four were due in the same burst, up to four are made up for
  EXPECT_GE(thread.stats().dropped, 11u);
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
  thread.start([](const RtGrant&) {});
  thread.join();
  EXPECT_EQ(ticks, 10000);
  EXPECT_EQ(thread.stats().overrun, 0u);
  EXPECT_EQ(thread.stats().wake.total(), 0u);  // nobody has waited for a deadline
}

}  // namespace
}  // namespace swage::session
