// SPDX-License-Identifier: Apache-2.0
//
// Identities and carriers of the features that touch. Room-internal.
#pragma once

#include <type_traits>

#include "contact/candidate.hpp"
#include "contact/curve.hpp"
#include "contact/solid.hpp"
#include "contact/voronoi.hpp"

namespace swage::contact {

/// 0 up to `low`, 1 from `high` on, smooth in between.
inline double ramp(double x, double low, double high) {
  if (x <= low) return 0;
  if (x >= high) return 1;
  const double t = (x - low) / (high - low);
  return t * t * (3 - 2 * t);
}

/// Identity of a contact within its pair of shapes: the feature of b, which of two minima on one edge, which point of a line.
inline uint64_t feature_id(Region region, int branch, int point) {
  const uint64_t kind = region.kind == Region::kInside ? Region::kFace : region.kind;
  return (kind << 40) | (uint64_t{region.index} << 8) | (static_cast<uint64_t>(branch) << 4) |
         static_cast<uint64_t>(point);
}

/// The carrier of a polyhedron's feature. Written in place: members that the kind does not use keep their values.
inline void set_convex_feature(const Solid& solid, Region region, Feature& f) {
  const Convex& c = solid.convex;
  f.tube = solid.radius;
  switch (region.kind) {
    case Region::kFace:
    case Region::kInside:
      f.kind = Feature::kPlane;
      f.u = c.face[region.index].n;
      f.p = c.face[region.index].d * f.u;
      break;
    case Region::kEdge:
      f.kind = Feature::kSegment;
      f.p = c.vertex[c.edge[region.index].v0];
      f.u = c.vertex[c.edge[region.index].v1] - f.p;
      break;
    case Region::kVertex:
      f.kind = Feature::kPoint;
      f.p = c.vertex[region.index];
      break;
  }
}

/// Distance of the place p of a wire from the feature of a polyhedron, and the outward normal there.
struct Offset {
  double distance;  // m, of the centre line; negative under a face
  Vec3 n;           // unit
};
inline Offset offset(const Solid& b, Region region, const Vec3& p, double wire_radius) {
  const Convex& c = b.convex;
  if (region.kind == Region::kFace || region.kind == Region::kInside)
    return {c.face[region.index].n.dot(p) - c.face[region.index].d, c.face[region.index].n};
  Vec3 w, outward;
  if (region.kind == Region::kEdge) {
    const Convex::Edge& e = c.edge[region.index];
    w = p - c.vertex[e.v0];
    w -= w.dot(e.u) * e.u;
    outward = e.side_left + e.side_right;
  } else {
    w = p - c.vertex[region.index];
    outward = c.vertex[region.index] - b.centre;
  }
  const double distance = w.norm();
  if (distance > 1e-6 * wire_radius) return {distance, w / distance};
  // the axes of two round wires cross: any direction will do
  return {distance, outward.isZero() ? Vec3(Vec3::UnitZ()) : Vec3(outward.normalized())};
}

/// The centre line of a wire, carried over into the frame B of the polyhedron.
template <class Curve>
Curve curve_of(const Solid& wire, const toolkit::Frame& X_BA) {
  if constexpr (std::is_same_v<Curve, ArcCurve>) {
    toolkit::Arc arc = wire.arc;
    arc.centre = X_BA * arc.centre, arc.x = X_BA.turn(arc.x), arc.y = X_BA.turn(arc.y);
    return ArcCurve(arc);
  } else {
    return LineCurve(X_BA * wire.axis.a, X_BA * wire.axis.b);
  }
}

/// One place of a wire, fixed to it.
inline void set_wire_point(const Solid& wire, double t, Feature& f) {
  f.kind = Feature::kPoint;
  f.tube = wire.radius;
  const double length = wire.axis.length();
  f.p = length > 0 ? wire.axis.point(t / length) : wire.axis.a;
}
inline void set_wire_point(const Solid& wire, Turn e, Feature& f) {
  f.kind = Feature::kPoint;
  f.tube = wire.radius;
  f.p = wire.arc.point(e);
}

/// A stretch of a wire within which the touching place may move.
inline void set_wire_stretch(const Solid& wire, double, const Stretch<double>& range, Feature& f) {
  set_wire_point(wire, range.to, f);
  const Vec3 end = f.p;
  set_wire_point(wire, range.from, f);
  f.u = end - f.p;
  if (range.to > range.from) f.kind = Feature::kSegment;
}
inline void set_wire_stretch(const Solid& wire, Turn e, const Stretch<Turn>& range, Feature& f) {
  f.kind = Feature::kCircle;
  f.tube = wire.radius;
  f.p = wire.arc.centre, f.u = wire.arc.x, f.v = wire.arc.y, f.radius = wire.arc.radius;
  f.e = e, f.from = range.from, f.upto = range.to;
}

}  // namespace swage::contact
