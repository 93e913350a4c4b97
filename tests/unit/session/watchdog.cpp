// SPDX-License-Identifier: Apache-2.0
#include "session/watchdog.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <time.h>

#include <chrono>

namespace swage::session {
namespace {

using namespace std::chrono_literals;

constexpr Watchdog::Settings kQuick{2, 10, 100};

// CTest's limit ends what never comes
template <class F>
void until(F done) {
  while (!done()) std::this_thread::sleep_for(1ms);
}

TEST(Watchdog, IsSilentWhileTheStepBeats) {
  std::atomic<uint64_t> asked{0};
  std::atomic<int> hung{0};
  Watchdog dog([&] { return asked.fetch_add(1); }, [&] { ++hung; }, kQuick);
  dog.start();
  until([&] { return asked.load() > 100; });
  dog.stop();
  EXPECT_EQ(dog.stalls(), 0u);
  EXPECT_EQ(hung.load(), 0);
}

TEST(Watchdog, SeesAStallAndItsEnd) {
  std::atomic<uint64_t> beat{1};
  std::atomic<bool> beating{false};
  Watchdog dog([&] { return beating ? ++beat : beat.load(); }, [] {}, {2, 10, 1000000});
  dog.start();
  until([&] { return dog.stalled(); });
  beating = true;
  until([&] { return !dog.stalled(); });
  EXPECT_EQ(dog.stalls(), 1u);
}

// A study at the lowest priority on a busy machine was ended: its step had not come back for half a second.
TEST(Watchdog, WhoWaitsForAProcessorStallsAndDoesNotHang) {
  std::atomic<bool> starved{true};
  std::atomic<int> hung{0}, looks{0};
  Watchdog dog(
      [&] {
        ++looks;
        return uint64_t{7};
      },
      [&] { ++hung; }, kQuick, [&] { return starved.load(); });
  dog.start();
  until([&] { return looks > 100; });
  EXPECT_TRUE(dog.stalled());
  EXPECT_EQ(hung.load(), 0);
  starved = false;
  until([&] { return hung.load() > 0; });
}

TEST(Watchdog, AccusesOnceAfterALongSilence) {
  std::atomic<int> hung{0};
  std::atomic<int> looks{0};
  Watchdog dog(
      [&] {
        ++looks;
        return uint64_t{7};
      },
      [&] { ++hung; }, kQuick);
  dog.start();
  until([&] { return hung.load() > 0; });
  EXPECT_GE(looks.load(), 100 / 2);  // not before as many looks as the silence is long
  const int then = looks;
  until([&] { return looks > then + 100; });
  dog.stop();
  EXPECT_EQ(hung.load(), 1);
}

// Two plugins that never returned took both processors of a small machine at the priority of the step. The watchdog ran in what the
// kernel keeps for others, 50 ms of each second, and found them after 100 s.
TEST(Watchdog, IsNotKeptWaitingByTheStepThatItWatches) {
  std::atomic<int> hung{0}, looks{0};
  bool granted = true;
  double spun_s = 0;
  std::thread one_processor([&] {
    cpu_set_t first;
    CPU_ZERO(&first);
    CPU_SET(static_cast<std::size_t>(sched_getcpu()), &first);
    sched_setaffinity(0, sizeof first, &first);
    Watchdog dog(
        [&] {
          ++looks;
          return uint64_t{7};
        },
        [&] { ++hung; });
    dog.start();
    until([&] { return looks > 1; });
    sched_param step{};
    step.sched_priority = 70;
    granted = sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &step) == 0;
    while (granted && hung == 0 && spun_s < 3) {
      timespec spun{};
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spun);
      spun_s = static_cast<double>(spun.tv_sec) + 1e-9 * static_cast<double>(spun.tv_nsec);
    }
  });
  one_processor.join();
  if (!granted) GTEST_SKIP() << "needs real-time priority";
  EXPECT_EQ(hung.load(), 1);
  EXPECT_LT(spun_s, 1);  // s of the processor's time: half of one is the silence; 1.4 and more without a priority
}

TEST(Watchdog, AccusesNobodyBeforeTheFirstStep) {
  std::atomic<int> hung{0}, looks{0};
  Watchdog dog(
      [&] {
        ++looks;
        return uint64_t{0};
      },
      [&] { ++hung; }, kQuick);
  dog.start();
  until([&] { return looks.load() > 200; });  // four times as long as a silence may be
  dog.stop();
  EXPECT_EQ(hung.load(), 0);
  EXPECT_EQ(dog.stalls(), 0u);
}

TEST(Watchdog, AccusesAnewInTheNextSilence) {
  std::atomic<uint64_t> beat{1};
  std::atomic<int> hung{0};
  Watchdog dog([&] { return beat.load(); }, [&] { ++hung; }, kQuick);
  dog.start();
  until([&] { return hung.load() == 1; });
  ++beat;
  until([&] { return hung.load() == 2; });
  dog.stop();
}

}  // namespace
}  // namespace swage::session
