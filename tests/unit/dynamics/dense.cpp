// SPDX-License-Identifier: Apache-2.0
#include "dynamics/dense.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "base/rng.hpp"

namespace swage::dynamics {
namespace dense_test {

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

// on machines without registers for four numbers the two-number variant is compared with itself
TEST(Dense, HasTheSameBitsAtEveryWidthOfRegisters) {
  base::Xoshiro256 rng(3);
  for (const size_t n : {1u, 2u, 7u, 40u, 93u}) {
    const int size = static_cast<int>(n);
    const RowMajor J = random_matrix(rng, size, size);
    RowMajor A = RowMajor::Identity(size, size) + J * J.transpose(), by_twos = A;
    ASSERT_TRUE(ldl_factor(n, A.data()) && dense::ldl_factor<toolkit::Twos>(n, by_twos.data()));
    EXPECT_EQ(A, by_twos) << n;
    RowMajor x = random_matrix(rng, size, 1), y = x;
    solve_transposed(n, A.data(), x.data()), dense::solve_transposed<toolkit::Twos>(n, A.data(), y.data());
    EXPECT_EQ(x, y) << n;
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

TEST(Dense, SolvesSymmetricPositiveDefiniteSystemsFromTheirUpperHalf) {
  base::Xoshiro256 rng(2);
  for (const int n : {1, 2, 7, 40}) {
    // I + J J', of rank below n, as contacts make them
    const RowMajor J = 1e3 * random_matrix(rng, n, (n + 1) / 2), b = random_matrix(rng, n, 1);
    const RowMajor A = RowMajor::Identity(n, n) + J * J.transpose();
    RowMajor upper = A.triangularView<Eigen::Upper>(), x(n, 1);
    ASSERT_TRUE(ldl_factor(static_cast<size_t>(n), upper.data()));
    ldl_solve(static_cast<size_t>(n), upper.data(), b.data(), x.data());
    EXPECT_LT((A * x - b).norm(), 1e-8) << n;
  }
  double indefinite[4] = {1, 2, 2, 1};
  EXPECT_FALSE(ldl_factor(2, indefinite));
  double as_roots[4] = {1, 2, 2, 1};
  EXPECT_FALSE(cholesky_factor(2, as_roots));
  double poisoned[4] = {1, NAN, NAN, 1};
  EXPECT_FALSE(ldl_factor(2, poisoned));
  EXPECT_TRUE(ldl_factor(0, nullptr));
}

TEST(Dense, SolvesByHalves) {
  base::Xoshiro256 rng(4);
  for (const int n : {1, 2, 7, 40}) {
    const RowMajor J = random_matrix(rng, n, n), b = random_matrix(rng, n, 1);
    const RowMajor A = RowMajor::Identity(n, n) + J * J.transpose();
    RowMajor upper = A.triangularView<Eigen::Upper>(), x = b;
    ASSERT_TRUE(cholesky_factor(static_cast<size_t>(n), upper.data()));
    solve_transposed(static_cast<size_t>(n), upper.data(), x.data());
    EXPECT_NEAR(x.squaredNorm(), (b.transpose() * A.inverse() * b)(0), 1e-10 * b.squaredNorm()) << n;
    solve_upper(static_cast<size_t>(n), upper.data(), x.data());
    EXPECT_LT((A * x - b).norm(), 1e-10) << n;
  }
}

// several lines at a time give the same bits as one at a time
TEST(Dense, HasTheBitsOfOneLineAtATime) {
  base::Xoshiro256 rng(6);
  for (int n = 1; n <= 41; ++n) {
    const size_t size = static_cast<size_t>(n);
    const RowMajor J = random_matrix(rng, n, n), b = random_matrix(rng, n, 1);
    RowMajor U = RowMajor::Identity(n, n) + J * J.transpose(), plain = U, x = b, y = b;
    for (int k = 0; k < n; ++k)
      for (int i = k + 1; i < n; ++i) {
        const double l = plain(k, i) * (1 / plain(k, k));
        for (int j = i; j < n; ++j) plain(i, j) -= l * plain(k, j);
      }
    ASSERT_TRUE(ldl_factor(size, U.data()));
    for (int k = 0; k < n; ++k)
      for (int i = k; i < n; ++i) ASSERT_EQ(U(k, i), plain(k, i)) << n;
    solve_transposed(size, U.data(), x.data());
    for (int k = 0; k < n; ++k) {
      y(k) /= U(k, k);
      for (int i = k + 1; i < n; ++i) y(i) -= y(k) * U(k, i);
    }
    for (int k = 0; k < n; ++k) ASSERT_EQ(x(k), y(k)) << n;
  }
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

}  // namespace dense_test
}  // namespace swage::dynamics
