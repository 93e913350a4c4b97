// SPDX-License-Identifier: Apache-2.0
#include "dynamics/island.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/constraint_law.hpp"
#include "dynamics/contact_space.hpp"
#include "dynamics/displacement_space.hpp"
#include "dynamics/sparse_space.hpp"

namespace swage::dynamics {
namespace {

constexpr uint32_t kNewtonSteps = 8;  // of Coulomb's Newton before the convex path is taken
constexpr uint32_t kHalvings = 3;     // of one of these steps
constexpr uint32_t kBandedHalvings = 0;  // the same with threads: their path costs less than shorter steps
constexpr uint32_t kTiedSteps = 20,
                   kTiedHalvings = 6;  // the same with ties, with which det H does not change its sign
constexpr double kDecrease = 1e-3;     // fraction of the predicted decrease that a step must bring
constexpr double kFlat = 0.1;          // slope that ends a line search, of the slope at its start
constexpr uint32_t kSearch = 30;       // evaluations of one line search
constexpr uint32_t kConvexSteps = 12;  // Newton steps of one convex problem
constexpr uint32_t kTrescaRounds = 3;  // convex problems, each with the limits that the one before gave
constexpr uint32_t kProjections = 44;  // steps of the projection, normal: 8 to 15
// Steps of the projection where the path goes on from its end: in tight knots of 60 contacts by 3 to 8 directions. Also after Newton's method on
// a thread's forces, which mostly gives up nanometres from the solution: 11 directions at p99.9 over a tray, 38 without. With 20 a thread sank in.
constexpr uint32_t kProjectionsBeforePath = 10;
// Contacts of thread with thread from which on the projection comes first. A square knot drawn tight with 30 mN has 50 that bear, a surgeon's with
// 100 mN as many: 8 and 10 directions a step, 15 and 18 if from 40 on, 38 and 56 by Newton's method. Fewer: a crossing or two, whose path ends near.
constexpr uint32_t kWound = 25;
constexpr double kNeverSlips = 1e300;  // N
constexpr double kHere = 1e-4;         // in tolerances: a step as short as this is due to rounding

bool has_ties(const Island& island) {
  return std::any_of(island.constraints.begin(), island.constraints.end(),
                     [](const Constraint& constraint) { return constraint.tie; });
}

/// Whether a constraint overlaps or bore force at the start of the step.
bool touches(const Constraint& c) { return c.tie || c.at.g < 0 || c.before.fn > 0; }

/// Whether threads are wound about themselves or each other.
bool wound(const Island& island) {
  const auto on_band = [&](uint32_t block) {
    return block != UINT32_MAX && island.blocks[block]->kind == DofBlock::Kind::kBanded;
  };
  uint32_t n = 0;
  for (const Constraint& c : island.constraints) n += touches(c) && on_band(c.block_a) && on_band(c.block_b);
  return n > kWound;
}

}  // namespace

IslandSolver::IslandSolver(uint32_t max_unknowns, uint32_t max_constraints, uint32_t max_hinges,
                           const SparseRoom& bands)
    : displacement_space_(std::make_unique<DisplacementSpace>(max_unknowns)),
      contact_space_(
          std::make_unique<ContactSpace>(max_constraints, max_hinges, BandedBody::kUnknowns * bands.vertices)),
      d_(max_unknowns + size_t{BandedBody::kUnknowns} * bands.vertices) {
  if (bands.vertices > 0) sparse_space_ = std::make_unique<SparseSpace>(max_unknowns, bands);
  const size_t numbers = std::max<size_t>(d_.size(), 2 * (3 * size_t{max_constraints} + max_hinges));
  for (std::vector<double>* z : {&z_, &trial_, &step_, &before_, &first_}) z->resize(numbers);
}

IslandSolver::~IslandSolver() = default;

void IslandSolver::begin_step(uint64_t budget) noexcept {
  budget_ = budget;
  displacement_space_->work = contact_space_->work = 0;
  if (sparse_space_) sparse_space_->work = 0;
}

uint64_t IslandSolver::work() const noexcept { 
  return displacement_space_->work + contact_space_->work + (sparse_space_ ? sparse_space_->work : 0);
}

/// Sets z to the pose of the linearisation.
void IslandSolver::start() noexcept { consistent_ = space_->start(z_.data()); }

/// Computes the forces of all constraints and the residual at z.
void IslandSolver::evaluate(const Island& island, const double* z, Friction friction) noexcept {
  space_->displace(z);
  for (Constraint& c : island.constraints) c.f = constraint_force(c, c.u, friction, c.limit);
  space_->residual(z);
}

/// Newton step from the point last evaluated.
bool IslandSolver::search_direction(const Island& island, Friction friction) noexcept {
  const bool same = same_stiffness(island, friction) && law_;
  law_ = space_->search_direction(z_.data(), same, step_.data());
  newton_ += law_;
  return law_;
}

/// Updates the tangents of all constraints. True when none changed.
bool IslandSolver::same_stiffness(const Island& island, Friction friction) noexcept {
  bool same = true;
  const auto keep = [&same](double& kept, double now) {
    same = same && kept == now;
    kept = now;
  };
  for (Constraint& constraint : island.constraints) {
    const Tangent D = constraint_tangent(constraint, constraint.u, constraint.f, friction, constraint.limit);
    const double now[] = {D.nn, D.n1, D.n2, D.t11, D.t12, D.t22};
    double* const kept[] = {&constraint.D.nn,  &constraint.D.n1,  &constraint.D.n2,
                            &constraint.D.t11, &constraint.D.t12, &constraint.D.t22};
    for (int i = 0; i < 6; ++i) keep(*kept[i], now[i]);
  }
  return same;
}

/// Takes a whole step from the start, where the space needs that for a consistent point.
bool IslandSolver::make_consistent(const Island& island, Friction friction) noexcept {
  if (consistent_) return true;
  const bool where_it_was = island.banded && friction == Friction::kCoulomb;
  if (where_it_was && has_first_) {
    std::copy_n(first_.begin(), point_size_, z_.begin());
    return consistent_ = true;
  }
  if (where_it_was) {
    if (!begin_where_it_was(island)) return false;
  } else {
    evaluate(island, z_.data(), friction);
    if (!search_direction(island, friction)) return false;
  }
  advance(1);
  z_.swap(trial_);
  if (where_it_was) {
    std::copy_n(z_.begin(), point_size_, first_.begin());
    has_first_ = true;
  }
  return consistent_ = true;
}

/// Newton step with every constraint on its piece of the last step or pass. A thread that has advanced freely has opened or overlapped most
/// of its contacts, and the law there would give pieces that do not apply. Contacts that bore no force begin with the law at the start.
bool IslandSolver::begin_where_it_was(const Island& island) noexcept {
  space_->displace(z_.data());
  for (Constraint& c : island.constraints) {
    if (c.tie) {
      c.on.tie = tie_pieces_before(*c.tie, c.before);
      c.f = force_on(c, c.u), c.D = tangent_on(c, c.u);
    } else if (c.before.fn > 0) {
      const LinearLaw law = law_before(c.surface, c.before, c.u);
      c.f = law.f, c.D = law.D;
    } else {
      c.f = constraint_force(c, c.u, Friction::kCoulomb, c.limit);
      c.D = constraint_tangent(c, c.u, c.f, Friction::kCoulomb, c.limit);
    }
  }
  space_->residual(z_.data());
  law_ = space_->search_direction(z_.data(), false, step_.data());
  newton_ += law_;
  return law_;
}

void IslandSolver::advance(double fraction) noexcept {
  for (size_t i = 0; i < point_size_; ++i) trial_[i] = z_[i] + fraction * step_[i];
}

/// Merit below which a correction H^-1 F is negligible: where nothing slips H is above A, so a correction dx of the lightest
/// block's centre has m dx^2 / h^2 <= F' A^-1 F. dx is a hundredth of the tolerance, because points far from the centre move more. Where
/// every contact stays on one piece, the first step ends there and need not be confirmed by a second. Islands that slip, have ties or
/// flexible bodies iterate until the correction itself is small.
double IslandSolver::negligible_merit(const Island& island, double tolerance) const noexcept {
  double lightest = HUGE_VAL;
  for (const DofBlock* block : island.blocks) {
    if (block->kind == DofBlock::Kind::kFlexible || block->kind == DofBlock::Kind::kBanded) return 0;
    if (block->kind != DofBlock::Kind::kHinge) lightest = std::min(lightest, block->m_hh);
  }
  const double dx = 0.01 * tolerance;
  return lightest < HUGE_VAL ? lightest * dx * dx : 0;
}

bool IslandSolver::sticks(const Island& island) const noexcept {
  for (const Constraint& constraint : island.constraints)
    if (constraint.tie || constraint.f.slips) return false;
  return true;
}

/// Semi-smooth Newton on F with a line search on the merit F' A^-1 F, for which its direction descends. Gives up soon:
/// where it does not converge in a few steps, the convex path does better.
bool IslandSolver::newton(const Island& island, double tolerance) noexcept {
  const bool tied = has_ties(island) && !island.banded;
  const uint32_t steps = tied ? kTiedSteps : kNewtonSteps;
  const uint32_t halvings = island.banded ? kBandedHalvings : tied ? kTiedHalvings : kHalvings;
  if (!make_consistent(island, Friction::kCoulomb)) return false;
  evaluate(island, z_.data(), Friction::kCoulomb);
  double now = -1;  // not known yet
  const double nothing = negligible_merit(island, tolerance);
  for (uint32_t i = 0; i < steps; ++i) {
    if ((i > 0 && over_budget()) || !search_direction(island, Friction::kCoulomb)) return false;
    const double far = space_->length(step_.data());
    if (!std::isfinite(far)) return false;
    // every constraint is on the piece for which the last step was computed: that step ended at the solution
    if (island.contact_space && far <= kHere * tolerance) return true;
    if (far > tolerance && now < 0) now = space_->merit();

    double fraction = 1, next = 0;
    for (uint32_t k = 0;; ++k, fraction *= 0.5) {
      advance(fraction);
      evaluate(island, trial_.data(), Friction::kCoulomb);
      // close enough: this correction is the last
      if (far <= tolerance) break;
      next = space_->merit();
      if (next <= (1 - 2 * kDecrease * fraction) * now) break;
      if (k == halvings) return false;
    }
    z_.swap(trial_);
    if (far <= tolerance || (next <= nothing && sticks(island))) return true;
    now = next;
  }
  return false;
}

/// Slope of the energy along the step, at a fraction of it from d: rises monotonically, because the energy is convex.
double IslandSolver::slope(const Island& island, double fraction) noexcept {
  advance(fraction);
  double sum = space_->slope(trial_.data(), step_.data());
  for (const Constraint& constraint : island.constraints) {
    const Displacement& w = constraint.along;
    const Displacement u{constraint.u.g + fraction * w.g, constraint.u.s1 + fraction * w.s1,
                         constraint.u.s2 + fraction * w.s2};
    double limit = constraint.limit;
    const Force f = constraint_force(constraint, u, Friction::kTresca, limit);
    sum -= f.fn * w.g + f.f1 * w.s1 + f.f2 * w.s2;
  }
  return sum;
}

/// Fraction of the step at which the energy is nearly least: the slope there is at most a tenth of that at the start. Regula
/// falsi on the slope, which is piecewise smooth with steep kinks where a contact begins to slip.
double IslandSolver::search(const Island& island) noexcept {
  space_->set_search_direction(step_.data());
  const double start = slope(island, 0), good = kFlat * std::abs(start);
  double low = 0, high = 1, at_low = start, at_high = slope(island, 1);
  if (at_high <= good) return 1;  // the energy still falls at the end of the step, or nearly so
  for (uint32_t k = 0; k < kSearch; ++k) {
    // every third time the middle, so that the bracket surely shrinks
    double fraction = low - at_low * (high - low) / (at_high - at_low);
    if (k % 3 == 2 || !(fraction > low && fraction < high)) fraction = 0.5 * (low + high);
    const double at = slope(island, fraction);
    if (std::abs(at) <= good) return fraction;
    if (at < 0) {
      low = fraction, at_low = at;
    } else {
      high = fraction, at_high = at;
    }
  }
  return low;
}

/// Least energy with the friction limits held: convex, so Newton with a line search finds it from anywhere.
bool IslandSolver::minimise(const Island& island, double tolerance) noexcept {
  if (!make_consistent(island, Friction::kTresca)) return false;
  evaluate(island, z_.data(), Friction::kTresca);
  uint32_t still = 0;
  for (uint32_t i = 0; i < kConvexSteps; ++i) {
    if ((i > 0 && over_budget()) || !search_direction(island, Friction::kTresca)) return false;
    const double far = space_->length(step_.data());
    if (!std::isfinite(far)) return false;
    if (far <= tolerance) {
      advance(1);
      z_.swap(trial_);
      evaluate(island, z_.data(), Friction::kTresca);
      return true;
    }
    // one short part of a long step may only have met a kink; two in a row end the search
    const double fraction = search(island);
    advance(fraction);
    z_.swap(trial_);
    evaluate(island, z_.data(), Friction::kTresca);
    still = fraction * far <= tolerance ? still + 1 : 0;
    if (still == 2) return true;
  }
  return false;
}

Outcome IslandSolver::solve(const Island& island, const Scales& scales, Limits limits) noexcept {
  const double tolerance = scales.converged;
  space_ = island.contact_space ? contact_space_.get() : island.banded ? sparse_space_.get() : displacement_space_.get();
  size_ = island.size;
  point_size_ = space_->begin(island);
  touching_ = static_cast<uint32_t>(std::count_if(island.constraints.begin(), island.constraints.end(), touches));
  newton_ = 0;
  law_ = has_first_ = false;
  start();
  Outcome outcome;
  if (limits == Limits::kHeld) {
    outcome.rounds = 1;
    outcome.fell_back = true;
    outcome.converged = minimise(island, tolerance);
    outcome.limits_hold = limits_hold(island);
  } else {
    outcome.converged = begins_with_projection(island) ? project_first(island, tolerance, outcome) : newton(island, tolerance);
    if (!outcome.converged && island.contact_space && island.banded) {
      const bool many = touching_ > kMostBends;
      if (many) start();
      outcome.fell_back = true;
      outcome.converged = project(island, tolerance, many ? kProjections : kProjectionsBeforePath);
    }
    if (!outcome.converged) fall_back(island, scales, outcome);
  }
  outcome.newton = newton_;
  outcome.moved = space_->moved(z_.data());
  space_->finish(z_.data(), d_.data());
  return outcome;
}

/// Threads with many contacts: Newton's method seldom converges there, and a path from the start is long. With few contacts a path ends at a
/// near solution; the projection may end where an edge has turned once about itself.
bool IslandSolver::begins_with_projection(const Island& island) const noexcept {
  return island.banded && !island.contact_space && (touching_ > kMostBends || (touching_ > kWound && wound(island)));
}

/// The projection finds the pieces of most contacts in a few steps, or takes turns between those of one or two. From there the path is short.
bool IslandSolver::project_first(const Island& island, double tolerance, Outcome& outcome) noexcept {
  const bool long_path = touching_ > kMostBends;
  if (project(island, tolerance, long_path ? kProjections : kProjectionsBeforePath)) return true;
  if (!long_path) {
    outcome.fell_back = true;
    if (follow_path(island, tolerance)) {
      evaluate(island, z_.data(), Friction::kCoulomb);
      return true;
    }
  }
  start();
  return newton(island, tolerance);
}

/// Follows the path from the start, then from the solution without slip, from where a contact that must slip slips the right way. Where
/// neither converges, or ends far away, limits are held. Far: a light body that slides out of a wedge loses friction and leaves within
/// the step; with held limits it slides only as far as its loads exceed these. A thread goes far, through the contacts that hold it.
void IslandSolver::fall_back(const Island& island, const Scales& scales, Outcome& outcome) noexcept {
  const double tolerance = scales.converged;
  outcome.fell_back = true;
  if (over_budget()) {
    evaluate(island, z_.data(), Friction::kCoulomb);
    outcome.held = true;
    hold_limits(island, tolerance, 1, outcome);
    return;
  }
  // a needle in tissue: a path may end far from where nothing slips, Newton's method ends near; the path is tried last
  const bool tied = has_ties(island) && !island.banded, long_path = island.banded && touching_ > kMostBends;
  bool stood = false;
  start();
  outcome.converged = !tied && !long_path && follow_path(island, tolerance);
  const bool far = outcome.converged && !island.banded && space_->moved(z_.data()) > scales.lost;
  if (!outcome.converged || far) {
    start();
    stick_all(island, tolerance);
    std::copy_n(z_.begin(), point_size_, before_.begin());
    stood = consistent_;
    outcome.converged = !far && (tied ? newton(island, tolerance) : !long_path && follow_path(island, tolerance));
    if (tied && !outcome.converged) outcome.converged = follow_path_near(island, scales, stood);
  }
  if (outcome.converged) {
    evaluate(island, z_.data(), Friction::kCoulomb);
    return;
  }
  std::copy_n(before_.begin(), point_size_, z_.begin());
  consistent_ = stood;
  evaluate(island, z_.data(), Friction::kCoulomb);
  outcome.held = true;
  outcome.converged = hold_limits(island, tolerance, far ? 1 : kTrescaRounds, outcome);
  outcome.limits_hold = limits_hold(island);
}

/// Least energy where nothing slips.
void IslandSolver::stick_all(const Island& island, double tolerance) noexcept {
  evaluate(island, z_.data(), Friction::kCoulomb);
  for (Constraint& constraint : island.constraints) constraint.limit = constraint.limit > 0 ? kNeverSlips : 0;
  minimise(island, tolerance);
}

/// Limits from the normal forces, least energy, new limits ... a few times.
bool IslandSolver::hold_limits(const Island& island, double tolerance, uint32_t rounds,
                               Outcome& outcome) noexcept {
  while (true) {
    ++outcome.rounds;
    const bool least = minimise(island, tolerance);
    if (outcome.rounds == rounds || !least || limits_hold(island)) return least;
    for (Constraint& constraint : island.constraints)
      if (!constraint.tie) constraint.limit = constraint.surface.mu * constraint.f.fn;
  }
}

/// Every friction limit is mu f_n to one in a thousand of the largest.
bool IslandSolver::limits_hold(const Island& island) const noexcept {
  double largest = 0, off = 0;
  for (const Constraint& constraint : island.constraints) {
    if (constraint.tie) continue;  // its limits are constants
    largest = std::max(largest, constraint.limit);
    off = std::max(off, std::abs(constraint.limit - constraint.surface.mu * constraint.f.fn));
  }
  return off <= 1e-3 * largest;
}

}  // namespace swage::dynamics
