// SPDX-License-Identifier: Apache-2.0
//
// Newton's method on the law as a projection (law_projected(), contact_law.hpp), with the forces of the contacts as unknowns beside the
// displacements. Islands of threads that are wound about each other have hundreds of contacts, which alternate between stick and slip over
// cones of a tenth of a nanometre: Newton's method on the law itself jumps from one side of the cone to the other, and its path meets
// these bends one by one. Here all contacts find their pieces at once, as in the primal-dual active set method of Hueber, Stadler
// and Wohlmuth (SIAM J. Sci. Comput. 30 (2008) 572).
#include <algorithm>
#include <cmath>

#include "dynamics/constraint_law.hpp"
#include "dynamics/island.hpp"
#include "dynamics/space.hpp"

namespace swage::dynamics {
namespace {

constexpr uint32_t kWholeSteps = 8;   // after these, steps that get no shorter are shortened: the iteration may be a cycle
constexpr double kShortened = 0.6;    // share taken of such a step
constexpr double kShorter = 0.5;      // of the step before: a step below this counts as shorter
// r over the tangential stiffness. Tight knots of 60 contacts take 20 % fewer steps with the first. Braids of 100 to 300 do not always converge
// with 0.02 or more, and less with 0.0001
constexpr double kScale = 0.05, kScaleOfMany = 0.01;
constexpr double kNear = 1;           // in tolerances: step after which the factors are kept
constexpr double kEnds = 1e-4;        // in tolerances: the last step; a cone is less than one tolerance
constexpr uint32_t kSettles = 3;      // most steps with those factors

Force linear_force(const Constraint& c) noexcept {
  const Tangent& D = c.D;
  const Displacement& w = c.along;
  return {c.f.fn - D.nn * w.g, c.f.f1 - D.n1 * w.g - D.t11 * w.s1 - D.t12 * w.s2,
          c.f.f2 - D.n2 * w.g - D.t12 * w.s1 - D.t22 * w.s2, false};
}

}  // namespace

/// Computes forces and tangents of the projection at z, and the search direction from there.
bool IslandSolver::search_direction_of_projection(const Island& island) noexcept {
  const double scale = touching_ > kMostBends ? kScaleOfMany : kScale;
  space_->displace(z_.data());
  for (Constraint& c : island.constraints) {
    const LinearLaw law = c.tie ? LinearLaw{tie_force(*c.tie, c.u), tie_tangent(*c.tie, c.u)}
                                : law_projected(c.surface, c.projected, c.u, scale * c.surface.kt);
    c.f = law.f, c.D = law.D;
  }
  space_->residual(z_.data());
  law_ = false;
  const bool there = !over_budget() && space_->search_direction(z_.data(), false, step_.data());
  newton_ += there;
  return there;
}

/// At most so many steps from the forces of the last step or pass. True when it converged to a point at which the law holds.
bool IslandSolver::project(const Island& island, double tolerance, uint32_t steps) noexcept {
  for (Constraint& c : island.constraints) c.projected = c.before.fn > 0 ? c.before : Force{};
  double last = HUGE_VAL;
  for (uint32_t i = 0; i < steps; ++i) {
    if (!search_direction_of_projection(island)) return false;
    const double far = space_->length(step_.data());
    if (!std::isfinite(far)) return false;
    const double fraction = i >= kWholeSteps && far > kShorter * last ? kShortened : 1;
    space_->set_search_direction(step_.data());
    for (Constraint& c : island.constraints) {
      const Force to = linear_force(c), from = c.projected;
      c.projected = {from.fn + fraction * (to.fn - from.fn), from.f1 + fraction * (to.f1 - from.f1),
                     from.f2 + fraction * (to.f2 - from.f2), false};
    }
    advance(fraction);
    z_.swap(trial_);
    consistent_ = true;
    last = fraction * far;
    if (far <= kNear * tolerance && settle(island, tolerance)) return true;
  }
  return false;
}

/// Corrects z to a point at which the law itself holds, with the present factors.
bool IslandSolver::settle(const Island& island, double tolerance) noexcept {
  for (uint32_t i = 0; i < kSettles; ++i) {
    evaluate(island, z_.data(), Friction::kCoulomb);
    if (!space_->search_direction(z_.data(), true, step_.data())) return false;
    const double far = space_->length(step_.data());
    if (!(far <= kNear * tolerance)) return false;
    advance(1);
    z_.swap(trial_);
    if (far <= kEnds * tolerance) {
      evaluate(island, z_.data(), Friction::kCoulomb);
      return true;
    }
  }
  return false;
}

}  // namespace swage::dynamics
