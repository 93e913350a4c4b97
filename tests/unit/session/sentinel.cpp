// SPDX-License-Identifier: Apache-2.0
#include "session/sentinel.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "host/guard.hpp"
#include "session/sentences.hpp"

namespace swage::session {
namespace {

namespace fs = std::filesystem;

class SentinelTest : public ::testing::Test {
 protected:
  SentinelTest() {
    char name[] = "/tmp/swage-sentinel-XXXXXX";
    folder = mkdtemp(name);
  }
  ~SentinelTest() override { fs::remove_all(folder); }

  // runs `work` in a child and returns how it ended
  template <class F>
  int in_child(F work) {
    const pid_t child = fork();
    if (child == 0) {
      Sentinel sentinel(folder);
      work();
      sentinel.~Sentinel();
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  std::string folder;
};

// a call of a plugin as the guard makes it
template <class F>
void plugin_call(F f) {
  host::Instance instance;
  instance.name = "clip";
  instance.plugin_id = "org.example.clip";
  host::guarded(instance, host::Call::kForces, 812, f);
}

TEST_F(SentinelTest, LeavesNothingAfterAGoodEnd) {
  EXPECT_EQ(in_child([] { plugin_call([] {}); }), 0);
  EXPECT_EQ(files(), 0u);
  Sentinel::Report report;
  EXPECT_FALSE(Sentinel::take(folder, report));
}

TEST_F(SentinelTest, NamesThePluginThatCrashed) {
  const int status = in_child([] { plugin_call([] { raise(SIGSEGV); }); });
  ASSERT_TRUE(WIFSIGNALED(status));  // the signal went on
  EXPECT_EQ(WTERMSIG(status), SIGSEGV);
  Sentinel::Report report;
  ASSERT_TRUE(Sentinel::take(folder, report));
  EXPECT_EQ(report.instance, "clip");
  EXPECT_EQ(report.plugin, "org.example.clip");
  EXPECT_EQ(report.call, "forces");
  EXPECT_EQ(report.step, 812u);
  EXPECT_EQ(report.cause, "signal 11");
  const base::Problem problem = Sentinel::problem(report);
  EXPECT_EQ(problem.where, "clip");
  EXPECT_EQ(
      problem.message,
      say::kEndedInPlugin("signal 11", "forces", "clip", "org.example.clip", 812));
  EXPECT_FALSE(Sentinel::take(folder, report));  // told once
}

TEST_F(SentinelTest, DoesNotAccuseAPluginOfOurOwnCrash) {
  in_child([] { raise(SIGABRT); });
  Sentinel::Report report;
  ASSERT_TRUE(Sentinel::take(folder, report));
  EXPECT_EQ(report.plugin, "");
  EXPECT_NE(Sentinel::problem(report).message.find(say::kEndedOutside.words(1)), std::string::npos);
}

// each call keeps a page of the stack that the next one reads: no compiler makes a loop of it
__attribute__((noinline)) int deeper(const volatile char* above) {
  volatile char page[4096];
  page[0] = above[0];
  return page[0] == 1 ? 0 : page[0] + deeper(page);
}

TEST_F(SentinelTest, CatchesAStackOverflow) {
  const int status = in_child([] {
    plugin_call([] {
      const volatile char top[1] = {0};
      static_cast<void>(deeper(top));
    });
  });
  ASSERT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) != 0);
  Sentinel::Report report;
  ASSERT_TRUE(Sentinel::take(folder, report));
  EXPECT_EQ(report.instance, "clip");
}

TEST_F(SentinelTest, WritesTheCallOfAnotherThread) {
  in_child([] {
    plugin_call([] { Sentinel::write(host::last_call, "hang"); });
    // an accusation stays although the program ends in order
  });
  Sentinel::Report report;
  ASSERT_TRUE(Sentinel::take(folder, report));
  EXPECT_EQ(report.cause, "hang");
  EXPECT_EQ(report.instance, "clip");
}

TEST_F(SentinelTest, LeavesTheReportsOfLivingProgramsAlone) {
  Sentinel sentinel(folder);
  EXPECT_EQ(files(), 1u);
  Sentinel::Report report;
  EXPECT_FALSE(Sentinel::take(folder, report));
  EXPECT_EQ(files(), 1u);
}

TEST_F(SentinelTest, AFolderThatCannotBeWrittenIsNoError) {
  Sentinel sentinel("/proc/no/such/folder");
  Sentinel::Report report;
  EXPECT_FALSE(Sentinel::take("/proc/no/such/folder", report));
}

}  // namespace
}  // namespace swage::session
