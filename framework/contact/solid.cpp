// SPDX-License-Identifier: Apache-2.0
#include "contact/solid.hpp"

#include <algorithm>

namespace swage::contact {
namespace {

/// Centre and radius of a sphere around a solid: tight for round shapes, around the box of the vertices for
/// polyhedra.
void add_bound(Solid& s) {
  if (s.kind == SWAGE_SHAPE_ARC) {
    // an arc up to half a circle fits the sphere on its chord, a longer one the sphere on its circle
    const toolkit::Turn middle = s.arc.at(0.5);
    const bool short_arc = s.arc.sweep < M_PI;
    const double half = std::min(0.5 * s.arc.sweep, M_PI / 2);
    s.centre =
        short_arc ? s.arc.centre + std::cos(half) * (s.arc.point(middle) - s.arc.centre) : s.arc.centre;
    s.bound = std::sin(half) * s.arc.radius + s.radius;
  } else if (s.kind == SWAGE_SHAPE_CONVEX) {
    Vec3 low = s.convex.vertex[0], high = low;
    for (const Vec3& v : s.convex.vertex) low = low.cwiseMin(v), high = high.cwiseMax(v);
    s.centre = 0.5 * (low + high);
    for (const Vec3& v : s.convex.vertex) s.bound = std::max(s.bound, (v - s.centre).norm());
  } else {
    const double half = 0.5 * s.axis.length();
    s.centre = s.axis.point(0.5);
    s.bound = half + s.radius;
  }
}

/// The polyhedron of one edge or one vertex inside a capsule or sphere. It has no faces; the planes beside its edge are
/// nowhere crossed.
toolkit::Convex skeleton(const toolkit::Segment& axis, bool point) {
  toolkit::Convex c;
  c.vertex.push_back(axis.a);
  c.edges_at.resize(1);
  if (point) return c;
  c.vertex.push_back(axis.b);
  toolkit::Convex::Edge e;
  e.v0 = 0, e.v1 = 1;
  e.length = axis.length(), e.u = (axis.b - axis.a) / e.length;
  e.side_left = e.side_right = Vec3::Zero();
  c.edge.push_back(e);
  c.edges_at = {{0}, {0}};
  return c;
}

/// Prism of a cylinder about S.z: a circle of corners below, one above. Its radius gives it the cylinder's volume.
toolkit::Convex prism(double radius, double half_length) {
  constexpr uint32_t n = kCylinderSides;
  const double turn = 2 * M_PI / n, out = radius * std::sqrt(turn / std::sin(turn));
  std::vector<Vec3> vertex;
  for (const double z : {-half_length, half_length})
    for (uint32_t i = 0; i < n; ++i)
      vertex.emplace_back(out * std::cos(i * turn), out * std::sin(i * turn), z);
  std::vector<uint32_t> start{0}, index;
  for (uint32_t i = 0; i < n; ++i) index.push_back(n - 1 - i);
  start.push_back(n);
  for (uint32_t i = 0; i < n; ++i) index.push_back(n + i);
  start.push_back(2 * n);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t next = (i + 1) % n;
    index.insert(index.end(), {i, next, n + next, n + i});
    start.push_back(static_cast<uint32_t>(index.size()));
  }
  toolkit::Convex out_convex;
  toolkit::build_convex(vertex, start, index, out_convex);
  return out_convex;
}

/// Points the field to the present heights of `world` and sets the sphere around its box.
void fit_field(Solid& s, const scene::World& world, const scene::Shape& shape) {
  const scene::HeightFieldInfo& info = world.field[shape.field];
  s.field.z = info.state == scene::kNone ? info.height.data() : world.plugin_state.data() + info.state;
  const auto [low, high] = std::minmax_element(s.field.z, s.field.z + s.field.vertices());
  s.height = *high - *low + s.below;
  const Vec3 half = 0.5 * Vec3(s.field.width(), s.field.depth(), s.height);
  s.centre = s.X_BH * Vec3(half.x(), half.y(), *high - half.z());
  s.bound = half.norm();
}

}  // namespace

double support(const Solid& s, const Vec3& n) noexcept {
  switch (s.kind) {
    case SWAGE_SHAPE_CONVEX:
      return s.convex.support(n);
    case SWAGE_SHAPE_ARC:
      return n.dot(s.arc.point(lowest(s.arc, -n))) + s.radius * n.norm();
    case SWAGE_SHAPE_HEIGHT_FIELD: {
      // volume of the bounding box: enough for a separation test
      const Vec3 m = s.X_BH.turn_back(n), half = 0.5 * Vec3(s.field.width(), s.field.depth(), s.height);
      return n.dot(s.centre) + half.dot(m.cwiseAbs());
    }
    default:
      return std::max(n.dot(s.axis.a), n.dot(s.axis.b)) + s.radius * n.norm();
  }
}

Solid make_ball(double radius) {
  scene::Shape shape;
  shape.kind = SWAGE_SHAPE_SPHERE;
  shape.X_BS = Pose().abi();
  shape.radius = radius;
  return make_solid(shape, {});
}

Solid make_capsule() {
  scene::Shape shape;
  shape.kind = SWAGE_SHAPE_CAPSULE;
  shape.X_BS = Pose().abi();
  shape.radius = shape.half_length = 1;
  return make_solid(shape, {});
}

Solid make_solid(const scene::Shape& shape, const std::vector<toolkit::Convex>& convexes) {
  const Pose X_BS(shape.X_BS);
  Solid s;
  s.kind = shape.kind;
  s.radius = shape.kind == SWAGE_SHAPE_CONVEX ? 0.0 : shape.radius;
  if (shape.kind == SWAGE_SHAPE_CYLINDER) {
    s.kind = SWAGE_SHAPE_CONVEX;
    s.radius = 0;
    s.convex = toolkit::transformed(prism(shape.radius, shape.half_length), X_BS);
  } else if (shape.kind == SWAGE_SHAPE_CONVEX)
    s.convex = toolkit::transformed(convexes[shape.convex], X_BS);
  else if (shape.kind == SWAGE_SHAPE_ARC)
    s.arc = toolkit::Arc(X_BS, shape.arc_radius, shape.sweep);
  else
    s.axis = {X_BS * Vec3(0, 0, -shape.half_length), X_BS * Vec3(0, 0, shape.half_length)};
  if (shape.kind == SWAGE_SHAPE_SPHERE) s.axis = {X_BS.p, X_BS.p};
  if (shape.kind == SWAGE_SHAPE_SPHERE || shape.kind == SWAGE_SHAPE_CAPSULE)
    s.convex = skeleton(s.axis, shape.kind == SWAGE_SHAPE_SPHERE || shape.half_length <= 0);
  add_bound(s);
  return s;
}

Solid make_solid(const scene::World& world, uint32_t shape) {
  const scene::Shape& it = world.shape[shape];
  if (it.kind == SWAGE_SHAPE_CHAIN) {  // chain.hpp
    Solid chain;
    chain.kind = it.kind, chain.radius = it.radius;
    return chain;
  }
  if (it.kind != SWAGE_SHAPE_HEIGHT_FIELD) return make_solid(it, world.convex);
  const scene::HeightFieldInfo& info = world.field[it.field];
  Solid s;
  s.kind = it.kind;
  s.field = {info.nx, info.ny, info.dx, info.dy, nullptr};
  s.X_BH = Frame(it.X_BS);
  s.below = info.below;
  fit_field(s, world, it);
  return s;
}

void update_field(Solid& s, const scene::World& world, uint32_t shape) noexcept {
  const scene::Shape& it = world.shape[shape];
  if (world.field[it.field].state != scene::kNone) fit_field(s, world, it);
}

}  // namespace swage::contact
