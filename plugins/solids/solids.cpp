// SPDX-License-Identifier: Apache-2.0
#include "solids.hpp"

#include <swage/plugin.hpp>

#include <algorithm>
#include <numbers>
#include <vector>

namespace swage::solids {
namespace {

using std::numbers::pi;
using toolkit::Vec3;

swage_mass mass_of(const SolidParams& p) {
  const double r = 0.5 * p.diameter;
  if (p.form == Form::kSphere) {
    const double m = p.density * 4.0 / 3.0 * pi * r * r * r;
    const double i = 0.4 * m * r * r;
    return {m, {i, i, i}};
  }
  // a cylinder between two half balls, whose centres of mass are 3/8 r outside their flat sides
  const double straight = p.length - p.diameter;
  const double cylinder = p.density * pi * r * r * straight, balls = p.density * 4.0 / 3.0 * pi * r * r * r;
  const double along = 0.5 * cylinder * r * r + 0.4 * balls * r * r;
  const double across = cylinder * (3 * r * r + straight * straight) / 12 +
                        balls * (0.4 * r * r + 0.25 * straight * straight + 0.375 * straight * r);
  return {cylinder + balls, {across, across, along}};
}

/// A box with edges along the axes, centred at c.
void add_box(ObjectBuilder& builder, Body body, swage_vec3 c, swage_vec3 size) {
  std::vector<double> vertex;
  for (int i = 0; i < 8; ++i) {
    vertex.push_back(c.x + ((i & 1) != 0 ? 0.5 : -0.5) * size.x);
    vertex.push_back(c.y + ((i & 2) != 0 ? 0.5 : -0.5) * size.y);
    vertex.push_back(c.z + ((i & 4) != 0 ? 0.5 : -0.5) * size.z);
  }
  constexpr uint32_t kStart[] = {0, 4, 8, 12, 16, 20, 24};
  constexpr uint32_t kFaces[] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  builder.convex(body, vertex, kStart, kFaces);
}

/// A floor whose upper face is z = 0 and a rim on four sides, about the middle of the floor.
void add_tray(ObjectBuilder& builder, Body body, swage_vec3 inside) {
  constexpr double kWall = 1e-3;  // m, thick enough that nothing is pushed through in one step
  const swage_vec3 a = inside;
  add_box(builder, body, {0, 0, -0.5 * kWall}, {a.x + 2 * kWall, a.y + 2 * kWall, kWall});
  for (const double side : {-1.0, 1.0}) {
    add_box(builder, body, {side * 0.5 * (a.x + kWall), 0, 0.5 * a.z}, {kWall, a.y + 2 * kWall, a.z});
    add_box(builder, body, {0, side * 0.5 * (a.y + kWall), 0.5 * a.z}, {a.x, kWall, a.z});
  }
}

}  // namespace

Body SolidObject::add_body(const SolidParams& params, ObjectBuilder& builder) const {
  return params.fixed ? builder.fixed_body("solid") : builder.dynamic_body("solid", mass_of(params));
}

void SolidObject::build(const SolidParams& params, ObjectBuilder& builder) {
  const bool round = params.form == Form::kSphere || params.form == Form::kCylinder;
  if (!round && !params.fixed)
    builder.error("fixed", "only spheres and cylinders move: set \"fixed\" to true");
  if (params.form == Form::kCylinder && params.length <= params.diameter) {
    builder.error("length", "a cylinder is longer than it is thick: its ends are half balls");
  }
  if (builder.failed()) return;

  body_ = add_body(params, builder);
  const double r = 0.5 * params.diameter;
  extent_ = params.diameter;
  switch (params.form) {
    case Form::kSphere:
      builder.sphere(body_, {0, 0, 0}, r);
      break;
    case Form::kCylinder:
      length_ = extent_ = params.length;
      builder.capsule(body_, {0, 0, r - 0.5 * length_}, {0, 0, 0.5 * length_ - r}, r);
      break;
    case Form::kBox:
      extent_ = std::max({params.size.x, params.size.y, params.size.z});
      add_box(builder, body_, {0, 0, 0}, params.size);
      break;
    case Form::kSlot:
      for (const double side : {-0.5, 0.5}) {
        add_box(builder, body_, {0, side * (params.gap + params.size.y), 0}, params.size);
      }
      break;
    case Form::kTray:
      add_tray(builder, body_, params.size);
      break;
    case Form::kNest:
      for (int i = 0; i < 3; ++i) {
        const double a = 2 * pi * i / 3;
        builder.sphere(body_, {r * std::cos(a), r * std::sin(a), 0}, 0.5 * params.bead);
      }
      break;
  }
}

void SolidObject::locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) {
  const toolkit::Pose X_WB(step.pose(body_));
  const double z = std::clamp((X_WB.inverse() * toolkit::vec(p_W)).z(), -0.5 * length_, 0.5 * length_);
  out.s = length_ > 0 ? 0.5 + z / length_ : 0.5;
  out.length = extent_;
  out.p_W = toolkit::raw(X_WB * Vec3(0, 0, z));
  out.tangent_W = toolkit::raw(X_WB.q * Vec3::UnitZ());
  out.normal_W = toolkit::raw(X_WB.q * Vec3::UnitX());
}

}  // namespace swage::solids

SWAGE_EXPORT(swage::solids::SolidObject)
