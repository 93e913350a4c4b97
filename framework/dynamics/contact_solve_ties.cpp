// SPDX-License-Identifier: Apache-2.0
//
// Ties beside contacts: constraints of the same islands, always active, with constant limits.
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
  tie_ = ties.first(std::min(ties.size(), tie_workspace_.size()));
  health_.dropped_ties += ties.size() - tie_.size();
  for (Tie& tie : ties) tie.f_a_W = tie.plastic_slip_W = Vec3::Zero();
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    const Tie& tie = tie_[i];
    TieWorkspace& k = tie_workspace_[i];
    k = {};
    for (const bool is_a : {true, false}) {
      const uint32_t body = is_a ? tie.body_a : tie.body_b;
      Side& side = is_a ? k.a : k.b;
      if (body == kNone) continue;
      side = place_.side(body, kNone);
      if (!place_.is_flexible(side.block)) continue;
      const Vec3 across = tie.offset_W - tie.axis_W.dot(tie.offset_W) * tie.axis_W;
      const Vec3 at =
          is_a ? tie.p_W : tie.p_W - across;  // b gives where it is held, wherever a has been pulled to
      side.point = place_.flexible().add_point(place_.block(side.block).index, body, kNone, at, tie.axis_W);
      if (side.point != kNone) continue;
      ++health_.shared_points;
      side.shares = true;
      side.point = place_.flexible().nearest(place_.block(side.block).index, at);
    }
  }
}

/// What a flexible body gave way for in the last step it is expected to give way for again.
void ContactSolve::predict_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i)
    for (const Side* s : {&tie_workspace_[i].a, &tie_workspace_[i].b})
      if (s->point != kNone && !s->shares) place_.expect(*s, tie_[i].p_W);
}

/// The material points that each tie holds, once it is known who can be moved.
void ContactSolve::start_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    TieWorkspace& k = tie_workspace_[i];
    k.active = place_.moves(k.a.block) || place_.moves(k.b.block);
    k.p_W = tie_[i].p_W;
    k.axis_A = tie_[i].axis_W;
    if (k.a.body != kNone) k.p_A = place_.frame(k.a).inverse_times(tie_[i].p_W);
    if (k.a.body != kNone) k.axis_A = place_.frame(k.a).R.transpose() * tie_[i].axis_W;
    if (k.b.body != kNone) k.p_B = place_.frame(k.b).inverse_times(tie_[i].p_W);
  }
}

/// What is tied is held where it is predicted to be.
void ContactSolve::mark_tied() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i)
    for (const Side* s : {&tie_workspace_[i].a, &tie_workspace_[i].b})
      if (s->block != kNone) touched_[s->block] = 1;
}

uint32_t ContactSolve::first_block(const TieWorkspace& k) const noexcept {
  return place_.moves(k.a.block) ? k.a.block : place_.moves(k.b.block) ? k.b.block : kNone;
}

void ContactSolve::join_tied_blocks() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    const TieWorkspace& k = tie_workspace_[i];
    if (!place_.moves(k.a.block) || !place_.moves(k.b.block)) continue;
    const uint32_t a = root(k.a.block), b = root(k.b.block);
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

/// Islands of what no contact names, after the others.
void ContactSolve::add_tie_islands() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    if (!tie_workspace_[i].active) continue;
    const uint32_t r = root(first_block(tie_workspace_[i]));
    if (island_of_[r] != kNone) continue;
    island_of_[r] = static_cast<uint32_t>(island_.size());
    island_.push_back({});
  }
}

void ContactSolve::fill_ties(uint32_t index) noexcept {
  IslandWorkspace& island = island_[index];
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    TieWorkspace& k = tie_workspace_[i];
    if (!k.active || island_of_[first_block(k)] != index) continue;
    if (place_.moves(k.a.block)) add_block(island, k.a.block);
    if (place_.moves(k.b.block)) add_block(island, k.b.block);
    k.constraint = island.first_constraint + island.constraints++;
    Constraint& constraint = constraint_[k.constraint];
    constraint.contact = i;
    constraint.tie = &tie_[i].law;
    constraint.limit = 0;
    island.tied = true;
    linearise(tie_[i], k, constraint);
  }
}

void ContactSolve::refresh_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    TieWorkspace& k = tie_workspace_[i];
    IslandWorkspace* const moved[2] = {moving_island(k.a), moving_island(k.b)};
    if (!moved[0] && !moved[1]) continue;
    Constraint& constraint = constraint_[k.constraint];
    const double relaxation = island_[island_of_[first_block(k)]].relaxation;
    const Vec3 said(constraint.at.g + relaxation * constraint.last_step.g,
                    constraint.at.s1 + relaxation * constraint.last_step.s1,
                    constraint.at.s2 + relaxation * constraint.last_step.s2);
    linearise(tie_[i], k, constraint);
    const TieLaw& law = tie_[i].law;
    const double off = (Vec3(constraint.at.g, constraint.at.s1, constraint.at.s2) - said).norm() *
                       std::min(1.0, std::max(law.k_across, law.k_along) / kContactStiffness);
    for (IslandWorkspace* island : moved)
      if (island) island->geometry_error = std::max(island->geometry_error, off);
  }
}

/// How far a side's material point is from where it was predicted to be, or from where its shape is [m].
Vec3 ContactSolve::moved(const Side& side, const Vec3& p_own, const Vec3& p_W) const noexcept {
  if (side.body == kNone) return Vec3::Zero();
  if (side.point != kNone) return off_shape(side, p_W);
  return place_.frame(side) * p_own - p_W;
}

/// The tie at the present poses. Its axis turns with a; what it is stretched across the axis stands in the world.
void ContactSolve::linearise(const Tie& tie, TieWorkspace& k, Constraint& constraint) noexcept {
  constraint.n = k.a.body != kNone ? Vec3(place_.frame(k.a).R * k.axis_A) : k.axis_A;
  axes_across(constraint.n, constraint.t1, constraint.t2);
  const Vec3 a = moved(k.a, k.p_A, tie.p_W), b = moved(k.b, k.p_B, tie.p_W);
  const double along = tie.axis_W.dot(tie.offset_W);
  const Vec3 s = tie.offset_W - along * tie.axis_W + a - b;
  k.p_W = tie.p_W + (place_.moves(k.a.block) ? a - s : b);
  constraint.at = {along + constraint.n.dot(s), constraint.t1.dot(s), constraint.t2.dot(s)};
}

/// What was put elsewhere than its constraints said.
void ContactSolve::linearise_ties(const IslandWorkspace& island) noexcept {
  for (uint32_t r = island.first_constraint; r < island.first_constraint + island.constraints; ++r)
    if (constraint_[r].tie != nullptr)
      linearise(tie_[constraint_[r].contact], tie_workspace_[constraint_[r].contact], constraint_[r]);
}

void ContactSolve::write_ties() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    TieWorkspace& k = tie_workspace_[i];
    Tie& tie = tie_[i];
    Constraint fixed;
    if (!k.active) {  // nothing of it can be moved: its force follows from where it is
      linearise(tie, k, fixed);
      fixed.f = tie_force(tie.law, fixed.at);
      tie.f_a_W = fixed.f.fn * fixed.n + fixed.f.f1 * fixed.t1 + fixed.f.f2 * fixed.t2;
    }
    const Constraint& constraint = k.active ? constraint_[k.constraint] : fixed;
    const Displacement slid = tie_plastic_slip(tie.law, constraint.at, tie_force(tie.law, constraint.at));
    tie.axis_W = constraint.n;
    tie.plastic_slip_W = slid.g * constraint.n + slid.s1 * constraint.t1 + slid.s2 * constraint.t2;
  }
}

void ContactSolve::mark_held_by_ties(Motion& motion) noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i)
    if (!tie_[i].f_a_W.isZero(0)) hold(motion, tie_workspace_[i].a), hold(motion, tie_workspace_[i].b);
}

void ContactSolve::hold(Motion& motion, const Side& side) const noexcept {
  if (side.block == kNone) return;
  const DofBlock& m = place_.block(side.block);
  if (m.kind == DofBlock::Kind::kRigid) motion.held_body[m.index] = 1;
  if (m.kind == DofBlock::Kind::kHinge) motion.held_hinge[m.index] = 1;
  if (m.kind == DofBlock::Kind::kParticle) motion.held_particle[m.index] = 1;
}

}  // namespace swage::dynamics
