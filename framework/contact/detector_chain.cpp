// SPDX-License-Identifier: Apache-2.0
//
// The detector's part for chains: which pieces are near, and where on the chain a contact is.
#include <algorithm>
#include <cmath>

#include "contact/detector.hpp"
#include "contact/detector_part.hpp"
#include "contact/wire_feature.hpp"

namespace swage::contact {
namespace {

/// A line of contact this many radii long weighs as much as one touch: 0.44 mm of a 10-0 thread, which bears on a jaw 0.5 mm wide
/// with the stiffness of the pair. Smaller: stiffer lines.
constexpr double kLine = 40;

/// Points of a piece that lies on a face or along a wire, for the friction moment (chain_line.hpp).
constexpr int kPiecePoints = 2;

/// Feature of a piece, transformed to the frame of its body.
void carry(Feature& f, const Frame& X_BS) {
  f.p = X_BS * f.p;
  f.u = X_BS.turn(f.u);
}

}  // namespace

void Detector::refit_chain(const scene::World& world, uint32_t shape) noexcept {
  ChainTree& tree = tree_[tree_of_[shape]];
  tree.refit(world);
  if (is_spheres(shape)) spheres_[spheres_of_[tree_of_[shape]]].refit(tree);
  ball_[shape] = {tree.all().centre(), tree.all().half(), tree.moves() + tree.drift()};
}

Detector::Part Detector::whole(const scene::World& world, uint32_t shape) noexcept {
  return {&solids_[shape], X_WB_[body_[shape]], motion(world, body_[shape]), nullptr, 0, 0, false, {}};
}

Detector::Part Detector::piece(const scene::World& world, uint32_t shape, uint32_t segment,
                               Solid& solid) const noexcept {
  Part part;
  part.chain = &tree_[tree_of_[shape]], part.segment = part.number = segment;
  part.chain->solid_of(segment, world.dt, solid, part.X, part.motion);
  part.solid = &solid;
  part.X_BS = X_WB_[body_[shape]].inverse_times(part.X);
  return part;
}

void Detector::detect_with_chain(const scene::World& world, const ShapePair& pair, ContactSet& set) noexcept {
  if (is_spheres(pair.shape_a) || is_spheres(pair.shape_b)) return detect_spheres(world, pair, set);
  const double margin = options_.margin * world.length;
  const bool a = is_chain(pair.shape_a), b = is_chain(pair.shape_b);
  if (a && b) {
    const ChainTree &tree_a = tree_[tree_of_[pair.shape_a]], &tree_b = tree_[tree_of_[pair.shape_b]];
    const double drift = (tree_a.drift_W() - tree_b.drift_W()).norm();
    const double reach = margin + tree_a.moves() + tree_b.moves() + drift;
    const auto look = [&](uint32_t i, uint32_t j) {
      if (tree_a.apart(i, tree_b, j, reach)) return;
      detect_parts(world, pair, piece(world, pair.shape_a, i, piece_a_),
                   piece(world, pair.shape_b, j, piece_b_), set);
    };
    if (pair.shape_a == pair.shape_b)
      tree_a.visit_self(margin, look);
    else
      tree_a.visit_pairs(tree_b, margin + drift, look);
    return;
  }
  const uint32_t chain = a ? pair.shape_a : pair.shape_b, other = a ? pair.shape_b : pair.shape_a;
  const Ball& ball = ball_[other];
  const ChainTree& tree = tree_[tree_of_[chain]];
  const double reach = ball.radius + ball.moves + tree.drift() + margin;
  const auto near = [&](const Box& box) {
    return box.near(ball.centre, reach) && !far_apart({box.centre(), box.half(), tree.drift()}, other, margin);
  };
  const Part whole = this->whole(world, other);
  tree.visit(near, [&](uint32_t i) {
    const Part part = piece(world, chain, i, piece_a_);
    if (a)
      detect_parts(world, pair, part, whole, set);
    else
      detect_parts(world, pair, whole, part, set);
  });
}

/// Finds the contacts of two parts, swept where they move farther than they are thick, and sets their places on the chains.
void Detector::detect_parts(const scene::World& world, const ShapePair& pair, const Part& a, const Part& b,
                            ContactSet& set) noexcept {
  const double margin = options_.margin * world.length;
  const double moves = relative_motion(*a.solid, a.motion, b.motion);
  const double reach = a.solid->bound + b.solid->bound + margin + moves;
  if ((a.X * a.solid->centre - b.X * b.solid->centre).squaredNorm() > reach * reach) return;

  Query query = query_of(world, pair, margin + moves);
  query.piece = true, query.line_points = kPiecePoints;
  const Part& wire = a.chain != nullptr ? a : b;
  query.piece_before = wire.segment > 0 && wire.chain->there(wire.segment - 1);
  query.piece_after = wire.chain->there(wire.segment + 1);
  // a sphere touches in one point, where it is at the end of the step
  if (a.sphere || b.sphere) query.piece = query.goes_on = query.goes_on_after = false, query.flatness = 0;
  const bool swept = collide_parts(a, b, moves, query, world.length);
  weigh_lines(a.chain != nullptr ? a.solid->radius : b.solid->radius);
  const uint64_t part = a.chain != nullptr && b.chain != nullptr ? uint64_t{a.number} << 10 | b.number
                        : a.chain != nullptr                      ? a.number
                                                                  : b.number;
  set.dropped += static_cast<uint64_t>(manifold_.dropped);
  for (int i = 0; i < manifold_.count; ++i) {
    Candidate& c = manifold_.candidate[static_cast<size_t>(i)];
    const Touch& t = c.touch;
    constexpr uint64_t kFarEnd = 9;  // far end of a straight wire (wire_convex.cpp): the neighbour's lowest place
    if ((c.feature & 0xF) == kFarEnd) continue;
    Contact contact;
    contact.place_a = a.place(t, t.n_W), contact.place_b = b.place(t, -t.n_W);
    // a piece that did not pass through the surface does not report for a neighbour that did
    if (!swept && (a.left_to_next(contact.place_a.share, t.n_W) || b.left_to_next(contact.place_b.share, -t.n_W)))
      continue;
    if (a.chain != nullptr) carry(c.a, a.X_BS);
    if (b.chain != nullptr) {
      carry(c.b, b.X_BS);
      c.n_B = b.X_BS.turn(c.n_B);
    }
    if (a.chain == b.chain && std::abs(contact.place_a.s - contact.place_b.s) < a.chain->exclusion()) continue;
    keep(world, pair, c, part, contact, set);
  }
}

/// Finds the contacts of two parts. Returns whether they are those of the first touch of the sweep.
bool Detector::collide_parts(const Part& a, const Part& b, double moves, const Query& query,
                             double length) noexcept {
  Separation none;
  const double thickness = std::max(a.solid->radius + b.solid->radius, kSweepFrom * length);
  if (moves > thickness && !a.sphere && !b.sphere) {
    const FirstTouch touch =
        first_touch(*a.solid, a.motion, *b.solid, b.motion, kTouchGap * length, none, manifold_);
    if (touch.hit) {
      collide(*a.solid, Frame(a.motion.at(touch.t)), *b.solid, Frame(b.motion.at(touch.t)), query, none,
              manifold_);
      for (int i = 0; i < manifold_.count; ++i) {
        Candidate& c = manifold_.candidate[static_cast<size_t>(i)];
        c.touch = reevaluate(c, a.X, b.X);
      }
      return true;
    }
  }
  collide(*a.solid, a.X, *b.solid, b.X, query, none, manifold_);
  return false;
}

/// Weight of a line contact, in proportion to its length.
void Detector::weigh_lines(double radius) noexcept {
  for (int i = 0; i + 1 < manifold_.count; ++i) {
    Candidate &c = manifold_.candidate[static_cast<size_t>(i)],
              &next = manifold_.candidate[static_cast<size_t>(i) + 1];
    if ((c.feature & 0xF) != 1 || next.feature != c.feature + 1) continue;
    const double share =
        std::min(1.0, kPiecePoints * (next.touch.p_W - c.touch.p_W).norm() / (kLine * radius));
    c.weight *= share, next.weight *= share;
  }
}

// --- chains of spheres: each near one against whole shapes, pieces of other chains, and other spheres, where the step ends; nothing is swept
// (thesis 4.2.1)

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
