// SPDX-License-Identifier: Apache-2.0
#include "dynamics/refinement.hpp"

#include <algorithm>

#include "dynamics/rotation.hpp"

namespace swage::dynamics {

using toolkit::raw;
using toolkit::vec;

namespace {
/// Parts of a step: 0.016 ms for 1 ms. Fewer: a wire of 50 um under three times the limit swings 0.2 rad too far in 32. More: cost.
constexpr int kParts = 64;
}  // namespace

Refinement::Refinement(const scene::World& world)
    : held_body_(world.body.size()),
      held_hinge_(world.hinge.size()),
      X_end_(world.body.size()),
      everything_(world.body.size(), 1) {
  memory_.reserve(world.capacity.contacts);
}

bool Refinement::keep(const Motion& motion, const contact::ContactSet& contacts,
                      const base::SolverHealth& health) noexcept {
  if (contacts.contact.size() > memory_.capacity()) return false;
  memory_.clear();
  for (const contact::Contact& c : contacts.contact) memory_.push_back({c.bristle_W, c.f_a_W});
  std::copy(motion.held_body.begin(), motion.held_body.end(), held_body_.begin());
  std::copy(motion.held_hinge.begin(), motion.held_hinge.end(), held_hinge_.begin());
  health_ = health;
  return true;
}

void Refinement::run(scene::World& world, Motion& motion, contact::ContactSet& contacts, contact::Detector& detector,
                     ContactSolve& solve, const Options& options, Stats& stats) noexcept {
  const double h = world.dt;
  const base::SolverHealth whole = stats.health;
  const uint64_t work = stats.work;
  std::copy(world.X_WB.begin(), world.X_WB.end(), X_end_.begin());
  go_back(world, motion, contacts);
  for (int left = kParts; left > 0;) {
    // beyond the budget the rest is one part
    const int parts = stats.work - work > options.budget ? left : 1;
    left -= parts;
    world.dt = h * parts / kParts;
    follow(world, h * left / kParts);
    motion.predict(world, options.free_motion);
    detector.look_again(world, contacts, everything_, {});
    if (contacts.contact.empty())
      motion.go_free(world);
    else
      solve.solve(world, motion, contacts, {}, {}, stats);
  }
  world.dt = h;
  count(stats, whole);
}

/// Moves everything that the solve moves back to the start of the step.
void Refinement::go_back(scene::World& world, Motion& motion, contact::ContactSet& contacts) const noexcept {
  for (size_t i = 0; i < memory_.size(); ++i)
    contacts.contact[i].bristle_W = memory_[i].bristle_W, contacts.contact[i].f_a_W = memory_[i].f_a_W;
  motion.held_body = held_body_, motion.held_hinge = held_hinge_;
  for (uint32_t b = 0; b < world.body.size(); ++b) {
    if (world.body[b].motion != SWAGE_MOTION_DYNAMIC) continue;
    world.X_WB[b] = motion.X0[b].abi();
    world.V_WB[b] = {raw(motion.v0[b]), raw(motion.w0[b])};
  }
  for (uint32_t i = 0; i < world.hinge.size(); ++i) {
    world.X_WB[world.hinge[i].child] = motion.X0[world.hinge[i].child].abi();
    world.hinge_angle[i] = motion.q0[i], world.hinge_rate[i] = motion.rate0[i];
  }
}

/// Moves kinematic bodies to where they are `rest` [s] before the end of the step.
void Refinement::follow(scene::World& world, double rest) const noexcept {
  for (uint32_t b = 0; b < world.body.size(); ++b) {
    const int32_t kind = world.body[b].motion;
    if (kind == SWAGE_MOTION_DYNAMIC || kind == SWAGE_MOTION_HINGED) continue;
    const Pose X(X_end_[b]);
    const Vec3 v = vec(world.V_WB[b].v), w = vec(world.V_WB[b].w);
    world.X_WB[b] = rest > 0 ? Pose(X.p - rest * v, turn(-rest * w) * X.q).abi() : X_end_[b];
  }
}

/// Counts at most one step as short, however many parts fell short; lack of room is counted as of the whole step.
void Refinement::count(Stats& stats, const base::SolverHealth& whole) const noexcept {
  const base::SolverHealth parts = stats.health;
  stats.health = whole;
  stats.health.not_converged = health_.not_converged + (parts.not_converged > whole.not_converged);
  stats.health.over_budget = std::min(parts.over_budget, health_.over_budget + 1);
  stats.health.steps = health_.steps + (stats.health.total() > health_.total());
}

}  // namespace swage::dynamics
