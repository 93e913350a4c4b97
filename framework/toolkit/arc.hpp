// SPDX-License-Identifier: Apache-2.0
//
// A circular arc and its places closest to others, without trigonometric functions: a place on the arc is a unit
// vector (c, s) in its plane, so only +, -, *, / and sqrt are used and every machine gets the same bits.
// Header-only.
#pragma once

#include <algorithm>
#include <cmath>

#include "toolkit/math.hpp"
#include "toolkit/segment.hpp"

namespace swage::toolkit {

/// A direction in the plane of an arc: (c, s) = (cos, sin) of the angle from the arc's start.
struct Turn {
  double c = 1, s = 0;

  /// Grows with the angle: 0 at 0, 1 at 90 deg, 2 at 180 deg, up to 4. One division instead of an arctangent.
  double order() const {
    const double t = s / (std::abs(c) + std::abs(s));
    return c < 0 ? 2 - t : s < 0 ? 4 + t : t;
  }
  double angle() const {
    const double a = std::atan2(s, c);
    return a < 0 ? a + 2 * M_PI : a;
  }
  /// The unit vector along (x, y), or `otherwise` when that has no direction.
  static Turn along(double x, double y, Turn otherwise) {
    const double n = std::sqrt(x * x + y * y);
    if (!(n > 0)) return otherwise;
    const double scale = 1 / n;
    return {scale * x, scale * y};
  }
  /// The direction of e + step e', e' the tangent: a turn by atan(step). For short steps by the series of
  /// 1 / sqrt(1 + step^2), exact to rounding below step^2 = 1e-5.
  Turn stepped(double step) const {
    const double x = c - step * s, y = s + step * c, q = step * step;
    if (q > 1e-5) return along(x, y, *this);
    const double scale = 1 - q * (0.5 - q * (0.375 - q * 0.3125));
    return {scale * x, scale * y};
  }
};

/// Centre line of a bent wire: centre + radius (c x + s y), angle from 0 to sweep.
struct Arc {
  Vec3 centre = Vec3::Zero();                 // m
  Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();  // unit, in the plane: towards the start, and a quarter turn on
  double radius = 0;                          // m
  double sweep = 0;                           // rad, (0, 2 pi)
  Turn end;                                   // the turn `sweep`
  double end_order = 0;                       // end.order()

  Arc() = default;
  /// Centre line of `sweep` about the z axis of X_FA, starting on its x axis; result in F.
  Arc(const Pose& X_FA, double arc_radius, double arc_sweep)
      : centre(X_FA.p),
        x(X_FA.q * Vec3::UnitX()),
        y(X_FA.q * Vec3::UnitY()),
        radius(arc_radius),
        sweep(arc_sweep),
        end{std::cos(arc_sweep), std::sin(arc_sweep)},
        end_order(end.order()) {}

  double length() const { return radius * sweep; }
  Vec3 normal() const { return x.cross(y); }
  Vec3 point(Turn e) const { return centre + radius * (e.c * x + e.s * y); }
  Vec3 tangent(Turn e) const { return e.c * y - e.s * x; }

  /// Place at arc coordinate s: 0 at the start, 1 at the end.
  Turn at(double s) const { return {std::cos(s * sweep), std::sin(s * sweep)}; }
  /// Arc coordinate of a place on the arc.
  double coordinate(Turn e) const { return std::min(e.angle() / sweep, 1.0); }
  bool contains(Turn e) const { return e.order() <= end_order; }
};

/// Height of the arc above a plane: h(e) = h0 + hx c + hy s.
struct ArcHeight {
  double h0 = 0, hx = 0, hy = 0;

  ArcHeight() = default;
  ArcHeight(double constant, double along_x, double along_y) : h0(constant), hx(along_x), hy(along_y) {}
  /// Height above the plane n . p = d.
  ArcHeight(const Arc& arc, const Vec3& n, double d)
      : h0(n.dot(arc.centre) - d), hx(arc.radius * n.dot(arc.x)), hy(arc.radius * n.dot(arc.y)) {}

  double at(Turn e) const { return h0 + hx * e.c + hy * e.s; }
  double slope(Turn e) const { return hy * e.c - hx * e.s; }  // dh / d angle
};

/// The end of the arc at which `distance`, the caller's distance to a plane, line or point, is smaller;
/// the start where both are equal.
template <class Distance>
Turn nearer_end(const Arc& arc, const Distance& distance) {
  return distance(Turn{}) <= distance(arc.end) ? Turn{} : arc.end;
}

/// Lowest place of the arc along n: h is a sinusoid, least opposite to (hx, hy), or at an end.
inline Turn lowest(const Arc& arc, const Vec3& n) {
  const ArcHeight h(arc, n, 0);
  const Turn bottom = Turn::along(-h.hx, -h.hy, Turn{});
  return arc.contains(bottom) ? bottom : nearer_end(arc, [&](Turn e) { return h.at(e); });
}

/// Closest place to the point p: along the projection of p on the plane, or an end.
inline Turn closest(const Arc& arc, const Vec3& p) {
  const Vec3 w = p - arc.centre;
  const Turn e = Turn::along(w.dot(arc.x), w.dot(arc.y), Turn{});
  return arc.contains(e) ? e : nearer_end(arc, [&](Turn end) { return (arc.point(end) - p).squaredNorm(); });
}

/// Squared distance of an arc to an infinite line, divided by twice the radius, as a function of the turn.
/// With k = centre - q, q on the line and u its direction, and the components kx, ky, ux, uy in the arc's
/// plane:
///   g(e) = (|w|^2 - (w . u)^2) / 2R,   w = k + R e
///   g' = c ky - s kx - a b,   a = w . u = ku + R (c ux + s uy),   b = c uy - s ux
///   g'' = -c kx - s ky - R b^2 + a (c ux + s uy)
/// Seen along the line the arc is an ellipse with axes along (ux, uy) and across it; between two axes, g has
/// at most one minimum and one maximum.
struct ArcLine {
  double kx = 0, ky = 0, ku = 0, ux = 0, uy = 0, R = 0;

  ArcLine() = default;
  ArcLine(const Vec3& k, const Vec3& x, const Vec3& y, double radius, const Vec3& u)
      : kx(k.dot(x)), ky(k.dot(y)), ku(k.dot(u)), ux(u.dot(x)), uy(u.dot(y)), R(radius) {}
  ArcLine(const Arc& arc, const Vec3& q, const Vec3& u)
      : ArcLine(arc.centre - q, arc.x, arc.y, arc.radius, u) {}
  /// Place along the line, from q in units of |u| = 1, of the foot of the arc's point.
  double along(Turn e) const { return ku + R * (e.c * ux + e.s * uy); }
  double slope(Turn e) const { return e.c * ky - e.s * kx - along(e) * (e.c * uy - e.s * ux); }
  double curvature(Turn e) const {
    const double b = e.c * uy - e.s * ux;
    return -e.c * kx - e.s * ky - R * b * b + along(e) * (e.c * ux + e.s * uy);
  }
};

/// The zero of the slope between `lo` (slope < 0) and `hi` (slope >= 0), less than half a turn apart: Newton
/// from `guess`, bisection of the angle whenever Newton leaves the bracket or curvature is not positive.
/// Converged to rounding.
inline Turn minimum_between(const ArcLine& g, Turn lo, Turn hi, Turn guess) {
  const auto after = [](Turn a, Turn b) { return a.c * b.s - a.s * b.c; };  // > 0: b follows a
  Turn e = guess;
  for (int i = 0; i < 60; ++i) {
    const double slope = g.slope(e);
    (slope < 0 ? lo : hi) = e;
    const double curvature = g.curvature(e);

    // newton: turn by -slope / curvature, as a step along the tangent followed by normalisation
    const double step = curvature > 0 ? -slope / curvature : 2.0;
    Turn next = e.stepped(step);
    if (std::abs(step) < 1e-8) return next;  // the next correction would be below rounding
    if (std::abs(step) > 1 || after(lo, next) <= 0 || after(next, hi) <= 0)
      next = Turn::along(lo.c + hi.c, lo.s + hi.s, e);
    e = next;
  }
  return e;
}

/// The minimum that a descent from `guess` reaches: Newton where the curvature is positive, else and for long steps a
/// fifth of a radian downhill.
inline Turn minimum_near(const ArcLine& g, Turn guess) {
  Turn e = guess;
  for (int i = 0; i < 40; ++i) {
    const double slope = g.slope(e), curvature = g.curvature(e);
    const double newton = curvature > 0 ? -slope / curvature : slope > 0 ? -1.0 : 1.0;
    const double step = std::clamp(newton, -0.2, 0.2);
    e = e.stepped(step);
    if (std::abs(step) < 1e-9) return e;
  }
  return e;
}

/// Places on two circles.
struct ArcPair {
  Turn a, b;
};

/// The local minimum of the distance of two whole circles that a descent from `guess` reaches: Newton on
///   f(e_a, e_b) = |w|^2 / 2,   w = p(e_a) - q(e_b),   p' = R_a t_a,   p'' = -R_a r_a (r radial, t along)
///   f' = (R_a t_a . w, -R_b t_b . w)
///   f'' = (R_a^2 - R_a r_a . w, -R_a R_b t_a . t_b; ., R_b^2 + R_b r_b . w)
/// where that is positive definite, else straight downhill; no step turns by more than a fifth of a radian or increases the distance.
inline ArcPair minimum_near(const Arc& p, const Arc& q, const ArcPair& guess) {
  ArcPair e = guess;
  for (int i = 0; i < 40; ++i) {
    const Vec3 r_a = e.a.c * p.x + e.a.s * p.y, r_b = e.b.c * q.x + e.b.s * q.y;
    const Vec3 t_a = p.tangent(e.a), t_b = q.tangent(e.b);
    const Vec3 w = p.centre - q.centre + p.radius * r_a - q.radius * r_b;
    const double g_a = p.radius * t_a.dot(w), g_b = -q.radius * t_b.dot(w);
    const double aa = p.radius * (p.radius - r_a.dot(w)), bb = q.radius * (q.radius + r_b.dot(w));
    const double ab = -p.radius * q.radius * t_a.dot(t_b), det = aa * bb - ab * ab;
    const bool convex = aa > 0 && det > 1e-12 * aa * std::abs(bb);
    double s_a = convex ? -(bb * g_a - ab * g_b) / det : -g_a / (p.radius * p.radius);
    double s_b = convex ? -(aa * g_b - ab * g_a) / det : -g_b / (q.radius * q.radius);
    const double longest = std::max(std::abs(s_a), std::abs(s_b));
    if (longest > 0.2) s_a *= 0.2 / longest, s_b *= 0.2 / longest;
    if (longest < 1e-10) return {e.a.stepped(s_a), e.b.stepped(s_b)};
    // halve the step while the distance would grow
    ArcPair next;
    double share = 2;
    do {
      share *= 0.5;
      next = {e.a.stepped(share * s_a), e.b.stepped(share * s_b)};
    } while (share > 1e-3 && (p.point(next.a) - q.point(next.b)).squaredNorm() > w.squaredNorm());
    e = next;
  }
  return e;
}

}  // namespace swage::toolkit
