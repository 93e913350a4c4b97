// SPDX-License-Identifier: Apache-2.0
//
// Worlds with chains, for tests of the detector; and what all pairs of pieces say in long double.
#pragma once

#include <cmath>
#include <random>

#include "contact/detector.hpp"
#include "scene/kinematics.hpp"

namespace swage::contact {

/// Adds a chain on a body of its own; object: its index.
inline uint32_t add_chain(scene::World& w, const std::vector<Vec3>& p, double radius, double bend_radius,
                          uint32_t object) {
  scene::ChainInfo info;
  double s = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    if (i > 0) s += (p[i] - p[i - 1]).norm();
    info.start.push_back(toolkit::raw(p[i]));
    info.s.push_back(s);
    info.radius.push_back(i + 1 < p.size() ? radius : 0);
  }
  info.bend_radius = bend_radius;
  info.state = static_cast<uint32_t>(w.plugin_state.size());
  w.plugin_state.resize(info.state + scene::chain_doubles(static_cast<uint32_t>(p.size())));
  scene::BodyInfo body;
  body.motion = SWAGE_MOTION_FLEXIBLE, body.object = object, body.start = Pose().abi();
  scene::Shape shape;
  shape.kind = SWAGE_SHAPE_CHAIN;
  shape.X_BS = Pose().abi();
  shape.body = static_cast<uint32_t>(w.body.size()), shape.object = object;
  shape.chain = static_cast<uint32_t>(w.chain.size()), shape.radius = radius;
  w.body.push_back(body);
  w.shape.push_back(shape);
  w.chain.push_back(info);
  scene::reset(w);
  return shape.chain;
}

/// A rigid shape on a body of its own.
inline uint32_t add_shape(scene::World& w, scene::Shape shape, uint32_t object, const Pose& X_WB = Pose(),
                          int32_t motion = SWAGE_MOTION_FIXED) {
  scene::BodyInfo body;
  body.motion = motion, body.object = object, body.start = X_WB.abi();
  shape.body = static_cast<uint32_t>(w.body.size()), shape.object = object;
  w.body.push_back(body);
  w.shape.push_back(shape);
  scene::reset(w);
  return shape.body;
}
inline scene::Shape ball(double radius) {
  scene::Shape s;
  s.X_BS = Pose().abi();
  s.radius = s.bounding_radius = radius;
  return s;
}

/// A thread that wanders inside a ball, n pieces of the given length, turning by up to `turn` rad from piece to piece.
inline std::vector<Vec3> wander(uint32_t n, double length, double turn, double inside, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
  std::vector<Vec3> p{inside * 0.3 * vector()};
  Vec3 along = vector().normalized();
  while (p.size() <= n) {
    along = (along + turn * vector() - 0.3 * (p.back().norm() > inside) * p.back().normalized()).normalized();
    p.push_back(p.back() + length * along);
  }
  return p;
}

struct Nearest {
  long double distance, s, t;  // m; shares of the two pieces
};

/// Nearest places of two pieces: those of their lines where they are on both, otherwise those of an end and the other piece.
inline Nearest nearest(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  using V = Eigen::Matrix<long double, 3, 1>;
  const V a = a0.cast<long double>(), u = a1.cast<long double>() - a, b = b0.cast<long double>(),
          v = b1.cast<long double>() - b;
  Nearest best{1e300L, 0, 0};
  const auto consider = [&](long double s, long double t) {
    const long double d = (a + s * u - b - t * v).norm();
    if (d < best.distance) best = {d, s, t};
  };
  const auto clamp = [](long double x) { return std::min(1.0L, std::max(0.0L, x)); };
  for (const long double end : {0.0L, 1.0L}) {
    consider(end, clamp(v.dot(a + end * u - b) / v.squaredNorm()));
    consider(clamp(u.dot(b + end * v - a) / u.squaredNorm()), end);
  }
  const long double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), det = uu * vv - uv * uv;
  const long double s = (uv * v.dot(a - b) - vv * u.dot(a - b)) / det, t = (uv * s + v.dot(a - b)) / vv;
  if (det > 0 && s >= 0 && s <= 1 && t >= 0 && t <= 1) consider(s, t);
  return best;
}

}  // namespace swage::contact
