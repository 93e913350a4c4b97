// SPDX-License-Identifier: Apache-2.0
//
// The walk of a curve through the Voronoi regions of a polyhedron: which part of it is in which region, and all local minima of
// the distance within reach. Room-internal; README.md states the method.
#pragma once

#include "contact/clip.hpp"
#include "contact/curve.hpp"
#include "contact/narrow_phase.hpp"
#include "contact/voronoi.hpp"
#include "toolkit/fixed_vector.hpp"

namespace swage::contact {

/// Slope of the distance, per length of wire, that counts as level: an error of 6e-12 m over a wire of 6 mm.
inline constexpr double kLevel = 1e-9;

/// Distance of the places of a curve to the polyhedron, within one region.
template <class Curve>
class RegionDistance {
 public:
  using Place = typename Curve::Place;

  RegionDistance(const Curve& curve, const Convex& convex, Region region)
      : curve_(curve), kind_(region.kind == Region::kInside ? Region::kFace : region.kind) {
    if (on_face()) {
      const Convex::Face& f = convex.face[region.index];
      height_ = curve.height(f.n, f.d);
    } else if (on_edge()) {
      const Convex::Edge& e = convex.edge[region.index];
      q_ = convex.vertex[e.v0], u_ = e.u;
      line_ = curve.to_line(q_, u_);
    } else {
      q_ = convex.vertex[region.index];
    }
  }
  /// Distance to the line through q along the unit vector u, or to the point q when u is zero.
  RegionDistance(const Curve& curve, const Vec3& q, const Vec3& u)
      : curve_(curve), kind_(u.isZero(0) ? Region::kVertex : Region::kEdge), q_(q), u_(u) {
    if (on_edge()) line_ = curve.to_line(q, u);
  }
  /// Distance to a plane.
  RegionDistance(const Curve& curve, const typename Curve::Height& height)
      : curve_(curve), kind_(Region::kFace), height_(height) {}

  double at(Place e) const {
    if (on_face()) return height_.at(e);
    const Vec3 w = curve_.point(e) - q_;
    return (w - w.dot(u_) * u_).norm();
  }
  /// A number with the sign of the slope of the distance; its unit depends on the region.
  double slope(Place e) const {
    if (on_face()) return height_.slope(e);
    if (on_edge()) return line_.slope(e);
    return (curve_.point(e) - q_).dot(curve_.tangent(e));
  }
  /// kLevel in the unit of slope(), at distances of about a wire radius.
  double level(double radius) const { return kLevel * (on_face() ? curve_.unit() : radius); }

  /// The minimum between a place of negative and one of positive slope.
  Place lowest(Place from, Place to, double slope_from, double slope_to) const {
    if (on_face()) return Curve::valley(height_, from, to);
    if (on_edge()) return Curve::closest(line_, from, to, slope_from, slope_to);
    return curve_.closest(q_, from, to);
  }
  /// Adds places between which the slope changes sign at most once.
  template <class List>
  void split(Place from, Place to, double slope_from, double slope_to, double level, List& out) const {
    if (on_edge()) Curve::split(line_, from, to, slope_from, slope_to, level, out);
  }
  Place middle(Place from, Place to) const { return curve_.middle(from, to); }
  int branch(Place e) const { return on_edge() ? Curve::branch(line_, e) : 0; }

 private:
  bool on_face() const { return kind_ == Region::kFace; }
  bool on_edge() const { return kind_ == Region::kEdge; }

  const Curve& curve_;
  Region::Kind kind_;
  Vec3 q_ = Vec3::Zero(), u_ = Vec3::Zero();  // edge: a point and the direction. vertex: the point, and zero
  typename Curve::Height height_;
  typename Curve::ToLine line_;
};

/// Calls visit(place) at each local minimum between two places. `falling`: whether the distance fell before the first; set to
/// whether it falls at the second.
template <class Curve, class Visit>
void for_each_dip(const RegionDistance<Curve>& distance, typename Curve::Place from, typename Curve::Place to,
                  double level, bool& falling, Visit&& visit) {
  // sign changes of the slope, between places where there is at most one
  const double slope_from = distance.slope(from), slope_to = distance.slope(to);
  toolkit::FixedVector<typename Curve::Place, 8> cut;
  distance.split(from, to, slope_from, slope_to, level, cut);
  // at the start of a piece a kink, or the end of the curve, may be the minimum. Where the slope is level there, the slope a sixteenth
  // of the interval further on decides whether the distance falls
  double slope_on = slope_from;
  if (falling && std::abs(slope_from) <= level) {
    typename Curve::Place on = cut.empty() ? to : cut[0];
    for (int k = 0; k < 4; ++k) on = distance.middle(from, on);
    slope_on = distance.slope(on);
  }
  if (falling && slope_on >= -level) visit(from);
  falling = slope_on < -level;
  typename Curve::Place a = from;
  double slope_a = slope_from;
  for (int i = 0; i <= cut.size(); ++i) {
    const bool last = i == cut.size();
    const typename Curve::Place b = last ? to : cut[i];
    const double slope_b = last ? slope_to : distance.slope(b);
    if (falling && slope_b > 0) {
      visit(distance.lowest(a, b, slope_a, slope_b));
      falling = false;
    }
    falling |= slope_b < -level;
    a = b, slope_a = slope_b;
  }
}

/// The part of a curve that lies in one region.
template <class Place>
struct Piece {
  Region region;
  Place from{}, to{};
  bool joined = false;  // continues the piece before it
};

/// A local minimum of the distance.
template <class Place>
struct Dip {
  int piece = 0, branch = 0;
  Place at{};
  double distance = 0;  // m, from the curve
};

/// The parts of a curve in each region, and the minima of its distance from a polyhedron.
template <class Curve>
class Walk {
 public:
  using Place = typename Curve::Place;
  using Distance = RegionDistance<Curve>;
  /// A wire round a cylinder of 48 sides passes 96 regions.
  static constexpr int kPieces = 128;
  using Pieces = toolkit::FixedVector<Piece<Place>, kPieces>;
  using Dips = toolkit::FixedVector<Dip<Place>, 24>;

  /// Searches `stretch` for places of the curve nearer than `reach`. goes_on: the wire continues before the curve's start.
  Walk(const Curve& curve, const Convex& convex, double radius, double reach, const Stretches<Curve>& stretch,
       bool goes_on = false)
      : curve_(curve),
        convex_(convex),
        radius_(radius),
        reach_(reach),
        stretch_(stretch),
        goes_on_(goes_on) {}

  void walk() {
    for (const Stretch<Place>& s : stretch_) {
      if (s.at_from != Border::kJoined) region_ = locate(convex_, curve_.point(s.from));
      if (s.at_from != Border::kJoined) falling_ = !(goes_on_ && s.at_from == Border::kEnd);
      cross_regions(s);
      // at an end of the curve, the end may be the minimum; a clipped border is out of reach
      if (s.at_to == Border::kEnd && falling_) add_dip(Distance(curve_, convex_, region_), s.to);
    }
  }

  const Pieces& pieces() const { return piece_; }
  const Dips& dips() const { return dip_; }
  /// Number of minima that the table had no room for.
  int dropped() const { return dropped_; }

 private:
  void cross_regions(const Stretch<Place>& s) {
    const Vec3 end = curve_.point(s.to);
    Place from = s.from;
    bool joined = s.at_from == Border::kJoined;
    for (;;) {
      // first border that the curve leaves the region through; most are farther away than the curve bulges over its chord
      Place to = s.to;
      Region next = region_;
      const Vec3 p = curve_.point(from);
      const double bulge = curve_.bulge(p, end);
      for_each_border(convex_, region_, [&](const Vec3& n, double d, Region beyond) {
        if (std::max(n.dot(p), n.dot(end)) + bulge < d) return;
        if (leaves(curve_.height(n, d), from, to)) next = beyond;
      });
      add_piece(from, to, joined);
      // a full table ends the walk: so many regions on one wire are beyond any sane polyhedron
      if (next == region_ || piece_.full()) return;
      region_ = next;
      from = to;
      joined = true;
    }
  }

  /// Moves `to` to where h rises through zero between the two places. A curve that is just outside and rising (it
  /// passed a corner of the region) leaves at once; one that is outside and falling has just come in.
  static bool leaves(const typename Curve::Height& h, Place from, Place& to) {
    const double h_from = h.at(from), h_to = h.at(to);
    if (h_from >= 0 && h.slope(from) > 0) {
      to = from;
      return true;
    }
    if (h_to <= 0 && !Curve::has_peak(h, from, to)) return false;
    if (h_to > 0 && h_from >= 0 && !Curve::has_valley(h, from, to)) return false;
    to = Curve::rising(h, from, to);
    return true;
  }

  void add_piece(Place from, Place to, bool joined) {
    if (joined && !piece_.empty() && piece_.back().region == region_ &&
        Curve::may_join(piece_.back().from, to))
      piece_.back().to = to;
    else
      piece_.add({region_, from, to, joined});

    const Distance distance(curve_, convex_, region_);
    for_each_dip(distance, from, to, distance.level(radius_), falling_,
                 [&](Place place) { add_dip(distance, place); });
  }

  void add_dip(const Distance& distance, Place place) {
    const double d = distance.at(place);
    if (!(d < reach_)) return;
    if (dip_.full() && !drop_farthest(d)) return;
    dip_.add({piece_.size() - 1, distance.branch(place), place, d});
  }
  /// Of more minima than there is room for, the nearest stay. False when none is farther than `d`.
  bool drop_farthest(double d) {
    ++dropped_;
    int far = 0;
    for (int i = 1; i < dip_.size(); ++i)
      if (dip_[i].distance > dip_[far].distance) far = i;
    if (!(d < dip_[far].distance)) return false;
    for (int i = far; i + 1 < dip_.size(); ++i) dip_[i] = dip_[i + 1];
    dip_.shrink(dip_.size() - 1);
    return true;
  }

  const Curve& curve_;
  const Convex& convex_;
  double radius_, reach_;
  const Stretches<Curve>& stretch_;
  bool goes_on_;
  Region region_;
  bool falling_ = false;
  int dropped_ = 0;
  Pieces piece_;
  Dips dip_;
};

}  // namespace swage::contact
