// SPDX-License-Identifier: Apache-2.0
//
// Registration of an arm with the picture: the rigid motion from its frame to that of the picture, from points of the picture to which
// its tip was led; and the pose of its device for a lesson, so that hand and tool are in one place. [main]
#pragma once

#include <swage/abi/base.h>

#include <span>
#include <string>

namespace swage::session {

/// A point of the picture and the device's position there; m.
struct Touched {
  swage_vec3 p_S{};  // picture: origin in its middle, +x right, +y up, +z towards the person
  swage_vec3 p_D{};  // device
};

struct Registration {
  swage_pose X_SD{{0, 0, 0}, {1, 0, 0, 0}};
  double worst = 0, rms = 0;  // m, distance between the points of the picture and the transformed ones of the device
};

/// m. Points nearer together than this give no reliable direction: a hand holds still to some tenths of a millimetre.
inline constexpr double kLeastSpread = 10e-3;
/// m. A person who leads a tip to a mark is off by a millimetre or two; 5 mm mean another mark, or an arm that was moved.
inline constexpr double kMostResidual = 5e-3;

/// Least squares over all rotations and translations, without scale (Kabsch 1976, Umeyama 1991). At least three points that are not
/// on a line; with four the residual reveals a wrong one. "" or the reason why there is none, as a sentence; then `out` is unchanged.
std::string fit_registration(std::span<const Touched> points, Registration& out);

/// Pose of the device in the world, for a picture with p_WS in its middle, orientation q_WS and a size of `scale` times that of the
/// scene. The device's "motion_scale" is then the same scale.
swage_pose place_device(const Registration& registration, const swage_vec3& p_WS, const swage_quat& q_WS, double scale);

}  // namespace swage::session
