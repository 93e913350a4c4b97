// SPDX-License-Identifier: Apache-2.0
#include "contact/detector.hpp"

#include <algorithm>
#include <stdexcept>

#include "contact/chain_line.hpp"
#include "contact/chain_touch.hpp"
#include "contact/sphere_line.hpp"
#include "contact/sweep.hpp"

namespace swage::contact {
namespace {

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

bool collides(const scene::Shape& shape) { return (shape.flags & SWAGE_SHAPE_COLLIDES) != 0; }

/// Whether the plane of some face separates the polyhedron from a ball of radius `reach` [m], `centre` in the frame of the polyhedron.
bool beyond_a_face(const toolkit::Convex& convex, const Vec3& centre, double reach) {
  return std::any_of(convex.face.begin(), convex.face.end(),
                     [&](const toolkit::Convex::Face& f) { return f.n.dot(centre) - f.d > reach; });
}

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
      memory_(options_.capacity, pairs_.size()),
      chains_(world.shape.size()),
      X_WB_(world.body.size()),
      motion_(world.body.size()),
      ball_(world.shape.size()),
      sphere_(make_ball(0)),
      tree_of_(world.shape.size(), scene::kNone),
      piece_a_(make_capsule()),
      piece_b_(make_capsule()),
      ball_a_(make_ball(0)),
      ball_b_(make_ball(0)) {
  check(options_);
  for (uint32_t i = 0; i < world.shape.size(); ++i) {
    solids_.push_back(make_solid(world, i));
    if (world.shape[i].kind == SWAGE_SHAPE_CHAIN) {
      tree_of_[i] = static_cast<uint32_t>(tree_.size());
      tree_.emplace_back(world, i);
      const bool spheres = (world.shape[i].flags & scene::kChainOfSpheres) != 0;
      spheres_of_.push_back(spheres ? static_cast<uint32_t>(spheres_.size()) : scene::kNone);
      if (spheres) spheres_.emplace_back(tree_.back().segments() + 1);
    }
    body_.push_back(world.shape[i].body);
    const bool chained = in_chain(world, i);
    goes_on_.push_back(chained && i > 0 && in_chain(world, i - 1) &&
                       world.shape[i - 1].object == world.shape[i].object);
    if (chained && !goes_on_.back()) chain_.push_back({i, 0, {}});
    if (chained) ++chain_.back().shapes;
  }
  in_pair_.assign(world.shape.size(), 0);
  for (uint32_t p = 0; p < pairs_.size(); ++p)
    for (uint32_t a = 0; a < world.shape.size(); ++a)
      for (uint32_t b = 0; b < world.shape.size(); ++b) {
        const scene::Shape &shape_a = world.shape[a], &shape_b = world.shape[b];
        if (shape_a.object != pairs_[p].object_a || shape_b.object != pairs_[p].object_b) continue;
        if (!collides(shape_a) || !collides(shape_b)) continue;
        if (shape_a.body == shape_b.body && shape_a.kind != SWAGE_SHAPE_CHAIN && shape_b.kind != SWAGE_SHAPE_CHAIN)
          continue;
        // only a chain touches itself
        if (a == b && shape_a.kind != SWAGE_SHAPE_CHAIN) continue;
        // an object against itself: each two shapes once
        if (shape_a.object == shape_b.object && a > b) continue;
        shape_pairs_.push_back({p, a, b, group_of(p, a, b), {}});
        bodies_.push_back(shape_a.body);
        bodies_.push_back(shape_b.body);
        in_pair_[a] = in_pair_[b] = 1;
      }
  // the last separating feature is tried first, for polyhedra only
  for (ShapePair& pair : shape_pairs_)
    pair.remembers = pair.group == kNoGroup && !is_chain(pair.shape_a) && !is_chain(pair.shape_b);
  std::sort(bodies_.begin(), bodies_.end());
  bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());

  if (options_.level == Level::kThesis) lay_spheres(world);
  find_swept(world);
}

/// Builds the sphere chains of the thesis: one per wire, of which each arc of a wire that bends has its part. A chain per arc would have
/// as many spheres in each arc, a dozen of them in contact at each place, more than its object has points for.
void Detector::lay_spheres(const scene::World& world) {
  for (uint32_t i = 0; i < solids_.size(); ++i)
    if (solids_[i].kind == SWAGE_SHAPE_ARC && !in_chain(world, i))
      chains_[i] = build_sphere_tree(sphere_chain(solids_[i].arc, options_.chain_spheres), solids_[i].radius);
  for (const Chain& wire : chain_) {
    const auto length = [&](uint32_t i) { return solids_[i].arc.radius * solids_[i].arc.sweep; };
    double all = 0, before = 0;
    for (uint32_t i = wire.first; i < wire.first + wire.shapes; ++i) all += length(i);
    for (uint32_t i = wire.first; i < wire.first + wire.shapes; ++i) {
      const bool last = i + 1 == wire.first + wire.shapes;
      const double from = before / all, to = last ? 1 : (before + length(i)) / all;
      chains_[i] =
          build_sphere_tree(sphere_chain_part(solids_[i].arc, options_.chain_spheres, from, to), solids_[i].radius);
      before += length(i);
    }
  }
}

/// Group of a shape pair: all arcs of one wire (chain_line.hpp) against one other shape; kNoGroup unless just one of both is such an arc.
uint32_t Detector::group_of(uint32_t pair, uint32_t a, uint32_t b) {
  const auto chain = [&](uint32_t shape) {
    for (uint32_t c = 0; c < chain_.size(); ++c)
      if (shape - chain_[c].first < chain_[c].shapes) return c;
    return kNoGroup;
  };
  const uint32_t chain_a = chain(a), chain_b = chain(b);
  if ((chain_a == kNoGroup) == (chain_b == kNoGroup)) return kNoGroup;
  const Group wanted{pair, chain_a == kNoGroup ? chain_b : chain_a, chain_a == kNoGroup ? a : b, false};
  for (uint32_t g = 0; g < group_.size(); ++g)
    if (group_[g].pair == wanted.pair && group_[g].chain == wanted.chain && group_[g].other == wanted.other)
      return g;
  group_.push_back(wanted);
  return static_cast<uint32_t>(group_.size() - 1);
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
  memory_.take(set);
  set.dropped = 0;

  look_around(world);
  size_t next = 0;
  for (uint32_t p = 0; p < pairs_.size(); ++p) {
    const auto first = static_cast<uint32_t>(set.contact.size());
    for (; next < shape_pairs_.size() && shape_pairs_[next].pair == p; ++next)
      detect_shapes(world, shape_pairs_[next], set);
    share_chain_lines(world, set, first);
    if (options_.level == Level::kThesis) share_sphere_lines(chains_, options_.flatness * world.length, set, first);
    set.of_pair.push_back({first, static_cast<uint32_t>(set.contact.size()) - first});
  }
}

/// Updates poses and motions over this step, and which chains are far from which shapes. Shapes that nothing can touch are left out.
void Detector::look_around(const scene::World& world) noexcept {
  for (const uint32_t body : bodies_) {
    X_WB_[body] = Frame(world.X_WB[body]);
    motion_[body].known = false;
  }
  for (uint32_t i = 0; i < solids_.size(); ++i) {
    if (is_chain(i)) {
      refit_chain(world, i);
      continue;
    }
    if (!in_pair_[i]) continue;
    if (solids_[i].kind == SWAGE_SHAPE_HEIGHT_FIELD) update_field(solids_[i], world, i);
    // bounding sphere at the end of the step, and the greatest displacement of any point of the shape
    const swage_twist& V = world.V_WB[body_[i]];
    const double arm = solids_[i].centre.norm() + solids_[i].bound;
    ball_[i] = {X_WB_[body_[i]] * solids_[i].centre, solids_[i].bound,
                world.dt * (toolkit::vec(V.v).norm() + arm * toolkit::vec(V.w).norm())};
  }
  for (Chain& chain : chain_) {
    Ball& all = chain.ball = ball_[chain.first + chain.shapes / 2];
    for (uint32_t i = chain.first; i < chain.first + chain.shapes; ++i) {
      all.radius = std::max(all.radius, (ball_[i].centre - all.centre).norm() + ball_[i].radius);
      all.moves = std::max(all.moves, ball_[i].moves);
    }
  }
  for (Group& group : group_) {
    group.far = far_apart(chain_[group.chain].ball, group.other, options_.margin * world.length);
  }
}

/// Early exit: bounding spheres of the volumes swept in this step, then the face planes of a polyhedron.
bool Detector::far_apart(const Ball& ball, uint32_t other, double margin) const noexcept {
  const Ball& b = ball_[other];
  const double beside = ball.radius + ball.moves + b.moves + margin, reach = beside + b.radius;
  if ((ball.centre - b.centre).squaredNorm() > reach * reach) return true;
  const Solid& solid = solids_[other];
  return solid.kind == SWAGE_SHAPE_CONVEX &&
         beyond_a_face(solid.convex, X_WB_[body_[other]].inverse_times(ball.centre), beside);
}

/// Motion of a body over the step that is predicted to end at its pose; computed on first use.
const Motion& Detector::motion(const scene::World& world, uint32_t body) noexcept {
  KnownMotion& m = motion_[body];
  if (!m.known) m.motion = motion_of(world, body), m.known = true;
  return m.motion;
}

Query Detector::query_of(const scene::World& world, const ShapePair& pair, double margin) const noexcept {
  Query query{margin, world.length, options_.flatness, options_.line_points};
  query.piece = in_chain(world, pair.shape_a) || in_chain(world, pair.shape_b);
  if (query.piece) query.line_points = kChainPoints;
  const auto after = [this](uint32_t shape) { return shape + 1 < goes_on_.size() && goes_on_[shape + 1]; };
  query.goes_on = goes_on_[pair.shape_a] || goes_on_[pair.shape_b];
  query.goes_on_after = after(pair.shape_a) || after(pair.shape_b);
  return query;
}

void Detector::detect_shapes(const scene::World& world, ShapePair& pair, ContactSet& set) noexcept {
  const Solid &a = solids_[pair.shape_a], &b = solids_[pair.shape_b];
  const uint32_t body_a = world.shape[pair.shape_a].body, body_b = world.shape[pair.shape_b].body;
  const Frame &X_WA = X_WB_[body_a], &X_WB = X_WB_[body_b];

  const double margin = options_.margin * world.length;
  if (pair.group != kNoGroup && group_[pair.group].far) return;
  if (is_chain(pair.shape_a) || is_chain(pair.shape_b)) {
    const size_t first = set.contact.size();
    detect_with_chain(world, pair, set);
    memory_.leave_forces_to_one(set, first);
    return share_chain_touches(world, memory_, set, first);
  }
  const bool faces = b.kind == SWAGE_SHAPE_CONVEX;
  if (far_apart(ball_[faces ? pair.shape_a : pair.shape_b], faces ? pair.shape_b : pair.shape_a, margin))
    return;
  const double apart =
      (ball_[pair.shape_a].centre - ball_[pair.shape_b].centre).norm() - a.bound - b.bound - margin;
  const Motion &motion_a = motion(world, body_a), &motion_b = motion(world, body_b);
  const double moves = relative_motion(a, motion_a, motion_b);
  if (apart > moves) return;
  const Query query = query_of(world, pair, margin + moves);
  Separation none;
  Separation& memory = pair.remembers ? pair.memory : none;

  // chains of the thesis, sphere by sphere
  if (!chains_[pair.shape_a].node.empty() || !chains_[pair.shape_b].node.empty())
    return detect_chain(world, pair, query, set);

  // a body that moves farther than the wires are thick may have passed through: use the first contact of the sweep
  const double thickness = swept_from(a, b, world.length);
  if (moves > thickness) {
    const double tolerance = kTouchGap * world.length;
    const FirstTouch touch = first_touch(a, motion_a, b, motion_b, tolerance, memory, manifold_);
    if (touch.hit) {
      collide(a, Frame(motion_a.at(touch.t)), b, Frame(motion_b.at(touch.t)), query, memory, manifold_);
      for (int i = 0; i < manifold_.count; ++i) {
        Candidate& c = manifold_.candidate[static_cast<size_t>(i)];
        c.touch = reevaluate(c, X_WA, X_WB);
      }
      return append(world, pair, 0, set);
    }
  }
  collide(a, X_WA, b, X_WB, query, memory, manifold_);
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
  // each sphere represents a piece of wire and touches in one point
  Query point = query;
  point.flatness = 0;
  // and reports all its minima itself: with goes_on, all arcs of a wire but the first would touch nothing
  point.piece = point.goes_on = point.goes_on_after = false;
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
  for (int i = 0; i < manifold_.count; ++i)
    keep(world, pair, manifold_.candidate[static_cast<size_t>(i)], part, {}, set);
}

/// Adds a contact whose places on chains the caller has set.
void Detector::keep(const scene::World& world, const ShapePair& pair, const Candidate& found, uint64_t part,
                    Contact c, ContactSet& set) noexcept {
  if (set.contact.size() >= options_.capacity) {
    ++set.dropped;
    return;
  }
  c.pair = pair.pair;
  c.shape_a = pair.shape_a, c.shape_b = pair.shape_b;
  c.body_a = world.shape[pair.shape_a].body, c.body_b = world.shape[pair.shape_b].body;
  c.feature = found.feature | part << 44;
  c.p_W = found.touch.p_W, c.n_W = found.touch.n_W, c.gap = found.touch.gap;
  c.weight = found.weight;
  c.law = pairs_[pair.pair].law;
  memory_.give(world, c, set.contact.size());
  set.contact.push_back(c);
  set.candidate.push_back(found);
  set.candidate.back().feature = c.feature;
}

}  // namespace swage::contact
