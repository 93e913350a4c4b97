// SPDX-License-Identifier: Apache-2.0
//
// Tests of the validator for what a plugin may offer beside its own table: a solver, a surface, what is drawn, traits with functions; and
// the driver of a device that is not asked in the step; a device that sees. Each says what it skipped and why.
#pragma once

#include "host/validate.hpp"
#include "tools/test_scene.hpp"

namespace swage::tools {

/// An object's solver: answers symmetric, positive semi-definite, twice the same bits; equal for a part of the points; after
/// the impulses the points move as v_free + W j says; surface and what is drawn are numbers.
host::Finding solver(const TestScene& scene, uint64_t seed);

/// Every trait of an object that has functions, asked near, far, and beyond its ends.
host::Finding traits(const TestScene& scene, uint64_t seed);

/// A device on a thread of its own: opens and closes again and again, says what is valid, counts and measures forwards, comes back
/// in time, and works after a pause without calls.
host::Finding driver(const TestScene& scene, uint64_t seed);

/// A device that sees: whatever lies before it, its samples are finite, unit and within their ranges; a second instance that sees the
/// same answers with the same bits; it writes nothing into what it is shown, and allocates nothing.
host::Finding sight(const TestScene& scene, uint64_t seed);

}  // namespace swage::tools
