// SPDX-License-Identifier: Apache-2.0
#include "dynamics/tie_constraints.hpp"

#include <algorithm>
#include <cmath>

namespace swage::dynamics {

using scene::kNone;

namespace {
// N/m: stiffness to which the tolerance of the solve refers. A softer tie may be off by more for the same error of force.
constexpr double kContactStiffness = 1e6;
}  // namespace

/// Finds the sides of each tie and, on flexible bodies, the point that it pulls.
void TieConstraints::begin(std::span<Tie> ties) noexcept {
  p_.tie = ties.first(std::min(ties.size(), p_.tie_workspace.size()));
  p_.health.dropped_ties += ties.size() - p_.tie.size();
  for (Tie& tie : ties) tie.plastic_slip_W = Vec3::Zero();
  for (Tie& tie : ties.subspan(p_.tie.size())) tie.f_a_W = Vec3::Zero();
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    const Tie& tie = p_.tie[i];
    TieWorkspace& k = p_.tie_workspace[i];
    k = {};
    for (const bool is_a : {true, false}) {
      const uint32_t body = is_a ? tie.body_a : tie.body_b;
      Side& side = is_a ? k.a : k.b;
      if (body == kNone) continue;
      const Vec3 across = tie.offset_W - tie.axis_W.dot(tie.offset_W) * tie.axis_W;
      const Vec3 at =
          is_a ? tie.p_W : tie.p_W - across;  // b is pulled at its own point, which lies `across` from that of a
      side = p_.place.tied_side(body, at);
      if (!p_.place.is_flexible(side.block)) continue;
      side.point = p_.place.flexible().add_point(p_.place.block(side.block).index, body, kNone, at,
                                                 tie.axis_W, side.place);
      if (side.point != kNone) continue;
      ++p_.health.shared_points;
      side.shares = true;
      side.point = p_.place.flexible().nearest(p_.place.block(side.block).index, at);
    }
  }
}

/// Expects the points of ties on flexible bodies at their places in the poses that the bodies' solvers wrote.
void TieConstraints::predict() noexcept {
  for (uint32_t i = 0; i < p_.tie.size(); ++i)
    for (const Side* s : {&p_.tie_workspace[i].a, &p_.tie_workspace[i].b})
      if (s->point != kNone && !s->shares) p_.place.expect(*s, p_.tie[i].p_W);
}

/// Stores the material points of each tie in the frames of its bodies, once it is known which bodies can move.
void TieConstraints::start() noexcept {
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    TieWorkspace& k = p_.tie_workspace[i];
    k.active = p_.place.moves(k.a.block) || p_.place.moves(k.b.block);
    k.p_W = p_.tie[i].p_W;
    k.axis_A = p_.tie[i].axis_W;
    if (k.a.body != kNone) k.p_A = p_.place.frame(k.a).inverse_times(p_.tie[i].p_W);
    if (k.a.body != kNone) k.axis_A = p_.place.frame(k.a).R.transpose() * p_.tie[i].axis_W;
    if (k.b.body != kNone) k.p_B = p_.place.frame(k.b).inverse_times(p_.tie[i].p_W);
  }
}

void TieConstraints::refresh(ContactIslands& islands) noexcept {
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    TieWorkspace& k = p_.tie_workspace[i];
    IslandWorkspace* const moved[2] = {islands.moving(k.a), islands.moving(k.b)};
    if (!moved[0] && !moved[1]) continue;
    Constraint& constraint = p_.constraint[k.constraint];
    const double relaxation = islands.of(p_.first_block(k)).relaxation;
    const Vec3 said(constraint.at.g + relaxation * constraint.last_step.g,
                    constraint.at.s1 + relaxation * constraint.last_step.s1,
                    constraint.at.s2 + relaxation * constraint.last_step.s2);
    p_.linearise(p_.tie[i], k, constraint);
    const TieLaw& law = p_.tie[i].law;
    const double off = (Vec3(constraint.at.g, constraint.at.s1, constraint.at.s2) - said).norm() *
                       std::min(1.0, std::max(law.k_across, law.k_along) / kContactStiffness);
    for (IslandWorkspace* island : moved)
      if (island) island->geometry_error = std::max(island->geometry_error, off);
  }
}

/// Linearises the ties of an island at the present poses.
void TieConstraints::linearise(const IslandWorkspace& island) noexcept {
  for (uint32_t r = island.first_constraint; r < island.first_constraint + island.constraints; ++r)
    if (p_.constraint[r].tie != nullptr)
      p_.linearise(p_.tie[p_.constraint[r].contact], p_.tie_workspace[p_.constraint[r].contact],
                   p_.constraint[r]);
}

void TieConstraints::write() noexcept {
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    TieWorkspace& k = p_.tie_workspace[i];
    Tie& tie = p_.tie[i];
    Constraint fixed;
    if (!k.active) {  // neither side can be moved: the force follows from the present poses
      p_.linearise(tie, k, fixed);
      fixed.f = tie_force(tie.law, fixed.at);
      tie.f_a_W = fixed.f.fn * fixed.n + fixed.f.f1 * fixed.t1 + fixed.f.f2 * fixed.t2;
    }
    const Constraint& constraint = k.active ? p_.constraint[k.constraint] : fixed;
    const Displacement slid = tie_plastic_slip(tie.law, constraint.at, tie_force(tie.law, constraint.at));
    tie.axis_W = constraint.n;
    tie.plastic_slip_W = slid.g * constraint.n + slid.s1 * constraint.t1 + slid.s2 * constraint.t2;
  }
}

}  // namespace swage::dynamics
