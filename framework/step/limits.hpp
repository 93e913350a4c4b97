// SPDX-License-Identifier: Apache-2.0
//
// Bounds on values from plugins and devices. They are far beyond what a lesson needs: a larger value is an error of the plugin or device.
#pragma once

namespace swage::step {

// N and N m that an object may put on one of its bodies in one step. Normal: 1e-6 to 1. Larger: nothing in microsurgery
inline constexpr double kMaxForce = 1e3;
// N at one contact. Normal: up to 16, a needleholder closed hard; a fist holds some 500. Larger: a stiffness, a mass or a rate that
// does not belong to such a scene, and a result that no hand can cause
inline constexpr double kMaxContactForce = 500;
// m/s of a free surface. Normal: under 0.1. Larger: an unstable solver on its way to infinity
inline constexpr double kMaxSpeed = 1e3;
// m/s per N s of a free surface: 1 / effective mass. Normal: 1e3 to 1e8 (a wire end of 10 ug). Larger: no mass at all
inline constexpr double kMaxMobility = 1e12;
// m from the world's origin. Normal: under 0.1. Larger: the point has left the scene
inline constexpr double kMaxPosition = 1e3;
// SI, anything that is only required to be a number
inline constexpr double kAnyNumber = 1e300;

// Lengths of the scene per second that a tool follows its device. Normal hands: up to 50. Faster (a tracker that jumps, a
// script that teleports) the tool lags behind on a swept path, so that it passes through nothing; slower limits would be felt
inline constexpr double kMaxToolSpeed = 250;
// rad/s. Normal wrists: up to 10
inline constexpr double kMaxToolTurn = 30;

}  // namespace swage::step
