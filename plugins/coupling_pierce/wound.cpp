// SPDX-License-Identifier: Apache-2.0
#include "wound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swage::coupling_pierce {
namespace {

constexpr double kFine = 0.02;    // of the radius: what moves less has not moved
constexpr double kCorner = 0.05;  // of the radius: what one capsule may cut off the path that it stands for
constexpr int kHalf = 12;         // corners of a half circle
constexpr int kCorners = 2 * kHalf;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
Vec2 vec2(const double* a) { return {a[0], a[1]}; }

/// Circles as 24-gons of equal area.
double corner_radius(double r) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return r * std::sqrt(kTurn / (kCorners * std::sin(kTurn / kCorners)));
}

/// The middle line of a capsule.
struct Line {
  Vec2 from, along;

  double distance(const Vec2& p) const {
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - from).dot(along) / length2, 0.0, 1.0) : 0;
    return (p - from - t * along).norm();
  }
};

/// A capsule as a convex polygon, counter-clockwise. Within `inner` of its middle line everything is inside, beyond
/// `outer` nothing.
struct Polygon {
  Vec2 corner[kCorners];
  Line line;
  Vec2 middle;
  double bound = 0, inner = 0, outer = 0;  // m
};

Polygon polygon(const Wound::Capsule& c, double radius) {
  const Vec2 a = vec2(c.a), b = vec2(c.b), along = b - a;
  const double length = along.norm(), r = corner_radius(radius);
  const Vec2 e = length > 0 ? Vec2(along / length) : Vec2(1, 0), f(-e.y(), e.x());
  Polygon p;
  for (int i = 0; i < kHalf; ++i) {
    // corners half a side away from the ends of the straight edges, so that a circle is a regular 24-gon
    const double angle = std::numbers::pi * ((i + 0.5) / kHalf - 0.5);
    const Vec2 out = r * (std::cos(angle) * e + std::sin(angle) * f);
    p.corner[i] = b + out;
    p.corner[kHalf + i] = a - out;
  }
  constexpr double kHair = 1e-9;  // by which rounding may be wrong, of the radius
  p.line = {a, along};
  p.middle = 0.5 * (a + b);
  p.bound = 0.5 * length + r;
  p.inner = (std::cos(std::numbers::pi / kCorners) - kHair) * r;
  p.outer = (1 + kHair) * r;
  return p;
}

bool apart(const Polygon& p, const Polygon& q) { return (p.middle - q.middle).norm() > p.bound + q.bound; }

/// Whether an edge lies in a polygon as a whole, or surely nowhere; else it must be clipped, at ten times the price.
enum class Lies { kInside, kOutside, kPartly };
Lies lies(const Polygon& q, const Vec2& a, const Vec2& b) {
  const double far = q.line.distance(0.5 * (a + b)), half = 0.5 * (b - a).norm();
  if (far > q.outer + half) return Lies::kOutside;
  return far + half < q.inner ? Lies::kInside : Lies::kPartly;
}

/// The stretch [t0, t1] of the edge a..b that lies in a convex polygon; `edge_counts`: its border belongs to it.
bool clip(const Polygon& q, const Vec2& a, const Vec2& b, bool edge_counts, double& t0, double& t1) {
  const double slack = (edge_counts ? 1e-12 : -1e-12) * q.bound * q.bound;
  t0 = 0, t1 = 1;
  for (int i = 0; i < kCorners; ++i) {
    const Vec2 &p = q.corner[i], side = q.corner[(i + 1) % kCorners] - p;
    const double at_a = cross(side, a - p) + slack, at_b = cross(side, b - p) + slack;
    if (at_a < 0 && at_b < 0) return false;
    if (at_a < 0) t0 = std::max(t0, at_a / (at_a - at_b));
    if (at_b < 0) t1 = std::min(t1, at_a / (at_a - at_b));
    if (t0 >= t1) return false;
  }
  return true;
}

/// Contribution of the edge a..b to twice the area, where none of the polygons but `own` covers it.
double uncovered(const Polygon* polygon, uint32_t n, uint32_t own, const Vec2& a, const Vec2& b) {
  struct Stretch {
    double from, upto;
  } covered[Wound::kCapsules];
  uint32_t m = 0;
  for (uint32_t j = 0; j < n; ++j) {
    if (j == own) continue;
    const Lies place = lies(polygon[j], a, b);
    if (place == Lies::kInside) return 0;
    if (place == Lies::kOutside) continue;
    double t0, t1;
    if (clip(polygon[j], a, b, j < own, t0, t1)) covered[m++] = {t0, t1};
  }
  std::sort(covered, covered + m, [](const Stretch& x, const Stretch& y) { return x.from < y.from; });
  double sum = 0, at = 0;
  const auto add = [&](double from, double upto) {
    if (upto > from) sum += cross(a + from * (b - a), a + upto * (b - a));
  };
  for (uint32_t k = 0; k < m; ++k) {
    add(at, covered[k].from);
    at = std::max(at, covered[k].upto);
  }
  add(at, 1);
  return sum;
}

double area_of(const Polygon* polygon, uint32_t n) {
  double twice = 0;
  for (uint32_t i = 0; i < n; ++i)
    for (int k = 0; k < kCorners; ++k)
      twice += uncovered(polygon, n, i, polygon[i].corner[k], polygon[i].corner[(k + 1) % kCorners]);
  return 0.5 * twice;
}

/// What the last capsule adds to the union of those before it: only what lies near it matters.
double added(const Wound& w) {
  const auto n = static_cast<uint32_t>(w.count);
  Polygon near[Wound::kCapsules];
  const Polygon last = polygon(w.capsule[n - 1], w.radius);
  uint32_t m = 0;
  for (uint32_t i = 0; i + 1 < n; ++i) {
    near[m] = polygon(w.capsule[i], w.radius);
    if (!apart(near[m], last)) ++m;
  }
  near[m] = last;
  double twice = 0;
  for (int k = 0; k < kCorners; ++k)
    twice += uncovered(near, m + 1, m, last.corner[k], last.corner[(k + 1) % kCorners]);
  for (uint32_t i = 0; i < m; ++i)
    for (int k = 0; k < kCorners; ++k) {
      const Vec2 &a = near[i].corner[k], &b = near[i].corner[(k + 1) % kCorners];
      if (lies(last, a, b) == Lies::kOutside) continue;  // as it was
      const double before = uncovered(near, m, i, a, b);
      if (before != 0) twice += uncovered(near, m + 1, i, a, b) - before;
    }
  return 0.5 * twice;
}

double distance(const Vec2& p, const Wound::Capsule& c) {
  return Line{vec2(c.a), vec2(c.b) - vec2(c.a)}.distance(p);
}

/// Adds the capsule from a to b; `goes_on`: a path that may lengthen the last one.
void cover(Wound& w, const Vec2& a, const Vec2& b, bool goes_on) {
  const double fine = kFine * w.radius;
  auto n = static_cast<uint32_t>(w.count);
  for (uint32_t i = 0; i < n; ++i)
    if (distance(a, w.capsule[i]) < fine && distance(b, w.capsule[i]) < fine) return;

  Wound::Capsule next{{a.x(), a.y()}, {b.x(), b.y()}};
  Wound::Capsule* last = n > 0 ? &w.capsule[n - 1] : nullptr;
  bool longer = false;
  if (goes_on && last != nullptr && (vec2(last->b) - a).norm() < fine) {
    Wound::Capsule whole = *last;
    whole.b[0] = b.x(), whole.b[1] = b.y();
    const double corner = w.bend + distance(vec2(last->b), whole);
    longer = corner < kCorner * w.radius || n == Wound::kCapsules;
    if (longer) *last = whole, w.bend = corner;
  }
  if (!longer && n == Wound::kCapsules) {  // no room: the last one reaches there
    last->b[0] = b.x(), last->b[1] = b.y();
    longer = true;
  }
  if (!longer) {
    w.settled = w.area;
    w.capsule[n] = next;
    w.count = ++n;
    w.bend = 0;
  }
  w.area = std::max(w.area, w.settled + added(w));
  w.reach = std::max({w.reach, a.norm() + w.radius, b.norm() + w.radius});
}

}  // namespace

void open_wound(Wound& w, const Vec3& p_O, const Vec3& normal_O, const Vec3& along_O,
                double radius) noexcept {
  w = {};
  w.open = 1;
  w.radius = radius;
  const Vec3 flat = along_O - normal_O.dot(along_O) * normal_O;
  const Vec3 first = flat.norm() > 1e-9 ? Vec3(flat.normalized()) : Vec3(normal_O.unitOrthogonal());
  for (int i = 0; i < 3; ++i) w.origin[i] = p_O[i], w.normal[i] = normal_O[i], w.first[i] = first[i];
  cover(w, Vec2::Zero(), Vec2::Zero(), false);
}

void sweep(Wound& w, const Vec3& p_O, double cosine, const Vec3& along_O) noexcept {
  const Vec3 r = p_O - origin(w);
  const Vec2 centre(axis(w, 1).dot(r), axis(w, 2).dot(r)), before = vec2(w.centre);
  const double fine = kFine * w.radius;
  if ((centre - before).norm() > fine) {
    cover(w, before, centre, true);
    w.centre[0] = centre.x(), w.centre[1] = centre.y();
  }
  // the section of a leaning wire is longer by 1/cosine; a needle that lies flat is no section any more
  const Vec2 lean(axis(w, 1).dot(along_O), axis(w, 2).dot(along_O));
  const double length = lean.norm(), longer = w.radius * (1 / std::max(cosine, 0.2) - 1);
  if (length > 1e-9 && longer > 2 * fine) {
    const Vec2 d = longer / length * lean;
    cover(w, centre - d, centre + d, false);
  }
}

double union_area(const Wound& w, uint32_t n) noexcept {
  Polygon all[Wound::kCapsules];
  for (uint32_t i = 0; i < n; ++i) all[i] = polygon(w.capsule[i], w.radius);
  return area_of(all, n);
}

}  // namespace swage::coupling_pierce
