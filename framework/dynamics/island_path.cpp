// SPDX-License-Identifier: Apache-2.0
//
// Newton's path through the pieces of Coulomb's law. On one piece of every contact F is smooth, almost linear, and its Newton
// direction leads straight down: F(d + t step) = (1 - t) F(d). Where a contact reaches the end of its piece the path bends into
// the next (Katzenelson, Bell Syst. Tech. J. 44 (1965) 1605). Friction can change the sign of det H from one piece to
// the next; |F| then rises along the path for a while, until the sign changes again. Steps across the bends, as a line search
// takes them, alternate between the pieces instead. Where the path ends every constraint must be on the piece that it was
// taken to be on; otherwise the path continues from there.
#include <algorithm>
#include <cmath>

#include "dynamics/constraint_law.hpp"
#include "dynamics/island.hpp"
#include "dynamics/space.hpp"

namespace swage::dynamics {
namespace {

constexpr uint32_t kPathSteps = 48;  // normal: one per contact that changes, so 5 to 20
constexpr uint32_t kBandedPathSteps = 150;  // the same for threads, which slide at all of their 10 to 100 contacts
constexpr uint32_t kTurningSteps = 40;  // first steps in which a slip that reverses sticks. More: stick and slip may alternate for ever
constexpr uint32_t kTurnHalvings = 6;    // of a step within one piece, where the direction of slip changes
constexpr double kPassed = 1e-9;     // of a step: a contact does not come back to the kink it has just passed

}  // namespace

/// Forces of the pieces and the residual at z.
void IslandSolver::evaluate_pieces(const Island& island, const double* z) noexcept {
  space_->displace(z);
  for (Constraint& constraint : island.constraints) constraint.f = force_on(constraint, constraint.u);
  space_->residual(z);
}

/// Newton's direction on the present pieces. find_bend() reverses it where det H < 0.
bool IslandSolver::search_direction_on_pieces(const Island& island) noexcept {
  for (Constraint& constraint : island.constraints) constraint.D = tangent_on(constraint, constraint.u);
  law_ = false;
  const bool there = space_->search_direction(z_.data(), false, step_.data());
  newton_ += there;
  return there;
}

/// The same where one constraint has come to another piece, with the tangents of all others as they were when the system was factored.
bool IslandSolver::correct_direction_on_pieces(const Island& island, uint32_t changed) noexcept {
  const Constraint& c = island.constraints[changed];
  const bool there = space_->corrected_direction(z_.data(), changed, tangent_on(c, c.u), step_.data());
  newton_ += there;
  return there;
}

/// The constraint that first comes to the end of its piece, before `fraction` of the step; `passed`: the constraint that just did.
/// `turns`: a contact whose slip reverses is taken to stick.
uint32_t IslandSolver::first_kink(const Island& island, uint32_t passed, bool turns, double& fraction,
                                  Pieces& next) const noexcept {
  uint32_t hit = UINT32_MAX;
  for (uint32_t i = 0; i < island.constraints.size(); ++i) {
    const Constraint& constraint = island.constraints[i];
    Pieces then;
    double t = kink(constraint, constraint.u, constraint.along, then);
    if (turns && !constraint.tie && constraint.on.contact == Piece::kSlip) {
      const double back = turns_back(constraint.u, constraint.along);
      if (back < t) t = back, then.contact = Piece::kStick;
    }
    if (!(t < fraction) || (i == passed && t < kPassed)) continue;
    hit = i, fraction = t, next = then;
  }
  return hit;
}

/// Length and sign of the direction, and the bend that comes first along it. `bend` [in]: that which was passed last.
bool IslandSolver::find_bend(const Island& island, Bend& bend, bool may_turn) noexcept {
  bend.down = space_->sign() > 0;
  if (!bend.down)
    for (size_t k = 0; k < point_size_; ++k) step_[k] = -step_[k];
  bend.far = space_->length(step_.data());
  if (!std::isfinite(bend.far)) return false;
  bend.fraction = bend.down ? 1 : HUGE_VAL;
  space_->set_search_direction(step_.data());
  bend.constraint = first_kink(island, bend.constraint, bend.down && may_turn, bend.fraction, bend.next);
  return true;
}

/// The direction from z and the next bend along it. After a bend the last factors are corrected for it, which is enough to find the next one; where the
/// path ends, or may end, they are computed anew.
bool IslandSolver::look_ahead(const Island& island, Bend& bend, bool may_turn) noexcept {
  const uint32_t passed = bend.constraint;
  if (passed != UINT32_MAX && correct_direction_on_pieces(island, passed) && find_bend(island, bend, may_turn) &&
      bend.constraint != UINT32_MAX)
    return true;
  bend.constraint = passed;
  return search_direction_on_pieces(island) && find_bend(island, bend, may_turn);
}

/// Newton step to where F would vanish, halved while |F| does not fall. True when the whole step was taken. `merit`: that of z; negative: not known.
bool IslandSolver::whole_step(const Island& island, double far, double tolerance, double& merit) noexcept {
  const bool last = far <= tolerance;
  const double now = last ? 0 : merit < 0 ? space_->merit() : merit;
  double fraction = 1;
  for (uint32_t k = 0;; ++k, fraction *= 0.5) {
    advance(fraction);
    evaluate_pieces(island, trial_.data());
    if (last) break;
    merit = space_->merit();
    if (k == kTurnHalvings || merit <= now) break;
  }
  z_.swap(trial_);
  return fraction == 1;
}

/// Puts every constraint on the piece on which it is at z. True when all were there already, within the tolerance: a constraint that
/// reached a kink and turned back may have been left on the piece beyond it.
bool IslandSolver::on_their_pieces(const Island& island, double tolerance) noexcept {
  bool were = true;
  for (Constraint& c : island.constraints) {
    double limit = 0;
    const Force law = constraint_force(c, c.u, Friction::kCoulomb, limit), f = force_on(c, c.u);
    const double off = std::abs(law.fn - f.fn) + std::abs(law.f1 - f.f1) + std::abs(law.f2 - f.f2);
    were = were && off <= tolerance * (c.tie ? std::max(c.tie->k_along, c.tie->k_across) : c.surface.k);
    c.on = pieces(c, c.u);
  }
  return were;
}

bool IslandSolver::follow_path(const Island& island, double tolerance) noexcept {
  if (!make_consistent(island, Friction::kCoulomb)) return false;
  space_->displace(z_.data());
  for (Constraint& constraint : island.constraints) constraint.on = pieces(constraint, constraint.u);
  evaluate_pieces(island, z_.data());
  const uint32_t steps = island.banded ? kBandedPathSteps : kPathSteps;
  Bend bend;
  double merit = -1;
  for (uint32_t i = 0; i < steps; ++i) {
    if (over_budget() || !look_ahead(island, bend, island.banded && i < kTurningSteps)) return false;
    if (bend.constraint != UINT32_MAX) {
      advance(bend.fraction);
      z_.swap(trial_);
      island.constraints[bend.constraint].on = bend.next;
      evaluate_pieces(island, z_.data());
      merit = -1;
    } else if (!bend.down) {
      return false;  // no kink ahead: the path does not return
    } else if (whole_step(island, bend.far, tolerance, merit) && bend.far <= tolerance) {
      if (on_their_pieces(island, tolerance)) return true;
      evaluate_pieces(island, z_.data());
      merit = -1;
    }
  }
  return false;
}

/// Follows the path from the solution without slip, before_. False also where it ends farther away than a body moves in a step.
bool IslandSolver::follow_path_near(const Island& island, const Scales& scales, bool consistent) noexcept {
  std::copy_n(before_.begin(), point_size_, z_.begin());
  consistent_ = consistent;
  return follow_path(island, scales.converged) && space_->moved(z_.data()) <= scales.lost;
}

}  // namespace swage::dynamics
