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

/// A contact in the system: the blocks under its two sides, J = J_a - J_b by columns and by rows, in lines of four numbers, and the blocks of
/// H to which it adds.
struct BlockContact {
  struct Pair {
    uint8_t high = 0, low = 0;  // of the blocks; `high` is eliminated last
    bool diagonal = false;
    uint32_t at = 0;            // among the diagonal blocks, or those below
  };
  uint32_t size = 0;
  uint32_t at[4] = {};          // first number of each block in a vector of the system or, after begin_late(), of its late part
  double column[4][4][4] = {};  // of each block: four columns (g, s1, s2, 0)
  double row[4][3][4] = {};     // the same by rows
  uint32_t pairs = 0;
  Pair pair[10];

  BlockContact(const BandedBlocks& H, const BlockPoint& a, const BlockPoint& b) {
    uint32_t place[4] = {};
    for (const BlockPoint* p : {&a, &b})
      for (uint32_t k = 0; k < p->size; ++k, ++size) {
        place[size] = H.place_of(p->block[k]), at[size] = 4 * place[size];
        for (int c = 0; c < 4; ++c)
          for (int r = 0; r < 3; ++r) {
            const double J = p == &a ? p->J[k](r, c) : -p->J[k](r, c);
            column[size][c][r] = row[size][r][c] = J;
          }
      }
    for (uint8_t i = 0; i < size; ++i)
      for (uint8_t j = 0; j <= i; ++j) {
        const bool swap = place[i] < place[j];
        Pair& to = pair[pairs++];
        to = {swap ? j : i, swap ? i : j, place[i] == place[j], place[i]};
        if (!to.diagonal) to.at = H.place_below(place[to.high], place[to.low]);
      }
  }
  void begin_late(uint32_t early) noexcept {
    for (uint32_t k = 0; k < size; ++k) at[k] -= 4 * early;
  }
};

namespace assembly {

template <class V>
using Line = toolkit::Line<V, 4>;

/// u = J x: g, s1, s2 and a 0.
template <class V>
[[gnu::always_inline]] inline void displace(const BlockContact& c, const double* x, double* u) noexcept {
  Line<V> sum;
  sum.fill(0);
  for (uint32_t k = 0; k < c.size; ++k)
#pragma GCC unroll 4
    for (uint32_t i = 0; i < 4; ++i) sum.add(x[c.at[k] + i], c.column[k][i]);
  sum.store(u);
}
SWAGE_FOURS inline void displace_by_fours(const BlockContact& c, const double* x, double* u) noexcept { displace<toolkit::Fours>(c, x, u); }

/// F -= J' f.
template <class V>
[[gnu::always_inline]] inline void push(const BlockContact& c, const double* f, double* F) noexcept {
  for (uint32_t k = 0; k < c.size; ++k) {
    Line<V> at;
    at.load(F + c.at[k]);
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) at.take(f[r], c.row[k][r]);
    at.store(F + c.at[k]);
  }
}
SWAGE_FOURS inline void push_by_fours(const BlockContact& c, const double* f, double* F) noexcept { push<toolkit::Fours>(c, f, F); }

/// H += J' DJ, a block of 16 numbers; DJ: three rows.
template <class V>
[[gnu::always_inline]] inline void add_product(const double J[3][4], const double DJ[3][4], double* H) noexcept {
  Line<V> j[3];
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r) j[r].load(J[r]);
#pragma GCC unroll 4
  for (int c = 0; c < 4; ++c) {
    Line<V> h;
    h.load(H + 4 * c);
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) h.add(DJ[r][c], j[r]);
    h.store(H + 4 * c);
  }
}

/// DJ = D J, by rows; D: three rows.
template <class V>
[[gnu::always_inline]] inline void multiply(const double D[3][3], const double J[3][4], double DJ[3][4]) noexcept {
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r) {
    Line<V> sum;
    sum.fill(0);
#pragma GCC unroll 3
    for (int q = 0; q < 3; ++q) sum.add(D[r][q], J[q]);
    sum.store(DJ[r]);
  }
}

/// H += J' D J: the lower blocks and, unless symmetric, the upper ones, which are kept transposed: J_high' D' J_low.
template <class V>
[[gnu::always_inline]] inline void add(const BlockStore& H, const BlockContact& c, const double D[3][3], bool symmetric) noexcept {
  double DJ[4][3][4], transposed[4][3][4];
  const double T[3][3] = {{D[0][0], D[1][0], D[2][0]}, {D[0][1], D[1][1], D[2][1]}, {D[0][2], D[1][2], D[2][2]}};
  for (uint32_t k = 0; k < c.size; ++k) {
    multiply<V>(D, c.row[k], DJ[k]);
    if (!symmetric) multiply<V>(T, c.row[k], transposed[k]);
  }
  for (uint32_t p = 0; p < c.pairs; ++p) {
    const BlockContact::Pair& to = c.pair[p];
    double* const at = (to.diagonal ? H.diagonal : H.lower) + elimination::kBlock * to.at;
    add_product<V>(c.row[to.high], DJ[to.low], at);
    // two sides in one block
    if (to.diagonal && to.high != to.low) add_product<V>(c.row[to.low], DJ[to.high], at);
    if (!symmetric && !to.diagonal) add_product<V>(c.row[to.high], transposed[to.low], H.upper + elimination::kBlock * to.at);
  }
}
SWAGE_FOURS inline void add_by_fours(const BlockStore& H, const BlockContact& c, const double D[3][3], bool symmetric) noexcept {
  add<toolkit::Fours>(H, c, D, symmetric);
}

}  // namespace assembly

/// H += J' D J, J = J_a - J_b; D [N/m]. `symmetric`: adds one of the blocks (a, b) and (b, a), as BandedBlocks::add() expects.
inline void add_contact(BandedBlocks& H, const BlockContact& c, const toolkit::Mat3& D, bool symmetric) noexcept {
  const double rows[3][3] = {{D(0, 0), D(0, 1), D(0, 2)}, {D(1, 0), D(1, 1), D(1, 2)}, {D(2, 0), D(2, 1), D(2, 2)}};
  H.has_fours() ? assembly::add_by_fours(H.store(), c, rows, symmetric) : assembly::add<toolkit::Twos>(H.store(), c, rows, symmetric);
}
inline void add_contact(BandedBlocks& H, const BlockPoint& a, const BlockPoint& b, const toolkit::Mat3& D,
                        bool symmetric) noexcept {
  add_contact(H, BlockContact(H, a, b), D, symmetric);
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
