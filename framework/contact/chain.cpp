// SPDX-License-Identifier: Apache-2.0
#include "contact/chain.hpp"

#include <algorithm>
#include <numbers>

namespace swage::contact {

ChainTree::ChainTree(const scene::World& world, uint32_t shape) : chain_(world.shape[shape].chain) {
  const scene::ChainInfo& info = world.chain[chain_];
  segments_ = static_cast<uint32_t>(info.start.size() - 1);
  exclusion_ = std::numbers::pi * std::max(info.bend_radius, world.shape[shape].radius);
  piece_.resize(segments_);
  node_.reserve(2 * size_t{segments_});
  add_halves(node_, 0, segments_, kLeaf);
}

void ChainTree::refit(const scene::World& world) noexcept {
  const scene::ChainView chain(world, world.chain[chain_]);
  drift_.setZero();
  for (uint32_t i = 0; i < segments_; ++i) {
    Piece& piece = piece_[i];
    piece.p0 = i > 0 ? piece_[i - 1].p1 : chain.p(0), piece.p1 = chain.p(i + 1);
    piece.v0 = i > 0 ? piece_[i - 1].v1 : chain.v(0), piece.v1 = chain.v(i + 1);
    piece.s0 = i > 0 ? piece_[i - 1].s1 : chain.s(0), piece.s1 = chain.s(i + 1);
    piece.radius = piece.p0 == piece.p1 ? 0.0 : chain.radius(i);
    drift_ += piece.v0 + piece.v1;
  }
  const Vec3 mean = drift_ / (2.0 * segments_);
  drift_ = world.dt * mean;
  // a piece begins where the one before it ends
  double fastest = (piece_[0].v0 - mean).squaredNorm();
  for (const Piece& piece : piece_) fastest = std::max(fastest, (piece.v1 - mean).squaredNorm());
  moves_ = world.dt * std::sqrt(fastest);

  // children follow their parents
  for (size_t k = node_.size(); k-- > 0;) {
    Node& node = node_[k];
    node.box = {};
    node.s_low = piece_[node.first].s0, node.s_high = piece_[node.first + node.count - 1].s1;
    if (node.right != 0) {
      node.box.add(node_[k + 1].box);
      node.box.add(node_[node.right].box);
      continue;
    }
    double thick = 0;
    const auto add = [&](const Vec3& p, const Vec3& v) {
      node.box.add(p);
      if (moves_ > 0) node.box.add(p - world.dt * (v - mean));
    };
    add(piece_[node.first].p0, piece_[node.first].v0);
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      thick = std::max(thick, piece_[i].radius);
      add(piece_[i].p1, piece_[i].v1);
    }
    node.box.grow(thick);
  }
}

Vec3 ChainTree::onward(uint32_t i, bool end) const {
  if (end) return there(i + 1) ? Vec3((piece_[i + 1].p1 - piece_[i + 1].p0).normalized()) : Vec3::Zero();
  return i > 0 && there(i - 1) ? Vec3((piece_[i - 1].p0 - piece_[i - 1].p1).normalized()) : Vec3::Zero();
}

ChainPlace ChainTree::place(uint32_t i, const Vec3& p_W) const {
  const Piece& piece = piece_[i];
  const Vec3 along = piece.p1 - piece.p0;
  const double share = std::clamp(along.dot(p_W - piece.p0) / along.squaredNorm(), 0.0, 1.0);
  return {i, share, piece.s0 + share * (piece.s1 - piece.s0)};
}

void ChainTree::solid_of(uint32_t i, double dt, Solid& solid, Frame& X_WS, Motion& motion) const {
  const Piece& piece = piece_[i];
  const Vec3 half = 0.5 * (piece.p1 - piece.p0), middle = 0.5 * (piece.p0 + piece.p1);
  const double length = 2 * half.norm();
  solid.axis = {-half, half};
  solid.radius = piece.radius;
  solid.bound = 0.5 * length + piece.radius;
  solid.convex.vertex[0] = -half, solid.convex.vertex[1] = half;
  solid.convex.edge[0].length = length, solid.convex.edge[0].u = (2 / length) * half;
  X_WS = Frame(middle, toolkit::Mat3::Identity());

  motion.d = 0.5 * dt * (piece.v0 + piece.v1);
  motion.turn = (dt / (length * length)) * (2 * half).cross(piece.v1 - piece.v0);
  motion.X0 = {middle - motion.d, toolkit::exp_rotation(-motion.turn)};
}

}  // namespace swage::contact
