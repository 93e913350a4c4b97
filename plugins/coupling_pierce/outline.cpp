// SPDX-License-Identifier: Apache-2.0
#include "outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace swage::coupling_pierce {
namespace {

constexpr int kCorners = Polygon::kCorners;
constexpr int kHalf = kCorners / 2;  // corners of a half circle

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

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

bool apart(const Polygon& p, const Vec2& low, const Vec2& high) {
  return p.high.x() < low.x() || p.high.y() < low.y() || high.x() < p.low.x() || high.y() < p.low.y();
}

/// An edge of a polygon, or a piece of one.
struct Edge {
  Vec2 a, b;

  /// Twice the area between the origin and the stretch [from, upto] of the edge.
  double swept(double from, double upto) const { return (upto - from) * cross(a, b - a); }
  Vec2 at(double t) const { return a + t * (b - a); }
};

Edge edge(const Polygon& p, int k) { return {p.corner[k], p.corner[(k + 1) % kCorners]}; }

/// Whether an edge is wholly inside a polygon, or surely outside; else it must be clipped, at ten times the cost.
enum class Lies { kInside, kOutside, kPartly };
Lies lies(const Polygon& q, const Edge& e) {
  if (apart(q, e.a.cwiseMin(e.b), e.a.cwiseMax(e.b))) return Lies::kOutside;
  const double far2 = q.line.distance2(0.5 * (e.a + e.b)), half = 0.5 * (e.b - e.a).norm();
  const double beyond = q.outer + half, within = q.inner - half;
  if (far2 > beyond * beyond) return Lies::kOutside;
  return within > 0 && far2 < within * within ? Lies::kInside : Lies::kPartly;
}

struct Stretch {
  double from, upto;
};

/// Finds the stretch of an edge inside a convex polygon; `edge_counts`: the border belongs to the polygon. False: there is none.
bool clip(const Polygon& q, const Edge& e, bool edge_counts, Stretch& s) {
  const double slack = (edge_counts ? 1e-12 : -1e-12) * q.size2;
  s = {0, 1};
  for (int i = 0; i < kCorners; ++i) {
    const double border = q.beside[i] - slack;
    const double at_a = cross(q.side[i], e.a) - border, at_b = cross(q.side[i], e.b) - border;
    if (at_a >= 0 && at_b >= 0) continue;
    if (at_a < 0 && at_b < 0) return false;
    if (at_a < 0) s.from = std::max(s.from, at_a / (at_a - at_b));
    if (at_b < 0) s.upto = std::min(s.upto, at_a / (at_a - at_b));
    if (s.from >= s.upto) return false;
  }
  return true;
}

/// Finds the stretch of an edge that a polygon covers; false: none.
bool covers(const Polygon& q, const Edge& e, bool edge_counts, Stretch& s) {
  const Lies place = lies(q, e);
  s = {0, 1};
  return place == Lies::kInside || (place == Lies::kPartly && clip(q, e, edge_counts, s));
}

/// Stretches of an edge that polygons cover.
class Cover {
 public:
  /// Adds the cover by one polygon; `edge_counts`: the border belongs to it. False: no part of the edge is left.
  bool by(const Polygon& polygon, const Edge& e, bool edge_counts) {
    Stretch s;
    if (!covers(polygon, e, edge_counts, s)) return true;
    if (s.from <= 0 && s.upto >= 1) return false;
    uint32_t k = size_++;
    for (; k > 0 && stretch_[k - 1].from > s.from; --k) stretch_[k] = stretch_[k - 1];
    stretch_[k] = s;
    return true;
  }
  /// Calls f(from, upto) for each stretch that is not covered.
  template <class F>
  void rest(F&& f) const {
    double at = 0;
    for (uint32_t k = 0; k < size_; ++k) {
      if (stretch_[k].from > at) f(at, stretch_[k].from);
      at = std::max(at, stretch_[k].upto);
    }
    if (at < 1) f(at, 1.0);
  }

 private:
  Stretch stretch_[Outline::kMost];
  uint32_t size_ = 0;
};

/// Calls f(edge, from, upto) for the parts of a polygon's edges that n others leave uncovered; the others' borders belong to them.
template <class F>
void uncovered(const Polygon& polygon, const Polygon* const* other, uint32_t n, F&& f) {
  for (int k = 0; k < kCorners; ++k) {
    const Edge e = edge(polygon, k);
    Cover cover;
    uint32_t j = 0;
    while (j < n && cover.by(*other[j], e, true)) ++j;
    if (j == n) cover.rest([&](double from, double upto) { f(e, from, upto); });
  }
}

/// Writes those of n polygons that a further one may touch; returns their number.
uint32_t near(const Polygon& polygon, const Polygon* other, uint32_t n, const Polygon** out) {
  uint32_t m = 0;
  for (uint32_t i = 0; i < n; ++i)
    if (!apart(other[i], polygon.low, polygon.high)) out[m++] = &other[i];
  return m;
}

}  // namespace

Line::Line(const Capsule& c) : from(c.a[0], c.a[1]), along(c.b[0] - c.a[0], c.b[1] - c.a[1]) {
  const double length2 = along.squaredNorm();
  if (length2 > 0) per_length2 = 1 / length2;
}

double Line::distance2(const Vec2& p) const {
  const double t = std::clamp((p - from).dot(along) * per_length2, 0.0, 1.0);
  return (p - from - t * along).squaredNorm();
}

Polygon::Polygon(const Capsule& capsule, double radius) : line(capsule) {
  const Vec2 a = line.from, b = a + line.along;
  const double length = line.along.norm(), r = corner_radius(radius);
  const Vec2 e = length > 0 ? Vec2(line.along / length) : Vec2(1, 0), f(-e.y(), e.x());
  for (int i = 0; i < kHalf; ++i) {
    const Vec2& at = kHalfCircle[static_cast<size_t>(i)];
    const Vec2 out = r * (at.x() * e + at.y() * f);
    corner[i] = b + out;
    corner[kHalf + i] = a - out;
  }
  for (int i = 0; i < kCorners; ++i) {
    side[i] = corner[(i + 1) % kCorners] - corner[i];
    beside[i] = cross(side[i], corner[i]);
  }
  constexpr double kHair = 1e-9;  // bound of the rounding error, over the radius
  low = a.cwiseMin(b) - Vec2::Constant((1 + kHair) * r);
  high = a.cwiseMax(b) + Vec2::Constant((1 + kHair) * r);
  inner = (std::cos(std::numbers::pi / kCorners) - kHair) * r;
  outer = (1 + kHair) * r;
  size2 = (0.5 * length + r) * (0.5 * length + r);
}

void Outline::follow(const Capsule* capsule, uint32_t n, double radius) noexcept {
  const bool goes_on =
      n_ <= n && radius_ == radius && std::memcmp(capsule_, capsule, n_ * sizeof(Capsule)) == 0;
  if (!goes_on) n_ = n_piece_ = 0;
  radius_ = radius;
  while (n_ < n) insert(capsule[n_], radius);
}

/// Removes the pieces that a polygon covers; its border does not cover.
void Outline::cut(const Polygon& polygon) noexcept {
  uint32_t kept = 0, end = n_piece_;
  for (uint32_t i = 0; i < n_piece_; ++i) {
    const Edge e{piece_[i].a, piece_[i].b};
    Stretch s;
    if (!covers(polygon, e, false, s)) {
      piece_[kept++] = piece_[i];
      continue;
    }
    if (s.from > 0) piece_[kept++] = {e.a, e.at(s.from)};
    if (s.upto < 1) piece_[s.from > 0 ? end++ : kept++] = {e.at(s.upto), e.b};
  }
  std::copy(piece_ + n_piece_, piece_ + end, piece_ + kept);
  n_piece_ = kept + end - n_piece_;
}

void Outline::insert(const Capsule& capsule, double radius) noexcept {
  const Polygon polygon(capsule, radius);
  const Polygon* others[kMost];
  const uint32_t m = near(polygon, polygon_, n_, others);
  cut(polygon);
  uncovered(polygon, others, m, [&](const Edge& e, double from, double upto) {
    piece_[n_piece_++] = {e.at(from), e.at(upto)};
  });
  capsule_[n_] = capsule;
  polygon_[n_++] = polygon;
}

double Outline::area() const noexcept {
  double twice = 0;
  for (uint32_t i = 0; i < n_piece_; ++i) twice += cross(piece_[i].a, piece_[i].b);
  return 0.5 * twice;
}

double Outline::added(const Capsule& capsule, double radius) const noexcept {
  const Polygon polygon(capsule, radius);
  const Polygon* others[kMost];
  const uint32_t m = near(polygon, polygon_, n_, others);
  double twice = 0;
  uncovered(polygon, others, m,
            [&](const Edge& e, double from, double upto) { twice += e.swept(from, upto); });
  for (uint32_t i = 0; i < n_piece_; ++i) {
    const Edge e{piece_[i].a, piece_[i].b};
    Stretch s;
    if (covers(polygon, e, false, s)) twice -= e.swept(s.from, s.upto);
  }
  return 0.5 * twice;
}

double union_area(const Capsule* capsule, uint32_t n, double radius) noexcept {
  double twice = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const Polygon polygon(capsule[i], radius);
    for (int k = 0; k < kCorners; ++k) {
      const Edge e = edge(polygon, k);
      Cover cover;
      bool left = true;
      for (uint32_t j = 0; left && j < n; ++j)
        left = j == i || cover.by(Polygon(capsule[j], radius), e, j < i);
      if (left) cover.rest([&](double from, double upto) { twice += e.swept(from, upto); });
    }
  }
  return 0.5 * twice;
}

}  // namespace swage::coupling_pierce
