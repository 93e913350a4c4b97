// SPDX-License-Identifier: Apache-2.0
//
// Ties beside contacts: rows of the same islands, always active, with constant limits.
#include <algorithm>
#include <cmath>

#include "dynamics/axes.hpp"
#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

namespace {
// N/m, for which the solve's tolerance is meant: what is softer may be off by as much more for the same force.
constexpr double kContactStiffness = 1e6;
}  // namespace

/// Sides and, where an object answers for itself, its points.
void ContactSolve::begin_ties(std::span<Tie> ties) noexcept {
  tie_ = ties.first(std::min(ties.size(), known_tie_.size()));
  health_.dropped_ties += ties.size() - tie_.size();
  for (Tie& tie : ties) tie.f_a_W = tie.slid_W = Vec3::Zero();
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    const Tie& tie = tie_[i];
    KnownTie& k = known_tie_[i];
    k = {};
    for (const bool is_a : {true, false}) {
      const uint32_t body = is_a ? tie.body_a : tie.body_b;
      Side& side = is_a ? k.a : k.b;
      if (body == kNone) continue;
      side = place_.side(body, kNone);
      if (!place_.is_self(side.mover)) continue;
      const Vec3 across = tie.offset_W - tie.axis_W.dot(tie.offset_W) * tie.axis_W;
      const Vec3 at =
          is_a ? tie.p_W : tie.p_W - across;  // b gives where it is held, wherever a has been pulled to
      side.point = place_.self().add_point(place_.mover(side.mover).index, body, kNone, at, tie.axis_W);
      if (side.point != kNone) continue;
      ++health_.shared_points;
      side.shares = true;
      side.point = place_.self().nearest(place_.mover(side.mover).index, at);
    }
  }
}

/// What an own solver gave way for in the last step it is expected to give way for again.
void ContactSolve::expect_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i)
    for (const Side* s : {&known_tie_[i].a, &known_tie_[i].b})
      if (s->point != kNone && !s->shares) place_.expect(*s, tie_[i].p_W);
}

/// The material points that each tie holds, once it is known who can be moved.
void ContactSolve::start_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    KnownTie& k = known_tie_[i];
    k.active = place_.moves(k.a.mover) || place_.moves(k.b.mover);
    k.p_W = tie_[i].p_W;
    k.axis_A = tie_[i].axis_W;
    if (k.a.body != kNone) k.p_A = place_.frame(k.a).inverse_times(tie_[i].p_W);
    if (k.a.body != kNone) k.axis_A = place_.frame(k.a).R.transpose() * tie_[i].axis_W;
    if (k.b.body != kNone) k.p_B = place_.frame(k.b).inverse_times(tie_[i].p_W);
  }
}

/// What is tied is held where it is predicted to be.
void ContactSolve::touch_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i)
    for (const Side* s : {&known_tie_[i].a, &known_tie_[i].b})
      if (s->mover != kNone) touched_[s->mover] = 1;
}

uint32_t ContactSolve::first_mover(const KnownTie& k) const noexcept {
  return place_.moves(k.a.mover) ? k.a.mover : place_.moves(k.b.mover) ? k.b.mover : kNone;
}

void ContactSolve::join_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    const KnownTie& k = known_tie_[i];
    if (!place_.moves(k.a.mover) || !place_.moves(k.b.mover)) continue;
    const uint32_t a = root(k.a.mover), b = root(k.b.mover);
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

/// Islands of what no contact names, after the others.
void ContactSolve::found_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    if (!known_tie_[i].active) continue;
    const uint32_t r = root(first_mover(known_tie_[i]));
    if (island_of_[r] != kNone) continue;
    island_of_[r] = static_cast<uint32_t>(island_.size());
    island_.push_back({});
  }
}

void ContactSolve::fill_ties(uint32_t island) noexcept {
  Group& group = island_[island];
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    KnownTie& k = known_tie_[i];
    if (!k.active || island_of_[first_mover(k)] != island) continue;
    if (place_.moves(k.a.mover)) add_mover(group, k.a.mover);
    if (place_.moves(k.b.mover)) add_mover(group, k.b.mover);
    k.row = group.first_row + group.rows++;
    Row& row = row_[k.row];
    row.contact = i;
    row.tie = &tie_[i].law;
    row.limit = 0;
    group.tied = true;
    look(tie_[i], k, row);
  }
}

void ContactSolve::refresh_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    KnownTie& k = known_tie_[i];
    Group* const moved[2] = {moving_group(k.a), moving_group(k.b)};
    if (!moved[0] && !moved[1]) continue;
    Row& row = row_[k.row];
    const double share = island_[island_of_[first_mover(k)]].share;
    const Vec3 said(row.at.g + share * row.asked.g, row.at.s1 + share * row.asked.s1,
                    row.at.s2 + share * row.asked.s2);
    look(tie_[i], k, row);
    const TieLaw& law = tie_[i].law;
    const double off = (Vec3(row.at.g, row.at.s1, row.at.s2) - said).norm() *
                       std::min(1.0, std::max(law.k_across, law.k_along) / kContactStiffness);
    for (Group* group : moved)
      if (group) group->off = std::max(group->off, off);
  }
}

/// How far a side's material point is from where it was predicted to be, or from where its shape is [m].
Vec3 ContactSolve::moved(const Side& side, const Vec3& p_own, const Vec3& p_W) const noexcept {
  if (side.body == kNone) return Vec3::Zero();
  if (side.point != kNone) return off_shape(side, p_W);
  return place_.frame(side) * p_own - p_W;
}

/// The tie at the present poses. Its axis turns with a; what it is stretched across the axis stands in the world.
void ContactSolve::look(const Tie& tie, KnownTie& k, Row& row) noexcept {
  row.n = k.a.body != kNone ? Vec3(place_.frame(k.a).R * k.axis_A) : k.axis_A;
  axes_across(row.n, row.t1, row.t2);
  const Vec3 a = moved(k.a, k.p_A, tie.p_W), b = moved(k.b, k.p_B, tie.p_W);
  const double along = tie.axis_W.dot(tie.offset_W);
  const Vec3 s = tie.offset_W - along * tie.axis_W + a - b;
  k.p_W = tie.p_W + (place_.moves(k.a.mover) ? a - s : b);
  row.at = {along + row.n.dot(s), row.t1.dot(s), row.t2.dot(s)};
}

/// What was put elsewhere than its rows said.
void ContactSolve::look_again(const Group& group) noexcept {
  for (uint32_t r = group.first_row; r < group.first_row + group.rows; ++r)
    if (row_[r].tie != nullptr) look(tie_[row_[r].contact], known_tie_[row_[r].contact], row_[r]);
}

void ContactSolve::write_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    KnownTie& k = known_tie_[i];
    Tie& tie = tie_[i];
    Row fixed;
    if (!k.active) {  // nothing of it can be moved: its force follows from where it is
      look(tie, k, fixed);
      fixed.f = tie_force(tie.law, fixed.at);
      tie.f_a_W = fixed.f.fn * fixed.n + fixed.f.f1 * fixed.t1 + fixed.f.f2 * fixed.t2;
    }
    const Row& row = k.active ? row_[k.row] : fixed;
    const Displacement slid = tie_slid(tie.law, row.at, tie_force(tie.law, row.at));
    tie.axis_W = row.n;
    tie.slid_W = slid.g * row.n + slid.s1 * row.t1 + slid.s2 * row.t2;
  }
}

void ContactSolve::mark_held_by_ties(Motion& motion) noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i)
    if (!tie_[i].f_a_W.isZero(0)) hold(motion, known_tie_[i].a), hold(motion, known_tie_[i].b);
}

void ContactSolve::hold(Motion& motion, const Side& side) const noexcept {
  if (side.mover == kNone) return;
  const Mover& m = place_.mover(side.mover);
  if (m.kind == Mover::Kind::kBody) motion.held_body[m.index] = 1;
  if (m.kind == Mover::Kind::kHinge) motion.held_hinge[m.index] = 1;
  if (m.kind == Mover::Kind::kParticle) motion.held_particle[m.index] = 1;
}

}  // namespace swage::dynamics
