// SPDX-License-Identifier: Apache-2.0
//
// Phases of a lesson with a needle, as its couplings tell them.
#pragma once

#include "run_lesson.hpp"

namespace swage::bench {

/// The needle is in the jaws.
inline bool in_jaws(const stage::LessonRun& run) { return run.signal("grasp", "grasp.held") == 1; }
/// The point has pierced the tissue.
inline bool inserted(const stage::LessonRun& run) { return run.signal("pierce", "pierce.state") >= 2; }

}  // namespace swage::bench
