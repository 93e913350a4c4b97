// SPDX-License-Identifier: Apache-2.0
#include "tissue.hpp"

#include <swage/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swage::tissue {

using toolkit::Pose;
using toolkit::raw;
using toolkit::vec;

namespace {

// N/m of one touch at the level compliant: in series with the half space, so stiff that it adds under a hundredth to it.
constexpr double kTouchStiffness = 1e5;
// Forces nearer to each other than this share of the spread act at one place.
constexpr double kMerge = 0.25;
// What creep remembers below this, N, is forgotten: it displaces less than a nanometre.
constexpr double kForgotten = 1e-9;

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
/// Where a source is seen: where it bears, or bore.
Vec3 place_of(const Source& s) { return vec3(vec3(s.f).isZero(0) ? s.p : s.q); }

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
  if (params.form == Form::kTable) {
    try {
      shape.table = read_heights(params.heights);
    } catch (const std::runtime_error& problem) {
      builder.error("heights", problem.what());
    }
  }
  if (builder.failed()) return;

  wall_ = Wall(shape);
  const bool compliant = params.level == Level::kCompliant;
  body_ = compliant ? builder.own_body("wall") : builder.fixed_body("wall");
  if (compliant) {
    compliance_ = Compliance({params.young / 3, params.spread, params.skin, params.skin_young});
    builder.state<State>();
  }
  add_surface(params, builder);
  dimple_ =
      builder.signal("tissue.dimple", "m", "Deepest displacement of the surface; level compliant only.");
  force_ = builder.signal("tissue.force", "N", "Sum of what presses on the surface; level compliant only.");
}

/// What touches is deeper than what is seen, so that nothing is pushed out on the wrong side.
void Tissue::add_surface(const TissueParams& params, ObjectBuilder& builder) {
  constexpr uint32_t kStart[] = {0, 4, 8, 12, 16, 20, 24};
  constexpr uint32_t kFaces[] = {0, 1, 2, 3, 7, 6, 5, 4, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0};
  const auto add = [&](double depth, uint32_t flags) {
    for (const Wall::Piece& piece : wall_.pieces(depth)) {
      std::vector<double> vertex;
      for (const Vec3& corner : piece) vertex.insert(vertex.end(), corner.data(), corner.data() + 3);
      builder.convex(body_, vertex, kStart, kFaces, flags);
    }
  };
  if (params.backing > 0) {
    add(params.thickness + params.backing, SWAGE_SHAPE_COLLIDES);
    add(params.thickness, SWAGE_SHAPE_DRAWN);
  } else {
    add(params.thickness, SWAGE_SHAPE_USUAL);
  }
}

void Tissue::activate(double dt_s) { creep_ = Creep(params_.relaxed, params_.relaxation_time, dt_s); }

void Tissue::reset(const Step& step) {
  if (params_.level == Level::kCompliant) step.state<State>() = {};
}

void Tissue::law(const Step&, swage_pierceable_law& out) {
  const bool compliant = params_.level == Level::kCompliant;
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
  const Pose X_WO = pose(step);
  const WallPlace place = wall_.locate(X_WO.inverse() * vec(p_W));
  out.depth = place.depth;
  out.beyond = place.depth - params_.thickness;
  out.edge = place.edge;
  out.p_W = raw(X_WO * place.foot);
  out.normal_W = raw(X_WO.q * place.normal);
  out.body = body_;
  out.reserved = 0;
}

// --- level compliant

Tissue::Spot Tissue::spot(const Pose& X_WO, const Vec3& foot_O) const {
  Spot s;
  s.foot_O = foot_O;
  const Vec3 n = wall_.normal(foot_O.x(), foot_O.y());
  const Vec3 along = Vec3(n.z(), 0, -n.x()).normalized();
  s.axes_W.col(0) = X_WO.q * n;
  s.axes_W.col(1) = X_WO.q * along;
  s.axes_W.col(2) = X_WO.q * n.cross(along);
  return s;
}

Tissue::Spot Tissue::spot_at(const Pose& X_WO, swage_vec3 p_W) const {
  return spot(X_WO, wall_.locate(X_WO.inverse() * vec(p_W)).foot);
}

/// Between two places of the surface, flattened: distances along x grow with the slope there.
Mat3 Tissue::response(const Vec3& a, const Vec3& b) const {
  const double dx = a.x() - b.x(), dz = a.z() - b.z();
  return compliance_.between(std::copysign(std::sqrt(dx * dx + dz * dz), dx), a.y() - b.y());
}

void Tissue::advance(const Step& step) {
  if (params_.level != Level::kCompliant) return;
  for (Source& s : step.state<State>().source)
    for (int i = 0; i < 3; ++i) {
      s.q_old[i] = s.q[i], s.w[i] = s.f[i];
      s.dv[i] = (creep_.keep - 1) * s.v[i];
      s.v[i] += s.dv[i];
      s.f[i] = 0;
    }
}

/// u = C (f + v): while nothing new presses, the surface goes over the step by C dv - C w.
void Tissue::compliance(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                        double* W) {
  const Pose X_WO = pose(step);
  const State& state = step.state<State>();
  const double h = step.dt(), give = creep_.at_once() / (h * h);
  const size_t n = points.size(), stride = 3 * n;
  Spot spots[kPoints];
  for (size_t i = 0; i < n && i < kPoints; ++i) {
    spots[i] = spot_at(X_WO, points[i].p_W);
    Vec3 v = Vec3::Zero();
    for (const Source& s : state.source) {
      if (!vec3(s.dv).isZero(0)) v += response(spots[i].foot_O, vec3(s.p)) * vec3(s.dv);
      if (!vec3(s.w).isZero(0)) v -= response(spots[i].foot_O, vec3(s.q_old)) * vec3(s.w);
    }
    put(v_free + 3 * i, spots[i].axes_W * v / h);
    for (size_t j = 0; j <= i; ++j) {
      const Mat3 C =
          give * spots[i].axes_W * response(spots[i].foot_O, spots[j].foot_O) * spots[j].axes_W.transpose();
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c) {
          const double value = C(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
          W[(3 * i + r) * stride + 3 * j + c] = value;
          W[(3 * j + c) * stride + 3 * i + r] = value;
        }
    }
  }
}

void Tissue::displacement(const Step& step, std::span<const swage_contact_point> points, double* u_W) {
  const Pose X_WO = pose(step);
  const State& state = step.state<State>();
  for (size_t i = 0; i < points.size(); ++i) {
    const Spot at = spot_at(X_WO, points[i].p_W);
    put(u_W + 3 * i, at.axes_W * displaced(state, at.foot_O));
  }
}

/// The source that remembers for a place and bears nothing yet in this step: the nearest one, or the one that matters least.
Source& Tissue::source_at(State& state, const Vec3& foot_O) const {
  Source *least = state.source, *nearest = nullptr;
  double least_size = HUGE_VAL, near = kMerge * params_.spread;
  for (Source& s : state.source) {
    const double size = (vec3(s.f) + vec3(s.v)).norm();
    if (size < least_size) least = &s, least_size = size;
    const double distance = (vec3(s.p) - foot_O).norm();
    if (size > 0 && vec3(s.f).isZero(0) && distance < near) nearest = &s, near = distance;
  }
  if (nearest != nullptr) return *nearest;
  *least = {};
  put(least->p, foot_O);
  return *least;
}

void Tissue::yield(const Step& step, std::span<const swage_contact_point> points, const double* impulse) {
  const Pose X_WO = pose(step);
  State& state = step.state<State>();
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 f_W = vec3(impulse + 3 * i) / step.dt();
    if (f_W.isZero(0)) continue;
    const Spot at = spot_at(X_WO, points[i].p_W);
    Source& s = source_at(state, at.foot_O);
    put(s.q, at.foot_O);
    put(s.f, at.axes_W.transpose() * f_W);
  }
  for (Source& s : state.source) put(s.v, vec3(s.v) + creep_.gain * vec3(s.f));
}

/// Where a place of the surface is displaced to [m, along n, 1, 2].
Vec3 Tissue::displaced(const State& state, const Vec3& foot_O) const {
  Vec3 u = Vec3::Zero();
  for (const Source& s : state.source) {
    if (!vec3(s.v).isZero(0)) u += response(foot_O, vec3(s.p)) * vec3(s.v);
    if (!vec3(s.f).isZero(0)) u += response(foot_O, vec3(s.q)) * vec3(s.f);
  }
  return u;
}

void Tissue::finish(const Step& step) {
  double dimple = 0, force = 0;
  if (params_.level == Level::kCompliant) {
    State& state = step.state<State>();
    const Source* deepest = nullptr;
    double most = 0;
    for (Source& s : state.source) {
      const double size = (vec3(s.f) + vec3(s.v)).norm();
      if (vec3(s.f).isZero(0) && size < kForgotten) s = {};
      force += std::max(0.0, -s.f[0]);
      if (size > most) deepest = &s, most = size;
    }
    if (most > 0) dimple = displaced(state, place_of(*deepest)).norm();
  }
  step.signal(dimple_, dimple);
  step.signal(force_, force);
}

uint32_t Tissue::dents(const Step& step, std::span<swage_dent> out) {
  if (params_.level != Level::kCompliant) return 0;
  const Pose X_WO = pose(step);
  const Mat3 own = compliance_.between(0, 0);
  uint32_t n = 0;
  for (const Source& s : step.state<State>().source) {
    const Vec3 amplitude = vec3(s.f) + vec3(s.v);
    if (amplitude.norm() < 1e3 * kForgotten || n == out.size()) continue;
    const Spot at = spot(X_WO, place_of(s));
    out[n++] = {raw(X_WO * at.foot_O), raw(Vec3(at.axes_W * (own * amplitude))), compliance_.spread()};
  }
  return n;
}

}  // namespace swage::tissue

SWAGE_EXPORT(swage::tissue::Tissue)
