// SPDX-License-Identifier: Apache-2.0
//
// Queries of the detector within a step, for bodies that rebound in it.
#include <algorithm>

#include "contact/chain_line.hpp"
#include "contact/detector.hpp"

namespace swage::contact {
namespace {

/// Reduction of a wire's radius in a sweep, and its further reduction after each touch: this share of the radius, at most
/// kThinnerMost touch gaps (12.5 um both for a wire of 50 um in a 1 mm scene). Smaller: a body that slides along a surface takes more
/// queries. Larger: a graze of a surface less deep than that is not found.
constexpr double kThinner = 0.25, kThinnerMost = 12.5;
constexpr double kThinnest = 0.1;  // share of its radius that is left in any case

bool may_fly(const scene::World& world, uint32_t body) {
  return world.body[body].motion == SWAGE_MOTION_DYNAMIC;
}
bool moves_itself(const scene::World& world, uint32_t body) {
  return world.body[body].motion == SWAGE_MOTION_FLEXIBLE;
}

/// Upper bound of the displacement of any point of a solid [m].
double way_of(const Solid& solid, const Motion& motion) {
  return motion.d.norm() + motion.turn.norm() * (solid.centre.norm() + solid.bound);
}

}  // namespace

/// Lists the shapes for queries within the step. Sphere chains of the thesis are left to detect(), at its end.
void Detector::find_swept(const scene::World& world) {
  for (const ShapePair& pair : shape_pairs_) {
    const uint32_t a = world.shape[pair.shape_a].body, b = world.shape[pair.shape_b].body;
    if (!may_fly(world, a) && !may_fly(world, b)) continue;
    if (moves_itself(world, a) || moves_itself(world, b)) continue;
    if (!chains_[pair.shape_a].node.empty() || !chains_[pair.shape_b].node.empty()) continue;
    swept_.push_back({pair.pair, pair.shape_a, pair.shape_b, a, b});
  }
}

Detector::Reach Detector::reach(const scene::World& world, uint32_t i, const Motion& motion_a,
                                const Motion& motion_b) const noexcept {
  const Solid &a = solids_[swept_[i].shape_a], &b = solids_[swept_[i].shape_b];
  const double ways = way_of(a, motion_a) + way_of(b, motion_b);
  const double apart = (motion_a.X0 * a.centre - motion_b.X0 * b.centre).norm() - a.bound - b.bound;
  if (apart > ways + options_.margin * world.length) return Reach::kFar;
  const double thickness = swept_from(a, b, world.length);
  if (ways <= thickness) return Reach::kNear;
  return relative_motion(a, motion_a, motion_b) > thickness ? Reach::kFast : Reach::kNear;
}

FirstTouch Detector::first_overlap(const scene::World& world, uint32_t i, const Motion& a, const Motion& b,
                                 double sunk, uint32_t touches) noexcept {
  Solid &solid_a = solids_[swept_[i].shape_a], &solid_b = solids_[swept_[i].shape_b];
  Solid& thinner = solid_a.radius >= solid_b.radius ? solid_a : solid_b;
  const double radius = thinner.radius, near = kTouchGap * world.length;
  Separation none;
  if (!(radius > 0))
    return contact::first_touch(solid_a, a, solid_b, b, near / (1 + touches), none, manifold_);
  // so deep that even the thinnest wire overlaps: only the contacts at the end of a query show it
  if (sunk + near > (1 - kThinnest) * radius) return {};
  const double less = std::min(kThinner * radius, kThinnerMost * near);
  thinner.radius = std::max(radius - sunk - near - less * (1 + touches), kThinnest * radius);
  const FirstTouch touch = contact::first_touch(solid_a, a, solid_b, b, near, none, manifold_);
  thinner.radius = radius;
  return touch;
}

const Manifold& Detector::touches(const scene::World& world, uint32_t i, const Frame& X_WA, const Frame& X_WB,
                                  double margin) noexcept {
  const Solid &a = solids_[swept_[i].shape_a], &b = solids_[swept_[i].shape_b];
  // a sphere rebounds at one point
  const bool ball = a.kind == SWAGE_SHAPE_SPHERE || b.kind == SWAGE_SHAPE_SPHERE;
  Query query{margin, world.length, ball ? 0.0 : options_.flatness, options_.line_points};
  Separation none;
  contact::collide(a, X_WA, b, X_WB, query, none, manifold_);
  return manifold_;
}

void Detector::look_again(const scene::World& world, ContactSet& set, std::span<const uint8_t> moved,
                          std::span<const Struck> struck) noexcept {
  memory_.take(set);
  for (const uint32_t body : bodies_)
    if (moved[body]) X_WB_[body] = Frame(world.X_WB[body]);

  size_t next = 0;
  for (uint32_t p = 0; p < pairs_.size(); ++p) {
    const auto first = static_cast<uint32_t>(set.contact.size());
    for (; next < shape_pairs_.size() && shape_pairs_[next].pair == p; ++next)
      look_again(world, shape_pairs_[next], set, moved, struck);
    memory_.give_laws(set, first);
    set.of_pair.push_back({first, static_cast<uint32_t>(set.contact.size()) - first});
  }
}

void Detector::look_again(const scene::World& world, ShapePair& pair, ContactSet& set,
                          std::span<const uint8_t> moved, std::span<const Struck> struck) noexcept {
  const uint32_t a = body_[pair.shape_a], b = body_[pair.shape_b];
  const bool anew = moved[a] || moved[b];
  // pieces of a chain share their load; their contacts with a rebounding body are handled with the whole chain
  const bool itself = moves_itself(world, a) || moves_itself(world, b);
  const bool spheres = !chains_[pair.shape_a].node.empty() || !chains_[pair.shape_b].node.empty();
  if (!anew || itself || spheres) return keep(world, pair, set, anew);
  const size_t first = set.contact.size();
  Separation none;
  contact::collide(solids_[pair.shape_a], X_WB_[a], solids_[pair.shape_b], X_WB_[b],
                   query_of(world, pair, options_.margin * world.length), pair.remembers ? pair.memory : none,
                   manifold_);
  append(world, pair, 0, set);
  if (set.contact.size() == first) add_struck(world, pair, set, struck);
}

/// Contacts of two shapes as last found; re-evaluated at the current poses when a shape has moved.
void Detector::keep(const scene::World& world, const ShapePair& pair, ContactSet& set, bool moved) noexcept {
  const std::span<const Contact> last = memory_.contacts(pair.pair);
  const std::span<const Candidate> found = memory_.candidates(pair.pair);
  for (size_t i = 0; i < last.size(); ++i) {
    if (last[i].shape_a != pair.shape_a || last[i].shape_b != pair.shape_b) continue;
    if (set.contact.size() >= options_.capacity) {
      ++set.dropped;
      continue;
    }
    set.contact.push_back(last[i]);
    set.candidate.push_back(found[i]);
    if (!moved) continue;
    Contact& c = set.contact.back();
    const Touch touch = reevaluate(found[i], Frame(world.X_WB[c.body_a]), Frame(world.X_WB[c.body_b]));
    c.p_W = touch.p_W, c.n_W = touch.n_W, c.gap = touch.gap;
  }
}

void Detector::add_struck(const scene::World& world, const ShapePair& pair, ContactSet& set,
                          std::span<const Struck> struck) noexcept {
  for (const Struck& s : struck) {
    const Shapes& shapes = swept_[s.swept];
    if (shapes.shape_a != pair.shape_a || shapes.shape_b != pair.shape_b) continue;
    manifold_.clear();
    Candidate* c = manifold_.add(0);
    *c = s.candidate;
    c->touch = reevaluate(*c, X_WB_[body_[pair.shape_a]], X_WB_[body_[pair.shape_b]]);
    // the point may be far from its face by now, and a plane has no end: the contact bears nothing and only records the impulse
    c->weight = 0;
    return append(world, pair, 0, set);
  }
}

}  // namespace swage::contact
