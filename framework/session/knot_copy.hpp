// SPDX-License-Identifier: Apache-2.0
//
// A knot as it is at a moment of an attempt, cut free of what it is tied about and laid over two pins: settings for lesson 139, which draws the pins
// apart. Whether a knot holds is not in any state of the attempt; it is found out by pulling a copy.
// Threads: [main]; the attempt must not be stepped meanwhile.
#pragma once

#include <string>
#include <vector>

#include "base/problem.hpp"
#include "host/rig.hpp"
#include "scene/world.hpp"

namespace swage::session {

/// The file name of the lesson that pulls a knot, among the lessons of the series.
inline constexpr const char* kPullLesson = "139_pull_test.json";

struct KnotCopy {
  std::string thread;                 // name of the object
  std::string word;                   // its throws with their signs, the first one first: "2 -1 1"
  double loop = 0;                    // m, thread between the two strands of the first throw
  double friction = 0;                // of the thread on itself
  std::vector<std::string> settings;  // of lesson 139 (Options::settings)
};

/// Where the pins of lesson 139 are in the frame of its thread, on x, and how thick they are: as in the lesson.
inline constexpr double kPinRadius = 0.15e-3, kPinPlace = 0.25e-3;  // m; from the middle between the pins, m

/// Copies the knot with the most throws of all threads of the scene. False, and a sentence in `problems`, where none has a knot that can be read, or
/// the pins have no room in its loop.
bool copy_knot(const host::Rig& rig, const scene::World& world, KnotCopy& out, base::Problems& problems);

}  // namespace swage::session
