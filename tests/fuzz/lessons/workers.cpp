// SPDX-License-Identifier: Apache-2.0
#include "workers.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace swage::fuzz {
namespace {

constexpr uint64_t kPerChild = 2000;
constexpr long kSecondsOfProcessor = 5, kSecondsOfClock = 60;
[[maybe_unused]] constexpr rlim_t kMemory = rlim_t{1} << 30;
constexpr std::size_t kMostFailures = 20;

/// Shared with the children: how far they are and what they found.
struct Board {
  uint64_t next = 0, accepted = 0;
  bool wrong = false;
  char what[500] = {};
};

// other than SIGABRT, so that a hang is told from an assertion
void arm(long processor_s, long clock_s) {
  const itimerval processor{{0, 0}, {processor_s, 0}}, wall{{0, 0}, {clock_s, 0}};
  setitimer(ITIMER_PROF, &processor, nullptr);
  setitimer(ITIMER_REAL, &wall, nullptr);
}

[[noreturn]] void work(Board& board, uint64_t end, const std::function<Tried(uint64_t)>& trial) {
#ifndef SWAGE_SANITIZED
  const rlimit memory{kMemory, kMemory};
  setrlimit(RLIMIT_DATA, &memory);
#endif
  for (; board.next < end; ++board.next) {
    arm(kSecondsOfProcessor, kSecondsOfClock);
    Tried tried;
    try {
      tried = trial(board.next);
    } catch (const std::exception& e) {
      tried.wrong = std::string("thrown: ") + e.what();
    }
    board.accepted += tried.accepted ? 1 : 0;
    if (tried.wrong.empty()) continue;
    std::snprintf(board.what, sizeof board.what, "%s", tried.wrong.c_str());
    board.wrong = true;
    _exit(1);
  }
  _exit(0);
}

std::string why(const Board& board, int status) {
  if (board.wrong) return board.what;
  if (!WIFSIGNALED(status)) return "left with " + std::to_string(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  if (signal == SIGPROF || signal == SIGALRM) return "hung";
  return strsignal(signal);
}

}  // namespace

Tally run_trials(uint64_t n, const std::function<Tried(uint64_t)>& trial) {
  void* const shared = mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto& board = *new (shared) Board;
  Tally tally;
  while (board.next < n && tally.failures.size() < kMostFailures) {
    const uint64_t end = std::min(n, board.next + kPerChild);
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) work(board, end, trial);
    int status = 0;
    waitpid(child, &status, 0);
    if (board.next >= end) continue;
    tally.failures.push_back({board.next, why(board, status)});
    board.wrong = false;
    ++board.next;
  }
  tally.trials = board.next;
  tally.accepted = board.accepted;
  munmap(shared, sizeof(Board));
  return tally;
}

}  // namespace swage::fuzz
