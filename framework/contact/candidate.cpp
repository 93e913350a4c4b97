// SPDX-License-Identifier: Apache-2.0
#include "contact/candidate.hpp"

#include "toolkit/segment.hpp"

namespace swage::contact {
namespace {

using toolkit::ArcLine;
using toolkit::Segment;
using toolkit::Turn;

/// A feature with its points and directions in the world frame.
struct Carrier {
  Feature::Kind kind;
  Vec3 p, u, v;
  const Feature& feature;

  Carrier(const Feature& f, const Frame& X_WB)
      : kind(f.kind), p(X_WB * f.p), u(Vec3::Zero()), v(Vec3::Zero()), feature(f) {
    if (kind != Feature::kPoint) u = X_WB.turn(f.u);
    if (kind == Feature::kCircle) v = X_WB.turn(f.v);
  }
  Vec3 on_circle(Turn e) const { return p + feature.radius * (e.c * u + e.s * v); }
};

/// Whether e lies within the interval of the feature.
bool inside(const Feature& f, Turn e) {
  const auto follows = [](Turn a, Turn b) { return a.c * b.s >= a.s * b.c; };
  return follows(f.from, e) && follows(e, f.upto);
}

/// e, clamped to the interval of the feature.
Turn within(const Feature& f, Turn e) {
  if (inside(f, e)) return e;
  return e.c * f.from.c + e.s * f.from.s >= e.c * f.upto.c + e.s * f.upto.s ? f.from : f.upto;
}

Vec3 lowest_on_circle(const Carrier& circle, const Vec3& n) {
  const Feature& f = circle.feature;
  const Turn e = Turn::along(-n.dot(circle.u), -n.dot(circle.v), f.e);
  // an arc that is convex away from the face is lowest at one of its ends: the end where the contact was found
  const bool arches = e.c * f.e.c + e.s * f.e.s < 0;
  return circle.on_circle(within(f, arches && !inside(f, e) ? f.e : e));
}

Vec3 closest_on_circle(const Carrier& circle, const Vec3& p) {
  const Vec3 w = p - circle.p;
  const Turn e = Turn::along(w.dot(circle.u), w.dot(circle.v), circle.feature.e);
  return circle.on_circle(within(circle.feature, e));
}

struct PointPair {
  Vec3 a, b;
};

PointPair segment_segment(const Carrier& a, const Carrier& b) {
  const Segment p{a.p, a.p + a.u}, q{b.p, b.p + b.u};
  const toolkit::SegmentPair pair = closest(p, q);
  return {p.point(pair.s), q.point(pair.t)};
}

PointPair circle_segment(const Carrier& circle, const Carrier& segment) {
  const Feature& f = circle.feature;
  const double length = segment.u.norm();
  const Vec3 u = segment.u / length;
  const ArcLine g(circle.p - segment.p, circle.u, circle.v, f.radius, u);

  // closest point to the line of the edge, near the point where the contact was found
  const Turn e = within(f, toolkit::minimum_near(g, f.e));

  // beyond an end of the segment that end is the closest point
  const double t = g.along(e);
  if (t >= 0 && t <= length) return {circle.on_circle(e), segment.p + t * u};
  const Vec3 end = t < 0 ? segment.p : Vec3(segment.p + segment.u);
  return {closest_on_circle(circle, end), end};
}

/// Two arcs: the minimum near the touching places. Beyond the end of a stretch, the nearest pair of those that the end and
/// alternating projections from the touching place give.
PointPair circle_circle(const Carrier& a, const Carrier& b) {
  const auto circle = [](const Carrier& c) {
    toolkit::Arc arc;
    arc.centre = c.p, arc.x = c.u, arc.y = c.v, arc.radius = c.feature.radius;
    return arc;
  };
  const toolkit::ArcPair at = minimum_near(circle(a), circle(b), {a.feature.e, b.feature.e});
  PointPair best{a.on_circle(within(a.feature, at.a)), b.on_circle(within(b.feature, at.b))};
  if (inside(a.feature, at.a) && inside(b.feature, at.b)) return best;

  const auto consider = [&](const Vec3& on_a, const Vec3& on_b) {
    if ((on_a - on_b).squaredNorm() < (best.a - best.b).squaredNorm()) best = {on_a, on_b};
  };
  consider(best.a, closest_on_circle(b, best.a));
  consider(closest_on_circle(a, best.b), best.b);
  Vec3 on_a = a.on_circle(a.feature.e);
  for (int i = 0; i < 8; ++i) {
    const Vec3 on_b = closest_on_circle(b, on_a);
    on_a = closest_on_circle(a, on_b);
    consider(on_a, on_b);
  }
  return best;
}

/// Closest points of two curves; kind(a) <= kind(b).
PointPair ordered_closest(const Carrier& a, const Carrier& b) {
  if (b.kind == Feature::kPoint) return {a.p, b.p};
  if (a.kind == Feature::kPoint && b.kind == Feature::kSegment) {
    const Segment segment{b.p, b.p + b.u};
    return {a.p, segment.point(closest(segment, a.p))};
  }
  if (a.kind == Feature::kPoint) return {a.p, closest_on_circle(b, a.p)};
  if (b.kind == Feature::kSegment) return segment_segment(a, b);
  if (a.kind == Feature::kCircle) return circle_circle(a, b);
  const PointPair swapped = circle_segment(b, a);
  return {swapped.b, swapped.a};
}

/// Point of `body` that is deepest below the plane.
Vec3 lowest(const Carrier& body, const Vec3& n) {
  if (body.kind == Feature::kCircle) return lowest_on_circle(body, n);
  if (body.kind == Feature::kSegment && n.dot(body.u) < 0) return body.p + body.u;
  return body.p;
}

}  // namespace

Touch reevaluate(const Candidate& candidate, const Frame& X_WA, const Frame& X_WB) noexcept {
  const Carrier a(candidate.a, X_WA), b(candidate.b, X_WB);
  const double tubes = candidate.a.tube + candidate.b.tube;
  Touch touch;
  Vec3 pa, pb;
  double distance;

  // a face: its normal is the normal of the contact
  if (b.kind == Feature::kPlane) {
    touch.n_W = b.u;
    pa = lowest(a, b.u);
    distance = b.u.dot(pa - b.p);
    pb = pa - distance * b.u;
  } else if (a.kind == Feature::kPlane) {
    touch.n_W = -a.u;
    pb = lowest(b, a.u);
    distance = a.u.dot(pb - a.p);
    pa = pb - distance * a.u;
  } else {
    // two curves: the normal is the shortest connection, with its sign as when the contact was found
    const PointPair pair = a.kind <= b.kind ? ordered_closest(a, b) : [&] {
      const PointPair swapped = ordered_closest(b, a);
      return PointPair{swapped.b, swapped.a};
    }();
    pa = pair.a, pb = pair.b;
    const Vec3 n_found_W = X_WB.turn(candidate.n_B);
    const Vec3 w = pa - pb;
    const double sign = w.dot(n_found_W) < 0 ? -1.0 : 1.0;
    const double d = w.norm();
    distance = sign * d;
    touch.n_W = d > 1e-6 * tubes ? Vec3((sign / d) * w) : n_found_W;
  }
  touch.gap = distance - tubes;
  touch.p_W = pb + (candidate.b.tube + 0.5 * touch.gap) * touch.n_W;
  return touch;
}

}  // namespace swage::contact
