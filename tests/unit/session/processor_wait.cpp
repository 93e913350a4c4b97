// SPDX-License-Identifier: Apache-2.0
#include "session/processor_wait.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <string>
#include <thread>

namespace swage::session {
namespace {

using namespace std::chrono_literals;

// A thread that spins on the first processor, until it is told to end.
class Spinner {
 public:
  explicit Spinner(int policy)
      : thread_([this, policy] {
          cpu_set_t first;
          CPU_ZERO(&first);
          CPU_SET(0, &first);
          pthread_setaffinity_np(pthread_self(), sizeof first, &first);
          const sched_param none{};
          sched_setscheduler(0, policy, &none);
          tid_ = static_cast<pid_t>(syscall(SYS_gettid));
          while (!end_) {
          }
        }) {
    while (tid_ == 0) std::this_thread::sleep_for(1ms);
  }
  ~Spinner() {
    end_ = true;
    thread_.join();
  }
  pid_t tid() const { return tid_; }

 private:
  std::atomic<bool> end_{false};
  std::atomic<pid_t> tid_{0};
  std::thread thread_;
};

// CTest's limit ends what never comes
bool comes(ProcessorWait& wait, pid_t tid, bool starved) {
  while (wait.starved(tid) != starved) std::this_thread::sleep_for(5ms);
  return true;
}

// The kernel's word for it, "State: S" of proc(5): on a busy machine a thread may be runnable for long before it comes to its wait.
bool sleeps(pid_t tid) {
  std::ifstream status("/proc/self/task/" + std::to_string(tid) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("State:")) return line.find('S', 6) != std::string::npos;
  return false;
}

TEST(ProcessorWait, WhoeverRunsOnlyWhenNobodyElseWantsToIsStarved) {
  const Spinner last(SCHED_IDLE);
  ProcessorWait wait;
  EXPECT_FALSE(wait.starved(last.tid())) << "nothing is known at the first look";
  const Spinner other(SCHED_OTHER);
  EXPECT_TRUE(comes(wait, last.tid(), true));
}

TEST(ProcessorWait, WhoeverLoopsHasAProcessor) {
  const Spinner loops(SCHED_OTHER);
  ProcessorWait wait;
  wait.starved(loops.tid());
  std::this_thread::sleep_for(5ms);
  EXPECT_TRUE(comes(wait, loops.tid(), false));
}

TEST(ProcessorWait, WhoeverWaitsForSomethingElseIsNotStarved) {
  std::atomic<pid_t> tid{0};
  std::atomic<bool> end{false};
  std::thread sleeper([&] {
    tid = static_cast<pid_t>(syscall(SYS_gettid));
    end.wait(false);
  });
  while (tid == 0 || !sleeps(tid)) std::this_thread::sleep_for(1ms);
  ProcessorWait wait;
  for (int look = 0; look < 5; ++look) {
    EXPECT_FALSE(wait.starved(tid));
    std::this_thread::sleep_for(5ms);
  }
  end = true;
  end.notify_all();
  sleeper.join();
  EXPECT_FALSE(wait.starved(-1)) << "there is no such thread";
}

}  // namespace
}  // namespace swage::session
