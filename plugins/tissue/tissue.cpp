// SPDX-License-Identifier: Apache-2.0
#include "tissue.hpp"

#include <swage/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swage::tissue {

using toolkit::Frame;
using toolkit::raw;
using toolkit::vec;

namespace {

// N/m of one contact with a compliant surface: in series with the half space, so stiff that its compliance adds less than
// a hundredth.
constexpr double kTouchStiffness = 1e5;

}  // namespace

void Tissue::build(const TissueParams& params, ObjectBuilder& builder) {
  params_ = params;
  WallShape shape{params.form,   params.size,        params.thickness,
                  params.slope,  params.wave_height, params.wave_length,
                  params.radius, params.slit,        {}};
  if (params.form == Form::kCylinder && params.size[0] > 1.9 * params.radius)
    builder.error("size", "a flap of a cylinder is narrower along x than 1.9 radii");
  if (params.slit > 0.5 * params.size[0])
    builder.error("slit", "the slit must be narrower than half the patch");
  if (params.edge_stiffness > 0 && (!(params.slit > 0) || !yields()))
    builder.error("edge_stiffness", "edges that move are those of a \"slit\", level compliant or mesh");
  if (params.mount_stiffness > 0 && yields()) builder.error("mount_stiffness", "a patch that moves as a whole is of level plane");
  if (params.touched == Touched::kSmooth && params.form > Form::kRightSlope && (params.slit > 0 || !(params.backing > 0)))
    builder.error("touched", "a curved wall that is touched as smooth has no \"slit\", and needs a \"backing\"");
  edges_ = {params.edge_stiffness > 0 ? 1 / params.edge_stiffness : 0, params.slit};
  if (params.form == Form::kTable) {
    try {
      shape.table = read_heights(params.heights);
    } catch (const std::runtime_error& problem) {
      builder.error("heights", problem.what());
    }
  }
  wall_ = Wall(shape);
  if (params.level == Level::kMesh && !builder.failed()) {
    const MeshSpec spec = mesh_spec(params);
    const std::string unfit = CoarseGrid(spec).unfit(spec);
    if (!unfit.empty()) builder.error("cells", unfit.c_str());
  }
  if (builder.failed()) return;

  build_body(params, builder);
  if (yields()) {
    asked_.C_W.resize(size_t{kPoints} * kPoints);
    edges_.move() ? builder.state<SlitState>() : builder.state<State>();
  }
  if (params.level == Level::kCompliant)
    compliance_ = Compliance({params.young / 3, params.spread, params.skin, params.skin_young});
  if (params.level == Level::kMesh) {
    mesh_ = Mesh(mesh_spec(params));
    asked_.response.resize(size_t{kPoints} * kPoints);
    asked_.load.reserve(2 * kSources);
  }
  add_surface(params, builder);
  dimple_ = builder.signal("tissue.dimple", "m", "Deepest displacement of the surface; not level plane.");
  force_ = builder.signal("tissue.force", "N", "Sum of what presses on the surface; not level plane.");
  if (edges_.move()) gap_ = builder.signal("tissue.gap", "m", "Width of the slit as its edges are drawn now; 0: they meet.");
}

/// Builds a patch that moves as a whole on a hinge far below it.
void Tissue::build_body(const TissueParams& p, ObjectBuilder& builder) {
  if (!mounted()) {
    body_ = yields() ? builder.flexible_body("wall") : builder.fixed_body("wall");
    return;
  }
  const Body base = builder.fixed_body("base");
  body_ = builder.hinged_body("wall");
  mount_ = builder.hinge({base, body_, {0, 0, -kMountArm}, {0, 1, 0}, p.mount_mass * kMountArm * kMountArm, -p.mount_travel / kMountArm,
                          p.mount_travel / kMountArm});
  shift_ = builder.signal("tissue.shift", "m", "Way of the whole patch along its x axis.");
}

/// The spring of the mount, critically damped.
void Tissue::forces(const Step& step) {
  if (!mounted()) return;
  const double k = params_.mount_stiffness, square = kMountArm * kMountArm;
  step.drive(mount_) = {0, k * square, 2 * std::sqrt(k * params_.mount_mass) * square, k * square};
}

void Tissue::add_piece(const Wall::Piece& piece, uint32_t flags, ObjectBuilder& builder) {
  constexpr uint32_t kStart[] = {0, 4, 8, 12, 16, 20, 24};
  constexpr uint32_t kFaces[] = {0, 1, 2, 3, 7, 6, 5, 4, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0};
  std::vector<double> vertex;
  for (const Vec3& corner : piece) vertex.insert(vertex.end(), corner.data(), corner.data() + 3);
  builder.convex(body_, vertex, kStart, kFaces, flags);
}

/// The colliding pieces are deeper than the drawn ones, so that no object is pushed out on the wrong side.
void Tissue::add_surface(const TissueParams& params, ObjectBuilder& builder) {
  const auto add = [&](double depth, uint32_t flags) {
    for (const Wall::Piece& piece : wall_.pieces(depth)) add_piece(piece, flags, builder);
  };
  if (smooth()) {
    add_smooth_surface(params, builder);
    add(params.thickness, SWAGE_SHAPE_DRAWN);
  } else if (params.backing > 0) {
    add(params.thickness + params.backing, SWAGE_SHAPE_COLLIDES);
    add(params.thickness, SWAGE_SHAPE_DRAWN);
  } else {
    add(params.thickness, SWAGE_SHAPE_USUAL);
  }
}

/// A curved surface without borders: a height field, which pushes outwards wherever it is dented.
void Tissue::add_smooth_surface(const TissueParams& params, ObjectBuilder& builder) {
  const Wall::Grid grid = wall_.grid(params.thickness + params.backing, 0.5 * params.backing);
  swage_height_field field{};
  field.X_BH = {{grid.x0, grid.y0, 0}, {1, 0, 0, 0}};
  field.nx = grid.nx, field.ny = grid.ny, field.dx = grid.dx, field.dy = grid.dy;
  field.below = grid.below;
  field.height = grid.height.data();
  field.state = SWAGE_NONE;
  builder.height_field(host_extension<swage_host_height_field>(SWAGE_HOST_HEIGHT_FIELD), body_, field, SWAGE_SHAPE_COLLIDES);
  for (const Wall::Piece& piece : grid.frame) add_piece(piece, SWAGE_SHAPE_COLLIDES, builder);
}

MeshSpec Tissue::mesh_spec(const TissueParams& p) const {
  const double width = wall_.laid_flat(0.5 * p.size[0]) - wall_.laid_flat(-0.5 * p.size[0]);
  return {{width, p.size[1]}, p.thickness, p.slit,  p.young,     p.spread, p.skin,
          p.skin_young,       p.underside, p.cells, p.refinement};
}

void Tissue::activate(double dt_s) { creep_in(dt_s); }

void Tissue::creep_in(double dt) {
  if (dt == creep_dt_) return;
  creep_dt_ = dt;
  creep_ = Creep(params_.relaxed, params_.relaxation_time, dt);
}

void Tissue::reset(const Step& step) {
  if (yields()) step.state<State>() = {};
  if (edges_.move()) step.state<SlitState>() = {};
  asked_.n = 0;
}

void Tissue::law(const Step&, swage_pierceable_law& out) {
  const bool compliant = yields();
  out = {compliant ? kTouchStiffness : params_.stiffness,
         compliant ? 0 : params_.stiffening,
         params_.friction,
         params_.puncture_force,
         params_.cutting_force,
         params_.drag,
         params_.side_stiffness,
         params_.failure_stress};
}

void Tissue::locate(const Step& step, swage_vec3 p_W, swage_pierceable_place& out) {
  const Frame& X_WO = frame(step);
  const WallPlace place = wall_.locate(X_WO.inverse_times(vec(p_W)));
  out.depth = place.depth;
  out.beyond = place.depth - params_.thickness;
  out.edge = place.edge;
  out.p_W = raw(X_WO * place.foot);
  out.normal_W = raw(X_WO.turn(place.normal));
  out.body = body_;
  out.reserved = 0;
}

}  // namespace swage::tissue

SWAGE_EXPORT(swage::tissue::Tissue)
