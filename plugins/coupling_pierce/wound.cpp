// SPDX-License-Identifier: Apache-2.0
#include "wound.hpp"

#include <algorithm>
#include <array>
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

/// Corners of a half circle about the x axis, half a side away from its ends, so that two make a regular 24-gon.
const std::array<Vec2, kHalf> kHalfCircle = [] {
  std::array<Vec2, kHalf> corner;
  for (size_t i = 0; i < corner.size(); ++i) {
    const double angle = std::numbers::pi * ((static_cast<double>(i) + 0.5) / kHalf - 0.5);
    corner[i] = {std::cos(angle), std::sin(angle)};
  }
  return corner;
}();

/// The middle line of a capsule.
struct Line {
  Vec2 from, along;
  double per_length2;  // 1/m2

  Line(const Vec2& a, const Vec2& b) : from(a), along(b - a), per_length2(0) {
    const double length2 = along.squaredNorm();
    if (length2 > 0) per_length2 = 1 / length2;
  }
  double distance2(const Vec2& p) const {
    const double t = std::clamp((p - from).dot(along) * per_length2, 0.0, 1.0);
    return (p - from - t * along).squaredNorm();
  }
};

/// A capsule as a convex polygon, counter-clockwise. Within `inner` of its middle line everything is inside, beyond
/// `outer` nothing.
struct Polygon {
  Vec2 corner[kCorners];
  Line line{Vec2::Zero(), Vec2::Zero()};
  Vec2 middle;
  double bound = 0, inner = 0, outer = 0;  // m
};

Polygon polygon(const Wound::Capsule& c, double radius) {
  const Vec2 a = vec2(c.a), b = vec2(c.b), along = b - a;
  const double length = along.norm(), r = corner_radius(radius);
  const Vec2 e = length > 0 ? Vec2(along / length) : Vec2(1, 0), f(-e.y(), e.x());
  Polygon p;
  for (int i = 0; i < kHalf; ++i) {
    const Vec2& at = kHalfCircle[static_cast<size_t>(i)];
    const Vec2 out = r * (at.x() * e + at.y() * f);
    p.corner[i] = b + out;
    p.corner[kHalf + i] = a - out;
  }
  constexpr double kHair = 1e-9;  // by which rounding may be wrong, of the radius
  p.line = {a, b};
  p.middle = 0.5 * (a + b);
  p.bound = 0.5 * length + r;
  p.inner = (std::cos(std::numbers::pi / kCorners) - kHair) * r;
  p.outer = (1 + kHair) * r;
  return p;
}

bool apart(const Polygon& p, const Polygon& q) { return (p.middle - q.middle).norm() > p.bound + q.bound; }

/// An edge of a polygon.
struct Edge {
  Vec2 a, b, middle;
  double half;  // m, of its length

  Edge(const Vec2& from, const Vec2& to)
      : a(from), b(to), middle(0.5 * (from + to)), half(0.5 * (to - from).norm()) {}
  Edge(const Polygon& p, int k) : Edge(p.corner[k], p.corner[(k + 1) % kCorners]) {}
};

/// Whether an edge lies in a polygon as a whole, or surely nowhere; else it must be clipped, at ten times the price.
enum class Lies { kInside, kOutside, kPartly };
Lies lies(const Polygon& q, const Edge& edge) {
  const double far2 = q.line.distance2(edge.middle), beyond = q.outer + edge.half,
               within = q.inner - edge.half;
  if (far2 > beyond * beyond) return Lies::kOutside;
  return within > 0 && far2 < within * within ? Lies::kInside : Lies::kPartly;
}

/// The stretch [t0, t1] of an edge that lies in a convex polygon; `edge_counts`: its border belongs to it.
bool clip(const Polygon& q, const Edge& edge, bool edge_counts, double& t0, double& t1) {
  const Vec2 &a = edge.a, &b = edge.b;
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

/// What of an edge polygons cover.
class Cover {
 public:
  /// By another polygon; `edge_counts`: its border belongs to it. False: the whole edge.
  bool by(const Polygon& polygon, const Edge& edge, bool edge_counts) {
    const Lies place = lies(polygon, edge);
    if (place == Lies::kInside) return false;
    double t0, t1;
    if (place == Lies::kOutside || !clip(polygon, edge, edge_counts, t0, t1)) return true;
    uint32_t k = size_++;
    for (; k > 0 && stretch_[k - 1].from > t0; --k) stretch_[k] = stretch_[k - 1];
    stretch_[k] = {t0, t1};
    return true;
  }
  /// By all of n but its own. False: the whole edge.
  bool by(const Polygon* polygon, uint32_t n, uint32_t own, const Edge& edge) {
    for (uint32_t j = 0; j < n; ++j)
      if (j != own && !by(polygon[j], edge, j < own)) return false;
    return true;
  }
  /// Contribution to twice the area of what is left of the edge.
  double rest(const Edge& edge) const {
    const Vec2 &a = edge.a, along = edge.b - edge.a;
    double sum = 0, at = 0;
    const auto add = [&](double from, double upto) {
      if (upto > from) sum += cross(a + from * along, a + upto * along);
    };
    for (uint32_t k = 0; k < size_; ++k) {
      add(at, stretch_[k].from);
      at = std::max(at, stretch_[k].upto);
    }
    add(at, 1);
    return sum;
  }

 private:
  struct Stretch {
    double from, upto;
  };
  Stretch stretch_[Wound::kCapsules];
  uint32_t size_ = 0;
};

/// Contribution of an edge to twice the area, where none of the polygons but `own` covers it.
double uncovered(const Polygon* polygon, uint32_t n, uint32_t own, const Edge& edge) {
  Cover cover;
  return cover.by(polygon, n, own, edge) ? cover.rest(edge) : 0;
}

double area_of(const Polygon* polygon, uint32_t n) {
  double twice = 0;
  for (uint32_t i = 0; i < n; ++i)
    for (int k = 0; k < kCorners; ++k) twice += uncovered(polygon, n, i, Edge(polygon[i], k));
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
  for (int k = 0; k < kCorners; ++k) twice += uncovered(near, m + 1, m, Edge(last, k));
  for (uint32_t i = 0; i < m; ++i)
    for (int k = 0; k < kCorners; ++k) {
      const Edge edge(near[i], k);
      if (lies(last, edge) == Lies::kOutside) continue;  // as it was
      Cover cover;
      if (!cover.by(near, m, i, edge)) continue;
      const double before = cover.rest(edge);
      twice += (cover.by(last, edge, false) ? cover.rest(edge) : 0) - before;
    }
  return 0.5 * twice;
}

double distance(const Vec2& p, const Wound::Capsule& c) {
  return std::sqrt(Line(vec2(c.a), vec2(c.b)).distance2(p));
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

/// The way into the tissue: along the needle, whichever of its ends is inside.
void lean_on(Wound& w, const Vec3& along_O) {
  const double side = axis(w, 0).dot(along_O) > 0 ? -1 : 1;
  for (int i = 0; i < 3; ++i) w.inward[i] = side * along_O[i];
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
  lean_on(w, along_O);
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
  lean_on(w, along_O);
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
