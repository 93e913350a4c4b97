// SPDX-License-Identifier: Apache-2.0
#include "host/child.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/clock.hpp"

using namespace swage::host;

namespace {

// for children that must not be ended by their limit, whatever the machine does
constexpr double kPlenty = 300;

}  // namespace

TEST(Child, SaysWhatItSaidAndHowItEnded) {
  const ChildResult good = run_forked([] { return std::string(100'000, 'x'); }, kPlenty);
  EXPECT_TRUE(good.ok());
  EXPECT_EQ(good.out, std::string(100'000, 'x'));
  const ChildResult bad = run_forked([]() -> std::string { _exit(7); }, kPlenty);
  EXPECT_EQ(bad.exit_code, 7);
  EXPECT_FALSE(bad.timed_out);
  const ChildResult dead = run_forked(
      []() -> std::string {
        raise(SIGKILL);
        return "";
      },
      kPlenty);
  EXPECT_EQ(dead.signal, SIGKILL);
  EXPECT_FALSE(dead.timed_out);
}

TEST(Child, OneThatEndsInOrderSaysNothingOfOursAgain) {
  testing::internal::CaptureStdout();
  std::printf("once");
  const ChildResult child = run_forked([]() -> std::string { std::exit(7); }, kPlenty);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "once");
  EXPECT_EQ(child.exit_code, 7);
}

TEST(Child, OneThatWorksForTooLongIsEnded) {
  const ChildResult child = run_forked(
      []() -> std::string {
        // a loop without effects may be taken to end
        for (volatile int turns = 0;;) turns = turns + 1;
      },
      0.2);
  EXPECT_TRUE(child.timed_out);
  EXPECT_EQ(child.signal, SIGALRM);
}

TEST(Child, OneThatWaitsForeverIsEnded) {
  const ChildResult child = run_forked(
      []() -> std::string {
        for (;;) pause();
      },
      0.2);
  EXPECT_TRUE(child.timed_out);
}

TEST(Child, OneThatWillNotGoIsKilled) {
  const ChildResult child = run_forked(
      []() -> std::string {
        signal(SIGALRM, SIG_IGN);
        for (;;) pause();
      },
      0.2);
  EXPECT_TRUE(child.timed_out);
  EXPECT_EQ(child.signal, SIGKILL);
}

TEST(Child, OneThatIsToldMaySayWhereItWas) {
  const ChildResult child = run_forked(
      []() -> std::string {
        signal(SIGALRM, [](int) {
          [[maybe_unused]] const auto n = write(STDERR_FILENO, "here", 4);
          _exit(99);
        });
        for (;;) pause();
      },
      0.2);
  EXPECT_TRUE(child.timed_out);
  EXPECT_EQ(child.exit_code, 99);
  EXPECT_EQ(child.err, "here");
}

// closing both streams is not the end
TEST(Child, OneThatFallsSilentIsWaitedFor) {
  const ChildResult child = run_forked(
      []() -> std::string {
        close(STDERR_FILENO);
        const int64_t end = swage::base::cpu_ns() + 50'000'000;
        while (swage::base::cpu_ns() < end) {
        }
        _exit(5);
      },
      kPlenty);
  EXPECT_EQ(child.exit_code, 5);
}
