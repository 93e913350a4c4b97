// SPDX-License-Identifier: Apache-2.0
#include "dynamics/mover_space.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dense.hpp"
#include "dynamics/row.hpp"

namespace swage::dynamics {

MoverSpace::MoverSpace(uint32_t max_unknowns)
    : F_(max_unknowns),
      negative_F_(max_unknowns),
      H_(size_t{max_unknowns} * max_unknowns),
      pivot_(max_unknowns) {}

size_t MoverSpace::begin(const Island& island) noexcept {
  island_ = &island;
  size_ = island.size;
  factored_ = false;
  return size_;
}

bool MoverSpace::start(double* d) noexcept {
  std::fill_n(d, size_, 0.0);
  return true;
}

void MoverSpace::displace(const double* d) noexcept {
  for (Row& row : island_->rows) row.u = displaced(row, d);
}

/// F = A (x + d - x_hat) - J' f.
void MoverSpace::residual(const double* d) noexcept {
  for (const Mover* mover : island_->movers) mover->residual(d + mover->offset, F_.data() + mover->offset);
  for (const Row& row : island_->rows)
    if (row.f.fn != 0 || row.f.f1 != 0 || row.f.f2 != 0) add_force(row, F_.data());
}

double MoverSpace::merit() noexcept {
  double sum = 0;
  for (const Mover* mover : island_->movers) sum += mover->merit(F_.data() + mover->offset);
  return sum;
}

/// Between kinks H does not change, and its factors are still there.
bool MoverSpace::direction(const double* d, bool same, double* step) noexcept {
  for (Mover* mover : island_->movers) {
    if (mover->kind != Mover::Kind::kHinge) continue;
    const double now = mover->drive.stiffness(mover->angle + d[mover->offset]);
    same = same && now == mover->stiffness;
    mover->stiffness = now;
  }
  if (!same || !factored_) {
    std::fill_n(H_.begin(), size_ * size_, 0.0);
    for (const Mover* mover : island_->movers) mover->add_stiffness(d + mover->offset, size_, H_.data());
    for (const Row& row : island_->rows)
      if (stiffens(row.D)) add_stiffness(row, row.D, size_, H_.data());
    work += size_ * size_ * size_ / 3 + 432 * island_->rows.size();
    factored_ = lu_factor(size_, H_.data(), pivot_.data());
    if (!factored_) return false;
  }
  work += size_ * size_;
  for (size_t i = 0; i < size_; ++i) negative_F_[i] = -F_[i];
  lu_solve(size_, H_.data(), pivot_.data(), negative_F_.data(), step);
  return true;
}

int MoverSpace::sign() const noexcept { return determinant_sign(size_, H_.data(), pivot_.data()); }

void MoverSpace::aim(const double* step) noexcept {
  for (Row& row : island_->rows) {
    row.way = displaced(row, step);
    row.way.g -= row.at.g, row.way.s1 -= row.at.s1, row.way.s2 -= row.at.s2;
  }
}

double MoverSpace::slope(const double* d, const double* step) noexcept {
  double sum = 0;
  for (const Mover* mover : island_->movers) mover->residual(d + mover->offset, F_.data() + mover->offset);
  for (size_t i = 0; i < size_; ++i) sum += F_[i] * step[i];
  return sum;
}

double MoverSpace::length(const double* step) noexcept {
  double longest = 0;
  for (const Mover* mover : island_->movers) longest = std::max(longest, mover->length(step + mover->offset));
  for (const Row& row : island_->rows) {
    const Displacement u = displaced(row, step);
    const double g = u.g - row.at.g, s1 = u.s1 - row.at.s1, s2 = u.s2 - row.at.s2;
    longest = std::max(longest, std::sqrt(g * g + s1 * s1 + s2 * s2));
  }
  return longest;
}

void MoverSpace::finish(const double* z, double* d) noexcept { std::copy_n(z, size_, d); }

}  // namespace swage::dynamics
