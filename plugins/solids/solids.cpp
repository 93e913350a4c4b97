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
  if (p.form == Form::kRing) {
    const double R2 = r * r, w2 = 0.25 * p.wire_diameter * p.wire_diameter;
    const double m = p.density * 2 * pi * pi * r * w2;
    const double across = m * (0.5 * R2 + 0.625 * w2);
    return {m, {across, across, m * (R2 + 0.75 * w2)}};
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

void SolidObject::check(const SolidParams& params, ObjectBuilder& builder) {
  const bool round = params.form == Form::kSphere || params.form == Form::kCylinder || params.form == Form::kRing;
  if (!round && !params.fixed)
    builder.error("fixed", "only spheres, cylinders and rings move: set \"fixed\" to true");
  if (params.form == Form::kCylinder && params.length <= params.diameter) {
    builder.error("length", "a cylinder is longer than it is thick: its ends are half balls");
  }
  if (params.form == Form::kRing && params.wire_diameter >= 0.5 * params.diameter)
    builder.error("wire_diameter", "a ring's wire is thinner than half of its diameter");
  if (params.form != Form::kWire) return;
  const std::string wrong = read_course(params.course, wire_);
  if (!wrong.empty()) return builder.error("course", wrong);
  for (const Piece& piece : wire_)
    if (piece.bend != 0 && piece.radius() <= 0.5 * params.wire_diameter)
      return builder.error("course", "a bend needs a radius of more than half of the wire's diameter");
}

/// Adds the pieces with round ends that overlap.
void SolidObject::add_wire(const SolidParams& params, ObjectBuilder& builder) const {
  const double r = 0.5 * params.wire_diameter;
  for (const Piece& piece : wire_) {
    if (piece.bend == 0) {
      builder.capsule(body_, toolkit::raw(piece.start), toolkit::raw(piece.at(piece.length)), r);
      continue;
    }
    // an arc runs counter-clockwise: a bend to the right begins at its end
    const Vec3 from = (piece.bend > 0 ? piece.start : piece.at(piece.length)) - piece.centre();
    const toolkit::Pose X(piece.centre(), toolkit::exp_rotation({0, 0, std::atan2(from.y(), from.x())}));
    builder.arc(body_, {X.abi(), piece.radius(), std::abs(piece.bend), r});
  }
}

void SolidObject::build(const SolidParams& params, ObjectBuilder& builder) {
  length_ = ring_ = 0;
  wire_.clear();
  check(params, builder);
  if (builder.failed()) return;

  body_ = add_body(params, builder);
  fixed_ = params.fixed;
  environment_ = environment(host());
  mass_ = fixed_ ? swage_mass{} : mass_of(params);
  density_ = params.density, thickness_ = params.form == Form::kRing ? params.wire_diameter : params.diameter;
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
    case Form::kRing: {
      // the two ends of the arc meet, on -x
      constexpr double kClosed = 2 * pi * (1 - 1e-9);
      const toolkit::Pose X(Vec3::Zero(), toolkit::exp_rotation({0, 0, pi}));
      ring_ = r;
      extent_ = 2 * pi * r;
      builder.arc(body_, {X.abi(), r, kClosed, 0.5 * params.wire_diameter});
      break;
    }
    case Form::kWire:
      extent_ = wire_.back().from + wire_.back().length;
      add_wire(params, builder);
      break;
  }
}

void SolidObject::locate_on_wire(const Vec3& p_B, Vec3& at, Vec3& tangent, double& s) const {
  double least = HUGE_VAL;
  for (const Piece& piece : wire_) {
    const double l = piece.nearest(p_B);
    const double far = (piece.at(l) - p_B).squaredNorm();
    if (far >= least) continue;
    least = far;
    at = piece.at(l);
    tangent = piece.forward(l);
    s = (piece.from + l) / extent_;
  }
}

void SolidObject::locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) {
  const toolkit::Pose X_WB(step.pose(body_));
  const Vec3 p_B = X_WB.inverse() * toolkit::vec(p_W);
  Vec3 at = Vec3::Zero(), tangent = Vec3::UnitZ(), normal = Vec3::UnitX();
  out.s = 0.5;
  if (!wire_.empty()) {
    normal = Vec3::UnitZ();
    locate_on_wire(p_B, at, tangent, out.s);
  } else if (ring_ > 0) {
    const double angle = std::atan2(p_B.y(), p_B.x());
    normal = Vec3::UnitZ();
    tangent = Vec3(-std::sin(angle), std::cos(angle), 0);
    at = ring_ * Vec3(std::cos(angle), std::sin(angle), 0);
    out.s = 0.5 + angle / (2 * pi);
  } else if (length_ > 0) {
    at.z() = std::clamp(p_B.z(), -0.5 * length_, 0.5 * length_);
    out.s = 0.5 + at.z() / length_;
  }
  out.length = extent_;
  out.p_W = toolkit::raw(X_WB * at);
  out.tangent_W = toolkit::raw(X_WB.q * tangent);
  out.normal_W = toolkit::raw(X_WB.q * normal);
}

}  // namespace swage::solids

SWAGE_EXPORT(swage::solids::SolidObject)
