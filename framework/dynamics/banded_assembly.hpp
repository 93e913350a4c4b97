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

/// A point at the share `s` of the edge after `node`, `arm` [m] from the centre line; t: the edge's tangent.
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

/// H += J' D J, J = J_a - J_b; D [N/m]. Symmetric: the half that BandedBlocks::add asks for.
inline void add_contact(BandedBlocks& H, const BlockPoint& a, const BlockPoint& b, const toolkit::Mat3& D,
                        bool symmetric) noexcept {
  struct Side {
    uint32_t block;
    double sign;
    const BlockJacobian* J;
  };
  Side side[4] = {};
  uint32_t n = 0;
  for (uint32_t k = 0; k < a.size; ++k) side[n++] = {a.block[k], 1, &a.J[k]};
  for (uint32_t k = 0; k < b.size; ++k) side[n++] = {b.block[k], -1, &b.J[k]};
  for (uint32_t j = 0; j < n; ++j) {
    BlockJacobian DJ;
    for (int c = 0; c < 4; ++c) {
      const toolkit::Vec3 x = side[j].sign * side[j].J->col(c);
      DJ.col(c) = (x[0] * D.col(0) + x[1] * D.col(1)) + x[2] * D.col(2);
    }
    for (uint32_t i = symmetric ? j : 0; i < n; ++i) {
      BandedBlocks::Block M;
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
          const auto left = side[i].J->col(r);
          M(r, c) = side[i].sign * ((left[0] * DJ(0, c) + left[1] * DJ(1, c)) + left[2] * DJ(2, c));
        }
      // two sides under one block: it takes both halves
      if (symmetric && i != j && side[i].block == side[j].block) M += BandedBlocks::Block(M.transpose());
      H.add(side[i].block, side[j].block, M);
    }
  }
}

/// A thread's own matrix: nodes are coupled to two neighbours, rotations to the nodes of the three edges around. The last block has no
/// rotation: an idle unknown.
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
