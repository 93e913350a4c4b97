// SPDX-License-Identifier: Apache-2.0
#include "dynamics/dense.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "base/rng.hpp"

namespace swage::dynamics {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

RowMajor random_matrix(base::Xoshiro256& rng, int n, int m) {
  RowMajor A(n, m);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) A(i, j) = 2 * rng.uniform() - 1;
  return A;
}

TEST(Dense, SolvesWhatEigenSolves) {
  base::Xoshiro256 rng(1);
  for (int n = 1; n <= 20; ++n) {
    const RowMajor A = random_matrix(rng, n, n);
    const RowMajor b = random_matrix(rng, n, 1);
    RowMajor LU = A;
    std::vector<uint32_t> pivot(static_cast<size_t>(n));
    RowMajor x(n, 1);
    ASSERT_TRUE(lu_factor(static_cast<size_t>(n), LU.data(), pivot.data()));
    lu_solve(static_cast<size_t>(n), LU.data(), pivot.data(), b.data(), x.data());
    EXPECT_LT((A * x - b).norm(), 1e-11) << n;
  }
}

TEST(Dense, PivotsAndRefusesSingularMatrices) {
  double swap[4] = {0, 1, 1, 0};
  uint32_t pivot[2];
  EXPECT_TRUE(lu_factor(2, swap, pivot));
  double singular[4] = {1, 2, 2, 4};
  EXPECT_FALSE(lu_factor(2, singular, pivot));
  double poisoned[4] = {NAN, 0, 0, 1};
  EXPECT_FALSE(lu_factor(2, poisoned, pivot));
}

// a compliance of rank 6, as every rigid body has at any number of points, is recovered from its 6 columns
TEST(Dense, CholeskyOfASemidefiniteMatrixFindsItsRank) {
  base::Xoshiro256 rng(2);
  const int n = 12, rank = 6;
  const RowMajor J = random_matrix(rng, n, rank);
  const RowMajor W = J * J.transpose();
  RowMajor copy = W, L = RowMajor::Zero(n, n);
  ASSERT_EQ(cholesky_semidefinite(n, copy.data(), L.data()), static_cast<size_t>(rank));
  EXPECT_LT((L.leftCols(rank) * L.leftCols(rank).transpose() - W).norm(), 1e-13 * W.norm());

  RowMajor zero = RowMajor::Zero(3, 3), none(3, 3);
  EXPECT_EQ(cholesky_semidefinite(3, zero.data(), none.data()), 0u);
}

TEST(Dense, KnowsTheSignOfTheDeterminant) {
  base::Xoshiro256 rng(3);
  int negative = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 1 + trial % 9;
    RowMajor A = random_matrix(rng, n, n);
    const double expected = A.determinant();
    std::vector<uint32_t> pivot(static_cast<size_t>(n));
    ASSERT_TRUE(lu_factor(static_cast<size_t>(n), A.data(), pivot.data()));
    EXPECT_EQ(determinant_sign(static_cast<size_t>(n), A.data(), pivot.data()), expected > 0 ? 1 : -1);
    negative += expected < 0;
  }
  EXPECT_GT(negative, 50);
}

}  // namespace
}  // namespace swage::dynamics
