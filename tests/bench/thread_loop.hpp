// SPDX-License-Identifier: Apache-2.0
//
// Lesson 117 with a thread of 99 segments, whose expert takes the needle and turns it in: the scenes of goal G8.
#pragma once

#include <memory>
#include <string>

#include "run_lesson.hpp"

namespace swage::bench {

/// `level` of the needle's ladder; `alone`: without the tray, and without contact of the thread with the tissue: nothing touches the thread
/// but needle and jaws.
std::unique_ptr<stage::LessonRun> thread_loop(const std::string& level, bool alone);

/// The needle is in the jaws and not yet in the tissue.
bool carried(const stage::LessonRun& run);

}  // namespace swage::bench
