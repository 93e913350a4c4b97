// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_solve.hpp"

#include <algorithm>
#include <cmath>

#include "contact/candidate.hpp"
#include "dynamics/axes.hpp"

namespace swage::dynamics {

using scene::kNone;

namespace {

constexpr double kGeometry =
    0.01;  // by how much a contact may be elsewhere than its linear model says, in tolerances: 1 pm
constexpr uint32_t kFreePasses = 4;       // before friction limits are held
constexpr double kLeastRelaxation = 0.1;  // of the way that a pass asks for
constexpr double kMostRelaxation =
    8;  // the same where ties hold: what they bear turns with what moves, and passes fall short
constexpr uint32_t kPasses = 12;      // geometry evaluations before an island is left at its best
constexpr uint32_t kTiedPasses = 24;  // the same where ties hold

}  // namespace

ContactSolve::ContactSolve(const scene::World& world, const Options& options)
    : options_(options),
      room_(world.capacity),
      place_(world),
      solver_(place_.unknowns(), place_.flexible().capacity() > 0 ? room_.rows : 0,
              static_cast<uint32_t>(world.hinge.size())) {
  const size_t blocks = place_.blocks();
  const size_t constraints = size_t{room_.contacts} + room_.ties;
  contact_.resize(room_.contacts), tie_workspace_.resize(room_.ties), constraint_.resize(constraints);
  ranked_.reserve(room_.contacts), points_.assign(blocks, 0);
  move_.resize(place_.unknowns());
  J_.resize(3 * constraints * 12);
  island_.reserve(blocks + 1);
  parent_.assign(blocks, 0), island_of_.assign(blocks, kNone);
  member_.assign(blocks, 0), member_block_.assign(blocks, nullptr);
  solved_.assign(blocks, 0), touched_.assign(blocks, 0), local_.assign(blocks, 0);
}

void ContactSolve::solve(scene::World& world, Motion& motion, contact::ContactSet& contacts,
                         std::span<Tie> ties, std::span<FlexibleBody* const> self, Stats& stats) noexcept {
  ask_all_ = false;
  solver_.begin_step(options_.budget);
  for (size_t i = 0; i < std::min(contact_.size(), contacts.contact.size()); ++i)
    contact_[i].bore = !contacts.contact[i].f_a_W.isZero(0);
  begin(world, motion, contacts, ties, self);
  const bool moved = iterate(contacts, stats);
  if (!missed_contact(contacts, moved)) return finish(motion, contacts, stats);
  ++stats.asked_again;
  restore_found(contacts);
  ask_all_ = true;
  begin(world, motion, contacts, ties, self);
  iterate(contacts, stats);
  finish(motion, contacts, stats);
}

/// Passes until every island is done. True when something moved that one of them did not settle.
bool ContactSolve::iterate(contact::ContactSet& contacts, Stats& stats) noexcept {
  bool regroup = true, again = release(contacts);
  for (uint32_t pass = 0; pass < (tie_.empty() ? kPasses : kTiedPasses); ++pass) {
    if (regroup) find_islands(contacts);
    bool done = true;
    for (IslandWorkspace& island : island_) {
      if (!island.done && !island.stalled) solve_island(contacts, island, stats);
      done = done && (island.done || island.stalled);
    }
    if (done) break;
    again = true;
    regroup = refresh(contacts);
    ++stats.refreshed;
    if (solver_.over_budget()) break;
  }
  return again;
}

void ContactSolve::finish(Motion& motion, contact::ContactSet& contacts, Stats& stats) noexcept {
  for (const IslandWorkspace& island : island_) {
    if (island.done && island.limits_hold) continue;
    ++health_.not_converged;
    if (island.done) continue;
    clamp_velocity(contacts, island);
    linearise_ties(island);
  }
  write_back(motion, contacts);
  count(contacts, stats);
}

// --- the start of the step

void ContactSolve::begin(scene::World& world, Motion& motion, contact::ContactSet& contacts,
                         std::span<Tie> ties, std::span<FlexibleBody* const> self) noexcept {
  h_ = world.dt;
  health_ = {};
  lengths_ = Lengths::of(world, options_.tolerance);
  tolerance_ = lengths_.converged;
  place_.begin(world, motion, self);
  std::fill(solved_.begin(), solved_.end(), uint8_t{0});

  n_ = static_cast<uint32_t>(std::min({contacts.contact.size(), contacts.candidate.size(), contact_.size()}));
  for (uint32_t i = 0; i < n_; ++i) {
    const contact::Contact& c = contacts.contact[i];
    ContactWorkspace& k = contact_[i];
    k.a = place_.side(c.body_a, c.particle_a);
    k.b = place_.side(c.body_b, c.particle_b);
    k.active = overlaps(c);
    k.dropped = false;
    k.constraint = kNone;
    k.found = {c.gap, c.p_W, c.n_W};
  }
  add_flexible_points(contacts, ties);
  begin_ties(ties);
  health_.unanswered += place_.flexible().ask(h_);
  place_.take_answers();
  meet_surfaces(contacts);
  start_at_predictions(contacts);
  start_ties();
}

/// Movers that were expected to stay held but overlap nothing go where they go by themselves, and meet what is there. True when
/// there are some.
bool ContactSolve::release(contact::ContactSet& contacts) noexcept {
  std::fill(touched_.begin(), touched_.end(), uint8_t{0});
  for (uint32_t i = 0; i < n_; ++i)
    for (const Side* s : {&contact_[i].a, &contact_[i].b})
      if (contact_[i].active && s->block != kNone) touched_[s->block] = 1;
  mark_tied();

  bool moved = false;
  for (uint32_t i = 0; i < n_; ++i)
    for (const Side* s : {&contact_[i].a, &contact_[i].b}) {
      if (s->block == kNone || touched_[s->block]) continue;
      touched_[s->block] = 1;
      moved = place_.release(s->block) || moved;
    }
  for (uint32_t i = 0; moved && i < n_; ++i) {
    if (contact_[i].skipped) continue;
    evaluate(contacts, i);
    contact_[i].active = contact_[i].active || overlaps(contacts.contact[i]);
  }
  return moved;
}

/// Gap, place and normal of a contact at the present poses. A flexible side stays where it advanced to; how far from there it
/// really is, by itself and by what contacts make it give, is added to the gap.
void ContactSolve::evaluate(contact::ContactSet& contacts, uint32_t i) noexcept {
  contact::Contact& c = contacts.contact[i];
  const ContactWorkspace& k = contact_[i];
  const contact::Touch touch = reevaluate(contacts.candidate[i], place_.frame(k.a), place_.frame(k.b));
  c.gap = touch.gap;
  c.p_W = touch.p_W;
  c.n_W = touch.n_W;
  c.gap += off_shapes(c, k);
}

/// Looks at the contacts of everything that moved. An island is done when they are where its linear problem said they
/// would be. True when a contact has begun to overlap that took no part.
bool ContactSolve::refresh(contact::ContactSet& contacts) noexcept {
  for (IslandWorkspace& island : island_)
    if (!island.done) island.geometry_error = 0;
  bool found = false;
  for (uint32_t i = 0; i < n_; ++i) {
    ContactWorkspace& k = contact_[i];
    if (k.skipped) continue;
    IslandWorkspace* const moved[2] = {moving_island(k.a), moving_island(k.b)};
    if (!moved[0] && !moved[1]) continue;
    contact::Contact& c = contacts.contact[i];
    evaluate(contacts, i);
    if (k.active) {
      Constraint& constraint = constraint_[k.constraint];
      const double relaxation = island_[island_of_[first_block(k)]].relaxation;
      const Vec3 said = (constraint.at.g + relaxation * constraint.last_step.g) * constraint.n +
                        (constraint.at.s1 + relaxation * constraint.last_step.s1) * constraint.t1 +
                        (constraint.at.s2 + relaxation * constraint.last_step.s2) * constraint.t2;
      linearise(c, k, constraint);
      const double off = (constraint.at.g * constraint.n + constraint.at.s1 * constraint.t1 +
                          constraint.at.s2 * constraint.t2 - said)
                             .norm();
      for (IslandWorkspace* island : moved)
        if (island) island->geometry_error = std::max(island->geometry_error, off);
    } else if (overlaps(c) && !k.dropped) {
      k.active = found = true;
      for (IslandWorkspace* island : moved)
        if (island) island->geometry_error = HUGE_VAL;
    }
  }
  refresh_ties();
  for (IslandWorkspace& island : island_) {
    if (island.done) continue;
    const bool all_the_way = island.relaxation == 1 || (island.tied && island.remaining <= tolerance_);
    island.done = island.converged && all_the_way && island.geometry_error <= kGeometry * tolerance_;
    // two surfaces that meet at the edge of a feature can send each other to and fro: no later pass is better
    if (island.passes > (island.tied ? kPasses : kFreePasses) &&
        !(island.geometry_error < 0.5 * island.last_errors[1])) {
      island.stalled = true;
      island.done = island.done || (island.converged && island.geometry_error <= tolerance_);
    }
    island.last_errors[1] = island.last_errors[0], island.last_errors[0] = island.geometry_error;
  }
  return found;
}

/// The island that moved this side in this pass.
ContactSolve::IslandWorkspace* ContactSolve::moving_island(const Side& side) noexcept {
  if (!place_.moves(side.block) || island_of_[side.block] == kNone) return nullptr;
  IslandWorkspace& island = island_[island_of_[side.block]];
  return island.done ? nullptr : &island;
}

// --- one pass

void ContactSolve::solve_island(contact::ContactSet& contacts, IslandWorkspace& island,
                                Stats& stats) noexcept {
  J_used_ = 0;
  const std::span<Constraint> constraints(constraint_.data() + island.first_constraint, island.constraints);
  for (Constraint& constraint : constraints) {
    const uint32_t i = constraint.contact;
    constraint.J = constraint.tie
                       ? jacobian(tie_workspace_[i].a, tie_workspace_[i].b, tie_workspace_[i].p_W, constraint)
                       : jacobian(contact_[i].a, contact_[i].b, contacts.contact[i].p_W, constraint);
  }

  const Island problem{
      {member_block_.data() + island.first_block, island.blocks}, constraints, island.unknowns, island.own};
  const Limits limits = island.passes < kFreePasses && !island.held ? Limits::kCoulomb : Limits::kHeld;
  ++island.passes;
  const Outcome outcome = solver_.solve(problem, lengths_, limits);
  relax(island);
  island.remaining = std::abs(1 - island.relaxation) * outcome.moved;
  for (uint32_t i = 0; i < island.unknowns; ++i) move_[i] = island.relaxation * solver_.d()[i];
  for (uint32_t i = 0; i < island.blocks; ++i) {
    const uint32_t m = member_[island.first_block + i];
    if (place_.is_flexible(m))
      move_flexible(m, constraints, island.relaxation);
    else
      place_.move(m, move_.data() + place_.block(m).offset);
  }
  for (const Constraint& constraint : constraints) {
    Vec3& f_a_W =
        constraint.tie ? tie_[constraint.contact].f_a_W : contacts.contact[constraint.contact].f_a_W;
    f_a_W =
        constraint.f.fn * constraint.n + constraint.f.f1 * constraint.t1 + constraint.f.f2 * constraint.t2;
  }

  // nothing moved that could be seen: the geometry is what it was
  island.converged = outcome.converged;
  island.limits_hold = outcome.limits_hold;
  island.held = island.held || outcome.held;
  island.done = outcome.converged && outcome.moved <= kGeometry * tolerance_;
  if (island.done)
    for (Constraint& constraint : constraints) constraint.at = constraint.u;
  ++stats.islands;
  stats.newton += outcome.newton;
  stats.fallbacks += outcome.fell_back;
  stats.rounds += outcome.rounds;
}

/// A flexible body goes by the forces of its constraints, and will be given those.
void ContactSolve::move_flexible(uint32_t block, std::span<const Constraint> constraints,
                                 double relaxation) noexcept {
  const uint32_t slot = place_.block(block).index, local = local_[block];
  place_.flexible().begin_forces(slot);
  for (const Constraint& constraint : constraints) {
    if (constraint.block_a == local) place_.flexible().add_force(slot, constraint.point_a, constraint.y);
    if (constraint.block_b == local) place_.flexible().add_force(slot, constraint.point_b, -constraint.y);
  }
  place_.flexible().go(slot, relaxation);
}

/// How much of the way that the linear problem asks for is gone: what Aitken's rule makes of this way and the one before, seen
/// at the contacts. Where normals turn with what moves, passes that went all the way would jump to and fro.
void ContactSolve::relax(IslandWorkspace& island) noexcept {
  double along = 0, change = 0;
  for (uint32_t r = island.first_constraint; r < island.first_constraint + island.constraints; ++r) {
    Constraint& constraint = constraint_[r];
    const double now[3] = {constraint.u.g - constraint.at.g, constraint.u.s1 - constraint.at.s1,
                           constraint.u.s2 - constraint.at.s2};
    const double before[3] = {constraint.last_step.g, constraint.last_step.s1, constraint.last_step.s2};
    for (int i = 0; i < 3; ++i) {
      along += before[i] * (now[i] - before[i]);
      change += (now[i] - before[i]) * (now[i] - before[i]);
    }
    constraint.last_step = {now[0], now[1], now[2]};
  }
  if (island.passes > 1 && change > 0)
    island.relaxation = std::clamp(-island.relaxation * along / change, kLeastRelaxation,
                                   island.tied ? kMostRelaxation : 1.0);
}

/// The contact at the present poses: axes, law, gap and tangential displacement.
void ContactSolve::linearise(const contact::Contact& c, const ContactWorkspace& k,
                             Constraint& constraint) noexcept {
  constraint.n = c.n_W;
  axes_across(constraint.n, constraint.t1, constraint.t2);
  const Vec3 u = place_.displacement(k.a, c.p_W) - place_.displacement(k.b, c.p_W);
  constraint.surface = surface(c.law.stiffness * c.weight, c.law.friction, c.law.restitution, h_);
  constraint.relaxed_gap = relaxed_gap(c.law.restitution, h_, c.gap - constraint.n.dot(u));
  const Vec3 s = carried_bristle(c, k) + u;
  constraint.at = {c.gap - constraint.relaxed_gap, constraint.t1.dot(s), constraint.t2.dot(s)};
}

/// How gap and displacement change with the unknowns of both sides.
const double* ContactSolve::jacobian(const Side& side_a, const Side& side_b, const Vec3& p_W,
                                     Constraint& constraint) noexcept {
  const bool a = place_.moves(side_a.block), b = place_.moves(side_b.block);
  constraint.size_a = a ? place_.block(side_a.block).size : 0;
  constraint.size_b = b ? place_.block(side_b.block).size : 0;
  constraint.offset_a = a ? place_.block(side_a.block).offset : 0;
  constraint.offset_b = b ? place_.block(side_b.block).offset : 0;
  constraint.block_a = a ? local_[side_a.block] : kNone, constraint.point_a = side_a.point;
  constraint.block_b = b ? local_[side_b.block] : kNone, constraint.point_b = side_b.point;

  double* J = J_.data() + J_used_;
  const uint32_t columns = constraint.size_a + constraint.size_b;
  const Vec3* axis[3] = {&constraint.n, &constraint.t1, &constraint.t2};
  for (uint32_t i = 0; i < 3; ++i) {
    if (constraint.size_a > 0) place_.columns(side_a, p_W, *axis[i], 1, J + i * columns);
    if (constraint.size_b > 0) place_.columns(side_b, p_W, *axis[i], -1, J + i * columns + constraint.size_a);
  }
  J_used_ += size_t{3} * columns;
  return J;
}

/// The bristle of the last step, turned as its surfaces turned since, in the tangent plane of now.
Vec3 ContactSolve::carried_bristle(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  if (c.bristle_W.isZero(0)) return Vec3::Zero();
  bool has_a, has_b;
  const Vec3 a = place_.rotation(k.a, has_a), b = place_.rotation(k.b, has_b);
  const Vec3 turn = has_a && has_b ? Vec3(0.5 * (a + b)) : Vec3(a + b);

  // both turns and the tilt of the normal change its direction, not its length
  const Vec3 s = carried(c.bristle_W, turn);
  const Vec3 flat = s - c.n_W.dot(s) * c.n_W;
  const double length = flat.norm();
  return length > 0 ? Vec3(flat * (c.bristle_W.norm() / length)) : Vec3::Zero();
}

// --- the end of the step

/// An island that did not converge must not gain energy: nothing in it leaves faster than the loads on it can
/// make it in a step, or than twice what pushes it.
void ContactSolve::clamp_velocity(const contact::ContactSet& contacts,
                                  const IslandWorkspace& island) noexcept {
  double fastest = 0;
  for (uint32_t r = island.first_constraint; r < island.first_constraint + island.constraints; ++r) {
    const uint32_t i = constraint_[r].contact;
    const bool tie = constraint_[r].tie != nullptr;
    const Vec3& p = tie ? tie_workspace_[i].p_W : contacts.contact[i].p_W;
    const Side* const sides[2] = {tie ? &tie_workspace_[i].a : &contact_[i].a,
                                  tie ? &tie_workspace_[i].b : &contact_[i].b};
    for (const Side* s : sides) {
      if (s->body == kNone && s->particle == kNone) continue;  // the world
      if (!place_.moves(s->block) || place_.block(s->block).kind == DofBlock::Kind::kHinge)
        fastest = std::max(fastest, place_.speed(*s, p));
    }
  }
  for (uint32_t i = 0; i < island.blocks; ++i) {
    const uint32_t m = member_[island.first_block + i];
    place_.slow_down(m, std::max(2 * fastest, place_.gain(m)));
  }
}

void ContactSolve::write_back(Motion& motion, contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i) write_contact(contacts.contact[i], contact_[i]);
  for (size_t i = n_; i < contacts.contact.size(); ++i) {
    contacts.contact[i].bristle_W.setZero();
    contacts.contact[i].f_a_W.setZero();
    contacts.contact[i].slip = 0;
  }
  write_ties();
  mark_held(motion, contacts);
  place_.write_back(solved_);
  place_.flexible().apply_impulses();
}

void ContactSolve::write_contact(contact::Contact& c, const ContactWorkspace& k) noexcept {
  const bool touches =
      k.active && k.constraint != kNone && first_block(k) != kNone && constraint_[k.constraint].f.fn > 0;
  c.slip = 0;
  if (!touches) {
    c.bristle_W.setZero();
    c.f_a_W.setZero();
    return;
  }
  const Constraint& constraint = constraint_[k.constraint];
  c.gap = constraint.at.g + constraint.relaxed_gap;

  // the bristle bears what friction bears; the rest has slipped
  const double stretch = std::sqrt(constraint.at.s1 * constraint.at.s1 + constraint.at.s2 * constraint.at.s2);
  const double most = constraint.limit / constraint.surface.kt;
  const double keep = stretch > most ? most / stretch : 1;
  c.bristle_W = keep * (constraint.at.s1 * constraint.t1 + constraint.at.s2 * constraint.t2);
  c.slip = (1 - keep) * stretch / h_;
}

void ContactSolve::mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept {
  std::fill(motion.held_body.begin(), motion.held_body.end(), 0);
  std::fill(motion.held_hinge.begin(), motion.held_hinge.end(), 0);
  std::fill(motion.held_particle.begin(), motion.held_particle.end(), 0);
  for (uint32_t i = 0; i < n_; ++i) {
    if (contacts.contact[i].f_a_W.isZero(0)) continue;
    hold(motion, contact_[i].a), hold(motion, contact_[i].b);
  }
  mark_held_by_ties(motion);
}

}  // namespace swage::dynamics
