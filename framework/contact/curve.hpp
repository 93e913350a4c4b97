// SPDX-License-Identifier: Apache-2.0
//
// Centre lines of wires, with one interface for the walk through the Voronoi regions: a straight piece (a point when its
// length is zero) and an arc. Both give their height above a plane, where they rise through it, and where they are closest to
// a line or point. Room-internal.
//
// Units: m. A Place is a position on the curve; a Stretch is short enough (150 deg at most) that a height has at most one
// extremum on it.
#pragma once

#include <cmath>

#include "toolkit/arc.hpp"
#include "toolkit/math.hpp"

namespace swage::contact {

using toolkit::Turn;
using toolkit::Vec3;

/// How a stretch begins or ends.
enum class Border : uint8_t {
  kEnd,      // the curve ends here
  kJoined,   // the neighbouring stretch continues it
  kClipped,  // beyond, everything is too far from the polyhedron
};

template <class Place>
struct Stretch {
  Place from{}, to{};
  Border at_from = Border::kEnd, at_to = Border::kEnd;
};

/// Height of a straight piece above a plane.
struct LineHeight {
  double h0 = 0, h1 = 0;
  double at(double t) const { return h0 + h1 * t; }
  double slope(double) const { return h1; }
};

/// h + s g.
inline LineHeight plus(const LineHeight& h, double s, const LineHeight& g) {
  return {h.h0 + s * g.h0, h.h1 + s * g.h1};
}
inline toolkit::ArcHeight plus(const toolkit::ArcHeight& h, double s, const toolkit::ArcHeight& g) {
  return {h.h0 + s * g.h0, h.hx + s * g.hx, h.hy + s * g.hy};
}

/// Squared distance of a straight piece to a line, halved, as a function of the place; convex. See toolkit::ArcLine.
struct LineLine {
  double kd = 0, ku = 0, du = 0;  // start - q along d and u; d along u

  LineLine() = default;
  LineLine(const Vec3& k, const Vec3& d, const Vec3& u) : kd(k.dot(d)), ku(k.dot(u)), du(d.dot(u)) {}
  double slope(double t) const { return kd + t - (ku + t * du) * du; }
};

/// start + t direction, t in [0, length].
class LineCurve {
 public:
  static constexpr bool kStraight = true;
  using Place = double;  // m from the start
  using Height = LineHeight;
  using ToLine = LineLine;

  LineCurve() = default;
  LineCurve(const Vec3& start, const Vec3& end) : start_(start) {
    const Vec3 d = end - start;
    length_ = d.norm();
    direction_ = length_ > 0 ? Vec3(d / length_) : Vec3::UnitZ();
  }
  Stretch<Place> stretch(int) const { return {0, length_, Border::kEnd, Border::kEnd}; }
  int stretches() const { return 1; }

  Vec3 point(Place t) const { return start_ + t * direction_; }
  Vec3 tangent(Place) const { return direction_; }
  double unit() const { return 1; }
  static bool may_join(Place, Place) { return true; }
  static double order(Place t) { return t; }
  double length(Place from, Place to) const { return to - from; }
  static double bulge(const Vec3&, const Vec3&) { return 0; }
  Place middle(Place from, Place to) const { return 0.5 * (from + to); }
  /// The place as far beyond t as `to` is beyond `from`.
  static Place moved(Place t, Place from, Place to) { return t + (to - from); }

  Height height(const Vec3& n, double d) const { return {n.dot(start_) - d, n.dot(direction_)}; }
  double lowest(const Height& h) const { return std::min(h.at(0), h.at(length_)); }
  static double lowest(const Height& h, Place from, Place to) { return std::min(h.at(from), h.at(to)); }
  static bool has_peak(const Height&, Place, Place) { return false; }
  static bool has_valley(const Height&, Place, Place) { return false; }
  static Place valley(const Height&, Place from, Place) { return from; }
  static Place rising(const Height& h, Place from, Place to) { return crossing(h, from, to); }
  static Place falling(const Height& h, Place from, Place to) { return crossing(h, from, to); }

  /// The stretch in which a touching place may move.
  Stretch<Place> around(Place, Place from, Place to) const { return {from, to}; }
  Stretch<Place> around(Place) const { return {0, length_}; }

  ToLine to_line(const Vec3& q, const Vec3& u) const { return {start_ - q, direction_, u}; }
  Place closest(const Vec3& q, Place from, Place to) const {
    return std::clamp((q - start_).dot(direction_), from, to);
  }
  /// The place closest to the line, given that the slope changes sign between the two.
  static Place closest(const ToLine& g, Place from, Place to, double, double) {
    const double curvature = 1 - g.du * g.du;
    return curvature > 0 ? std::clamp((g.ku * g.du - g.kd) / curvature, from, to) : from;
  }
  /// Adds places inside the stretch between which the slope of g has at most one zero; none is needed here.
  template <class List>
  static void split(const ToLine&, Place, Place, double, double, double, List&) {}
  static int branch(const ToLine&, Place) { return 0; }

 private:
  static Place crossing(const Height& h, Place from, Place to) { return std::clamp(-h.h0 / h.h1, from, to); }

  Vec3 start_ = Vec3::Zero(), direction_ = Vec3::UnitZ();
  double length_ = 0;
};

/// The direction between two others, at the share t of their chord. Without a root for those that are close: its series is exact to
/// rounding while the chord's point is within 5e-5 of unit length.
inline Turn between(Turn a, Turn b, double t) {
  const double x = a.c + t * (b.c - a.c), y = a.s + t * (b.s - a.s), q = 1 - (x * x + y * y);
  if (std::abs(q) > 1e-4) return Turn::along(x, y, a);
  const double scale = 1 + q * (0.5 + q * (0.375 + q * 0.3125));
  return {scale * x, scale * y};
}

/// Arc in the frame of the polyhedron.
class ArcCurve {
 public:
  static constexpr bool kStraight = false;
  using Place = Turn;
  using Height = toolkit::ArcHeight;  // slopes per radian
  using ToLine = toolkit::ArcLine;

  ArcCurve() = default;
  explicit ArcCurve(const toolkit::Arc& arc) : arc_(arc) {
    while (stretches_ < 3 && kCut[stretches_].order() < arc.end_order) ++stretches_;
  }

  /// The arc in parts of 150 deg.
  Stretch<Place> stretch(int i) const {
    const bool last = i + 1 == stretches_;
    return {kCut[i], last ? arc_.end : kCut[i + 1], i == 0 ? Border::kEnd : Border::kJoined,
            last ? Border::kEnd : Border::kJoined};
  }
  int stretches() const { return stretches_; }

  Vec3 point(Place e) const { return arc_.point(e); }
  Vec3 tangent(Place e) const { return arc_.tangent(e); }
  double unit() const { return arc_.radius; }  // m of wire per radian, the argument of heights
  /// Grows along the curve.
  static double order(Place e) { return e.order(); }
  /// Whether the stretch is at most half a turn, which middle(), within() and the like require.
  static bool may_join(Place from, Place to) { return from.c * to.s >= from.s * to.c; }
  /// Chord of a stretch: at most 10 % short of its length.
  double length(Place from, Place to) const {
    const double dc = to.c - from.c, ds = to.s - from.s;
    return arc_.radius * std::sqrt(dc * dc + ds * ds);
  }
  /// Upper bound of the distance of a stretch from the chord between its ends: R sin^2 a; the sagitta is R (1 - cos a).
  double bulge(const Vec3& from, const Vec3& to) const {
    return (to - from).squaredNorm() / (4 * arc_.radius);
  }
  Place middle(Place from, Place to) const { return between(from, to, 0.5); }

  static Place moved(Place e, Place from, Place to) {
    const Turn by{from.c * to.c + from.s * to.s, from.c * to.s - from.s * to.c};
    return {e.c * by.c - e.s * by.s, e.s * by.c + e.c * by.s};
  }

  Height height(const Vec3& n, double d) const { return {arc_, n, d}; }
  double lowest(const Height& h) const {
    const double amplitude = std::sqrt(h.hx * h.hx + h.hy * h.hy);
    if (amplitude > 0 && arc_.contains({-h.hx / amplitude, -h.hy / amplitude})) return h.h0 - amplitude;
    return std::min(h.at(Turn{}), h.at(arc_.end));
  }
  static double lowest(const Height& h, Place from, Place to) {
    if (h.slope(from) < 0 && h.slope(to) > 0) return h.h0 - std::sqrt(h.hx * h.hx + h.hy * h.hy);
    return std::min(h.at(from), h.at(to));
  }
  /// Whether h rises above zero and falls again, or the reverse, between two places.
  static bool has_peak(const Height& h, Place from, Place to) {
    return h.slope(from) > 0 && h.slope(to) < 0 && (h.h0 > 0 || h.h0 * h.h0 < h.hx * h.hx + h.hy * h.hy);
  }
  static bool has_valley(const Height& h, Place from, Place to) {
    return h.slope(from) < 0 && h.slope(to) > 0 && (h.h0 < 0 || h.h0 * h.h0 < h.hx * h.hx + h.hy * h.hy);
  }
  static Place valley(const Height& h, Place from, Place to) {
    const Turn e = Turn::along(-h.hx, -h.hy, from);
    return within(e, from, to) ? e : h.at(from) <= h.at(to) ? from : to;
  }
  /// The place where h goes through zero upwards (downwards).
  static Place rising(const Height& h, Place from, Place to) { return crossing(h, from, to, 1); }
  static Place falling(const Height& h, Place from, Place to) { return crossing(h, from, to, -1); }

  /// The stretch in which a touching place may move: 80 deg to both sides at most, which keeps it under half a turn.
  Stretch<Place> around(Place e, Place from, Place to) const {
    constexpr double c = 0.17364817766693041, s = 0.98480775301220802;  // cos, sin of 80 deg
    Stretch<Place> range{{c * e.c + s * e.s, c * e.s - s * e.c}, {c * e.c - s * e.s, c * e.s + s * e.c}};
    if (within(from, range.from, e)) range.from = from;
    if (within(to, e, range.to)) range.to = to;
    return range;
  }
  Stretch<Place> around(Place e) const { return around(e, Turn{}, arc_.end); }

  ToLine to_line(const Vec3& q, const Vec3& u) const { return {arc_, q, u}; }
  Place closest(const Vec3& q, Place from, Place to) const {
    const Vec3 w = q - arc_.centre;
    const Turn e = Turn::along(w.dot(arc_.x), w.dot(arc_.y), from);
    if (within(e, from, to)) return e;
    return (point(from) - q).squaredNorm() <= (point(to) - q).squaredNorm() ? from : to;
  }
  static Place closest(const ToLine& g, Place from, Place to, double slope_from, double slope_to) {
    // start at the zero of the slope if that were linear
    const double t = slope_from / (slope_from - slope_to);
    return toolkit::minimum_between(g, from, to, between(from, to, t));
  }
  template <class List>
  static void split(const ToLine& g, Place from, Place to, double slope_from, double slope_to, double level,
                    List& out);
  /// Which of the two minima that g may have: they lie on opposite sides of the ellipse's long axis.
  static int branch(const ToLine& g, Place e) { return e.c * g.ux + e.s * g.uy < 0; }

  /// Whether e lies on the stretch, which is shorter than half a turn.
  static bool within(Turn e, Turn from, Turn to) {
    return from.c * e.s >= from.s * e.c && e.c * to.s >= e.s * to.c;
  }

 private:
  /// Whether a bound on the third derivative of g shows that its slope rises all the way.
  static bool monotone(const ToLine& g, Place from, Place to) {
    return g.curvature(from) + g.curvature(to) >= third(g) * angle(from, to);
  }
  /// A place, and slope and curvature of g there.
  struct Known {
    Place at;
    double slope, curvature;
  };
  static double third(const ToLine& g) { return std::abs(g.kx) + std::abs(g.ky) + std::abs(g.ku) + 2 * g.R; }
  /// Upper bound of the angle between two places up to a quarter turn apart [rad].
  static double angle(Place from, Place to) {
    const double dc = to.c - from.c, ds = to.s - from.s;
    return 1.12 * std::sqrt(dc * dc + ds * ds);
  }
  static bool search_sign(const ToLine& g, const Known& from, const Known& to, double sign, double level, double third, Place& found);

  /// h0 + A cos(angle - phi) = 0 at angle = phi -+ acos(-h0 / A). One root and one division, neither of which waits for the other.
  static Place crossing(const Height& h, Place from, Place to, double upward) {
    const double A2 = h.hx * h.hx + h.hy * h.hy, B2 = A2 - h.h0 * h.h0;
    if (B2 > 0) {
      const double over = 1 / A2, B = upward * std::sqrt(B2);
      const Turn e{(B * h.hy - h.h0 * h.hx) * over, -(B * h.hx + h.h0 * h.hy) * over};
      if (within(e, from, to)) return e;
    }
    return std::abs(h.at(from)) < std::abs(h.at(to)) ? from : to;
  }

  static constexpr double kSin60 = 0.86602540378443865;
  static constexpr Turn kCut[] = {{1, 0}, {-kSin60, 0.5}, {0.5, -kSin60}};  // 0, 150, 300 deg

  toolkit::Arc arc_;
  int stretches_ = 1;
};

/// Between neighbouring axes of the ellipse, g has at most one minimum and one maximum. When both lie there the slope has
/// the same sign, or none, at both axes, and the other sign somewhere between: there it is cut.
template <class List>
void ArcCurve::split(const ToLine& g, Place from, Place to, double slope_from, double slope_to, double level,
                     List& out) {
  if (from.c * to.c + from.s * to.s > 0 && monotone(g, from, to)) return;
  Place start = from;
  double slope = slope_from;
  const auto part_until = [&](Place end, double slope_end) {
    const double sign = slope < -level ? 1 : -1;  // the sign that is missing at the start
    Place found;
    if (sign * slope_end <= level &&
        search_sign(g, {start, slope, g.curvature(start)}, {end, slope_end, g.curvature(end)}, sign, level, third(g), found))
      out.add(found);
    start = end, slope = slope_end;
  };
  const auto cut_at = [&](double c, double s) {
    if (from.c * s <= from.s * c || c * to.s <= s * to.c) return;
    const Turn axis = Turn::along(c, s, from);
    part_until(axis, g.slope(axis));
    out.add(axis);
  };
  // of the four axes, the first that follows `from` and the next
  double c = g.ux, s = g.uy;
  while (from.c * s - from.s * c < 0 || from.c * c + from.s * s < 0) {
    const double turned = -c;
    c = s, s = turned;
  }
  cut_at(c, s);
  cut_at(-s, c);
  part_until(to, slope_to);
}

/// Finds a place where the slope has the given sign, by bisection; none where bounds on its derivatives show that the slope is
/// monotone or stays away from zero. Extrema less than 1e-3 rad apart (depths within 0.1 nm) count as a level inflection.
inline bool ArcCurve::search_sign(const ToLine& g, const Known& from, const Known& to, double sign, double level, double third,
                                  Place& found) {
  const double turned = angle(from.at, to.at);
  if (turned < 1e-3 || from.curvature + to.curvature >= third * turned) return false;
  if (-sign * (from.slope + to.slope) >= 2 * third * turned) return false;
  // the chord between the two slopes is off by an eighth of the bound times the square of the angle at most
  if (std::min(-sign * from.slope, -sign * to.slope) >= 0.125 * third * turned * turned) return false;
  Known middle{Turn::along(from.at.c + to.at.c, from.at.s + to.at.s, from.at), 0, 0};
  middle.slope = g.slope(middle.at);
  if (sign * middle.slope > level) {
    found = middle.at;
    return true;
  }
  middle.curvature = g.curvature(middle.at);
  return search_sign(g, from, middle, sign, level, third, found) || search_sign(g, middle, to, sign, level, third, found);
}

}  // namespace swage::contact
