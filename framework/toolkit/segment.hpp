// SPDX-License-Identifier: Apache-2.0
//
// Straight segments and the closest points on them. Header-only, allocation-free, any frame, m.
#pragma once

#include <algorithm>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// a + t (b - a), t in [0, 1].
struct Segment {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  // m

  Vec3 point(double t) const { return a + t * (b - a); }
  double length() const { return (b - a).norm(); }
};

/// Parameter in [0, 1] of the point of the segment closest to p.
inline double closest(const Segment& segment, const Vec3& p) {
  const Vec3 d = segment.b - segment.a;
  const double dd = d.squaredNorm();
  return dd > 0 ? std::clamp((p - segment.a).dot(d) / dd, 0.0, 1.0) : 0.0;
}

/// Parameters of a closest pair of points on two segments.
struct SegmentPair {
  double s = 0, t = 0;    // on the first and on the second
  bool parallel = false;  // the pair is one of many
};

/// Closest points of two segments: the unconstrained pair of the carrying lines, moved to the nearest border
/// of the unit square when it lies outside. The squared distance is convex in (s, t), so at most two clamps
/// are needed. Lines are called parallel below a sine of 1e-8, where the unconstrained pair has no correct
/// digit left.
inline SegmentPair closest(const Segment& p, const Segment& q) {
  const Vec3 u = p.b - p.a, v = q.b - q.a, w = p.a - q.a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double det = uu * vv - uv * uv;
  SegmentPair pair;
  pair.parallel = det <= 1e-16 * uu * vv;

  pair.s = pair.parallel ? 0.0 : std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0);
  const double t = vv > 0 ? (uv * pair.s + vw) / vv : 0.0;
  pair.t = std::clamp(t, 0.0, 1.0);
  if (pair.t != t || pair.parallel) pair.s = uu > 0 ? std::clamp((uv * pair.t - uw) / uu, 0.0, 1.0) : 0.0;
  return pair;
}

}  // namespace swage::toolkit
