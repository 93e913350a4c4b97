// SPDX-License-Identifier: Apache-2.0
//
// A knot that two hands have tied, as it lies at the end of an attempt: copied and pulled, as `swage pull` does it.
#pragma once

#include <string>

#include "run_lesson.hpp"
#include "session/knot_pull.hpp"
#include "test_places.hpp"

namespace swage::stage {

struct PulledKnot : session::Pulled {
  session::KnotCopy copy;
  std::string problems;  // why it could not be pulled, or what was wrong
};

/// Pulled up to `load` [N] with that friction of the thread on itself; 0: that of the lesson.
inline PulledKnot pull_apart(const LessonRun& run, double friction, double load) {
  PulledKnot out;
  base::Problems problems;
  const session::PullOptions options{SWAGE_SOURCE_DIR "/lessons/series/" + std::string(session::kPullLesson), {SWAGE_BINARY_DIR "/plugins"}, load, friction};
  std::unique_ptr<session::Rehearsal> pull;
  if (session::copy_knot(run.rig(), run.world(), out.copy, problems)) pull = session::open_pull(out.copy, options, problems);
  for (const base::Problem& p : problems) out.problems += p.where + ": " + p.message + "\n";
  if (!pull) return out;
  while (pull->step()) {}
  static_cast<session::Pulled&>(out) = session::pulled(*pull);
  return out;
}

}  // namespace swage::stage
