// SPDX-License-Identifier: Apache-2.0
//
// A shape of the scene as the narrow phase sees it: in the frame of its body, everything precomputed.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/world.hpp"
#include "toolkit/arc.hpp"
#include "toolkit/convex.hpp"
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
///   CYLINDER   axis, radius     a segment with flat ends
///   CONVEX     convex           radius 0
struct Solid {
  int32_t kind = SWAGE_SHAPE_SPHERE;
  double radius = 0;           // m
  toolkit::Segment axis;       // m, in the body's frame
  toolkit::Arc arc;            // in the body's frame
  toolkit::Convex convex;      // in the body's frame
  Vec3 centre = Vec3::Zero();  // m, of the bounding sphere, in the body's frame
  double bound = 0;            // m, radius of the bounding sphere
};

/// [any] How far the solid reaches along n (any length) in the frame of its body: the largest n . p, m times |n|.
double support(const Solid& solid, const Vec3& n) noexcept;

/// [main] A ball about the origin.
Solid make_ball(double radius);

/// [main] The solid of a shape; `convexes` is World::convex.
Solid make_solid(const scene::Shape& shape, const std::vector<toolkit::Convex>& convexes);

}  // namespace swage::contact
