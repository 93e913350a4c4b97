// SPDX-License-Identifier: Apache-2.0
//
// An elastic rod as a flexible body, solved by its band or by the mobility of its points.
#pragma once

#include <vector>

#include "dynamics/flexible_body.hpp"
#include "sliding_chain.hpp"
#include "toolkit/rod.hpp"

namespace swage::dynamics {

class RodBody final : public FlexibleBody {
 public:
  /// The world must already have the rod's chain on a body of its own; its start shape is unstretched.
  RodBody(scene::World& world, uint32_t object, uint32_t chain, const toolkit::RodSection& section, bool as_band)
      : world_(world), info_(world.chain[chain]), object_(object), as_band_(as_band), n_(static_cast<int>(info_.start.size())) {
    std::vector<double> rest;
    for (size_t i = 1; i < info_.s.size(); ++i) rest.push_back(info_.s[i] - info_.s[i - 1]);
    rod_ = toolkit::Rod(section, rest);
    frames_.resize(toolkit::RodState::frames(n_));
    begun_.resize(toolkit::RodState::size(n_)), base_.resize(toolkit::RodState::size(n_));
    side_.resize(static_cast<size_t>(4 * n_));
    toolkit::RodState s = state();
    rod_.start(s);
  }
  toolkit::RodState state() { return {n_, world_.plugin_state.data() + info_.state, frames_.data()}; }
  /// Fixes a node.
  void hold(int node) { rod_.hold(node), held_node_.push_back(node); }
  void let_go(int node) { rod_.hold(node, false), std::erase(held_node_, node); }
  toolkit::Rod& rod() { return rod_; }
  /// Stays bent beyond `yield` from here on.
  void set_yield(const toolkit::RodYield& yield) {
    yield_ = yield;
    set_.resize(static_cast<size_t>(2 * n_));
    rod_.start_set(set_.data());
    rod_.remember(set_.data());
  }
  /// Drag of a surrounding fluid; none by default.
  toolkit::RodFluid fluid;
  /// Copies the state of another rod of the same form.
  void take(const RodBody& other) { frames_ = other.frames_, held_ = other.held_; }
  /// What it keeps from step to step beside the state of the world.
  struct Kept {
    std::vector<double> frames, set;
    bool held = false;
  };
  void keep(Kept& kept) const { kept.frames = frames_, kept.set = set_, kept.held = held_; }
  void put_back(const Kept& kept) {
    frames_ = kept.frames, held_ = kept.held;
    std::copy(kept.set.begin(), kept.set.end(), set_.begin());  // the rod knows the place
  }
  toolkit::RodLoad load() const {
    toolkit::RodLoad out;
    out.h = world_.dt, out.gravity = toolkit::vec(world_.gravity), out.fluid = fluid;
    return out;
  }

  void advance() {
    toolkit::RodState s = state(), begun(n_, begun_.data()), base(n_, base_.data());
    rod_.flow(s, yield_, set_.data());
    begun.copy(s);
    if (held_) {
      rod_.prepare(begun, load());
      rod_.go_on(s, load(), 1e-3);
      rod_.finish(s, load());
    } else {
      rod_.step(s, load(), 6, 1e-12);
    }
    held_ = false;
    base.copy(s);
  }

  uint32_t object() const noexcept override { return object_; }
  bool surface_is_shape() const noexcept override { return true; }
  void locate(std::span<const swage_chain_place> place) noexcept override { place_ = place; }
  bool banded() const noexcept override { return as_band_; }
  bool linearise(uint32_t stiffer, double* stiffness, double* gradient) noexcept override {
    rod_.linearise(toolkit::RodState(n_, base_.data()), load(), static_cast<int>(stiffer), stiffness, gradient);
    return true;
  }
  void displace(const double* change, std::span<const swage_contact_point>, const double* impulse) noexcept override {
    note(impulse);
    toolkit::RodState s = state();
    rod_.go(toolkit::RodState(n_, base_.data()), change, s);
  }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    const toolkit::RodState begun(n_, begun_.data()), base(n_, base_.data());
    if (!rod_.linearise(base, load())) return false;
    const double h = world_.dt;
    const size_t rows = 3 * point.size();
    for (size_t c = 0; c < rows; ++c) {
      std::fill(side_.begin(), side_.end(), 0.0);
      push(point[c / 3], place_[c / 3], toolkit::Vec3::Unit(static_cast<int>(c % 3)));
      for (const int node : held_node_)
        for (int r = 0; r < 3; ++r) side_[static_cast<size_t>(4 * node + r)] = 0;
      rod_.matrix().solve(side_.data());
      for (size_t i = 0; i < point.size(); ++i) {
        const toolkit::Vec3 w = at(point[i], place_[i], side_.data()) / (h * h);
        for (size_t r = 0; r < 3; ++r) W[(3 * i + r) * rows + c] = w[static_cast<int>(r)];
      }
    }
    for (size_t i = 0; i < point.size(); ++i) {
      const swage_chain_place& p = place_[i];
      const int e = static_cast<int>(p.segment);
      const toolkit::Vec3 x0 = begun.node(e) + p.share * begun.edge(e), x1 = base.node(e) + p.share * base.edge(e);
      const toolkit::Vec3 v = (x1 - x0 + at(point[i], p, rod_.change())) / h;
      for (size_t r = 0; r < 3; ++r) v_free[3 * i + r] = v[static_cast<int>(r)];
    }
    return true;
  }
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override {
    note(impulse);
    std::fill(side_.begin(), side_.end(), 0.0);
    for (size_t i = 0; i < point.size(); ++i)
      push(point[i], place_[i], toolkit::Vec3(impulse[3 * i], impulse[3 * i + 1], impulse[3 * i + 2]) / world_.dt);
    toolkit::RodState s = state();
    rod_.respond(toolkit::RodState(n_, base_.data()), load(), side_.data(), s);
  }

 private:
  void note(const double* impulse) {
    for (size_t i = 0; i < 3 * place_.size(); ++i) held_ = held_ || impulse[i] != 0;
  }
  toolkit::Vec3 turn(const swage_contact_point& c, const swage_chain_place& p) {
    const toolkit::RodState base(n_, base_.data());
    const int e = static_cast<int>(p.segment);
    const toolkit::Vec3 u = base.edge(e);
    return u.normalized().cross(toolkit::vec(c.p_W) - base.node(e) - p.share * u);
  }
  toolkit::Vec3 at(const swage_contact_point& c, const swage_chain_place& p, const double* q) {
    const double* a = q + 4 * p.segment;
    toolkit::Vec3 out;
    for (int r = 0; r < 3; ++r) out[r] = (1 - p.share) * a[r] + p.share * a[4 + r];
    return out + a[3] * turn(c, p);
  }
  void push(const swage_contact_point& c, const swage_chain_place& p, const toolkit::Vec3& f) {
    double* a = side_.data() + 4 * p.segment;
    for (int r = 0; r < 3; ++r) a[r] += (1 - p.share) * f[r], a[4 + r] += p.share * f[r];
    a[3] += turn(c, p).dot(f);
  }

  scene::World& world_;
  const scene::ChainInfo info_;
  uint32_t object_;
  bool as_band_, held_ = false;
  int n_;
  std::vector<int> held_node_;
  toolkit::Rod rod_;
  toolkit::RodYield yield_;
  std::vector<double> frames_, set_, begun_, base_, side_;
  std::span<const swage_chain_place> place_;
};

}  // namespace swage::dynamics
