// SPDX-License-Identifier: Apache-2.0
//
// Contacts of threads and rigid bodies, as they enter the system of banded_blocks.hpp. The displacement of a contact point is u =
// sum J_k d_k over at most two blocks: the two nodes of an edge with its rotation, or a body's translation and rotation.
// Header-only, [rt].
#pragma once

#include "dynamics/banded_blocks.hpp"
#include "toolkit/band.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

using BlockJacobian = Eigen::Matrix<double, 3, 4>;

/// One side of a contact: the Jacobian of its point. size 0: a fixed point.
struct BlockPoint {
  uint32_t size = 0;
  uint32_t block[2] = {};
  BlockJacobian J[2];
};

/// Point on a thread at the fraction `s` of the edge after `node`, `arm` [m] from the centre line; t: unit tangent of the edge.
inline BlockPoint thread_point(uint32_t first_block, uint32_t node, double s, const toolkit::Vec3& t,
                               const toolkit::Vec3& arm) {
  BlockPoint p;
  p.size = 2;
  for (uint32_t k = 0; k < 2; ++k) {
    p.block[k] = first_block + node + k;
    p.J[k].setZero();
    for (int r = 0; r < 3; ++r) p.J[k](r, r) = k == 0 ? 1 - s : s;
  }
  p.J[0].col(3) = t.cross(arm);
  return p;
}

/// A point of a rigid body `arm` [m] from its centre; its blocks: (v, -), (w, -).
inline BlockPoint body_point(uint32_t first_block, const toolkit::Vec3& arm) {
  BlockPoint p;
  p.size = 2;
  for (uint32_t k = 0; k < 2; ++k) p.block[k] = first_block + k, p.J[k].setZero();
  p.J[0].leftCols<3>().setIdentity();
  p.J[1].leftCols<3>() = -toolkit::skew(arm);
  return p;
}

namespace assembly {

/// One block under one side: its index, the sign of the side (+1: a, -1: b), and the 3 x 4 Jacobian by rows.
struct Side {
  uint32_t block;
  double sign;
  double row[3][4];
};
inline void add_sides(const BlockPoint& p, double sign, Side* to) noexcept {
  for (uint32_t k = 0; k < p.size; ++k) {
    to[k].block = p.block[k], to[k].sign = sign;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) to[k].row[r][c] = p.J[k](r, c);
  }
}

/// DJ = D J of one side: 3 rows, 4 columns.
inline void multiply(const toolkit::Mat3& D, const Side& side, double DJ[3][4]) noexcept {
  for (int c = 0; c < 4; ++c) {
    const double x = side.sign * side.row[0][c], y = side.sign * side.row[1][c], z = side.sign * side.row[2][c];
    for (int r = 0; r < 3; ++r) DJ[r][c] = (x * D(r, 0) + y * D(r, 1)) + z * D(r, 2);
  }
}

/// M = J' DJ, column by column.
template <class V>
[[gnu::always_inline]] inline void multiply_transposed(const Side& side, const double DJ[3][4], double* M) noexcept {
  toolkit::Line<V, 4> x, y, z;
  x.load(side.row[0]), y.load(side.row[1]), z.load(side.row[2]);
  const auto column = [&](int c) __attribute__((always_inline)) {
    toolkit::Line<V, 4> m = x, p = y, q = z;
    m.multiply(DJ[0][c]), p.multiply(DJ[1][c]), q.multiply(DJ[2][c]);
    m.add(p), m.add(q), m.multiply(side.sign);
    m.store(M + 4 * c);
  };
  column(0), column(1), column(2), column(3);
}
SWAGE_FOURS inline void multiply_by_fours(const Side& side, const double DJ[3][4], double* M) noexcept {
  multiply_transposed<toolkit::Fours>(side, DJ, M);
}

}  // namespace assembly

/// H += J' D J, J = J_a - J_b; D [N/m]. `symmetric`: adds one of the blocks (a, b) and (b, a), as BandedBlocks::add() expects.
inline void add_contact(BandedBlocks& H, const BlockPoint& a, const BlockPoint& b, const toolkit::Mat3& D,
                        bool symmetric) noexcept {
  assembly::Side side[4];
  assembly::add_sides(a, 1, side), assembly::add_sides(b, -1, side + a.size);
  const uint32_t n = a.size + b.size;
  const bool fours = toolkit::has_fours();
  for (uint32_t j = 0; j < n; ++j) {
    double DJ[3][4];
    assembly::multiply(D, side[j], DJ);
    for (uint32_t i = symmetric ? j : 0; i < n; ++i) {
      BandedBlocks::Block M;
      fours ? assembly::multiply_by_fours(side[i], DJ, M.data()) : assembly::multiply_transposed<toolkit::Twos>(side[i], DJ, M.data());
      // two sides in one block: the diagonal block takes both off-diagonal halves
      if (symmetric && i != j && side[i].block == side[j].block) M += BandedBlocks::Block(M.transpose());
      H.add(side[i].block, side[j].block, M);
    }
  }
}

/// Adds the Hessian of a thread: a node is coupled to two neighbours on each side, a rotation to the nodes of three edges. The last
/// block has no rotation; a 1 on its diagonal keeps the matrix regular.
inline void add_band(BandedBlocks& H, uint32_t first_block, const toolkit::Band<10>& A,
                     bool symmetric) noexcept {
  const int n = A.size(), blocks = (n + 1) / 4;
  for (int j = 0; j < blocks; ++j)
    for (int i = j; i < std::min(blocks, j + 3); ++i) {
      BandedBlocks::Block M = BandedBlocks::Block::Zero();
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
          const int row = 4 * i + r, column = 4 * j + c, low = std::max(row, column),
                    high = std::min(row, column);
          if (low < n && low - high <= 10) M(r, c) = A.at(low, high);
          if (row >= n && row == column) M(r, c) = 1;
        }
      const uint32_t a = first_block + static_cast<uint32_t>(i), b = first_block + static_cast<uint32_t>(j);
      H.add(a, b, M);
      if (!symmetric && i != j) H.add(b, a, M.transpose());
    }
}

}  // namespace swage::dynamics
