// SPDX-License-Identifier: Apache-2.0
//
// A hand that is controlled by velocities: sticks and caps that spring back. Pure arithmetic. [any]
#pragma once

#include <swage/abi/device.h>

#include <algorithm>
#include <cmath>

#include "toolkit/math.hpp"

namespace swage::rate {

using toolkit::Pose;
using toolkit::Vec3;

struct Speeds {
  double dead = 0.1;        // dead zone, share of an axis: worn sticks rest up to 8 % off their middle
  double exponent = 2;      // of the deflection beyond the dead zone: slow near the middle, quick at the end
  double move = 20e-3;      // m/s at full deflection
  double turn = 1.2;        // rad/s at full deflection
  double smoothing = 0.05;  // s, time constant of the velocities: an axis changes in steps
};

/// Response of an axis of -1..1, with its dead zone. NaN gives 0.
inline double shaped(double x, const Speeds& s) {
  const double way = std::min(std::abs(x), 1.0) - s.dead;
  return way > 0 ? std::copysign(std::pow(way / (1 - s.dead), s.exponent), x) : 0;
}

/// Pose of the hand in the device frame. It does not move while the axes are at rest.
class RateHand {
 public:
  RateHand() = default;
  explicit RateHand(const Pose& start) : pose_(start) {}

  /// One step of dt [s] with both axes in -1..1. dt is limited to 50 ms: after a pause the hand does not jump.
  void step(const Vec3& move, const Vec3& turn, const Speeds& s, double dt) {
    dt = dt > 0 ? std::min(dt, 0.05) : 0;
    const double share = s.smoothing > 0 ? 1 - std::exp(-dt / s.smoothing) : 1;
    for (int i = 0; i < 3; ++i) {
      v_[i] += share * (s.move * shaped(move[i], s) - v_[i]);
      w_[i] += share * (s.turn * shaped(turn[i], s) - w_[i]);
    }
    pose_.p += dt * v_;
    pose_.q = (toolkit::exp_rotation(dt * w_) * pose_.q).normalized();
  }
  void stand() { v_ = w_ = Vec3::Zero(); }

  const Pose& pose() const { return pose_; }
  void write(swage_sample& sample) const {
    sample.pose = pose_.abi();
    sample.twist.v = toolkit::raw(v_);
    sample.twist.w = toolkit::raw(w_);
    sample.valid |= SWAGE_VALID_POSE | SWAGE_VALID_TWIST;
  }

 private:
  Pose pose_;
  Vec3 v_ = Vec3::Zero(), w_ = Vec3::Zero();  // m/s, rad/s
};

}  // namespace swage::rate
