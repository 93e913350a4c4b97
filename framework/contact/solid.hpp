// SPDX-License-Identifier: Apache-2.0
//
// A shape of the scene as the narrow phase sees it: in the frame of its body, everything precomputed.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/world.hpp"
#include "toolkit/arc.hpp"
#include "toolkit/convex.hpp"
#include "toolkit/height_field.hpp"
#include "toolkit/math.hpp"
#include "toolkit/segment.hpp"

namespace swage::contact {

using toolkit::Frame;
using toolkit::Pose;
using toolkit::Vec3;

/// Which member counts depends on the kind:
///   SPHERE     axis.a, radius   a point, thickened by radius; `convex` is that vertex
///   CAPSULE    axis, radius     a segment, thickened; `convex` is that edge
///   ARC        arc, radius      an arc, thickened
///   CONVEX     convex           radius 0; a CYLINDER is a prism of kCylinderSides here
///   HEIGHT_FIELD  field (in its frame H), X_BH, below
inline constexpr int kCylinderSides =
    48;  // the prism's area is that of the circle; its outline is off by at most 0.14 % of the radius
struct Solid {
  int32_t kind = SWAGE_SHAPE_SPHERE;
  double radius = 0;           // m
  toolkit::Segment axis;       // m, in the body's frame
  toolkit::Arc arc;            // in the body's frame
  toolkit::Convex convex;      // in the body's frame
  toolkit::HeightField field;  // in its own frame H; heights are read where they live
  Frame X_BH;                  // pose of the field in the body
  double below = 0;            // m, how far the solid reaches under the field's surface
  double height = 0;           // m, from there to its highest vertex
  Vec3 centre = Vec3::Zero();  // m, of the bounding sphere, in the body's frame
  double bound = 0;            // m, radius of the bounding sphere
};

/// [any] A point, segment or arc, thickened.
inline bool is_wire(const Solid& s) {
  return s.kind == SWAGE_SHAPE_SPHERE || s.kind == SWAGE_SHAPE_CAPSULE || s.kind == SWAGE_SHAPE_ARC;
}
/// [any] Whether the solid is a polyhedron, or the one edge or vertex of a capsule or sphere, thickened.
inline bool has_vertices(const Solid& s) { return !s.convex.vertex.empty(); }

/// [any] How far the solid reaches along n (any length) in the frame of its body: the largest n . p, m times |n|.
double support(const Solid& solid, const Vec3& n) noexcept;

/// [main] A ball about the origin.
Solid make_ball(double radius);

/// [main] A capsule whose axis and radius the caller sets afterwards.
Solid make_capsule();

/// [main] The solid of a shape; `convexes` is World::convex.
Solid make_solid(const scene::Shape& shape, const std::vector<toolkit::Convex>& convexes);

/// [main] The solid of any shape of a world, which must outlive that of a height field.
Solid make_solid(const scene::World& world, uint32_t shape);

/// [rt] Fits the solid of a height field whose heights may have changed to those of `world`.
void update_field(Solid& solid, const scene::World& world, uint32_t shape) noexcept;

}  // namespace swage::contact
