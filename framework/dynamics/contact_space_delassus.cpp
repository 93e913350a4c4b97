// SPDX-License-Identifier: Apache-2.0
//
// v* and W of an island: where its rows would stand without forces, and how they give.
#include <algorithm>

#include "dynamics/contact_space.hpp"
#include "dynamics/row.hpp"

namespace swage::dynamics {
namespace {

Eigen::Index index(size_t n) { return static_cast<Eigen::Index>(n); }

}  // namespace

size_t ContactSpace::begin(const Island& island) noexcept {
  island_ = &island;
  rows_ = island.rows.size();
  hinge_.clear();
  for (const Mover* mover : island.movers)
    if (mover->kind == Mover::Kind::kHinge) hinge_.push_back(mover);
  n_ = 3 * rows_ + hinge_.size();
  factored_ = solved_ = false;
  std::fill_n(W_.begin(), n_ * n_, 0.0);
  for (size_t i = 0; i < rows_; ++i) {
    const Row& row = island.rows[i];
    put(in_world(row, row.at.g, row.at.s1, row.at.s2), &free_[3 * i]);
  }
  uint32_t hinge = 0;
  for (uint32_t m = 0; m < island.movers.size(); ++m) {
    const Mover& mover = *island.movers[m];
    collect(m);
    work += 9 * arm_.size() * arm_.size() * std::max(1u, mover.size);
    if (mover.kind == Mover::Kind::kSelf)
      add_own(mover);
    else
      add_rigid(mover, mover.kind == Mover::Kind::kHinge ? hinge++ : 0);
  }
  return 2 * n_;
}

/// The sides of rows that a mover is on.
void ContactSpace::collect(uint32_t mover) noexcept {
  arm_.clear();
  for (uint32_t i = 0; i < rows_; ++i) {
    const Row& row = island_->rows[i];
    const uint32_t stride = row.size_a + row.size_b;
    if (row.mover_a == mover) arm_.push_back({i, row.point_a, 1, row.J, stride});
    if (row.mover_b == mover) arm_.push_back({i, row.point_b, -1, row.J + row.size_a, stride});
  }
}

/// Blocks as the own solver answered them; it has come `extra` of its way already.
void ContactSpace::add_own(const Mover& mover) noexcept {
  const OwnAnswer& own = mover.own;
  for (size_t p = 0; p < arm_.size(); ++p) {
    const Arm& a = arm_[p];
    for (size_t i = 0; i < 3; ++i) free_[3 * a.row + i] -= a.sign * own.extra[3 * a.point + i];
    for (size_t q = 0; q <= p; ++q) {
      const Arm& b = arm_[q];
      const double s = a.sign * b.sign * own.hh;
      const double* from = own.W + 3 * a.point * own.stride + 3 * b.point;
      double *to = line(3 * a.row) + 3 * b.row, *back = line(3 * b.row) + 3 * a.row;
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const double w = s * from[i * own.stride + k];
          to[i * n_ + k] += w;
          if (p != q) back[k * n_ + i] += w;
        }
    }
  }
}

/// J A^-1 J'. The signs of the sides are in J.
void ContactSpace::add_rigid(const Mover& mover, uint32_t hinge) noexcept {
  const uint32_t size = mover.size;
  double way[6], F[6], d[6];
  mover.way(way);
  for (size_t p = 0; p < arm_.size(); ++p) {
    const Arm& a = arm_[p];
    Vec3 *lever = &lever_[size * p], *turn = &turn_[size * p], moves = Vec3::Zero();
    for (uint32_t u = 0; u < size; ++u) {
      lever[u] = in_world(island_->rows[a.row], a.J[u], a.J[a.stride + u], a.J[2 * a.stride + u]);
      moves += way[u] * lever[u];
    }
    for (int i = 0; i < 3; ++i) {
      for (uint32_t u = 0; u < size; ++u) F[u] = lever[u][i];
      mover.respond(F, d);
      for (uint32_t u = 0; u < size; ++u) turn[u][i] = d[u];
    }
    for (size_t i = 0; i < 3; ++i) free_[3 * a.row + i] += moves[index(i)];
    for (size_t q = 0; q <= p; ++q) {
      const Arm& b = arm_[q];
      Mat3 block = Mat3::Zero();
      for (uint32_t u = 0; u < size; ++u) block += lever[u] * turn_[size * q + u].transpose();
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const double w = block(index(i), index(k));
          line(3 * a.row + i)[3 * b.row + k] += w;
          if (p != q) line(3 * b.row + k)[3 * a.row + i] += w;
        }
    }
  }
  if (mover.kind == Mover::Kind::kHinge) add_drive(mover, 3 * rows_ + hinge);
}

/// The force of a drive acts on the angle: a row of its own, beside those that the hinge is on.
void ContactSpace::add_drive(const Mover& hinge, size_t at) noexcept {
  hinge.way(&free_[at]);
  line(at)[at] = 1 / hinge.drive.inertia_hh;
  for (size_t p = 0; p < arm_.size(); ++p)
    for (size_t i = 0; i < 3; ++i) {
      const double w = turn_[p][index(i)];
      line(at)[3 * arm_[p].row + i] += w, line(3 * arm_[p].row + i)[at] += w;
    }
}

}  // namespace swage::dynamics
