// SPDX-License-Identifier: Apache-2.0
//
// Distances by search rather than by formula: slow, independent of the code under test, and accurate to 1e-12
// m.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

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

/// Least distance of the needle's centre line to a jaw, minus the wire's radius, to 1e-12 m. The distance changes by at
/// most the way walked along the wire, so of the intervals between samples only those that can hold the minimum are
/// halved, down to 25 um; a golden section between the neighbours of each local minimum ends the search.
inline double exact_gap(const Needle& n, const Solid& s, const Pose& X_JN) {
  const auto distance = [&](double theta) { return s.distance(X_JN * n.point(theta)); };
  std::vector<std::pair<double, double>> sample, finer;  // angle, distance
  for (int i = 0; i <= 8; ++i)
    sample.emplace_back(n.arc * (i / 8.0 - 0.5), distance(n.arc * (i / 8.0 - 0.5)));
  double best = 1e9;
  for (const auto& [theta, d] : sample) best = std::min(best, d);
  for (double width = n.length() / 8; width > 25e-6; width /= 2) {
    finer.assign(1, sample[0]);
    for (size_t i = 1; i < sample.size(); ++i) {
      const auto& [a, f_a] = sample[i - 1];
      const auto& [b, f_b] = sample[i];
      const bool whole = n.radius() * (b - a) < 1.5 * width;  // wider ones were dropped before
      if (whole && 0.5 * (f_a + f_b - width) <= best) {
        finer.emplace_back(0.5 * (a + b), distance(0.5 * (a + b)));
        best = std::min(best, finer.back().second);
      }
      finer.push_back(sample[i]);
    }
    sample.swap(finer);
  }

  const double g = 0.6180339887498949;
  for (size_t i = 0; i < sample.size(); ++i) {
    const size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, sample.size() - 1);
    if (sample[i].second > sample[before].second || sample[i].second > sample[after].second) continue;
    if (sample[i].second > best + 25e-6) continue;
    double a = sample[before].first, b = sample[after].first;
    double c = b - g * (b - a), d = a + g * (b - a), f_c = distance(c), f_d = distance(d);
    for (int k = 0; k < 40; ++k) {
      if (f_c < f_d)
        b = d, d = c, f_d = f_c, c = b - g * (b - a), f_c = distance(c);
      else
        a = c, c = d, f_c = f_d, d = a + g * (b - a), f_d = distance(d);
    }
    best = std::min({best, f_c, f_d});
  }
  return best - n.wire_radius();
}

/// Gap between the thesis's chain of 100 spheres and a jaw.
inline double chain_gap(const Needle& n, const Solid& s, const Pose& X_JN) {
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
    const Pose X_JN = jaw_pose(Pose{}, side * middle).inverse() * X_WN;
    const double gap = exact_arc ? exact_gap(n, s, X_JN) : chain_gap(n, s, X_JN);
    (gap < -overlap ? closed : open) = middle;
  }
  return 0.5 * (closed + open);
}

}  // namespace swage::bench
