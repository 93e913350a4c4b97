// SPDX-License-Identifier: Apache-2.0
#include "dynamics/island.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dense.hpp"

namespace swage::dynamics {
namespace {

constexpr uint32_t kNewtonSteps = 8;    // of Coulomb's Newton before the convex path is taken
constexpr uint32_t kHalvings = 3;       // of one of them
constexpr double kDecrease = 1e-3;      // fraction of the predicted decrease that a step must bring
constexpr double kFlat = 0.1;           // slope that ends a line search, of the slope at its start
constexpr uint32_t kSearch = 60;        // evaluations of one line search
constexpr uint32_t kConvexSteps = 12;   // Newton steps of one convex problem
constexpr uint32_t kTrescaRounds = 10;  // convex problems before an island is left at its best iterate
constexpr double kNeverSlips = 1e300;   // N

/// u + J d.
Displacement displaced(const Row& row, const double* d) {
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  const double *da = d + row.offset_a, *db = d + row.offset_b;
  Displacement u = row.at;
  for (uint32_t i = 0; i < row.size_a; ++i) {
    u.g += J0[i] * da[i];
    u.s1 += J1[i] * da[i];
    u.s2 += J2[i] * da[i];
  }
  for (uint32_t i = 0; i < row.size_b; ++i) {
    u.g += J0[row.size_a + i] * db[i];
    u.s1 += J1[row.size_a + i] * db[i];
    u.s2 += J2[row.size_a + i] * db[i];
  }
  return u;
}

/// F -= J' f.
void add_force(const Row& row, double* F) {
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  double *Fa = F + row.offset_a, *Fb = F + row.offset_b;
  for (uint32_t i = 0; i < row.size_a; ++i) Fa[i] -= J0[i] * row.f.fn + J1[i] * row.f.f1 + J2[i] * row.f.f2;
  for (uint32_t j = 0, i = row.size_a; i < columns; ++i, ++j)
    Fb[j] -= J0[i] * row.f.fn + J1[i] * row.f.f1 + J2[i] * row.f.f2;
}

/// H += J' D J.
void add_stiffness(const Row& row, const Tangent& D, size_t n, double* H) {
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  for (uint32_t j = 0; j < columns; ++j) {
    const double k0 = D.nn * J0[j];
    const double k1 = D.n1 * J0[j] + D.t11 * J1[j] + D.t12 * J2[j];
    const double k2 = D.n2 * J0[j] + D.t12 * J1[j] + D.t22 * J2[j];
    double* column = H + (j < row.size_a ? row.offset_a + j : row.offset_b + j - row.size_a);
    double *Ha = column + row.offset_a * n, *Hb = column + row.offset_b * n;
    for (uint32_t i = 0; i < row.size_a; ++i) Ha[i * n] += J0[i] * k0 + J1[i] * k1 + J2[i] * k2;
    for (uint32_t b = 0, i = row.size_a; i < columns; ++i, ++b)
      Hb[b * n] += J0[i] * k0 + J1[i] * k1 + J2[i] * k2;
  }
}

}  // namespace

IslandSolver::IslandSolver(uint32_t max_unknowns)
    : d_(max_unknowns),
      trial_(max_unknowns),
      step_(max_unknowns),
      F_(max_unknowns),
      negative_F_(max_unknowns),
      H_(size_t{max_unknowns} * max_unknowns),
      before_(max_unknowns),
      pivot_(max_unknowns) {}

/// Forces of all rows and the residual F at d.
void IslandSolver::evaluate(const Island& island, const double* d, Friction friction) noexcept {
  for (const Mover* mover : island.movers) mover->residual(d + mover->offset, F_.data() + mover->offset);
  for (Row& row : island.rows) {
    row.u = displaced(row, d);
    const double fn = normal_force(row.surface, row.u.g);
    if (friction == Friction::kCoulomb) row.limit = row.surface.mu * fn;
    row.f = force_with_limit(row.surface, row.u, fn, row.limit);
    if (row.f.fn > 0 || row.limit > 0) add_force(row, F_.data());
  }
}

double IslandSolver::merit(const Island& island) const noexcept {
  double sum = 0;
  for (const Mover* mover : island.movers) sum += mover->merit(F_.data() + mover->offset);
  return sum;
}

/// Newton step from the point last evaluated: H step = -F.
bool IslandSolver::direction(const Island& island, Friction friction) noexcept {
  std::fill_n(H_.begin(), size_ * size_, 0.0);
  for (const Mover* mover : island.movers) mover->add_stiffness(d_.data() + mover->offset, size_, H_.data());
  for (const Row& row : island.rows) {
    if (row.f.fn <= 0 && row.limit <= 0) continue;
    const Tangent D = tangent(row.surface, row.u, row.f, row.limit, friction == Friction::kCoulomb);
    add_stiffness(row, D, size_, H_.data());
  }
  for (size_t i = 0; i < size_; ++i) negative_F_[i] = -F_[i];
  if (!lu_factor(size_, H_.data(), pivot_.data())) return false;
  ++newton_;
  lu_solve(size_, H_.data(), pivot_.data(), negative_F_.data(), step_.data());
  return true;
}

/// The farthest that a centre or a contact moves [m].
double IslandSolver::length(const Island& island, const double* step) const noexcept {
  double longest = 0;
  for (const Mover* mover : island.movers) longest = std::max(longest, mover->length(step + mover->offset));
  for (const Row& row : island.rows) {
    const Displacement u = displaced(row, step);
    const double g = u.g - row.at.g, s1 = u.s1 - row.at.s1, s2 = u.s2 - row.at.s2;
    longest = std::max(longest, std::sqrt(g * g + s1 * s1 + s2 * s2));
  }
  return longest;
}

void IslandSolver::advance(double fraction) noexcept {
  for (size_t i = 0; i < size_; ++i) trial_[i] = d_[i] + fraction * step_[i];
}

/// Semi-smooth Newton on F with a line search on the merit F' A^-1 F, for which its direction descends. Gives up soon:
/// what it cannot do in a few steps the convex path does better.
bool IslandSolver::newton(const Island& island, double tolerance) noexcept {
  evaluate(island, d_.data(), Friction::kCoulomb);
  double now = merit(island);
  for (uint32_t i = 0; i < kNewtonSteps; ++i) {
    if (!direction(island, Friction::kCoulomb)) return false;
    const double far = length(island, step_.data());
    if (!std::isfinite(far)) return false;

    double fraction = 1, next = 0;
    for (uint32_t k = 0;; ++k, fraction *= 0.5) {
      advance(fraction);
      evaluate(island, trial_.data(), Friction::kCoulomb);
      // close enough that the last correction settles it
      if (far <= tolerance) break;
      next = merit(island);
      if (next <= (1 - 2 * kDecrease * fraction) * now) break;
      if (k == kHalvings) return false;
    }
    d_.swap(trial_);
    if (far <= tolerance) return true;
    now = next;
  }
  return false;
}

/// Slope of the energy along the step, at a fraction of it: rises monotonically, because the energy is convex.
double IslandSolver::slope(const Island& island, double fraction) noexcept {
  advance(fraction);
  evaluate(island, trial_.data(), Friction::kTresca);
  double sum = 0;
  for (size_t i = 0; i < size_; ++i) sum += F_[i] * step_[i];
  return sum;
}

/// The fraction of the step at which the energy is least, well enough: the slope there is a tenth of what it was. Regula
/// falsi on the slope, which is piecewise smooth with steep kinks where a contact begins to slip.
double IslandSolver::search(const Island& island) noexcept {
  const double start = slope(island, 0), good = kFlat * std::abs(start);
  double low = 0, high = 1, at_low = start, at_high = slope(island, 1);
  if (at_high <= good) return 1;  // the whole step still descends, or all but
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
  slope(island, low);
  return low;
}

/// Least energy with the friction limits held: convex, so Newton with a line search finds it from anywhere.
bool IslandSolver::minimise(const Island& island, double tolerance) noexcept {
  evaluate(island, d_.data(), Friction::kTresca);
  uint32_t still = 0;
  for (uint32_t i = 0; i < kConvexSteps; ++i) {
    if (!direction(island, Friction::kTresca)) return false;
    const double far = length(island, step_.data());
    if (!std::isfinite(far)) return false;
    if (far <= tolerance) {
      advance(1);
      d_.swap(trial_);
      return true;
    }
    // a short piece of a long step may only have met a kink; two are the end
    const double fraction = search(island);
    d_.swap(trial_);
    still = fraction * far <= tolerance ? still + 1 : 0;
    if (still == 2) return true;
  }
  return false;
}

Outcome IslandSolver::solve(const Island& island, double tolerance, From from) noexcept {
  size_ = island.size;
  newton_ = 0;
  std::fill_n(d_.begin(), size_, 0.0);
  Outcome outcome;
  if (from == From::kHeldLimits) {
    outcome.rounds = 1;
    outcome.fell_back = true;
    outcome.converged = minimise(island, tolerance) && limits_hold(island);
  } else {
    outcome.converged = newton(island, tolerance);
    if (!outcome.converged) follow_limits(island, tolerance, from, outcome);
    evaluate(island, d_.data(), Friction::kCoulomb);
  }
  outcome.newton = newton_;
  outcome.moved = length(island, d_.data());
  return outcome;
}

/// Limits from the normal forces, least energy, new limits ... until they stay.
void IslandSolver::follow_limits(const Island& island, double tolerance, From from,
                                 Outcome& outcome) noexcept {
  outcome.fell_back = true;
  std::fill_n(d_.begin(), size_, 0.0);
  if (from == From::kPrediction) {
    // from where nothing slips: a contact that must slip then slips the right way
    evaluate(island, d_.data(), Friction::kCoulomb);
    for (Row& row : island.rows) row.limit = row.limit > 0 ? kNeverSlips : 0;
    minimise(island, tolerance);
    std::copy_n(d_.begin(), size_, before_.begin());
    outcome.converged = newton(island, tolerance);
    if (!outcome.converged) std::copy_n(before_.begin(), size_, d_.begin());
  }
  while (!outcome.converged && outcome.rounds < kTrescaRounds) {
    ++outcome.rounds;
    std::copy_n(d_.begin(), size_, before_.begin());
    evaluate(island, d_.data(), Friction::kCoulomb);
    const bool least = minimise(island, tolerance);
    for (size_t i = 0; i < size_; ++i) step_[i] = d_[i] - before_[i];
    outcome.converged = least && length(island, step_.data()) <= tolerance;
  }
}

/// Every friction limit is mu f_n to one in a thousand of the largest.
bool IslandSolver::limits_hold(const Island& island) const noexcept {
  double largest = 0, off = 0;
  for (const Row& row : island.rows) {
    largest = std::max(largest, row.limit);
    off = std::max(off, std::abs(row.limit - row.surface.mu * row.f.fn));
  }
  return off <= 1e-3 * largest;
}

}  // namespace swage::dynamics
