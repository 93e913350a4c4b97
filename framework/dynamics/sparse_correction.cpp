// SPDX-License-Identifier: Apache-2.0
#include "dynamics/sparse_correction.hpp"

#include <algorithm>

#include "dynamics/dense.hpp"

namespace swage::dynamics {

namespace {

/// J Y of a constraint: Y has four columns side by side, of which three count.
void displace(const BlockContact& c, const double* Y, double JY[3][3]) noexcept {
  std::fill_n(&JY[0][0], 9, 0.0);
  for (uint32_t k = 0; k < c.size; ++k)
    for (uint32_t i = 0; i < 4; ++i) {
      const double* y = Y + 4 * size_t{c.at[k] + i};
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < 3; ++s) JY[r][s] += c.row[k][r][i] * y[s];
    }
}

}  // namespace

SparseCorrection::SparseCorrection(size_t max_numbers) {
  for (auto& W : W_) W.resize(4 * max_numbers);
}

bool SparseCorrection::solve(const BandedBlocks& H, std::span<const BlockContact> contacts, uint32_t constraint,
                             const double E[3][3], double* x, size_t size) noexcept {
  uint32_t at = 0;
  while (at < n_ && change_[at].constraint != constraint) ++at;
  if (at == kMost) return false;
  std::copy_n(&E[0][0], 9, &change_[at].E[0][0]);
  if (at < n_) {
    H.solve_late(x);
  } else {
    change_[n_++].constraint = constraint;
    add_columns(H, contacts, x, size);
  }
  return correct(contacts, x, size);
}

/// W and K of the last change, and x = H^-1 x beside them.
void SparseCorrection::add_columns(const BandedBlocks& H, std::span<const BlockContact> contacts, double* x, size_t size) noexcept {
  const uint32_t last = n_ - 1;
  const BlockContact& c = contacts[change_[last].constraint];
  double* const W = W_[last].data();
  std::fill_n(W, 4 * size, 0.0);
  for (uint32_t k = 0; k < c.size; ++k)
    for (uint32_t i = 0; i < 4; ++i)
      for (uint32_t r = 0; r < 3; ++r) W[4 * (c.at[k] + i) + r] += c.row[k][r][i];
  for (size_t i = 0; i < size; ++i) W[4 * i + 3] = x[i];
  H.solve_four_late(W);
  for (size_t i = 0; i < size; ++i) x[i] = W[4 * i + 3];

  const auto set = [&](uint32_t a, uint32_t b) {
    double JW[3][3];
    displace(contacts[change_[a].constraint], W_[b].data(), JW);
    for (uint32_t r = 0; r < 3; ++r) std::copy_n(JW[r], 3, K_[3 * a + r] + 3 * b);
  };
  for (uint32_t a = 0; a < last; ++a) set(a, last), set(last, a);
  set(last, last);
}

/// x -= W (1 + E K)^-1 E J x.
bool SparseCorrection::correct(std::span<const BlockContact> contacts, double* x, size_t size) noexcept {
  const size_t n = size_t{3} * n_;
  double M[9 * kMost * kMost], b[3 * kMost], y[3 * kMost];
  uint32_t row[3 * kMost];
  for (uint32_t a = 0; a < n_; ++a) {
    double u[4];
    assembly::displace<toolkit::Twos>(contacts[change_[a].constraint], x, u);
    for (uint32_t r = 0; r < 3; ++r) {
      const double* E = change_[a].E[r];
      const size_t at = 3 * a + r;
      b[at] = E[0] * u[0] + E[1] * u[1] + E[2] * u[2];
      for (size_t j = 0; j < n; ++j) M[at * n + j] = E[0] * K_[3 * a][j] + E[1] * K_[3 * a + 1][j] + E[2] * K_[3 * a + 2][j];
      M[at * n + at] += 1;
    }
  }
  if (!lu_factor(n, M, row)) return false;
  sign_ = determinant_sign(n, M, row);
  lu_solve(n, M, row, b, y);
  for (uint32_t a = 0; a < n_; ++a)
    for (size_t i = 0; i < size; ++i) {
      const double* W = W_[a].data() + 4 * i;
      x[i] -= y[3 * a] * W[0] + y[3 * a + 1] * W[1] + y[3 * a + 2] * W[2];
    }
  return true;
}

}  // namespace swage::dynamics
