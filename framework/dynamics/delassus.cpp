// SPDX-License-Identifier: Apache-2.0
//
// v* and W of an island: displacements of its constraints without forces, and the Delassus operator.
#include <algorithm>

#include "dynamics/contact_space.hpp"
#include "dynamics/jacobian.hpp"
#include "toolkit/wide.hpp"

namespace swage::dynamics {
namespace {

constexpr size_t kPair = 12;  // numbers of the product of two sides: three rows of four, of which the last means nothing

/// W = sum of J[u] M[u]' over the unknowns u, for a side with J and each of `sides` with M one after the other. M: readable one number
/// beyond.
template <class V>
[[gnu::always_inline]] inline void multiply_sides(uint32_t size, const Vec3* J, const Vec3* M, size_t sides, double* W) noexcept {
  for (size_t q = 0; q < sides; ++q, M += size, W += kPair) {
    toolkit::Line<V, 4> x = {}, y = {}, z = {};
    for (uint32_t u = 0; u < size; ++u) {
      toolkit::Line<V, 4> m;
      m.load(M[u].data());
      x.add(J[u][0], m), y.add(J[u][1], m), z.add(J[u][2], m);
    }
    x.store(W), y.store(W + 4), z.store(W + 8);
  }
}
SWAGE_FOURS void multiply_sides_by_fours(uint32_t size, const Vec3* J, const Vec3* M, size_t sides, double* W) noexcept {
  size == 6 ? multiply_sides<toolkit::Fours>(6, J, M, sides, W) : multiply_sides<toolkit::Fours>(size, J, M, sides, W);
}

}  // namespace

size_t ContactSpace::begin(const Island& island) noexcept {
  island_ = &island;
  n_constraints_ = island.constraints.size();
  hinge_.clear();
  for (const DofBlock* block : island.blocks)
    if (block->kind == DofBlock::Kind::kHinge) hinge_.push_back(block);
  n_ = 3 * n_constraints_ + hinge_.size();
  factored_ = solved_ = false;
  std::fill_n(W_.begin(), n_ * n_, 0.0);
  for (size_t i = 0; i < n_constraints_; ++i) {
    const Constraint& constraint = island.constraints[i];
    put(in_world(constraint, constraint.at.g, constraint.at.s1, constraint.at.s2), &free_[3 * i]);
  }
  uint32_t hinge = 0;
  for (uint32_t m = 0; m < island.blocks.size(); ++m) {
    const DofBlock& block = *island.blocks[m];
    collect(m);
    work += 9 * arm_.size() * arm_.size() * std::clamp(block.size, 1u, BandedBody::kOfPoint);
    if (block.kind == DofBlock::Kind::kFlexible)
      add_flexible(block);
    else if (block.kind == DofBlock::Kind::kBanded)
      add_banded(block);
    else
      add_rigid(block, block.kind == DofBlock::Kind::kHinge ? hinge++ : 0);
  }
  system_.begin(W_.data(), n_constraints_, hinge_.size());
  return 2 * n_;
}

/// Collects the sides of constraints that are on a block.
void ContactSpace::collect(uint32_t block) noexcept {
  arm_.clear();
  for (uint32_t i = 0; i < n_constraints_; ++i) {
    const Constraint& constraint = island_->constraints[i];
    const uint32_t stride = constraint.size_a + constraint.size_b;
    const uint32_t first = island_->blocks[block]->offset;
    if (constraint.block_a == block)
      arm_.push_back({i, constraint.point_a, 1, constraint.J, stride, constraint.offset_a - first});
    if (constraint.block_b == block)
      arm_.push_back({i, constraint.point_b, -1, constraint.J + constraint.size_a, stride, constraint.offset_b - first});
  }
}

/// Adds the mobility that the flexible body answered; its points already have the displacement `extra`.
void ContactSpace::add_flexible(const DofBlock& block) noexcept {
  const PointMobility& own = block.own;
  const size_t n = n_, stride = own.stride;  // not read again after each store
  for (size_t p = 0; p < arm_.size(); ++p) {
    const JacobianBlock& a = arm_[p];
    for (size_t i = 0; i < 3; ++i) free_[3 * a.constraint + i] -= a.sign * own.extra[3 * a.point + i];
    for (size_t q = 0; q <= p; ++q) {
      const JacobianBlock& b = arm_[q];
      const double s = a.sign * b.sign * own.hh;
      const double* from = own.W + 3 * a.point * own.stride + 3 * b.point;
      double *to = line(3 * a.constraint) + 3 * b.constraint,
             *back = line(3 * b.constraint) + 3 * a.constraint;
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const double w = s * from[i * stride + k];
          to[i * n + k] += w;
          if (p != q) back[k * n + i] += w;
        }
    }
  }
}

/// Adds J A^-1 J' of a rigid body, hinge or particle. The signs of the sides are in J.
void ContactSpace::add_rigid(const DofBlock& block, uint32_t hinge) noexcept {
  const uint32_t size = block.size;
  const size_t n = n_;
  double to_free[6], F[6], d[6];
  block.to_free(to_free);
  for (size_t p = 0; p < arm_.size(); ++p) {
    const JacobianBlock& a = arm_[p];
    Vec3 *Jt = &Jt_[size * p], *turn = &Minv_Jt_[size * p], moves = Vec3::Zero();
    for (uint32_t u = 0; u < size; ++u) {
      Jt[u] = in_world(island_->constraints[a.constraint], a.J[u], a.J[a.stride + u], a.J[2 * a.stride + u]);
      moves += to_free[u] * Jt[u];
    }
    for (int i = 0; i < 3; ++i) {
      for (uint32_t u = 0; u < size; ++u) F[u] = Jt[u][i];
      block.apply_inverse_mass(F, d);
      for (uint32_t u = 0; u < size; ++u) turn[u][i] = d[u];
    }
    for (size_t i = 0; i < 3; ++i) free_[3 * a.constraint + i] += moves[index(i)];
    double* const products = products_.data();
    toolkit::has_fours() ? multiply_sides_by_fours(size, Jt, Minv_Jt_.data(), p + 1, products)
                         : multiply_sides<toolkit::Twos>(size, Jt, Minv_Jt_.data(), p + 1, products);
    double* const of_a = line(3 * a.constraint);
    for (size_t q = 0; q <= p; ++q) {
      const double* W_ab = products + kPair * q;
      double *to = of_a + 3 * arm_[q].constraint, *back = line(3 * arm_[q].constraint) + 3 * a.constraint;
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) to[i * n + k] += W_ab[4 * i + k];
      if (p == q) continue;
      for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < 3; ++i) back[k * n + i] += W_ab[4 * i + k];
    }
  }
  if (block.kind == DofBlock::Kind::kHinge) add_drive(block, 3 * n_constraints_ + hinge);
}

/// Adds J A^-1 J' of a band: a side moves with two vertices, by the columns of A^-1 for forces at the two vertices of another side. These
/// columns are the same in every pass of a step; J is not.
void ContactSpace::add_banded(const DofBlock& block) noexcept {
  constexpr uint32_t kColumns = BandedBody::kOfPoint, kOfVertex = BandedBody::kUnknowns;
  using Sides = Eigen::Matrix<double, 4, 3, Eigen::RowMajor>;  // of a vertex: its columns of J'
  using Square = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  block.to_free(of_block_.data());
  work += 40 * arm_.size() * block.size;
  for (size_t p = 0; p < arm_.size(); ++p) {
    const JacobianBlock& a = arm_[p];
    Vec3 *Jt = &Jt_[kColumns * p], moves = Vec3::Zero();
    for (uint32_t u = 0; u < kColumns; ++u) {
      Jt[u] = in_world(island_->constraints[a.constraint], a.J[u], a.J[a.stride + u], a.J[2 * a.stride + u]);
      moves += of_block_[a.first + u] * Jt[u];
    }
    for (size_t i = 0; i < 3; ++i) free_[3 * a.constraint + i] += moves[index(i)];
  }
  uint32_t least = UINT32_MAX, most = 0;
  for (const JacobianBlock& a : arm_) least = std::min(least, a.first / kOfVertex), most = std::max(most, a.first / kOfVertex + 1);
  const auto sides = [&](size_t p, uint32_t vertex) {
    return Eigen::Map<const Sides>(Jt_[kColumns * p + kOfVertex * vertex].data());
  };
  for (size_t p = 0; p < arm_.size(); ++p) {
    const JacobianBlock& a = arm_[p];
    const uint32_t first = a.first / kOfVertex;
    const double* column[2] = {block.band->column(first, least, most), block.band->column(first + 1, least, most)};
    for (size_t q = p; q < arm_.size(); ++q) {
      const JacobianBlock& b = arm_[q];
      Mat3 W_ba = Mat3::Zero();
      for (uint32_t v = 0; v < 2; ++v) {
        const size_t at = size_t{kOfVertex} * (b.first + kOfVertex * v);
        const Sides gone = Eigen::Map<const Square>(column[0] + at) * sides(p, 0) +
                           Eigen::Map<const Square>(column[1] + at) * sides(p, 1);
        W_ba += sides(q, v).transpose() * gone;
      }
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const double w = W_ba(index(i), index(k));
          line(3 * b.constraint + i)[3 * a.constraint + k] += w;
          if (p != q) line(3 * a.constraint + k)[3 * b.constraint + i] += w;
        }
    }
  }
}

/// Adds the row of a hinge drive: its torque acts on the angle, beside the constraints on the hinge.
void ContactSpace::add_drive(const DofBlock& hinge, size_t at) noexcept {
  hinge.to_free(&free_[at]);
  line(at)[at] = 1 / hinge.drive.inertia_hh;
  for (size_t p = 0; p < arm_.size(); ++p)
    for (size_t i = 0; i < 3; ++i) {
      const double w = Minv_Jt_[p][index(i)];
      line(at)[3 * arm_[p].constraint + i] += w, line(3 * arm_[p].constraint + i)[at] += w;
    }
}

}  // namespace swage::dynamics
