// SPDX-License-Identifier: Apache-2.0
//
// A wire of one flexible body that translates as a whole, without rotation: the simplest object with a chain.
#pragma once

#include <algorithm>
#include <vector>

#include "dynamics/flexible_body.hpp"
#include "scene/chain.hpp"
#include "scene/kinematics.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

/// Adds a body; returns its index.
inline uint32_t add_body(scene::World& w, int32_t motion, uint32_t object, const toolkit::Vec3& p) {
  scene::BodyInfo body;
  body.motion = motion, body.object = object;
  body.start = toolkit::Pose(p, toolkit::Quat::Identity()).abi();
  w.body.push_back(body);
  return static_cast<uint32_t>(w.body.size() - 1);
}

inline scene::Shape shape_on(uint32_t body, uint32_t object, int32_t kind, double radius) {
  scene::Shape shape;
  shape.body = body, shape.object = object, shape.kind = kind, shape.radius = radius;
  shape.X_BS = toolkit::Pose{}.abi();
  return shape;
}

/// Adds a chain on a body of its own.
inline void add_chain(scene::World& w, const std::vector<toolkit::Vec3>& p, double radius, uint32_t object) {
  scene::ChainInfo info;
  double s = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    if (i > 0) s += (p[i] - p[i - 1]).norm();
    info.start.push_back(toolkit::raw(p[i]));
    info.s.push_back(s);
    info.radius.push_back(i + 1 < p.size() ? radius : 0);
  }
  info.bend_radius = radius, info.state = static_cast<uint32_t>(w.plugin_state.size());
  w.plugin_state.resize(info.state + scene::chain_doubles(static_cast<uint32_t>(p.size())));
  const uint32_t body = add_body(w, SWAGE_MOTION_FLEXIBLE, object, toolkit::Vec3::Zero());
  scene::Shape shape = shape_on(body, object, SWAGE_SHAPE_CHAIN, radius);
  shape.chain = static_cast<uint32_t>(w.chain.size());
  w.chain.push_back(info);
  w.shape.push_back(shape);
}

class SlidingChain : public FlexibleBody {
 public:
  /// `load`: N. The world must already have its chain, or capsules on one body.
  SlidingChain(scene::World& world, uint32_t object, uint32_t body, uint32_t chain, double mass,
               const toolkit::Vec3& v, const toolkit::Vec3& load = toolkit::Vec3::Zero())
      : world_(world), object_(object), body_(body), chain_(chain), mass_(mass), load_(load), v_(v) {}

  uint32_t object() const noexcept override { return object_; }
  bool surface_is_shape() const noexcept override { return true; }
  void locate(std::span<const swage_chain_place> place) noexcept override {
    for (const swage_chain_place& p : place) furthest = std::max(furthest, p.segment);
  }
  void advance() noexcept {
    v_free_ = v_ + world_.dt / mass_ * load_;
    move(world_.dt * v_);
  }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    const size_t n = 3 * point.size();
    for (size_t i = 0; i < n; ++i) {
      v_free[i] = v_free_[static_cast<int>(i % 3)];
      for (size_t j = 0; j < n; ++j) W[i * n + j] = i % 3 == j % 3 ? 1 / mass_ : 0;
    }
    return true;
  }
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override {
    toolkit::Vec3 sum = world_.dt * load_;
    for (size_t i = 0; i < point.size(); ++i)
      sum += toolkit::Vec3(impulse[3 * i], impulse[3 * i + 1], impulse[3 * i + 2]);
    v_ += sum / mass_;
    move(world_.dt / mass_ * sum);
  }
  const toolkit::Vec3& x() const { return x_; }
  uint32_t furthest = 0;  // largest index of a touched piece

 private:
  void move(const toolkit::Vec3& d) {
    x_ += d;
    if (chain_ == scene::kNone) {
      world_.X_WB[body_].p = toolkit::raw(toolkit::Vec3(toolkit::vec(world_.body[body_].start.p) + x_));
      world_.V_WB[body_].v = toolkit::raw(v_);
      return;
    }
    const scene::ChainInfo& info = world_.chain[chain_];
    const size_t n = info.start.size();
    double* at = world_.plugin_state.data() + info.state;
    for (size_t i = 0; i < n; ++i) {
      Eigen::Map<toolkit::Vec3>(at + 3 * i) = toolkit::vec(info.start[i]) + x_;
      Eigen::Map<toolkit::Vec3>(at + 3 * (n + i)) = v_;
    }
  }
  scene::World& world_;
  uint32_t object_, body_, chain_;
  double mass_;
  toolkit::Vec3 load_, x_ = toolkit::Vec3::Zero(), v_, v_free_ = toolkit::Vec3::Zero();
};

}  // namespace swage::dynamics
