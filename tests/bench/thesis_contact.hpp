// SPDX-License-Identifier: Apache-2.0
//
// Collision detection of the thesis, sections 4.2.1 to 4.2.8, equation by equation. Table 6-1
// is measured with it; where the printed text takes a shortcut, the comment says which and what is done here.
//
// Units: m. Frames: one for all arguments. Threads: any; nothing allocates or throws.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "toolkit/math.hpp"

namespace swage::contact::thesis {

using toolkit::Vec3;

/// (4.17) Penetration of two spheres, gamma = (r1 + r2) - |p2 - p1|; they collide when it is not negative.
inline double sphere_sphere(const Vec3& p1, double r1, const Vec3& p2, double r2) {
  return r1 + r2 - (p2 - p1).norm();
}

/// A sphere's closest place on something, and how far away.
struct Nearest {
  Vec3 p_c = Vec3::Zero();
  double distance = 0;
};

/// 4.2.2 Sphere at p0 and the edge from p1 to p2. With v20 = p0 - p2 and v21 the unit vector from p2 to p1 (the printed
/// text compares v20 . v21 with |v21|, which is right only if v21 is unit on one side and whole on the other):
///   |n| = |v20 - (v20 . v21) v21|   (4.18)     p_c = p2 + (v20 . v21) v21   (4.19)
/// within the edge, else the nearer end. They collide when the distance is not above the radius.
inline Nearest sphere_edge(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const Vec3 v20 = p0 - p2;
  const double length = (p1 - p2).norm();
  const Vec3 v21 = (p1 - p2) / length;
  const double along = v20.dot(v21);
  if (along < 0) return {p2, v20.norm()};
  if (along > length) return {p1, (p0 - p1).norm()};
  return {p2 + along * v21, (v20 - along * v21).norm()};
}

/// (4.20), (4.21) Distance of p0 to the plane r_p . n = c: s = p0 . n - c. A sphere collides when s <= r0.
inline double sphere_plane(const Vec3& p0, const Vec3& n, double c) { return p0.dot(n) - c; }

/// A planar surface bounded by three or more edges, counter-clockwise about n.
struct Polygon {
  std::span<const Vec3> vertex;
  Vec3 n = Vec3::UnitZ();
  double c = 0;  // m: n . p = c on it
};

/// (4.22) Whether the projection of p lies in the polygon: (v_x x v_x+1) . n > 0 for the vectors from p to successive
/// vertices. The border counts as inside.
inline bool point_in_polygon(const Vec3& p, const Polygon& polygon) {
  const size_t count = polygon.vertex.size();
  for (size_t i = 0; i < count; ++i) {
    const Vec3 v_x = polygon.vertex[i] - p, v_x1 = polygon.vertex[(i + 1) % count] - p;
    if (v_x.cross(v_x1).dot(polygon.n) < 0) return false;
  }
  return true;
}

/// 4.2.5 Sphere and polygon: plane, then inside, then all edges. The closest place while they collide. A sphere behind
/// the plane by more than its radius is beyond it.
inline std::optional<Nearest> sphere_polygon(const Vec3& p0, double r0, const Polygon& polygon) {
  const double s = sphere_plane(p0, polygon.n, polygon.c);
  if (std::abs(s) > r0) return {};
  if (point_in_polygon(p0, polygon)) return Nearest{p0 - s * polygon.n, s};
  Nearest nearest{p0, r0};
  bool hit = false;
  for (size_t i = 0; i < polygon.vertex.size(); ++i) {
    const Nearest edge = sphere_edge(p0, polygon.vertex[i], polygon.vertex[(i + 1) % polygon.vertex.size()]);
    if (edge.distance <= nearest.distance) nearest = edge, hit = true;
  }
  return hit ? std::optional(nearest) : std::nullopt;
}

/// (4.23) A sphere that was over the polygon at displacement u0 > 0 and is now behind it at u1 < 0, over the polygon both
/// times, met it at about t_c = t0 + |u0| / (|u0| + |u1|) dt. Nothing when it did not pass.
inline std::optional<double> dynamic_sphere_polygon(const Vec3& p0, const Polygon& before, const Vec3& p1,
                                                    const Polygon& after, double t0, double dt) {
  const double u0 = sphere_plane(p0, before.n, before.c), u1 = sphere_plane(p1, after.n, after.c);
  if (!(u0 > 0 && u1 < 0) || !point_in_polygon(p0, before) || !point_in_polygon(p1, after)) return {};
  return t0 + std::abs(u0) / (std::abs(u0) + std::abs(u1)) * dt;
}

/// Parameters of the closest points p0 + s u and q0 + t v, and their connection w = p - q.
struct ClosestPair {
  double s = 0, t = 0;
  Vec3 w = Vec3::Zero();
};

/// (4.25) to (4.33) Two infinite lines. Parallel ones (the determinant below 1e-16 of its terms) get s = 0.
inline ClosestPair line_line(const Vec3& p0, const Vec3& u, const Vec3& q0, const Vec3& v) {
  const Vec3 w0 = p0 - q0;
  const double uu = u.dot(u), vv = v.dot(v), uv = u.dot(v), uw = u.dot(w0), vw = v.dot(w0);
  const double det = uu * vv - uv * uv;
  const bool parallel = det <= 1e-16 * uu * vv;
  const double s_c = parallel ? 0 : (uv * vw - vv * uw) / det;  // (4.32)
  const double t_c = (vw + uv * s_c) / vv;                      // (4.33), as (4.29) gives it from s_c
  return {s_c, t_c, w0 + s_c * u - t_c * v};
}

/// (4.34) to (4.36) Two edges, s and t in 0..1: the minimum of |w|^2 on the unit square, which is that of the lines when it
/// lies inside and else the least of the minima on the four sides (the text looks at the visible ones only).
inline ClosestPair edge_edge(const Vec3& p0, const Vec3& u, const Vec3& q0, const Vec3& v) {
  const Vec3 w0 = p0 - q0;
  ClosestPair best = line_line(p0, u, q0, v);
  if (best.s >= 0 && best.s <= 1 && best.t >= 0 && best.t <= 1) return best;
  double least = 1e300;
  const auto consider = [&](double s, double t) {
    const Vec3 w = w0 + s * u - t * v;
    if (w.squaredNorm() < least) least = w.squaredNorm(), best = {s, t, w};
  };
  for (const double end : {0.0, 1.0}) {
    consider(end, std::clamp(v.dot(w0 + end * u) / v.dot(v), 0.0, 1.0));   // (4.36), d/dt = 0 at s = end
    consider(std::clamp(-u.dot(w0 - end * v) / u.dot(u), 0.0, 1.0), end);  // d/ds = 0 at t = end
  }
  return best;
}

}  // namespace swage::contact::thesis
