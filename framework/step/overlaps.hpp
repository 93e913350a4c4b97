// SPDX-License-Identifier: Apache-2.0
//
// Objects that overlap at the start. The solver pushes them apart, and a light one is thrown: a ring of some milligrams
// that starts half a millimetre inside its hook leaves it at 74 m/s. A warning comes before the first step.
#pragma once

#include <vector>

#include "base/problem.hpp"
#include "contact/detector.hpp"
#include "host/rig.hpp"

namespace swage::step {

/// One warning per pair of objects that overlap at the poses of `rig` by more than 2 % of the scene's length, with names and depth;
/// none of a thread that is tied to the other, nor of what a gripper holds between its jaws.
/// After Engine's construction, before its first step. [main]
base::Problems start_overlaps(const host::Rig& rig, const contact::Options& options);

}  // namespace swage::step
