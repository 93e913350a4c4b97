// SPDX-License-Identifier: Apache-2.0
//
// Height fields, wires over them, and a search over all triangles to judge them by: tests of the height field alone.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/rng.hpp"
#include "contact/narrow_phase.hpp"
#include "least.hpp"

namespace swage::contact {

using toolkit::Quat;

inline constexpr double kCell = 0.2e-3;  // m
inline constexpr uint32_t kN = 25;

/// Heights over 24 x 24 cells, and the shape of a wire above them.
struct Ground {
  scene::World world;
  explicit Ground(const std::function<double(double, double)>& z) {
    scene::HeightFieldInfo info{kN, kN, kCell, kCell, 1e-3, {}, scene::kNone};
    for (uint32_t j = 0; j < kN; ++j)
      for (uint32_t i = 0; i < kN; ++i) info.height.push_back(z(i * kCell, j * kCell));
    world.field.push_back(info);
    world.shape.resize(1);
    world.shape[0].kind = SWAGE_SHAPE_HEIGHT_FIELD;
    world.shape[0].field = 0;
    world.shape[0].X_BS = Pose(Vec3(-2e-3, -2e-3, 0), Quat::Identity()).abi();
  }
  Solid solid() const { return make_solid(world, 0); }
  double at(double x, double y) const { return solid().field.height_at(x + 2e-3, y + 2e-3); }
};

inline Solid wire(int32_t kind, double radius, double half_length, double arc_radius = 0, double sweep = 0) {
  scene::Shape s;
  s.kind = kind;
  s.X_BS = Pose().abi();
  s.radius = radius, s.half_length = half_length, s.arc_radius = arc_radius, s.sweep = sweep;
  return make_solid(s, {});
}

/// Distance of p to a triangle, from Voronoi regions of its own (Ericson, Real-Time Collision Detection, 5.1.5).
inline double distance(const Vec3& p, const toolkit::HeightField::Corners& t) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.norm();
  const Vec3 bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.norm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).norm();
  const Vec3 cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.norm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).norm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b)).norm();
  return std::abs(t.normal().normalized().dot(ap));
}

/// Distance of a place above the surface, by looking at all triangles within 0.8 mm; farther, that.
inline double distance(const Vec3& p_H, const toolkit::HeightField& f) {
  double least = 4 * kCell;
  const auto near = [](double t, uint32_t k) { return std::abs(t / kCell - k) < 5; };
  for (uint32_t j = 0; j + 1 < f.ny; ++j)
    for (uint32_t i = 0; i + 1 < f.nx; ++i)
      if (near(p_H.x(), i) && near(p_H.y(), j))
        for (uint32_t half = 0; half < 2; ++half)
          least = std::min(least, distance(p_H, f.corners(2 * (j * f.nx + i) + half)));
  return least;
}

/// Least gap of a wire whose centre line is above the surface: samples, then golden section about the lowest ones.
template <class PointAt>
double searched_gap(const PointAt& point_H, const toolkit::HeightField& f, double radius) {
  constexpr int kSamples = 128;
  std::vector<double> d;
  for (int i = 0; i <= kSamples; ++i) d.push_back(distance(point_H(i / double{kSamples}), f));
  double best = *std::min_element(d.begin(), d.end());
  if (*std::max_element(d.begin(), d.end()) == best) return best - radius;  // a ball
  for (int i = 0; i <= kSamples; ++i) {
    if (d[static_cast<size_t>(i)] > best + 15e-6) continue;
    double a = std::max(0, i - 1) / double{kSamples}, b = std::min(kSamples, i + 1) / double{kSamples};
    for (int k = 0; k < 40; ++k) {
      const double c = b - 0.6180339887498949 * (b - a), e = a + 0.6180339887498949 * (b - a);
      (distance(point_H(c), f) < distance(point_H(e), f) ? b : a) =
          distance(point_H(c), f) < distance(point_H(e), f) ? e : c;
    }
    best = std::min(best, distance(point_H(0.5 * (a + b)), f));
  }
  return best - radius;
}

inline Manifold touch(const Solid& a, const Pose& X_WA, const Solid& b, double margin = 20e-6,
               double flatness = 2e-3) {
  Manifold m;
  Separation none;
  Query query;
  query.margin = margin, query.flatness = flatness;
  collide(a, Frame(X_WA), b, Frame(), query, none, m);
  return m;
}

}  // namespace swage::contact
