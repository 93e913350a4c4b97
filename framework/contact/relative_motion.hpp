// SPDX-License-Identifier: Apache-2.0
//
// Bounds on the speed at which two moving solids approach each other within a step. Room-internal.
#pragma once

#include "contact/sweep.hpp"

namespace swage::contact {

/// Most advances of a sweep. One closes most of the gap when bodies approach head on: 2 or 3 are usual, more when they slide.
inline constexpr int kMaxAdvances = 48;

/// Motion of the points of a as b sees it, in the frame of b, per step. With rho = p - p_B in W:
///   u(p) = R_b' (d_a - d_b - w_b x (p_A - p_B)) + w x (p - p_A),   w = R_b' (w_a - w_b)        now
///   |u'| = |w_a x (w_a x r) - 2 w_b x rho' + w_b x (w_b x rho)| <= bend                         at any time of the step
/// so that for the time s from now no point comes nearer along n by more than s (-n . u + bend s / 2).
class RelativeMotion {
 public:
  RelativeMotion(const Solid& a, const Motion& motion_a, const Motion& motion_b)
      : d_W_(motion_a.d - motion_b.d),
        w_W_(motion_a.turn - motion_b.turn),
        w_b_W_(motion_b.turn),
        turns_(!(motion_a.turn.isZero(0) && motion_b.turn.isZero(0))) {
    if (!turns_) return;
    const double w_a = motion_a.turn.norm(), w_b = w_b_W_.norm(), r = a.centre.norm() + a.bound;
    const double rate = d_W_.norm() + w_a * r, rho = (motion_a.X0.p - motion_b.X0.p).norm() + r + rate;
    bend_ = w_a * w_a * r + w_b * (2 * rate + w_b * rho);
  }

  /// Whether the motion has a rotation.
  bool turns() const { return turns_; }
  double bend() const { return bend_; }

  /// Sets the velocities at the present poses.
  void look(const Vec3& p_WA, const Frame& X_WB) {
    u_A_ = X_WB.turn_back(turns_ ? Vec3(d_W_ - w_b_W_.cross(p_WA - X_WB.p)) : d_W_);
    if (turns_) w_ = X_WB.turn_back(w_W_);
  }
  /// u of a's origin, and w.
  const Vec3& of_origin() const { return u_A_; }
  const Vec3& spin() const { return w_; }
  /// u at the place r from a's origin.
  Vec3 at(const Vec3& r) const { return u_A_ + w_.cross(r); }
  /// Bound on |u|, from now to the end of the step, for points within `bound` of the place r.
  double fastest(const Vec3& r, double bound) const { return at(r).norm() + w_.norm() * bound + bend_; }

 private:
  Vec3 d_W_, w_W_, w_b_W_;  // m, rad
  bool turns_;
  double bend_ = 0;                             // m
  Vec3 u_A_ = Vec3::Zero(), w_ = Vec3::Zero();  // m, rad, in b
};

}  // namespace swage::contact
