// SPDX-License-Identifier: Apache-2.0
#include "toolkit/band.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace swage::toolkit {
namespace {

template <int B>
Band<B> some(int n, unsigned seed, Eigen::MatrixXd& dense) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Band<B> a(n);
  dense = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = j; i < std::min(n, j + B + 1); ++i) {
      const double value = i == j ? B + 1 + any(random) : any(random);
      a.at(i, j) = dense(i, j) = dense(j, i) = value;
    }
  return a;
}

TEST(Band, SolvesAsADenseMatrixDoes) {
  for (const int n : {1, 5, 10, 11, 12, 39, 399}) {
    Eigen::MatrixXd dense;
    Band<10> a = some<10>(n, static_cast<unsigned>(n), dense);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
    Eigen::VectorXd product(n), x = b;
    a.multiply(b.data(), product.data());
    EXPECT_LT((product - dense * b).norm(), 1e-13 * product.norm());
    ASSERT_TRUE(a.factor());
    a.solve(x.data());
    EXPECT_LT((x - dense.ldlt().solve(b)).norm(), 1e-13 * x.norm()) << n;
  }
}

template <int kSides>
void expect_each_as_alone() {
  Eigen::MatrixXd dense;
  Band<10> a = some<10>(77, 3, dense);
  ASSERT_TRUE(a.factor());
  std::vector<double> all(size_t{77} * kSides);
  for (size_t k = 0; k < all.size(); ++k) all[k] = 1.0 / static_cast<double>(k + 1);
  std::vector<double> together = all;
  a.solve<kSides>(together.data());
  for (size_t r = 0; r < kSides; ++r) {
    std::vector<double> alone(77);
    for (size_t i = 0; i < 77; ++i) alone[i] = all[i * kSides + r];
    a.solve(alone.data());
    for (size_t i = 0; i < 77; ++i) EXPECT_EQ(alone[i], together[i * kSides + r]) << kSides;
  }
}

// by one, by two and by four numbers at a time
TEST(Band, SolvesManySidesToTheBitAsEachAlone) {
  expect_each_as_alone<3>();
  expect_each_as_alone<6>();
  expect_each_as_alone<4>();
  expect_each_as_alone<8>();
}

TEST(Band, SolvesAPartToTheBitOfTheWhole) {
  constexpr int kFirst = 40, kLeast = 24;
  Eigen::MatrixXd dense;
  Band<10> a = some<10>(77, 3, dense);
  ASSERT_TRUE(a.factor());
  std::vector<double> whole(4 * 77);
  for (size_t r = 0; r < 4; ++r) whole[4 * (kFirst + r) + r] = 1;
  std::vector<double> part = whole;
  a.solve<4>(whole.data());
  a.solve<4>(part.data(), kFirst, kLeast);
  for (size_t i = 4 * kLeast; i < whole.size(); ++i) EXPECT_EQ(part[i], whole[i]) << i;
  EXPECT_NE(part[4 * kLeast - 1], whole[4 * kLeast - 1]);
}

// on machines without registers of four it compares twos with twos
TEST(Band, FactorsToTheSameBitsAtEveryWidthOfRegisters) {
  for (const int n : {1, 9, 10, 11, 13, 77}) {
    Eigen::MatrixXd dense;
    Band<10> a = some<10>(n, 3, dense), by_twos = some<10>(n, 3, dense);
    ASSERT_TRUE(a.factor() && by_twos.factor_by_twos());
    for (int j = 0; j < n; ++j)
      for (int i = j; i < std::min(n, j + 11); ++i) EXPECT_EQ(a.at(i, j), by_twos.at(i, j)) << i << ", " << j;
  }
}

TEST(Band, RefusesWhatIsNotPositiveDefinite) {
  Eigen::MatrixXd dense;
  Band<10> a = some<10>(30, 3, dense);
  a.at(17, 17) = -1;
  EXPECT_FALSE(a.factor());
  Band<10> nan = some<10>(30, 3, dense);
  nan.at(17, 12) = std::nan("");
  EXPECT_FALSE(nan.factor());
}

TEST(Band, HoldsAnUnknown) {
  Eigen::MatrixXd dense;
  Band<10> a = some<10>(30, 5, dense);
  a.hold(13);
  dense.row(13).setZero(), dense.col(13).setZero(), dense(13, 13) = 1;
  Eigen::VectorXd b = Eigen::VectorXd::Ones(30);
  b[13] = 0;
  Eigen::VectorXd x = b;
  ASSERT_TRUE(a.factor());
  a.solve(x.data());
  EXPECT_EQ(x[13], 0);
  EXPECT_LT((dense * x - b).norm(), 1e-13);
}

}  // namespace
}  // namespace swage::toolkit
