// SPDX-License-Identifier: Apache-2.0
//
// Work that may crash or hang, done in another process. [main]
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swage::host {

// The limits must not depend on the load of the machine. `limit_s` limits a child's processor time, and the time during
// which it uses none (it waits for something that never comes); ten times as long by the wall clock is the limit in any case.
// A child over the limit gets SIGALRM, and is killed if that does not end it.

/// How a child ended.
struct ChildResult {
  int exit_code = 0;
  int signal = 0;          // signal that killed it, 0: none
  bool timed_out = false;  // ended at the limit
  bool started = true;     // false: the program could not be run
  std::string out, err;    // at most 8 MiB each
  double seconds = 0;      // wall

  bool ok() const { return started && !timed_out && signal == 0 && exit_code == 0; }
};

/// Runs a program and waits. argv[0] is its path.
ChildResult run_program(const std::vector<std::string>& argv, double limit_s);

/// Forks, runs `work` in the child, whose returned text becomes `out`, and waits. The child ends without running exit
/// handlers.
ChildResult run_forked(const std::function<std::string()>& work, double limit_s);

/// "signal 11 (Segmentation fault)"
std::string signal_text(int signal);

}  // namespace swage::host
