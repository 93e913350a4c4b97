// SPDX-License-Identifier: Apache-2.0
#include "trial.hpp"

#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "base/clock.hpp"

namespace swage::record::test {
namespace {

constexpr rlim_t kProcessor_s = 5;
constexpr double kWall_s = 60, kMost_MB = 1000;

// everything until the other end is closed; false after the limit
bool read_all(int from, std::string& out) {
  const int64_t end = base::wall_ns() + static_cast<int64_t>(kWall_s * 1e9);
  char buffer[4096];
  for (;;) {
    pollfd wait{from, POLLIN, 0};
    const int64_t left_ms = (end - base::wall_ns()) / 1'000'000;
    if (left_ms <= 0 || poll(&wait, 1, static_cast<int>(left_ms)) == 0) return false;
    const ssize_t n = read(from, buffer, sizeof buffer);
    if (n <= 0) return true;
    out.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

Ended run_trial(const std::function<std::string()>& trial) {
  Ended out;
  int ends[2];
  if (pipe(ends) != 0) return out;
  const int64_t start = base::wall_ns();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const rlimit limit{kProcessor_s, kProcessor_s};
    setrlimit(RLIMIT_CPU, &limit);
    const std::string said = trial();
    const bool whole = write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size());
    _exit(whole ? 0 : 3);
  }
  close(ends[1]);
  const bool in_time = read_all(ends[0], out.said);
  close(ends[0]);
  if (!in_time) kill(child, SIGKILL);
  int status = 0;
  rusage use{};
  wait4(child, &status, 0, &use);
  out.seconds = 1e-9 * static_cast<double>(base::wall_ns() - start);
  out.megabytes = 1e-3 * static_cast<double>(use.ru_maxrss);
  if (!in_time)
    out.wrong = "hung";
  else if (WIFSIGNALED(status))
    out.wrong = strsignal(WTERMSIG(status));
  else if (WEXITSTATUS(status) != 0)
    out.wrong = "exit status " + std::to_string(WEXITSTATUS(status));
  else if (out.megabytes > kMost_MB)
    out.wrong = "took " + std::to_string(out.megabytes) + " MB";
  return out;
}

int trials() {
  const char* text = std::getenv("SWAGE_FUZZ_TRIALS");
  return text != nullptr ? std::atoi(text) : 24;
}

}  // namespace swage::record::test
