// SPDX-License-Identifier: Apache-2.0
#include "dynamics/displacement_space.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dense.hpp"
#include "dynamics/jacobian.hpp"

namespace swage::dynamics {

DisplacementSpace::DisplacementSpace(uint32_t max_unknowns)
    : F_(max_unknowns), negative_F_(max_unknowns), H_(size_t{max_unknowns} * max_unknowns), pivot_(max_unknowns) {}

size_t DisplacementSpace::begin(const Island& island) noexcept {
  island_ = &island;
  size_ = island.size;
  factored_ = false;
  return size_;
}

bool DisplacementSpace::start(double* d) noexcept {
  std::fill_n(d, size_, 0.0);
  return true;
}

void DisplacementSpace::displace(const double* d) noexcept {
  for (Constraint& constraint : island_->constraints) constraint.u = displaced(constraint, d);
}

/// F = A (x + d - x_hat) - J' f.
void DisplacementSpace::residual(const double* d) noexcept {
  for (const DofBlock* block : island_->blocks) block->residual(d + block->offset, F_.data() + block->offset);
  for (const Constraint& constraint : island_->constraints)
    if (constraint.f.fn != 0 || constraint.f.f1 != 0 || constraint.f.f2 != 0)
      add_force(constraint, F_.data());
}

double DisplacementSpace::merit() noexcept {
  double sum = 0;
  for (const DofBlock* block : island_->blocks) sum += block->merit(F_.data() + block->offset);
  return sum;
}

/// Between kinks H does not change, and its factors are reused.
bool DisplacementSpace::search_direction(const double* d, bool same, double* step) noexcept {
  for (DofBlock* block : island_->blocks) same = block->update_drive(d[block->offset]) && same;
  if (!same || !factored_) {
    std::fill_n(H_.begin(), size_ * size_, 0.0);
    for (const DofBlock* block : island_->blocks) block->add_stiffness(d + block->offset, size_, H_.data());
    for (const Constraint& constraint : island_->constraints)
      if (stiffens(constraint.D)) add_stiffness(constraint, constraint.D, size_, H_.data());
    work += size_ * size_ * size_ / 3 + 432 * island_->constraints.size();
    factored_ = lu_factor(size_, H_.data(), pivot_.data());
    if (!factored_) return false;
  }
  work += size_ * size_;
  for (size_t i = 0; i < size_; ++i) negative_F_[i] = -F_[i];
  lu_solve(size_, H_.data(), pivot_.data(), negative_F_.data(), step);
  return true;
}

int DisplacementSpace::sign() const noexcept { return determinant_sign(size_, H_.data(), pivot_.data()); }

void DisplacementSpace::set_search_direction(const double* step) noexcept {
  for (Constraint& constraint : island_->constraints) {
    constraint.along = displaced(constraint, step);
    constraint.along.g -= constraint.at.g, constraint.along.s1 -= constraint.at.s1,
        constraint.along.s2 -= constraint.at.s2;
  }
}

double DisplacementSpace::slope(const double* d, const double* step) noexcept {
  double sum = 0;
  for (const DofBlock* block : island_->blocks) block->residual(d + block->offset, F_.data() + block->offset);
  for (size_t i = 0; i < size_; ++i) sum += F_[i] * step[i];
  return sum;
}

double DisplacementSpace::length(const double* step) noexcept {
  double longest = 0;
  for (const DofBlock* block : island_->blocks)
    longest = std::max(longest, block->length(step + block->offset));
  for (const Constraint& constraint : island_->constraints) {
    const Displacement u = displaced(constraint, step);
    const double g = u.g - constraint.at.g, s1 = u.s1 - constraint.at.s1, s2 = u.s2 - constraint.at.s2;
    longest = std::max(longest, std::sqrt(g * g + s1 * s1 + s2 * s2));
  }
  return longest;
}

void DisplacementSpace::finish(const double* z, double* d) noexcept { std::copy_n(z, size_, d); }

}  // namespace swage::dynamics
