// SPDX-License-Identifier: Apache-2.0
#include "bending_body.hpp"

#include "scene/kinematics.hpp"
#include "scene/view.hpp"

namespace swage::bench {
namespace {

constexpr double kStraight = 300;  // m, radius of what counts as straight

needle::Form form_of(const Needle& n) {
  needle::Form form;
  form.chord = false;
  form.size = n.length();
  form.share = n.straight ? n.length() / (2 * std::numbers::pi * kStraight) : n.arc / (2 * std::numbers::pi);
  form.wire_diameter = n.wire_diameter;
  form.material.density = n.density;
  return form;
}

}  // namespace

BendingBody::BendingBody(scene::World& world, const Setup& setup, int pieces)
    : world_(world), needle_(setup.needle), moments_(setup.moments()), point_(needle::Bending::kMaxPoints) {
  const needle::Form form = form_of(setup.needle);
  const needle::Arc arc = form.arc();
  // circle frame A in N: x away from the centre of curvature, y along the wire
  toolkit::Mat3 R;
  R << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  const double offset = setup.needle.straight ? arc.radius : setup.needle.offset();
  const Pose X_NA(Vec3(0, 0, -offset), Quat(R));
  const auto X_NP = [&](int i) {
    const double s = (i + 0.5) / pieces;
    return X_NA * Pose(place_at(arc, s).p, toolkit::exp_rotation({0, 0, arc.angle(s)}));
  };
  bending_.set_up(pieces, form, X_NP(pieces / 2));

  world.body[kNeedle].motion = SWAGE_MOTION_FIXED;
  world.shape.erase(world.shape.begin());
  const double sweep = bending_.piece_sweep();
  const Pose X_PA(Vec3(-arc.radius, 0, 0), toolkit::exp_rotation({0, 0, -0.5 * sweep}));
  for (uint32_t b = 0; b < static_cast<uint32_t>(pieces); ++b) {
    const int i = bending_.piece_of(b);
    scene::BodyInfo body;
    body.motion = SWAGE_MOTION_FLEXIBLE, body.object = kNeedleObject;
    X_NP_.push_back(b == 0 ? Pose{} : X_NP(i));
    body.start = X_NP_.back().abi();
    world.body.push_back(body);
  }
  for (int i = 0; i < pieces; ++i) {
    scene::Shape shape;
    shape.kind = SWAGE_SHAPE_ARC;
    shape.object = kNeedleObject, shape.body = kFirst + bending_.body_of(i);
    shape.X_BS = (i == bending_.middle() ? X_NP(i) * X_PA : X_PA).abi();
    shape.radius = arc.wire_radius, shape.arc_radius = arc.radius, shape.sweep = sweep;
    shape.bounding_radius = arc.radius + arc.wire_radius;
    world.shape.push_back(shape);
  }
  world.plugin_state.assign(bending_.n_state(), 0.0);
  scene::reset(world);
}

swage_object_step BendingBody::view() {
  scene::Slices own;
  own.body = {kFirst, static_cast<uint32_t>(bending_.pieces())};
  own.state = {0, bending_.n_state()};
  return scene::view(world_, own, nullptr);
}

void BendingBody::put(const Pose& X_WN, const Vec3& v_W, const Vec3& w_W) {
  const swage_object_step raw = view();
  const Step step(&raw);
  bending_.reset(step);
  for (uint32_t b = 0; b < X_NP_.size(); ++b) {
    const Pose X = X_WN * X_NP_[b];
    world_.X_WB[kFirst + b] = X.abi();
    world_.V_WB[kFirst + b] = {toolkit::raw(Vec3(v_W + w_W.cross(X.p - X_WN.p))), toolkit::raw(w_W)};
  }
  auto& state = step.state<needle::BendingState>();
  const Vec3 L = X_WN.q * moments_.cwiseProduct(X_WN.q.conjugate() * w_W);
  for (int i = 0; i < 3; ++i) state.v[i] = v_W[i], state.L[i] = L[i];
}

void BendingBody::advance() {
  const swage_object_step raw = view();
  bending_.advance(Step(&raw));
}

/// The points in the needle's own indices.
std::span<const swage_contact_point> BendingBody::local(std::span<const swage_contact_point> point) noexcept {
  for (size_t i = 0; i < point.size(); ++i) point_[i] = point[i], point_[i].body -= kFirst;
  return {point_.data(), point.size()};
}

bool BendingBody::mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept {
  const swage_object_step raw = view();
  bending_.mobility(Step(&raw), local(point), v_free, W);
  return true;
}

void BendingBody::apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept {
  const swage_object_step raw = view();
  bending_.apply_impulses(Step(&raw), local(point), impulse);
}

Vec3 BendingBody::gives() const {
  const int n = bending_.pieces();
  if (n % 2 != 0) return Vec3::Zero();
  const needle::Form form = form_of(needle_);
  const double length = form.arc().length() / n;
  const auto section = form.section(0.5, form.arc().length());
  return {length / section.stiffness[2], length / section.stiffness[1], length / section.stiffness[0]};
}

needle::Bending::Reading BendingBody::read() {
  const swage_object_step raw = view();
  return bending_.read(Step(&raw));
}

}  // namespace swage::bench
