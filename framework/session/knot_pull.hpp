// SPDX-License-Identifier: Apache-2.0
//
// Pull test of a copied knot: lesson 139 with the settings of the copy, stepped without a clock.
// Threads: opened on [main]; the rehearsal is stepped and read by one thread at a time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "session/knot_copy.hpp"
#include "session/rehearsal.hpp"

namespace swage::session {

struct PullOptions {
  std::string lesson_path;               // of kPullLesson
  std::vector<std::string> plugin_dirs;  // as in Options
  double load = 0.1;                     // N, that the knot is to bear
  double friction = 0;                   // of the thread on itself; 0: as in the attempt
};

/// Outcome of a pull test.
struct Pulled {
  bool over = false, holds = false;
  std::string reason;         // event id, "failed.slipped"; "" where it holds or is not over
  double bears = 0;           // N, greatest tension of the loop, mean of its two strands beside the pin
  double slip = 0;            // m, thread that has gone through the knot into its loop
  std::string health;         // what the solver could not do, "" in a sound scene
};

/// Lays the knot over the pins. nullptr, and why in `problems`, where the scene cannot be built.
std::unique_ptr<Rehearsal> open_pull(const KnotCopy& copy, const PullOptions& options, base::Problems& problems);

/// What has come of it so far.
Pulled pulled(const Rehearsal& pull);

}  // namespace swage::session
