// SPDX-License-Identifier: Apache-2.0
//
// Drag of a fluid on a rigid body of slender pieces and spheres, for an object that adds forces.
//
// A piece of a cylinder bears Lamb's drag across its axis and half of it along (rod_drag.hpp); a sphere Stokes' with the correction of
// Schiller and Naumann (1935), 24/Re (1 + 0.15 Re^0.687), to Re = 800. Pieces do not shield each other; there is no added mass.
//
// The coefficients are those of the speed that the body has; the drag itself is that of the speed at the end of the step,
//
//   (M + h D) V1 = M V0 + h F,    drag = -D V1
//
// so that a light body in a viscous fluid is stable, and reaches the terminal velocity of D V = F at any step.
// Units SI. Frame W. Header-only, [rt]: nothing allocates.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"
#include "toolkit/rod_drag.hpp"

namespace swage::toolkit {

/// Force over speed of a sphere [N s/m].
inline double sphere_drag(const RodFluid& fluid, double diameter, double speed) {
  if (!(fluid.viscosity > 0)) return 0;
  const double Re = std::min(fluid.density * speed * diameter / fluid.viscosity, kMostReynolds);
  return 3 * std::numbers::pi * fluid.viscosity * diameter * (1 + 0.15 * std::pow(Re, 0.687));
}

struct RigidMotion {
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();  // m/s, rad/s
};

/// The drag matrix of a rigid body about its centre of mass.
class FluidDrag {
 public:
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  using Vec6 = Eigen::Matrix<double, 6, 1>;

  FluidDrag(const RodFluid& fluid, const RigidMotion& V) : fluid_(fluid), V_(V) {}

  /// A straight piece: its middle `r` from the centre of mass [m], its direction `t`, length and diameter [m].
  void add_piece(const Vec3& r, const Vec3& t, double length, double diameter) {
    const Vec3 v = V_.v + V_.w.cross(r), across = v - v.dot(t) * t;
    const double c = length * rod_drag(fluid_, diameter, across.norm());
    add(r, Mat3(c * (Mat3::Identity() - 0.5 * t * t.transpose())));
    // a cylinder that spins about itself: 4 pi mu r^2 per length (Lamb 1932, art. 333)
    D_.bottomRightCorner<3, 3>() += std::numbers::pi * fluid_.viscosity * diameter * diameter * length * t * t.transpose();
  }
  /// A sphere about the centre of mass, whose spin has the drag pi mu d^3 as well.
  void add_sphere(double diameter) {
    add(Vec3::Zero(), Mat3(sphere_drag(fluid_, diameter, V_.v.norm()) * Mat3::Identity()));
    D_.bottomRightCorner<3, 3>() += std::numbers::pi * fluid_.viscosity * diameter * diameter * diameter * Mat3::Identity();
  }
  /// The motion at the end of a step h [s] of a mass [kg] and an inertia [kg m2, in W] under a force at its centre [N].
  RigidMotion after(double mass, const Mat3& inertia_W, const Vec3& force, double h) const {
    Mat6 M = Mat6::Zero();
    M.topLeftCorner<3, 3>() = mass * Mat3::Identity();
    M.bottomRightCorner<3, 3>() = inertia_W;
    Vec6 right;
    right << mass * V_.v + h * force, inertia_W * V_.w;
    // scaled by lengths of the body: N s/m and N m s are then alike
    const double l = std::sqrt(inertia_W.trace() / mass);
    const Vec6 scale = (Vec6() << 1, 1, 1, 1 / l, 1 / l, 1 / l).finished();
    const Mat6 A = scale.asDiagonal() * (M + h * D_) * scale.asDiagonal();
    const Vec6 V1 = scale.asDiagonal() * A.ldlt().solve(scale.asDiagonal() * right);
    return {V1.head<3>(), V1.tail<3>()};
  }
  /// Force [N] and torque about the centre of mass [N m] of the drag at a motion.
  Vec6 force(const RigidMotion& V) const {
    Vec6 V6;
    V6 << V.v, V.w;
    return -D_ * V6;
  }

 private:
  void add(const Vec3& r, const Mat3& C) {
    const Mat3 R = skew(r), CR = C * R;  // v + w x r = v - R w
    D_.topLeftCorner<3, 3>() += C;
    D_.topRightCorner<3, 3>() -= CR;
    D_.bottomLeftCorner<3, 3>() -= CR.transpose();
    D_.bottomRightCorner<3, 3>() += R.transpose() * CR;
  }

  RodFluid fluid_;
  RigidMotion V_;
  Mat6 D_ = Mat6::Zero();
};

}  // namespace swage::toolkit
