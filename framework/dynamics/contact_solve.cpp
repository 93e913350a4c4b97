// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_solve.hpp"

#include <algorithm>
#include <cmath>

namespace swage::dynamics {

using scene::kNone;

namespace {

constexpr double kGeometry =
    0.01;  // largest distance of a contact from where its linear model predicted it, in tolerances: 1 pm
constexpr uint32_t kFreePasses = 4;       // before friction limits are held
constexpr double kLeastRelaxation = 0.1;  // of the step that a pass computes
constexpr double kMostRelaxation =
    8;  // the largest, with ties: their forces turn with the moving bodies, and passes fall short
constexpr uint32_t kPasses = 12;      // geometry evaluations before an island is left at its best
constexpr uint32_t kTiedPasses = 24;  // the same in islands with ties

}  // namespace

ContactSolve::ContactSolve(const scene::World& world, const Options& options)
    : options_(options),
      p_(world),
      islands_(p_),
      points_(p_),
      ties_(p_),
      solver_(p_.place.unknowns(), p_.place.flexible().capacity() > 0 ? p_.room.rows : 0,
              static_cast<uint32_t>(world.hinge.size()),
              {p_.place.flexible().vertices(), static_cast<uint32_t>(p_.constraint.size())}) {
  move_.resize(p_.place.unknowns() + BandedBody::kUnknowns * p_.place.flexible().vertices());
  J_.resize(3 * p_.constraint.size() * 2 * BandedBody::kOfPoint);
  touched_.assign(p_.place.blocks(), 0);
}

void ContactSolve::solve(scene::World& world, Motion& motion, contact::ContactSet& contacts,
                         std::span<Tie> ties, std::span<FlexibleBody* const> self, Stats& stats) noexcept {
  solver_.begin_step(options_.budget);
  for (size_t i = 0; i < std::min(p_.contact.size(), contacts.contact.size()); ++i) {
    const contact::Contact& c = contacts.contact[i];
    p_.contact[i].bore = !c.f_a_W.isZero(0);
    p_.contact[i].normal_before = c.n_W.dot(c.f_a_W);
  }
  begin(world, motion, contacts, ties, self, false);
  const bool moved = iterate(contacts, stats);
  if (!points_.missed_contact(contacts, moved)) return finish(motion, contacts, stats);
  ++stats.asked_again;
  points_.restore(contacts);
  begin(world, motion, contacts, ties, self, true);
  iterate(contacts, stats);
  finish(motion, contacts, stats);
}

/// Passes until every island is done. True when released blocks moved or one pass was not enough.
bool ContactSolve::iterate(contact::ContactSet& contacts, Stats& stats) noexcept {
  bool regroup = true, again = release(contacts);
  for (uint32_t pass = 0; pass < (p_.tie.empty() ? kPasses : kTiedPasses); ++pass) {
    if (regroup) islands_.find(contacts);
    bool done = true;
    for (IslandWorkspace& island : islands_.all()) {
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
  for (const IslandWorkspace& island : islands_.all()) {
    if (island.done && island.limits_hold) continue;
    ++p_.health.not_converged;
    if (island.done) continue;
    clamp_velocity(contacts, island);
    ties_.linearise(island);
  }
  stats.strayed = strayed(contacts);
  write_back(motion, contacts);
  count(contacts, stats);
}

// --- the start of the step

void ContactSolve::begin(scene::World& world, Motion& motion, contact::ContactSet& contacts,
                         std::span<Tie> ties, std::span<FlexibleBody* const> self, bool ask_all) noexcept {
  p_.scales = Scales::of(world, options_);
  p_.begin(world, motion, contacts, self);
  points_.add(contacts, ties, ask_all);
  ties_.begin(ties);
  p_.health.unanswered += p_.place.flexible().ask(p_.h);
  p_.place.take_answers();
  points_.meet_surfaces(contacts);
  points_.start_at_predictions(contacts, ties_);
  ties_.start();
}

/// Moves blocks that were predicted as held but touch nothing to their free poses, and activates contacts that overlap there. True
/// when there are some.
bool ContactSolve::release(contact::ContactSet& contacts) noexcept {
  std::fill(touched_.begin(), touched_.end(), uint8_t{0});
  for (uint32_t i = 0; i < p_.n; ++i)
    for (const Side* s : {&p_.contact[i].a, &p_.contact[i].b})
      if (p_.contact[i].active && s->block != kNone) touched_[s->block] = 1;
  for (uint32_t i = 0; i < p_.tie.size(); ++i)
    for (const Side* s : {&p_.tie_workspace[i].a, &p_.tie_workspace[i].b})
      if (s->block != kNone) touched_[s->block] = 1;

  bool moved = false;
  for (uint32_t i = 0; i < p_.n; ++i)
    for (const Side* s : {&p_.contact[i].a, &p_.contact[i].b}) {
      if (s->block == kNone || touched_[s->block]) continue;
      touched_[s->block] = 1;
      moved = p_.place.release(s->block) || moved;
    }
  for (uint32_t i = 0; moved && i < p_.n; ++i) {
    if (p_.contact[i].skipped) continue;
    p_.evaluate(contacts, i);
    p_.contact[i].active = p_.contact[i].active || overlaps(contacts.contact[i]);
  }
  return moved;
}

/// Evaluates the contacts of all blocks that moved. An island is done when they are where its linear problem predicted them.
/// True when a contact that was not active has begun to overlap.
bool ContactSolve::refresh(contact::ContactSet& contacts) noexcept {
  for (IslandWorkspace& island : islands_.all())
    if (!island.done) island.geometry_error = 0;
  bool found = false;
  for (uint32_t i = 0; i < p_.n; ++i) {
    ContactWorkspace& k = p_.contact[i];
    if (k.skipped) continue;
    IslandWorkspace* const moved[2] = {islands_.moving(k.a), islands_.moving(k.b)};
    if (!moved[0] && !moved[1]) continue;
    contact::Contact& c = contacts.contact[i];
    p_.evaluate(contacts, i);
    if (k.active) {
      Constraint& constraint = p_.constraint[k.constraint];
      const double relaxation = islands_.of(p_.first_block(k)).relaxation;
      const Vec3 said = (constraint.at.g + relaxation * constraint.last_step.g) * constraint.n +
                        (constraint.at.s1 + relaxation * constraint.last_step.s1) * constraint.t1 +
                        (constraint.at.s2 + relaxation * constraint.last_step.s2) * constraint.t2;
      p_.linearise(c, k, constraint);
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
  ties_.refresh(islands_);
  for (IslandWorkspace& island : islands_.all()) {
    if (island.done) continue;
    const bool all_the_way =
        island.relaxation == 1 || (island.tied && island.remaining <= p_.scales.converged);
    island.done = ends(island, island.converged && all_the_way && island.geometry_error <= kGeometry * p_.scales.converged);
    // contacts at the edge of a feature can alternate between two states: no later pass is better
    if (island.passes > (island.tied ? kPasses : kFreePasses) &&
        !(island.geometry_error < 0.5 * island.last_errors[1])) {
      island.stalled = true;
      island.done = island.done || (island.converged && island.geometry_error <= p_.scales.converged);
    }
    island.last_errors[1] = island.last_errors[0], island.last_errors[0] = island.geometry_error;
  }
  return found;
}

// --- one pass

void ContactSolve::solve_island(contact::ContactSet& contacts, IslandWorkspace& island,
                                Stats& stats) noexcept {
  J_used_ = 0;
  const std::span<Constraint> constraints(p_.constraint.data() + island.first_constraint, island.constraints);
  for (Constraint& constraint : constraints) {
    const uint32_t i = constraint.contact;
    constraint.J =
        constraint.tie
            ? jacobian(p_.tie_workspace[i].a, p_.tie_workspace[i].b, p_.tie_workspace[i].p_W, constraint)
            : jacobian(p_.contact[i].a, p_.contact[i].b, contacts.contact[i].p_W, constraint);
  }

  const bool forces = island.own || (island.banded && island.constraints <= few_);
  const Island problem{islands_.blocks(island), constraints, island.unknowns, forces, island.banded};
  const Limits limits = island.passes < kFreePasses && !island.held ? Limits::kCoulomb : Limits::kHeld;
  if (island.begins_anew) begin_with_last_limits(constraints, island);
  ++island.passes;
  const Outcome outcome = solver_.solve(problem, p_.scales, limits);
  relax(island);
  island.remaining = std::abs(1 - island.relaxation) * outcome.moved;
  for (uint32_t i = 0; i < island.unknowns; ++i) move_[i] = island.relaxation * solver_.d()[i];
  for (const uint32_t m : islands_.members(island)) {
    if (p_.place.block(m).kind == DofBlock::Kind::kFlexible)
      move_flexible(m, constraints, island.relaxation);
    else
      p_.place.move(m, move_.data() + p_.place.block(m).offset);
  }
  for (const Constraint& constraint : constraints) {
    Vec3& f_a_W =
        constraint.tie ? p_.tie[constraint.contact].f_a_W : contacts.contact[constraint.contact].f_a_W;
    f_a_W =
        constraint.f.fn * constraint.n + constraint.f.f1 * constraint.t1 + constraint.f.f2 * constraint.t2;
  }

  // done where the step was negligible: the geometry has not changed
  island.converged = outcome.converged;
  island.limits_hold = outcome.limits_hold;
  island.held = island.held || outcome.held;
  island.done = ends(island, outcome.converged && outcome.moved <= kGeometry * p_.scales.converged);
  if (island.done)
    for (Constraint& constraint : constraints) constraint.at = constraint.u;
  ++stats.islands;
  stats.newton += outcome.newton;
  stats.fallbacks += outcome.fell_back;
  stats.rounds += outcome.rounds;
}

/// Whether an island is done. One that has come to an end with limits that do not hold begins anew with those of the last step, once. A light wire
/// that slides by its own radius within a step lifts a heavy jaw in a pass, and the limits of that pass hold half as much again as the grip does.
/// Islands whose limits are held from the first pass on have those of the start. Forces of threads change too much from step to step.
bool ContactSolve::ends(IslandWorkspace& island, bool settled) noexcept {
  if (!settled || island.limits_hold || island.held || island.banded || island.began_anew) return settled;
  island.begins_anew = island.began_anew = true;
  return false;
}

void ContactSolve::begin_with_last_limits(std::span<Constraint> constraints, IslandWorkspace& island) noexcept {
  island.begins_anew = false;
  for (Constraint& c : constraints)
    if (!c.tie && p_.contact[c.contact].normal_before > 0) c.limit = c.surface.mu * p_.contact[c.contact].normal_before;
}

/// Moves a flexible body by the forces of its constraints, which it will get as impulses.
void ContactSolve::move_flexible(uint32_t block, std::span<const Constraint> constraints,
                                 double relaxation) noexcept {
  const uint32_t slot = p_.place.block(block).index, local = islands_.local(block);
  p_.place.flexible().begin_forces(slot);
  for (const Constraint& constraint : constraints) {
    if (constraint.block_a == local) p_.place.flexible().add_force(slot, constraint.point_a, constraint.y);
    if (constraint.block_b == local) p_.place.flexible().add_force(slot, constraint.point_b, -constraint.y);
  }
  p_.place.flexible().go(slot, relaxation);
}

/// Sets the share of the linear problem's step that is taken: Aitken's rule on this step and the one before, as displacements at
/// the contacts. Where normals turn with the bodies, passes that took whole steps would oscillate.
void ContactSolve::relax(IslandWorkspace& island) noexcept {
  double along = 0, change = 0;
  for (uint32_t r = island.first_constraint; r < island.first_constraint + island.constraints; ++r) {
    Constraint& constraint = p_.constraint[r];
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

/// Jacobian of gap and tangential displacement with respect to the unknowns of both sides.
const double* ContactSolve::jacobian(const Side& side_a, const Side& side_b, const Vec3& p_W,
                                     Constraint& constraint) noexcept {
  const bool a = p_.place.moves(side_a.block), b = p_.place.moves(side_b.block);
  const Placement::Columns of_a = p_.place.columns(side_a), of_b = p_.place.columns(side_b);
  constraint.size_a = of_a.size, constraint.size_b = of_b.size;
  constraint.offset_a = a ? p_.place.block(side_a.block).offset + of_a.offset : 0;
  constraint.offset_b = b ? p_.place.block(side_b.block).offset + of_b.offset : 0;
  constraint.block_a = a ? islands_.local(side_a.block) : kNone, constraint.point_a = side_a.point;
  constraint.block_b = b ? islands_.local(side_b.block) : kNone, constraint.point_b = side_b.point;

  double* J = J_.data() + J_used_;
  const uint32_t columns = constraint.size_a + constraint.size_b;
  const Vec3* axis[3] = {&constraint.n, &constraint.t1, &constraint.t2};
  for (uint32_t i = 0; i < 3; ++i) {
    if (constraint.size_a > 0) p_.place.columns(side_a, p_W, *axis[i], 1, J + i * columns);
    if (constraint.size_b > 0)
      p_.place.columns(side_b, p_W, *axis[i], -1, J + i * columns + constraint.size_a);
  }
  J_used_ += size_t{3} * columns;
  return J;
}

}  // namespace swage::dynamics
