// SPDX-License-Identifier: Apache-2.0
//
// Tests of the validator for what a plugin may offer beside its own table: a solver, a surface, what is drawn, traits with functions; and
// LOCKSTEP; a device that observes the scene. Each reports what it skipped and why.
#pragma once

#include <string>
#include <vector>

#include "host/validate.hpp"
#include "tools/test_scene.hpp"

namespace swage::tools {

/// Tests an object's solver: W symmetric and positive semi-definite, the same bits twice, the same values for a part of the points;
/// the impulses the points move as v_free + W j says; the surface is numbers.
host::Finding solver(const TestScene& scene, uint64_t seed);

/// Tests what an object draws (visual_test.hpp). A warning: what of it will not be seen.
host::Finding drawing(const TestScene& scene, uint64_t seed);

/// Tests that a coupling or a lesson allocates nothing in the step; the host has that of objects and devices.
host::Finding real_time(const TestScene& scene, uint64_t seed);

/// Tests with the clocks of a paced run that the plugin does not sleep or wait in the step. A warning where it is late by its own
/// processor time, because that depends on the machine.
host::Finding waits(const TestScene& scene, uint64_t seed);

/// Parameters to test: the defaults, and each value of each choice (levels of detail are choices).
std::vector<std::string> ways_of(const host::ParamTable& table);

/// Tests every trait of an object that has functions, at places near, far, and beyond its ends.
host::Finding traits(const TestScene& scene, uint64_t seed);

/// Tests a device on a thread of its own: opens and closes repeatedly, sets `valid`, sequence and time increase, calls return in time,
/// and it works after a pause without calls.
host::Finding driver(const TestScene& scene, uint64_t seed);

/// Tests a device that observes the scene: its samples are finite, unit and within their ranges for any scene; a second instance gives
/// the same bits for the same scene; it does not write to the scene, and allocates nothing.
host::Finding sight(const TestScene& scene, uint64_t seed);

}  // namespace swage::tools
