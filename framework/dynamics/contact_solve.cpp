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
constexpr uint32_t kFreePasses = 4;  // before friction limits are held
constexpr double kLeastShare = 0.1;  // of the way that a pass asks for
constexpr double kMostShare =
    8;  // the same where ties hold: what they bear turns with what moves, and passes fall short
constexpr uint32_t kPasses = 12;      // geometry evaluations before an island is left at its best
constexpr uint32_t kTiedPasses = 24;  // the same where ties hold

}  // namespace

ContactSolve::ContactSolve(const scene::World& world, const Options& options)
    : options_(options),
      room_(world.capacity),
      place_(world),
      solver_(place_.unknowns(), place_.self().capacity() > 0 ? room_.rows : 0,
              static_cast<uint32_t>(world.hinge.size())) {
  const size_t movers = place_.movers();
  const size_t rows = size_t{room_.contacts} + room_.ties;
  known_.resize(room_.contacts), known_tie_.resize(room_.ties), row_.resize(rows);
  ranked_.reserve(room_.contacts), points_.assign(movers, 0);
  move_.resize(place_.unknowns());
  J_.resize(3 * rows * 12);
  island_.reserve(movers + 1);
  parent_.assign(movers, 0), island_of_.assign(movers, kNone);
  member_.assign(movers, 0), member_mover_.assign(movers, nullptr);
  solved_.assign(movers, 0), touched_.assign(movers, 0), local_.assign(movers, 0);
}

void ContactSolve::solve(scene::World& world, Motion& motion, contact::ContactSet& contacts,
                         std::span<Tie> ties, std::span<SelfSolver* const> self, Stats& stats) noexcept {
  ask_all_ = false;
  solver_.begin_step(options_.budget);
  for (size_t i = 0; i < std::min(known_.size(), contacts.contact.size()); ++i)
    known_[i].bore = !contacts.contact[i].f_a_W.isZero(0);
  begin(world, motion, contacts, ties, self);
  const bool moved = settle(contacts, stats);
  if (!wait_in_vain(contacts, moved)) return finish(motion, contacts, stats);
  ++stats.asked_again;
  as_found(contacts);
  ask_all_ = true;
  begin(world, motion, contacts, ties, self);
  settle(contacts, stats);
  finish(motion, contacts, stats);
}

/// Passes until every island is done. True when something moved that one of them did not settle.
bool ContactSolve::settle(contact::ContactSet& contacts, Stats& stats) noexcept {
  bool regroup = true, again = let_go(contacts);
  for (uint32_t pass = 0; pass < (tie_.empty() ? kPasses : kTiedPasses); ++pass) {
    if (regroup) find_islands(contacts);
    bool done = true;
    for (Group& group : island_) {
      if (!group.done && !group.stuck) solve_island(contacts, group, stats);
      done = done && (group.done || group.stuck);
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
  for (const Group& group : island_) {
    if (group.done && group.limits_hold) continue;
    ++health_.not_converged;
    if (group.done) continue;
    calm(contacts, group);
    look_again(group);
  }
  write_back(motion, contacts);
  count(contacts, stats);
}

// --- the start of the step

void ContactSolve::begin(scene::World& world, Motion& motion, contact::ContactSet& contacts,
                         std::span<Tie> ties, std::span<SelfSolver* const> self) noexcept {
  h_ = world.dt;
  health_ = {};
  lengths_ = Lengths::of(world, options_.tolerance);
  tolerance_ = lengths_.converged;
  place_.begin(world, motion, self);
  std::fill(solved_.begin(), solved_.end(), uint8_t{0});

  n_ = static_cast<uint32_t>(std::min({contacts.contact.size(), contacts.candidate.size(), known_.size()}));
  for (uint32_t i = 0; i < n_; ++i) {
    const contact::Contact& c = contacts.contact[i];
    Known& k = known_[i];
    k.a = place_.side(c.body_a, c.particle_a);
    k.b = place_.side(c.body_b, c.particle_b);
    k.active = overlaps(c);
    k.dropped = false;
    k.row = kNone;
    k.found = {c.gap, c.p_W, c.n_W};
  }
  add_own_points(contacts, ties);
  begin_ties(ties);
  health_.unanswered += place_.self().ask(h_);
  place_.take_answers();
  meet_surfaces(contacts);
  wake_own_points(contacts);
  start_ties();
}

/// Movers that were expected to stay held but overlap nothing go where they go by themselves, and meet what is there. True when
/// there are some.
bool ContactSolve::let_go(contact::ContactSet& contacts) noexcept {
  std::fill(touched_.begin(), touched_.end(), uint8_t{0});
  for (uint32_t i = 0; i < n_; ++i)
    for (const Side* s : {&known_[i].a, &known_[i].b})
      if (known_[i].active && s->mover != kNone) touched_[s->mover] = 1;
  touch_ties();

  bool moved = false;
  for (uint32_t i = 0; i < n_; ++i)
    for (const Side* s : {&known_[i].a, &known_[i].b}) {
      if (s->mover == kNone || touched_[s->mover]) continue;
      touched_[s->mover] = 1;
      moved = place_.let_go(s->mover) || moved;
    }
  for (uint32_t i = 0; moved && i < n_; ++i) {
    if (known_[i].waits) continue;
    evaluate(contacts, i);
    known_[i].active = known_[i].active || overlaps(contacts.contact[i]);
  }
  return moved;
}

/// Gap, place and normal of a contact at the present poses. A SELF side stays where it advanced to; how far from there it
/// really is, by itself and by what contacts make it give, is added to the gap.
void ContactSolve::evaluate(contact::ContactSet& contacts, uint32_t i) noexcept {
  contact::Contact& c = contacts.contact[i];
  const Known& k = known_[i];
  const contact::Touch touch = reevaluate(contacts.candidate[i], place_.frame(k.a), place_.frame(k.b));
  c.gap = touch.gap;
  c.p_W = touch.p_W;
  c.n_W = touch.n_W;
  c.gap += off_shapes(c, k);
}

/// Looks at the contacts of everything that moved. An island is done when they are where its linear problem said they
/// would be. True when a contact has begun to overlap that took no part.
bool ContactSolve::refresh(contact::ContactSet& contacts) noexcept {
  for (Group& group : island_)
    if (!group.done) group.off = 0;
  bool found = false;
  for (uint32_t i = 0; i < n_; ++i) {
    Known& k = known_[i];
    if (k.waits) continue;
    Group* const moved[2] = {moving_group(k.a), moving_group(k.b)};
    if (!moved[0] && !moved[1]) continue;
    contact::Contact& c = contacts.contact[i];
    evaluate(contacts, i);
    if (k.active) {
      Row& row = row_[k.row];
      const double share = island_[island_of_[first_mover(k)]].share;
      const Vec3 said = (row.at.g + share * row.asked.g) * row.n +
                        (row.at.s1 + share * row.asked.s1) * row.t1 +
                        (row.at.s2 + share * row.asked.s2) * row.t2;
      look(c, k, row);
      const double off = (row.at.g * row.n + row.at.s1 * row.t1 + row.at.s2 * row.t2 - said).norm();
      for (Group* group : moved)
        if (group) group->off = std::max(group->off, off);
    } else if (overlaps(c) && !k.dropped) {
      k.active = found = true;
      for (Group* group : moved)
        if (group) group->off = HUGE_VAL;
    }
  }
  refresh_ties();
  for (Group& group : island_) {
    if (group.done) continue;
    const bool all_the_way = group.share == 1 || (group.tied && group.left <= tolerance_);
    group.done = group.converged && all_the_way && group.off <= kGeometry * tolerance_;
    // two surfaces that meet at the edge of a feature can send each other to and fro: no later pass is better
    if (group.passes > (group.tied ? kPasses : kFreePasses) && !(group.off < 0.5 * group.off_before[1])) {
      group.stuck = true;
      group.done = group.done || (group.converged && group.off <= tolerance_);
    }
    group.off_before[1] = group.off_before[0], group.off_before[0] = group.off;
  }
  return found;
}

/// The island that moved this side in this pass.
ContactSolve::Group* ContactSolve::moving_group(const Side& side) noexcept {
  if (!place_.moves(side.mover) || island_of_[side.mover] == kNone) return nullptr;
  Group& group = island_[island_of_[side.mover]];
  return group.done ? nullptr : &group;
}

// --- one pass

void ContactSolve::solve_island(contact::ContactSet& contacts, Group& group, Stats& stats) noexcept {
  J_used_ = 0;
  const std::span<Row> rows(row_.data() + group.first_row, group.rows);
  for (Row& row : rows) {
    const uint32_t i = row.contact;
    row.J = row.tie ? jacobian(known_tie_[i].a, known_tie_[i].b, known_tie_[i].p_W, row)
                    : jacobian(known_[i].a, known_[i].b, contacts.contact[i].p_W, row);
  }

  const Island problem{
      {member_mover_.data() + group.first_mover, group.movers}, rows, group.unknowns, group.own};
  const Limits limits = group.passes < kFreePasses && !group.held ? Limits::kCoulomb : Limits::kHeld;
  ++group.passes;
  const Outcome outcome = solver_.solve(problem, lengths_, limits);
  relax(group);
  group.left = std::abs(1 - group.share) * outcome.moved;
  for (uint32_t i = 0; i < group.unknowns; ++i) move_[i] = group.share * solver_.d()[i];
  for (uint32_t i = 0; i < group.movers; ++i) {
    const uint32_t m = member_[group.first_mover + i];
    if (place_.is_self(m))
      move_own(m, rows, group.share);
    else
      place_.move(m, move_.data() + place_.mover(m).offset);
  }
  for (const Row& row : rows) {
    Vec3& f_a_W = row.tie ? tie_[row.contact].f_a_W : contacts.contact[row.contact].f_a_W;
    f_a_W = row.f.fn * row.n + row.f.f1 * row.t1 + row.f.f2 * row.t2;
  }

  // nothing moved that could be seen: the geometry is what it was
  group.converged = outcome.converged;
  group.limits_hold = outcome.limits_hold;
  group.held = group.held || outcome.held;
  group.done = outcome.converged && outcome.moved <= kGeometry * tolerance_;
  if (group.done)
    for (Row& row : rows) row.at = row.u;
  ++stats.islands;
  stats.newton += outcome.newton;
  stats.fallbacks += outcome.fell_back;
  stats.rounds += outcome.rounds;
}

/// An own solver goes by the forces of its rows, and will be given those.
void ContactSolve::move_own(uint32_t mover, std::span<const Row> rows, double share) noexcept {
  const uint32_t slot = place_.mover(mover).index, local = local_[mover];
  place_.self().begin_forces(slot);
  for (const Row& row : rows) {
    if (row.mover_a == local) place_.self().add_force(slot, row.point_a, row.y);
    if (row.mover_b == local) place_.self().add_force(slot, row.point_b, -row.y);
  }
  place_.self().go(slot, share);
}

/// How much of the way that the linear problem asks for is gone: what Aitken's rule makes of this way and the one before, seen
/// at the contacts. Where normals turn with what moves, passes that went all the way would jump to and fro.
void ContactSolve::relax(Group& group) noexcept {
  double along = 0, change = 0;
  for (uint32_t r = group.first_row; r < group.first_row + group.rows; ++r) {
    Row& row = row_[r];
    const double now[3] = {row.u.g - row.at.g, row.u.s1 - row.at.s1, row.u.s2 - row.at.s2};
    const double before[3] = {row.asked.g, row.asked.s1, row.asked.s2};
    for (int i = 0; i < 3; ++i) {
      along += before[i] * (now[i] - before[i]);
      change += (now[i] - before[i]) * (now[i] - before[i]);
    }
    row.asked = {now[0], now[1], now[2]};
  }
  if (group.passes > 1 && change > 0)
    group.share = std::clamp(-group.share * along / change, kLeastShare, group.tied ? kMostShare : 1.0);
}

/// The contact at the present poses: axes, law, gap and tangential displacement.
void ContactSolve::look(const contact::Contact& c, const Known& k, Row& row) noexcept {
  row.n = c.n_W;
  axes_across(row.n, row.t1, row.t2);
  const Vec3 u = place_.displacement(k.a, c.p_W) - place_.displacement(k.b, c.p_W);
  row.surface = surface(c.law.stiffness * c.weight, c.law.friction, c.law.restitution, h_);
  row.yielded = yielded(c.law.restitution, h_, c.gap - row.n.dot(u));
  const Vec3 s = carried_bristle(c, k) + u;
  row.at = {c.gap - row.yielded, row.t1.dot(s), row.t2.dot(s)};
}

/// How gap and displacement change with the unknowns of both sides.
const double* ContactSolve::jacobian(const Side& side_a, const Side& side_b, const Vec3& p_W,
                                     Row& row) noexcept {
  const bool a = place_.moves(side_a.mover), b = place_.moves(side_b.mover);
  row.size_a = a ? place_.mover(side_a.mover).size : 0;
  row.size_b = b ? place_.mover(side_b.mover).size : 0;
  row.offset_a = a ? place_.mover(side_a.mover).offset : 0;
  row.offset_b = b ? place_.mover(side_b.mover).offset : 0;
  row.mover_a = a ? local_[side_a.mover] : kNone, row.point_a = side_a.point;
  row.mover_b = b ? local_[side_b.mover] : kNone, row.point_b = side_b.point;

  double* J = J_.data() + J_used_;
  const uint32_t columns = row.size_a + row.size_b;
  const Vec3* axis[3] = {&row.n, &row.t1, &row.t2};
  for (uint32_t i = 0; i < 3; ++i) {
    if (row.size_a > 0) place_.columns(side_a, p_W, *axis[i], 1, J + i * columns);
    if (row.size_b > 0) place_.columns(side_b, p_W, *axis[i], -1, J + i * columns + row.size_a);
  }
  J_used_ += size_t{3} * columns;
  return J;
}

/// The bristle of the last step, turned as its surfaces turned since, in the tangent plane of now.
Vec3 ContactSolve::carried_bristle(const contact::Contact& c, const Known& k) const noexcept {
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
void ContactSolve::calm(const contact::ContactSet& contacts, const Group& group) noexcept {
  double fastest = 0;
  for (uint32_t r = group.first_row; r < group.first_row + group.rows; ++r) {
    const uint32_t i = row_[r].contact;
    const bool tie = row_[r].tie != nullptr;
    const Vec3& p = tie ? known_tie_[i].p_W : contacts.contact[i].p_W;
    const Side* const sides[2] = {tie ? &known_tie_[i].a : &known_[i].a,
                                  tie ? &known_tie_[i].b : &known_[i].b};
    for (const Side* s : sides) {
      if (s->body == kNone && s->particle == kNone) continue;  // the world
      if (!place_.moves(s->mover) || place_.mover(s->mover).kind == Mover::Kind::kHinge)
        fastest = std::max(fastest, place_.speed(*s, p));
    }
  }
  for (uint32_t i = 0; i < group.movers; ++i) {
    const uint32_t m = member_[group.first_mover + i];
    place_.slow_down(m, std::max(2 * fastest, place_.gain(m)));
  }
}

void ContactSolve::write_back(Motion& motion, contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i) write_contact(contacts.contact[i], known_[i]);
  for (size_t i = n_; i < contacts.contact.size(); ++i) {
    contacts.contact[i].bristle_W.setZero();
    contacts.contact[i].f_a_W.setZero();
    contacts.contact[i].slip = 0;
  }
  write_ties();
  mark_held(motion, contacts);
  place_.write_back(solved_);
  place_.self().yield();
}

void ContactSolve::write_contact(contact::Contact& c, const Known& k) noexcept {
  const bool touches = k.active && k.row != kNone && first_mover(k) != kNone && row_[k.row].f.fn > 0;
  c.slip = 0;
  if (!touches) {
    c.bristle_W.setZero();
    c.f_a_W.setZero();
    return;
  }
  const Row& row = row_[k.row];
  c.gap = row.at.g + row.yielded;

  // the bristle bears what friction bears; the rest has slipped
  const double stretch = std::sqrt(row.at.s1 * row.at.s1 + row.at.s2 * row.at.s2);
  const double most = row.limit / row.surface.kt;
  const double keep = stretch > most ? most / stretch : 1;
  c.bristle_W = keep * (row.at.s1 * row.t1 + row.at.s2 * row.t2);
  c.slip = (1 - keep) * stretch / h_;
}

void ContactSolve::mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept {
  std::fill(motion.held_body.begin(), motion.held_body.end(), 0);
  std::fill(motion.held_hinge.begin(), motion.held_hinge.end(), 0);
  std::fill(motion.held_particle.begin(), motion.held_particle.end(), 0);
  for (uint32_t i = 0; i < n_; ++i) {
    if (contacts.contact[i].f_a_W.isZero(0)) continue;
    hold(motion, known_[i].a), hold(motion, known_[i].b);
  }
  mark_held_by_ties(motion);
}

}  // namespace swage::dynamics
