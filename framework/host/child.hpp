// SPDX-License-Identifier: Apache-2.0
//
// Work that may crash or hang, done in another process. [main]
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swage::host {

/// How a child ended.
struct ChildResult {
  int exit_code = 0;
  int signal = 0;          // that killed it, 0: none
  bool timed_out = false;  // it was killed after the limit
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
