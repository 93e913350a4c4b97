// SPDX-License-Identifier: Apache-2.0
//
// The force-limited drive and the end stops of one hinge, implicit over a step. x is the change of the angle [rad].
//
//     t(x) = clamp(K (target - q0 - x) - B x / h, +- max)     minus a stiff spring beyond an end stop
//
// t falls with x and is the gradient of a concave function, so it joins the contact solve like any other spring.
// Header-only, pure functions, [rt].
#pragma once

#include <swage/abi/object.h>

#include <algorithm>
#include <cmath>

#include "scene/world.hpp"

namespace swage::dynamics {

struct HingeDrive {
  double t0 = 0;             // N m, unclamped torque at x = 0
  double kappa = 0;          // N m / rad, K + B / h
  double max = 0;            // N m
  double low = 0, high = 0;  // rad, end stops relative to q0
  double stop = 0;           // N m / rad, stiffness of an end stop
  double inertia_hh = 0;     // kg m2 / s2, I / h^2
  double x_hat = 0;          // rad, change of the angle without drive, stops and contacts

  HingeDrive() = default;
  /// `angle`, `rate`: at the start of the step; `torque`: from forces on the child [N m].
  HingeDrive(const scene::HingeInfo& info, const swage_drive& drive, double angle, double rate, double torque,
             double h)
      : t0(drive.stiffness * (drive.target - angle)),
        kappa(drive.stiffness + drive.damping / h),
        max(drive.max_torque),
        low(std::min(0.0, info.min - angle)),
        high(std::max(0.0, info.max - angle)),
        inertia_hh(info.inertia / (h * h)),
        x_hat(h * rate + h * h * torque / info.inertia) {
    // a stop is a million times as stiff as inertia and drive
    stop = 1e6 * (inertia_hh + kappa);
  }

  double torque(double x) const {
    double t = std::clamp(t0 - kappa * x, -max, max);
    if (x > high) t -= stop * (x - high);
    if (x < low) t -= stop * (x - low);
    return t;
  }
  /// -dt/dx
  double stiffness(double x) const {
    const double drive = std::abs(t0 - kappa * x) < max ? kappa : 0.0;
    return drive + (x > high || x < low ? stop : 0.0);
  }
  /// t(x) - x dt/dx: value at 0 of the tangent at x; the same bits all along one piece.
  double torque_at_zero(double x) const {
    const double t = t0 - kappa * x;
    return (std::abs(t) < max ? t0 : std::copysign(max, t)) + (x > high  ? stop * high
                                                               : x < low ? stop * low
                                                                         : 0.0);
  }
  /// Energy of drive and stops [J]: its gradient is -t.
  double energy(double x) const {
    const double t = std::abs(t0 - kappa * x);
    double e = kappa > 0 ? (t <= max ? 0.5 * t * t : max * (t - 0.5 * max)) / kappa : 0.0;
    if (x > high) e += 0.5 * stop * (x - high) * (x - high);
    if (x < low) e += 0.5 * stop * (x - low) * (x - low);
    return e;
  }
  /// Change of the angle when nothing touches the hinge: inertia_hh (x - x_hat) = t(x), solved exactly.
  double free() const {
    double x = (inertia_hh * x_hat + t0) / (inertia_hh + kappa);
    const double t = t0 - kappa * x;
    if (std::abs(t) > max) x = x_hat + std::copysign(max, t) / inertia_hh;
    return std::clamp(x, low, high);
  }
};

}  // namespace swage::dynamics
