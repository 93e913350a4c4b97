// SPDX-License-Identifier: Apache-2.0
//
// Work that may crash or hang, done in another process. [main]
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swage::host {

// How long is too long must not depend on what else the machine does. `limit_s` is a child's processor time, and the time for
// which it may use none at all (it waits for something that never comes); ten times as long by the clock is the end in any case.
// Whoever is over the limit gets SIGALRM, and is killed when that does not end it.

/// How a child ended.
struct ChildResult {
  int exit_code = 0;
  int signal = 0;          // that killed it, 0: none
  bool timed_out = false;  // it was ended at the limit
  bool started = true;     // false: the program could not be run
  std::string out, err;    // at most 8 MiB each
  double seconds = 0;      // wall

  bool ok() const { return started && !timed_out && signal == 0 && exit_code == 0; }
};

/// Runs a program and waits. argv[0] is its path.
ChildResult run_program(const std::vector<std::string>& argv, double limit_s);

/// Forks, runs `work` in the child with its text as `out`, and waits. The child ends without running exit
/// handlers.
ChildResult run_forked(const std::function<std::string()>& work, double limit_s);

/// "signal 11 (Segmentation fault)"
std::string signal_text(int signal);

}  // namespace swage::host
