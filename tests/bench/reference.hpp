// SPDX-License-Identifier: Apache-2.0
//
// Distances by search rather than by formula: slow, independent of the code under test, and accurate to 1e-12
// m.
#pragma once

#include <algorithm>
#include <limits>

#include "scene.hpp"

namespace swage::bench {

/// Jaw with its planes, for exact point distances.
struct Solid {
  std::vector<Vec3> vertex;
  std::vector<std::vector<uint32_t>> face;
  std::vector<Vec3> normal;
  std::vector<double> offset;

  explicit Solid(const Jaw& j) : vertex(j.vertex), face(j.face) {
    for (const auto& f : face) {
      const Vec3 n = (vertex[f[1]] - vertex[f[0]]).cross(vertex[f[2]] - vertex[f[0]]).normalized();
      normal.push_back(n);
      offset.push_back(n.dot(vertex[f[0]]));
    }
  }

  /// Signed distance of a point [m], negative inside.
  double distance(const Vec3& p) const {
    double deepest = -std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < face.size(); ++i) deepest = std::max(deepest, normal[i].dot(p) - offset[i]);
    if (deepest <= 0) return deepest;
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < face.size(); ++i) nearest = std::min(nearest, outside(i, p));
    return nearest;
  }

 private:
  /// Distance to one face as a polygon, from outside of the solid.
  double outside(size_t i, const Vec3& p) const {
    const double height = normal[i].dot(p) - offset[i];
    const Vec3 foot = p - height * normal[i];
    bool inside = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < face[i].size(); ++k) {
      const Vec3& a = vertex[face[i][k]];
      const Vec3& b = vertex[face[i][(k + 1) % face[i].size()]];
      inside = inside && (b - a).cross(foot - a).dot(normal[i]) >= 0;
      const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - a - t * (b - a)).norm());
    }
    return inside ? std::min(nearest, std::abs(height)) : nearest;
  }
};

/// Gap between the exact arc of the needle and a jaw: samples, then golden section around every local
/// minimum.
inline double arc_gap(const Needle& n, const Solid& s, const Pose& X_WN, const Pose& X_WJ) {
  constexpr int kSamples = 512;
  const Pose X_JN = X_WJ.inverse() * X_WN;
  const auto distance = [&](double u) { return s.distance(X_JN * n.point(n.arc * (u - 0.5))); };
  std::vector<double> d;
  for (int i = 0; i <= kSamples; ++i) d.push_back(distance(static_cast<double>(i) / kSamples));
  double best = *std::min_element(d.begin(), d.end());
  const double reach = n.length() / kSamples;
  for (int i = 0; i <= kSamples; ++i) {
    const auto at = static_cast<size_t>(i);
    if (d[at] > best + reach || (i > 0 && d[at - 1] < d[at]) || (i < kSamples && d[at + 1] < d[at])) continue;
    double a = std::max(0, i - 1) / static_cast<double>(kSamples),
           b = std::min(kSamples, i + 1) / static_cast<double>(kSamples);
    for (int k = 0; k < 64; ++k) {
      const double c = b - 0.6180339887498949 * (b - a), e = a + 0.6180339887498949 * (b - a);
      (distance(c) < distance(e) ? b : a) = distance(c) < distance(e) ? e : c;
    }
    best = std::min(best, distance(0.5 * (a + b)));
  }
  return best - n.wire_radius();
}

/// Gap between the thesis's chain of 100 spheres and a jaw.
inline double chain_gap(const Needle& n, const Solid& s, const Pose& X_WN, const Pose& X_WJ) {
  const Pose X_JN = X_WJ.inverse() * X_WN;
  double best = std::numeric_limits<double>::infinity();
  for (const Vec3& c : n.chain(100)) best = std::min(best, s.distance(X_JN * c));
  return best - n.wire_radius();
}

/// Opening [rad, >= 0] of one jaw at which it overlaps the gripped needle by `overlap` [m].
inline double closing_angle(const Needle& n, int side, double overlap, bool exact_arc) {
  const Solid s(jaw(side));
  const Pose X_WN = grip_pose(n);
  double closed = -0.02, open = 0.1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (closed + open);
    const Pose X_WJ = jaw_pose(Pose{}, side * middle);
    const double gap = exact_arc ? arc_gap(n, s, X_WN, X_WJ) : chain_gap(n, s, X_WN, X_WJ);
    (gap < -overlap ? closed : open) = middle;
  }
  return 0.5 * (closed + open);
}

}  // namespace swage::bench
