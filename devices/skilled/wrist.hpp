// SPDX-License-Identifier: Apache-2.0
//
// An arm that holds a tool: ranges of forearm and wrist, and the cost of a posture. Pure geometry, [rt].
//
// Forearm frame F: x from elbow to hand, z to the thumb of a right hand in the middle of its forearm's rotation, y out of the palm. The
// forearm rotates about the vertical with the shoulder, without cost up to `swing`; then the tool's attitude is
//
//   R_FT = Rx(rotation) Rz(flexion) Ry(deviation) Rx(hold)        supination, flexion and ulnar deviation positive
//
// A posture costs U(angle) for each of the three: zero within the share `ease` of its range, unbounded towards its end. The hand gives the
// attitude that minimises (asked - given)^2/2 + U(given). With L the end of the range on that side and c = ease L
//
//   U'(y) = c - y - (L - c) ln(1 - (y - c)/(L - c))  for y > c      given = c + (L - c) (1 - exp(-(asked - c)/(L - c)))
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "toolkit/math.hpp"

namespace swage::skilled {

using toolkit::Mat3;
using toolkit::Quat;
using toolkit::Vec3;

/// Angles of one arm [rad]: of the forearm, and of the wrist relative to it.
struct Posture {
  double swing = 0;                  // of the forearm about the vertical, from its rest direction
  std::array<double, 3> angle = {};  // rotation (supination > 0), flexion, deviation (ulnar > 0)
};

class Wrist {
 public:
  struct Range {
    double low = 0, high = 0;  // rad, low < 0 < high
  };
  struct Arm {
    bool left = false;
    Vec3 forearm_W = Vec3::UnitY();  // rest direction from elbow to hand; its horizontal part counts
    double swing = 0;                // rad, to either side
    double hold = 0;                 // rad, from the thumb's side of the hand to the closing direction, clockwise seen from the elbow
    double ease = 1;                 // share of each range, 0 < ease <= 1
    std::array<Range, 3> range;      // of a right hand: rotation, flexion, deviation
  };

  Wrist() = default;
  explicit Wrist(const Arm& arm) : arm_(arm), rest_(std::atan2(arm.forearm_W.y(), arm.forearm_W.x())) {
    // the left arm is the mirror image of the right one: rotations about x and z change sign
    if (arm.left)
      for (const size_t i : {size_t{0}, size_t{1}}) arm_.range[i] = {-arm.range[i].high, -arm.range[i].low};
    hold_ = about(0, arm.left ? -arm.hold : arm.hold);
  }

  /// The posture that the attitude q_WT requires, even outside of the ranges.
  Posture asked(const Quat& q_WT) const {
    Posture out;
    const Vec3 ahead = q_WT * Vec3::UnitX();
    constexpr double kUpright = 1e-6;  // a tool with a smaller horizontal share is upright and has no heading
    if (std::hypot(ahead.x(), ahead.y()) > kUpright)
      out.swing = std::clamp(std::remainder(std::atan2(ahead.y(), ahead.x()) - rest_, kTurn), -arm_.swing, arm_.swing);
    const Mat3 M = (about(2, -rest_ - out.swing) * q_WT * hold_.conjugate()).toRotationMatrix();
    out.angle = {std::atan2(M(2, 1), M(1, 1)), std::asin(std::clamp(-M(0, 1), -1.0, 1.0)), std::atan2(M(0, 2), M(0, 0))};
    return out;
  }
  /// The posture of least cost for a requested one.
  Posture given(Posture p) const {
    for (size_t i = 0; i < p.angle.size(); ++i)
      p.angle[i] = p.angle[i] < 0 ? -reach(-p.angle[i], -arm_.range[i].low) : reach(p.angle[i], arm_.range[i].high);
    return p;
  }
  Quat attitude(const Posture& p) const {
    return about(2, rest_ + p.swing) * about(0, p.angle[0]) * about(2, p.angle[1]) * about(1, p.angle[2]) * hold_;
  }
  /// The attitude that the hand gives for a requested one.
  Quat given(const Quat& q_WT) const { return attitude(given(asked(q_WT))).normalized(); }
  /// Sum of squared shares of the ranges: 1 for one angle at the end of its range.
  double strain(const Posture& p) const {
    double sum = 0;
    for (size_t i = 0; i < p.angle.size(); ++i) {
      const double share = p.angle[i] / (p.angle[i] < 0 ? arm_.range[i].low : arm_.range[i].high);
      sum += share * share;
    }
    return sum;
  }
  /// Angle that is given for a requested one [rad]; `end`: the range on that side.
  double reach(double angle, double end) const {
    const double free = arm_.ease * end, room = end - free;
    if (angle <= free) return angle;
    return room > 0 ? free - room * std::expm1((free - angle) / room) : end;
  }

 private:
  static constexpr double kTurn = 6.283185307179586;  // rad
  static Quat about(int axis, double angle) { return toolkit::exp_rotation(angle * Vec3::Unit(axis)); }

  Arm arm_;
  double rest_ = 0;  // rad, of the resting forearm from +x about +z
  Quat hold_ = Quat::Identity();
};

}  // namespace swage::skilled
