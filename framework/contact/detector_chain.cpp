// SPDX-License-Identifier: Apache-2.0
//
// The detector's part for chains: which pieces are near, where on the chain a contact is, and the memory that it takes from the
// contact that was there before.
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

/// Touches nearer to each other along the chain than this many radii, with gaps that differ by less than this share of the scene's
/// length (0.1 um for a 1 mm scene, what 0.1 N presses in), share the weight of one: where a thread bends towards a surface,
/// both pieces of a joint come near to it, and would be twice as stiff as one.
constexpr double kShare = 2, kShareGap = 1e-4;

/// Points of a piece that lies on a face or along a wire, for the friction moment (chain_line.hpp).
constexpr int kPiecePoints = 2;

/// Share of its last weight that a contact of a thread with anything but a thread keeps. The weight of a touch beside a line follows the tilt of
/// its piece, and the tilt follows the weight one step later. 0: a thread pinched with 0.3 N over the edge of a jaw swings by 20 um from step to
/// step. 0.5 and more: weights lag by 2 ms and more. Contacts of thread with thread keep nothing: touches go from piece to piece there, and with
/// weights that lag a twisted pair unwinds.
constexpr double kWeightKept = 1.0 / 3;

/// A contact that has no predecessor takes the bristle of the nearest one along the chain that bore force, within this share of the
/// scene's length (0.2 mm for a 1 mm scene, as far as a contact rolls in a step at 0.2 m/s) and with a normal alike.
constexpr double kReach = 0.2, kCosine = 0.7;

/// Feature of a piece, transformed to the frame of its body.
void carry(Feature& f, const Frame& X_BS) {
  f.p = X_BS * f.p;
  f.u = X_BS.turn(f.u);
}

bool bears(const Contact& c) { return !c.f_a_W.isZero(0) || !c.bristle_W.isZero(0); }

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

/// Contacts that are one contact on the uncut chain share one weight, which changes gradually.
void Detector::share_near(const scene::World& world, ContactSet& set, size_t first) const noexcept {
  const auto is_touch = [](const Contact& c) { return (c.feature & 0xF) == 0; };
  for (size_t i = first; i < set.contact.size(); ++i) {
    Contact& c = set.contact[i];
    if (!is_touch(c)) continue;
    const double near = kShare * world.shape[is_chain(c.shape_a) ? c.shape_a : c.shape_b].radius;
    double all = 0;
    for (size_t k = first; k < set.contact.size(); ++k) {
      const Contact& other = set.contact[k];
      if (!is_touch(other) || other.n_W.dot(c.n_W) < kCosine) continue;
      const double way = way_along(c, other);
      const double deeper = std::abs(c.gap - other.gap);
      all += (1 - ramp(way, 0, near)) * (1 - ramp(deeper, 0, kShareGap * world.length));
    }
    c.weight = set.candidate[i].weight / all;
  }
  for (size_t i = first; i < set.contact.size(); ++i) {
    Contact& c = set.contact[i];
    const bool threads = c.place_a.segment != scene::kNone && c.place_b.segment != scene::kNone;
    const Contact* before = heir_of_[i] != scene::kNone && !threads ? &last_[heir_of_[i]] : nullptr;
    if (before != nullptr && before->feature == c.feature) c.weight += kWeightKept * (before->weight - c.weight);
    set.candidate[i].weight = c.weight;
  }
}

/// Friction memory travels with the material: it is inherited from a contact of the same pieces, or else from the nearest place. Returns which
/// contact of the last step that was, or kNone.
uint32_t Detector::inherit_along(const scene::World& world, Contact& contact, scene::Range range) const noexcept {
  const Contact* best = nullptr;
  double nearest = kReach * world.length;
  for (uint32_t i = range.first; i < range.first + range.count; ++i) {
    const Contact& old = last_[i];
    if (old.shape_a != contact.shape_a || old.shape_b != contact.shape_b) continue;
    if (old.feature == contact.feature) {
      if (bears(old)) {
        best = &old;
        break;
      }
      // the contact existed without load: inherit only from its immediate neighbours
      nearest = std::min(nearest, world.shape[is_chain(old.shape_a) ? old.shape_a : old.shape_b].radius);
      if (best != nullptr && way_along(*best, contact) > nearest) best = nullptr;
      continue;
    }
    if (!bears(old) || old.n_W.dot(contact.n_W) < kCosine) continue;
    const double way = way_along(old, contact);
    if (way > nearest) continue;
    nearest = way, best = &old;
  }
  if (best == nullptr) return scene::kNone;
  contact.bristle_W = best->bristle_W;
  contact.f_a_W = best->f_a_W;
  contact.slip = best->slip;
  return static_cast<uint32_t>(best - last_.data());
}

/// The force of a contact of the last step goes on in one: in that of the same pieces, or else in the nearest. Where a thread slides round the
/// edge of a jaw, several have its bristle; were all of them taken to bear its force, the solve would begin with three contacts for one.
void Detector::leave_forces_to_one(ContactSet& set, size_t first) const noexcept {
  const auto way_from = [&](size_t i, const Contact& old) {
    const Contact& c = set.contact[i];
    return c.feature == old.feature ? -1 : way_along(old, c);
  };
  for (size_t i = first; i < set.contact.size(); ++i) {
    if (heir_of_[i] == scene::kNone) continue;
    const Contact& old = last_[heir_of_[i]];
    const double way = way_from(i, old);
    for (size_t k = first; way >= 0 && k < set.contact.size(); ++k) {
      const double other = k != i && heir_of_[k] == heir_of_[i] ? way_from(k, old) : HUGE_VAL;
      if (!(other < way || (other == way && k < i))) continue;
      set.contact[i].f_a_W.setZero(), set.contact[i].slip = 0;
      break;
    }
  }
}

double Detector::way_along(const Contact& a, const Contact& b) noexcept {
  double way = 0;
  if (a.place_a.segment != scene::kNone) way = std::abs(a.place_a.s - b.place_a.s);
  if (a.place_b.segment != scene::kNone) way = std::max(way, std::abs(a.place_b.s - b.place_b.s));
  return way;
}

}  // namespace swage::contact
