// SPDX-License-Identifier: Apache-2.0
#include "session/processor_wait.hpp"

#include <cstdio>
#include <cstring>
#include <ctime>

#include "base/clock.hpp"

namespace swage::session {
namespace {

// "R" of proc(5): running, or runnable.
bool runnable(pid_t tid) {
  char path[48], line[256] = {};
  std::snprintf(path, sizeof path, "/proc/self/task/%d/stat", static_cast<int>(tid));
  std::FILE* file = std::fopen(path, "re");
  if (!file) return false;
  const size_t n = std::fread(line, 1, sizeof line - 1, file);
  std::fclose(file);
  // the name is in brackets and may contain any character
  const char* name_end = n > 0 ? std::strrchr(line, ')') : nullptr;
  return name_end && name_end[1] == ' ' && name_end[2] == 'R';
}

// The clock id of a thread's processor time is computed from its tid, see clock_getcpuclockid(3) and the kernel's posix-timers.h.
int64_t cpu_of(pid_t tid) {
  timespec t{};
  const auto clock = static_cast<clockid_t>((~static_cast<unsigned>(tid) << 3) | 6u);
  return clock_gettime(clock, &t) == 0 ? t.tv_sec * INT64_C(1'000'000'000) + t.tv_nsec : 0;
}

}  // namespace

bool ProcessorWait::starved(pid_t tid) {
  const int64_t wall = base::wall_ns(), cpu = cpu_of(tid);
  const bool first = wall_ == 0;
  const bool had_little = 2 * (cpu - cpu_) < wall - wall_;
  wall_ = wall, cpu_ = cpu;
  return !first && had_little && runnable(tid);
}

}  // namespace swage::session
