// SPDX-License-Identifier: Apache-2.0
//
// The trajectory that collision queries are judged and timed on: a needle that two jaws approach, touch and grasp,
// 10,000 poses, the same on every machine. In the last two phases the gaps are set to a wanted value with a reference
// that shares no code with the room under test.
#pragma once

#include <array>
#include <vector>

#include "base/rng.hpp"
#include "reference.hpp"
#include "scene.hpp"

namespace swage::bench {

/// The thesis's count of 8 planes and 12 edges: each jaw a tetrahedron on the same gripping face.
inline Jaw tetra_jaw(int side) {
  const double x0 = Jaw::kHinge, x1 = Jaw::kHinge + Jaw::kLength, w = Jaw::kHalfWidth,
               t = side * 2 * Jaw::kThickness;
  Jaw j;
  j.vertex = {{x0, -w, 0}, {x0, w, 0}, {x1, 0, 0}, {x0, 0, t}};
  j.face = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  if (side > 0) return j;
  for (auto& f : j.face) std::reverse(f.begin(), f.end());
  return j;
}

enum class Phase { kFar, kNear, kTouching, kGrasped };
inline constexpr int kPhases = 4;

struct TrajectoryPose {
  Pose X_WN;
  std::array<Pose, 2> X_WJ;  // upper, lower
  Phase phase = Phase::kFar;
};

/// Smooth motion of the needle in its six degrees of freedom: sums of sines with seeded phases.
class Wobble {
 public:
  explicit Wobble(uint64_t seed) {
    base::Xoshiro256 random(seed);
    for (auto& channel : phase_)
      for (double& p : channel) p = random.uniform(0, 2 * std::numbers::pi);
  }
  /// -1..1, t in 0..1.
  double operator()(size_t channel, double t) const {
    const std::array<double, 3>& p = phase_[channel];
    const double w = 2 * std::numbers::pi * t;
    return 0.5 * std::sin(2.9 * w + p[0]) + 0.3 * std::sin(8.3 * w + p[1]) + 0.2 * std::sin(18.7 * w + p[2]);
  }

 private:
  std::array<std::array<double, 3>, 6> phase_{};
};

/// Opening of one jaw (rad) at which its gap to the needle first is `wanted` while it closes: no place of the jaw is
/// farther from the hinge than its tip, so turning by (gap - wanted) / reach never goes too far.
inline double opening_for(const Needle& n, const Solid& s, int side, const Pose& X_WN, double wanted) {
  const double reach = std::hypot(Jaw::kHinge + Jaw::kLength, 2 * Jaw::kThickness);
  double opening = 0.3;
  for (int k = 0; k < 60 && opening > -0.15; ++k) {
    const double excess = exact_gap(n, s, jaw_pose(Pose{}, side * opening).inverse() * X_WN) - wanted;
    opening -= excess / reach;
    if (std::abs(excess) < 1e-11) break;
  }
  return opening;
}

/// Opens or closes the jaws and brings the tool at time `t` (0 to 1) to a pose whose phase and needle are known.
inline void place_jaws(TrajectoryPose& f, const Needle& n, const Solid (&solid)[2], double t) {
  const auto gap = [&](size_t k, double wanted) {
    return opening_for(n, solid[k], k == 0 ? 1 : -1, f.X_WN, wanted);
  };
  double opening[2] = {0.13, 0.13}, tool = 0;
  if (f.phase == Phase::kFar) tool = -30e-3 + 22e-3 * t / 0.3;
  if (f.phase == Phase::kNear)
    tool = -8e-3 * (1 - (t - 0.3) / 0.3), opening[0] = opening[1] = 0.13 - 0.07 * (t - 0.3) / 0.3;
  if (f.phase == Phase::kTouching) {
    const double s = (t - 0.6) / 0.2;
    const size_t k = static_cast<size_t>(20 * s) % 2;
    opening[k] =
        gap(k, 20e-6 * (1 - s) * (0.5 + 0.5 * std::sin(40 * s)) - 4e-6 * s * (0.5 - 0.5 * std::cos(55 * s)));
    opening[1 - k] = 0.08;
  }
  if (f.phase == Phase::kGrasped) {
    const double s = (t - 0.8) / 0.2;
    for (size_t k = 0; k < 2; ++k)
      opening[k] = gap(k, -0.5e-6 - 3e-6 * (0.5 + 0.5 * std::sin(60 * s + static_cast<double>(k))));
  }
  const Pose X_WT(Vec3(tool, 0, 0), Quat::Identity());
  for (size_t k = 0; k < 2; ++k) f.X_WJ[k] = jaw_pose(X_WT, (k == 0 ? 1 : -1) * opening[k]);
}

/// `poses` poses: 30 % far (the tool comes from 30 mm), 30 % near (needle between open jaws), 20 % touching one jaw
/// (gap +20 to -4 um), 20 % grasped (both -0.5 to -3.5 um).
inline std::vector<TrajectoryPose> trajectory(const Needle& n, const Jaw& upper, const Jaw& lower,
                                              int poses = 10000, uint64_t seed = 1) {
  const Solid solid[2] = {Solid(upper), Solid(lower)};
  const Wobble wobble(seed);
  std::vector<TrajectoryPose> out;
  for (int i = 0; i < poses; ++i) {
    const double t = static_cast<double>(i) / poses;
    TrajectoryPose f;
    f.phase = t < 0.3 ? Phase::kFar : t < 0.6 ? Phase::kNear : t < 0.8 ? Phase::kTouching : Phase::kGrasped;

    // the wire crosses the jaws near the grip, its plane about across the tool
    const double size = f.phase == Phase::kGrasped ? 0.35 : 1.0;
    const auto turn = [&](size_t axis, double angle) {
      return toolkit::exp_rotation(angle * Vec3::Unit(static_cast<long>(axis)));
    };
    const double theta = 0.25 * n.arc * size * wobble(3, t);
    const Quat q = turn(0, 0.25 * size * wobble(0, t)) * turn(1, 0.4 * size * wobble(1, t)) *
                   turn(2, 0.5 * size * wobble(2, t)) * turn(0, theta);
    const Vec3 place(Jaw::kGrip + 0.8e-3 * size * wobble(4, t), 0.1e-3 * size * wobble(5, t), 0);
    f.X_WN = Pose(place - q * n.point(theta), q);

    place_jaws(f, n, solid, t);
    out.push_back(f);
  }
  return out;
}

}  // namespace swage::bench
