// SPDX-License-Identifier: Apache-2.0
#include "contact/detector.hpp"

#include <algorithm>
#include <stdexcept>

#include "contact/chain_line.hpp"
#include "contact/sweep.hpp"

namespace swage::contact {
namespace {

/// A contact that has no predecessor of the same feature takes the bristle of the nearest one, if it is not farther than
/// this share of the scene's length (0.2 mm for a 1 mm scene: the points of a line across a jaw are nearer) and its
/// normal is alike: a touch that slides from a face to its edge, or spreads into a line, goes on sticking.
constexpr double kInheritReach = 0.2, kInheritCosine = 0.7;

/// Bodies that move less than the thickness of their wires, or than this share of the scene's length (20 um for a 1 mm
/// scene) when they have sharp edges, cannot come out on the far side of each other and are not swept.
constexpr double kSweepFrom = 0.02;

/// Swept bodies touch when their gap is below this share of the scene's length (1 um for a 1 mm scene): the pose only
/// serves to find out which features meet, so a wire's fiftieth is near enough.
constexpr double kTouchGap = 1e-3;

/// Motion of a body over the step that is predicted to end at its pose.
Motion motion_of(const scene::World& world, uint32_t body) {
  const swage_twist& V = world.V_WB[body];
  Motion m;
  m.d = world.dt * toolkit::vec(V.v);
  m.turn = world.dt * toolkit::vec(V.w);
  const Pose X1(world.X_WB[body]);
  m.X0 = {X1.p - m.d, toolkit::exp_rotation(-m.turn) * X1.q};
  return m;
}

/// More than any point of a moves against b over the step, without looking closely, m.
double most_motion(const scene::World& world, uint32_t body_a, uint32_t body_b, const Solid& a,
                   const Vec3& a_from_b) {
  const swage_twist &A = world.V_WB[body_a], &B = world.V_WB[body_b];
  const double v = toolkit::vec(A.v).norm() + toolkit::vec(B.v).norm();
  const double w_a = toolkit::vec(A.w).norm(), w_b = toolkit::vec(B.w).norm();
  return 2 * world.dt * (v + w_a * (a.centre.norm() + a.bound) + w_b * (a_from_b.norm() + a.bound));
}

bool collides(const scene::Shape& shape) { return (shape.flags & SWAGE_SHAPE_COLLIDES) != 0; }

void check(const Options& o) {
  const bool power_of_two =
      o.line_points >= 2 && o.line_points <= 8 && (o.line_points & (o.line_points - 1)) == 0;
  if (!power_of_two) throw std::invalid_argument("contact: line_points must be 2, 4 or 8");
  if (!(o.margin >= 0) || !(o.flatness >= 0))
    throw std::invalid_argument("contact: margin and flatness must not be negative");
  if (o.chain_spheres < 2) throw std::invalid_argument("contact: a chain has at least 2 spheres");
}

}  // namespace

Detector::Detector(const scene::World& world, std::vector<Pair> pairs, const Options& options)
    : pairs_(std::move(pairs)),
      options_(options),
      chains_(world.shape.size()),
      X_WB_(world.body.size()),
      sphere_(make_ball(0)) {
  check(options_);
  for (uint32_t i = 0; i < world.shape.size(); ++i) solids_.push_back(make_solid(world, i));
  for (uint32_t p = 0; p < pairs_.size(); ++p)
    for (uint32_t a = 0; a < world.shape.size(); ++a)
      for (uint32_t b = 0; b < world.shape.size(); ++b) {
        const scene::Shape &shape_a = world.shape[a], &shape_b = world.shape[b];
        if (shape_a.object != pairs_[p].object_a || shape_b.object != pairs_[p].object_b) continue;
        if (!collides(shape_a) || !collides(shape_b) || shape_a.body == shape_b.body) continue;
        // an object against itself: each two shapes once
        if (shape_a.object == shape_b.object && a > b) continue;
        shape_pairs_.push_back({p, a, b, {}});
        bodies_.push_back(shape_a.body);
        bodies_.push_back(shape_b.body);
      }
  std::sort(bodies_.begin(), bodies_.end());
  bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());

  if (options_.level == Level::kThesis)
    for (size_t i = 0; i < solids_.size(); ++i)
      if (solids_[i].kind == SWAGE_SHAPE_ARC)
        chains_[i] =
            build_sphere_tree(sphere_chain(solids_[i].arc, options_.chain_spheres), solids_[i].radius);
  last_.reserve(options_.capacity);
  last_of_pair_.reserve(pairs_.size());
}

void Detector::reserve(ContactSet& set) const {
  set.contact.reserve(options_.capacity);
  set.candidate.reserve(options_.capacity);
  set.of_pair.reserve(pairs_.size());
  set.of_pair.assign(pairs_.size(), {});
}

void Detector::reset(ContactSet& set) noexcept {
  set.contact.clear();
  set.candidate.clear();
  set.of_pair.assign(pairs_.size(), {});
  for (ShapePair& pair : shape_pairs_) pair.memory = {};
}

void Detector::detect(const scene::World& world, ContactSet& set) noexcept {
  // keep last step's contacts to inherit from
  last_.swap(set.contact);
  last_of_pair_.swap(set.of_pair);
  set.contact.clear();
  set.candidate.clear();
  set.of_pair.clear();

  for (const uint32_t body : bodies_) X_WB_[body] = Frame(world.X_WB[body]);
  for (uint32_t i = 0; i < solids_.size(); ++i)
    if (solids_[i].kind == SWAGE_SHAPE_HEIGHT_FIELD) update_field(solids_[i], world, i);
  size_t next = 0;
  for (uint32_t p = 0; p < pairs_.size(); ++p) {
    const auto first = static_cast<uint32_t>(set.contact.size());
    for (; next < shape_pairs_.size() && shape_pairs_[next].pair == p; ++next)
      detect_shapes(world, shape_pairs_[next], set);
    share_chain_lines(world, set, first);
    set.of_pair.push_back({first, static_cast<uint32_t>(set.contact.size()) - first});
  }
}

void Detector::detect_shapes(const scene::World& world, ShapePair& pair, ContactSet& set) noexcept {
  const Solid &a = solids_[pair.shape_a], &b = solids_[pair.shape_b];
  const uint32_t body_a = world.shape[pair.shape_a].body, body_b = world.shape[pair.shape_b].body;
  const Frame &X_WA = X_WB_[body_a], &X_WB = X_WB_[body_b];

  // bounding spheres, the cheapest way out: first with all that they might move
  const Vec3 centre_a = X_WA * a.centre;
  const double apart =
      (centre_a - X_WB * b.centre).norm() - a.bound - b.bound - options_.margin * world.length;
  if (apart > most_motion(world, body_a, body_b, a, centre_a - X_WB.p)) return;
  const Motion motion_a = motion_of(world, body_a), motion_b = motion_of(world, body_b);
  const double motion = relative_motion(a, motion_a, motion_b);
  Query query{options_.margin * world.length + motion, world.length, options_.flatness, options_.line_points};
  if (in_chain(world, pair.shape_a) || in_chain(world, pair.shape_b)) query.line_points = kChainPoints;
  if (apart > motion) return;

  // chains of the thesis, sphere by sphere
  if (!chains_[pair.shape_a].node.empty() || !chains_[pair.shape_b].node.empty())
    return detect_chain(world, pair, query, set);

  // whoever moves farther than the wires are thick may have passed through: touch where the bodies first touched
  const double thickness = std::max(a.radius + b.radius, kSweepFrom * world.length);
  if (motion > thickness) {
    const double tolerance = kTouchGap * world.length;
    const FirstTouch touch = first_touch(a, motion_a, b, motion_b, tolerance, pair.memory, manifold_);
    if (touch.hit) {
      collide(a, Frame(motion_a.at(touch.t)), b, Frame(motion_b.at(touch.t)), query, pair.memory, manifold_);
      for (int i = 0; i < manifold_.count; ++i) {
        Candidate& c = manifold_.candidate[static_cast<size_t>(i)];
        c.touch = reevaluate(c, X_WA, X_WB);
      }
      return append(world, pair, 0, set);
    }
  }
  collide(a, X_WA, b, X_WB, query, pair.memory, manifold_);
  append(world, pair, 0, set);
}

void Detector::detect_chain(const scene::World& world, const ShapePair& pair, const Query& query,
                            ContactSet& set) noexcept {
  const bool chain_is_a = !chains_[pair.shape_a].node.empty();
  const SphereTree& chain = chains_[chain_is_a ? pair.shape_a : pair.shape_b];
  const Solid& other = solids_[chain_is_a ? pair.shape_b : pair.shape_a];
  const Frame& X_WC = X_WB_[world.shape[chain_is_a ? pair.shape_a : pair.shape_b].body];
  const Frame& X_WO = X_WB_[world.shape[chain_is_a ? pair.shape_b : pair.shape_a].body];
  const Vec3 centre_C = X_WC.inverse_times(X_WO * other.centre);
  const auto near = [&](const Vec3& centre, double radius) {
    const double reach = radius + other.bound + query.margin;
    return (centre - centre_C).squaredNorm() <= reach * reach;
  };
  // the spheres stand for a wire, not for balls: each touches in a point
  Query point = query;
  point.flatness = 0;
  chain.visit(near, [&](uint32_t i) {
    sphere_.axis = {chain.centre[i], chain.centre[i]};
    sphere_.convex.vertex[0] = sphere_.centre = chain.centre[i];
    sphere_.radius = sphere_.bound = chain.radius;
    Separation none;
    if (chain_is_a)
      collide(sphere_, X_WC, other, X_WO, point, none, manifold_);
    else
      collide(other, X_WO, sphere_, X_WC, point, none, manifold_);
    append(world, pair, uint64_t{chain.number[i]} + 1, set);
  });
}

void Detector::append(const scene::World& world, const ShapePair& pair, uint64_t part,
                      ContactSet& set) noexcept {
  set.dropped += static_cast<uint64_t>(manifold_.dropped);
  for (int i = 0; i < manifold_.count; ++i) {
    if (set.contact.size() >= options_.capacity) {
      ++set.dropped;
      continue;
    }
    const Candidate& found = manifold_.candidate[static_cast<size_t>(i)];
    Contact c;
    c.pair = pair.pair;
    c.shape_a = pair.shape_a, c.shape_b = pair.shape_b;
    c.body_a = world.shape[pair.shape_a].body, c.body_b = world.shape[pair.shape_b].body;
    c.feature = found.feature | part << 44;
    c.p_W = found.touch.p_W, c.n_W = found.touch.n_W, c.gap = found.touch.gap;
    c.weight = found.weight;
    c.law = pairs_[pair.pair].law;
    inherit(world, c);
    set.contact.push_back(c);
    set.candidate.push_back(found);
    set.candidate.back().feature = c.feature;
  }
}

void Detector::inherit(const scene::World& world, Contact& contact) const noexcept {
  if (contact.pair >= last_of_pair_.size()) return;
  const scene::Range range = last_of_pair_[contact.pair];
  const swage_twist& V = world.V_WB[contact.body_b];
  const Vec3 v = toolkit::vec(V.v), w = toolkit::vec(V.w), x = toolkit::vec(world.X_WB[contact.body_b].p);
  double nearest = kInheritReach * world.length;
  for (uint32_t i = range.first; i < range.first + range.count; ++i) {
    const Contact& old = last_[i];
    if (old.shape_a != contact.shape_a || old.shape_b != contact.shape_b) continue;
    if (old.feature == contact.feature) {
      contact.bristle_W = old.bristle_W;
      // couplings see them before the solve writes anew
      contact.f_a_W = old.f_a_W;
      contact.slip = old.slip;
      return;
    }
    // where that place of b is now
    const Vec3 moved = old.p_W + world.dt * (v + w.cross(old.p_W - x));
    const double distance = (moved - contact.p_W).norm();
    if (distance >= nearest || old.n_W.dot(contact.n_W) < kInheritCosine) continue;
    nearest = distance;
    contact.bristle_W = old.bristle_W;
  }
}

}  // namespace swage::contact
