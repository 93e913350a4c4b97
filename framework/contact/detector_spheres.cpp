// SPDX-License-Identifier: Apache-2.0
//
// The detector's part for chains of spheres: each near one against whole shapes, pieces of other chains, and other spheres, where the step
// ends; nothing is swept (thesis 4.2.1).
#include "contact/detector_part.hpp"

namespace swage::contact {

Detector::Part Detector::sphere(const scene::World& world, uint32_t shape, uint32_t vertex, Solid& solid) const noexcept {
  Part part;
  part.chain = &tree_[tree_of_[shape]], part.number = vertex, part.sphere = true;
  part.segment = part.chain->piece_at(vertex);
  if (part.segment == scene::kNone) return part;
  solid.radius = solid.bound = part.chain->radius(part.segment);
  part.solid = &solid;
  part.X = Frame(part.chain->vertex(vertex), toolkit::Mat3::Identity());
  part.motion.d = world.dt * part.chain->velocity(vertex);
  part.motion.X0 = {part.X.p - part.motion.d, toolkit::Quat::Identity()};
  part.X_BS = X_WB_[body_[shape]].inverse_times(part.X);
  return part;
}

void Detector::detect_spheres(const scene::World& world, const ShapePair& pair, ContactSet& set) noexcept {
  const bool a = is_spheres(pair.shape_a), b = is_spheres(pair.shape_b);
  if (!a || !b) return detect_spheres_with(world, pair, a, set);
  const ChainTree &tree_a = tree_[tree_of_[pair.shape_a]], &tree_b = tree_[tree_of_[pair.shape_b]];
  const double reach =
      options_.margin * world.length + tree_a.moves() + tree_b.moves() + (tree_a.drift_W() - tree_b.drift_W()).norm();
  const auto look = [&](uint32_t i, uint32_t j) {
    const Part one = sphere(world, pair.shape_a, i, ball_a_), other = sphere(world, pair.shape_b, j, ball_b_);
    if (one.solid != nullptr && other.solid != nullptr) detect_parts(world, pair, one, other, set);
  };
  if (pair.shape_a == pair.shape_b)
    spheres(pair.shape_a).visit_self(reach, look);
  else
    spheres(pair.shape_a).visit_pairs(spheres(pair.shape_b), reach, look);
}

/// `first`: the spheres are the pair's shape_a. The other is a whole shape or a chain of pieces.
void Detector::detect_spheres_with(const scene::World& world, const ShapePair& pair, bool first, ContactSet& set) noexcept {
  const uint32_t chain = first ? pair.shape_a : pair.shape_b, other = first ? pair.shape_b : pair.shape_a;
  const ChainTree& tree = tree_[tree_of_[chain]];
  const double margin = options_.margin * world.length, moves = tree.moves() + tree.drift();
  const auto against = [&](const Part& ball, const Part& part) {
    if (first)
      detect_parts(world, pair, ball, part, set);
    else
      detect_parts(world, pair, part, ball, set);
  };
  const auto near = [&](const Vec3& centre, double radius) { return !far_apart({centre, radius, moves}, other, margin); };
  spheres(chain).visit(near, [&](uint32_t i) {
    const Part ball = sphere(world, chain, i, ball_a_);
    if (ball.solid == nullptr) return;
    if (!is_chain(other)) return against(ball, whole(world, other));
    const ChainTree& pieces = tree_[tree_of_[other]];
    const double reach = ball.solid->radius + moves + pieces.moves() + pieces.drift() + margin;
    pieces.visit([&](const Box& box) { return box.near(ball.X.p, reach); },
                 [&](uint32_t j) { against(ball, piece(world, other, j, piece_b_)); });
  });
}

}  // namespace swage::contact
