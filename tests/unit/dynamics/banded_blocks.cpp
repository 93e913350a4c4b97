// SPDX-License-Identifier: Apache-2.0
//
// The sparse system of threads and bodies compared with a dense one.
#include "dynamics/banded_blocks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "dynamics/banded_assembly.hpp"
#include "random_system.hpp"
#include "toolkit/rod.hpp"

namespace swage::dynamics {
namespace banded_blocks_test {

TEST(BandedBlocks, WithWhatNothingTouchesEliminatedOnceSolveAsADenseMatrixDoes) {
  for (const bool symmetric : {true, false})
    for (const uint32_t contacts : {0u, 1u, 4u, 12u, 60u}) {
      Knot k(30, contacts, symmetric, contacts + 1, true);
      ASSERT_TRUE(k.blocks.factor()) << contacts;
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(k.dense.rows(), -1, 3);
      Eigen::VectorXd x = b;
      k.blocks.solve(x.data());
      EXPECT_LT((k.dense * x - b).norm(), 1e-11 * b.norm()) << symmetric << " " << contacts;
    }
}

/// The numbers of the blocks from..to in the order of elimination, of a vector or of the rows and columns of a dense matrix.
std::vector<int> in_order(const BandedBlocks& blocks, uint32_t from, uint32_t to) {
  std::vector<int> out(4 * size_t{to - from});
  for (uint32_t b = 0; b < blocks.blocks(); ++b)
    if (const uint32_t at = blocks.place_of(b); at >= from && at < to)
      for (uint32_t r = 0; r < 4; ++r) out[4 * (at - from) + r] = static_cast<int>(4 * b + r);
  return out;
}

TEST(BandedBlocks, WithoutWhatNothingTouchesSolveAsADenseMatrixDoes) {
  for (const bool by_twos : {true, false}) {
    Knot k(60, 9, false, 5, true);
    if (by_twos) k.blocks.work_by_twos();
    const uint32_t n = k.blocks.blocks(), early = k.blocks.early();
    ASSERT_GT(early, 20u);
    ASSERT_LT(early, n);
    const std::vector<int> all = in_order(k.blocks, 0, n), late = in_order(k.blocks, early, n), first = in_order(k.blocks, 0, early);

    // S x, without contacts
    const Eigen::MatrixXd bare = Knot(60, 0, false, 5).dense;
    const Eigen::MatrixXd S = bare(late, late) - bare(late, first) * Eigen::MatrixXd(bare(first, first)).partialPivLu().solve(Eigen::MatrixXd(bare(first, late)));
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(S.rows(), -2, 5);
    Eigen::VectorXd r = Eigen::VectorXd::Zero(S.rows());
    k.blocks.take_product(x.data(), r.data());
    EXPECT_LT((r + S * x).norm(), 1e-11 * r.norm());

    // H^-1 b in three parts
    ASSERT_TRUE(k.blocks.factor());
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(k.dense.rows(), -1, 3);
    Eigen::VectorXd y = b(all);
    k.blocks.condense(y.data());
    k.blocks.solve_late(y.data() + 4 * early);
    k.blocks.solve_early(y.data());
    EXPECT_LT((k.dense(all, all) * y - b(all)).norm(), 1e-11 * b.norm());
  }
}

TEST(BandedBlocks, FourVectorsAtOnceAreSolvedForAsOneIs) {
  for (const bool symmetric : {true, false}) {
    Knot k(60, 9, symmetric, 5, true), by_twos(60, 9, symmetric, 5, true);
    by_twos.blocks.work_by_twos();
    ASSERT_TRUE(k.blocks.factor() && by_twos.blocks.factor());
    const Eigen::Index n = 4 * (k.blocks.blocks() - k.blocks.early());
    Eigen::Matrix<double, 4, Eigen::Dynamic> X = Eigen::Matrix<double, 4, Eigen::Dynamic>::Random(4, n), Y = X;
    const Eigen::MatrixXd B = X;
    k.blocks.solve_four_late(X.data()), by_twos.blocks.solve_four_late(Y.data());
    EXPECT_EQ(X, Y);
    for (int r = 0; r < 4; ++r) {
      Eigen::VectorXd x = B.row(r);
      k.blocks.solve_late(x.data());
      EXPECT_LT((X.row(r).transpose() - x).norm(), 1e-13 * x.norm()) << r;
    }
  }
}

TEST(BandedBlocks, SolveAsADenseMatrixDoes) {
  for (const bool symmetric : {true, false})
    for (const uint32_t contacts : {0u, 1u, 12u, 60u, 200u}) {
      Knot k(30, contacts, symmetric, contacts + 1);
      ASSERT_TRUE(k.blocks.factor()) << contacts;
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(k.dense.rows(), -1, 3);
      Eigen::VectorXd x = b;
      k.blocks.solve(x.data());
      EXPECT_LT((k.dense * x - b).norm(), 1e-11 * b.norm()) << symmetric << " " << contacts;
      EXPECT_EQ(k.blocks.negative_pivots(), 0u);
    }
}

// on machines without registers for four numbers the two-number variant is compared with itself
TEST(BandedBlocks, HaveTheSameBitsAtEveryWidthOfRegisters) {
  for (const bool symmetric : {true, false}) {
    Knot k(30, 60, symmetric, 7), by_twos(30, 60, symmetric, 7);
    by_twos.blocks.work_by_twos();
    ASSERT_TRUE(k.blocks.factor() && by_twos.blocks.factor());
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(k.dense.rows(), -1, 3);
    Eigen::VectorXd x = b, y = b;
    k.blocks.solve(x.data()), by_twos.blocks.solve(y.data());
    EXPECT_EQ(x, y) << symmetric;
  }
}

/// The stiffer matrix of a step is asked for alone, after the last step ended one level below: it is not the last one, stiffened.
TEST(BandedBlocks, AStifferMatrixIsThatOfItsStep) {
  constexpr int kNodes = 9, kLevel = 5;
  const auto bent = [](double bow, toolkit::RodState s) {
    for (int i = 0; i < kNodes; ++i) Eigen::Map<Vec3>(s.x + 3 * i) = Vec3(0.4e-3 * i, bow * i * i, 0);
  };
  toolkit::RodLoad load;
  load.h = 1e-3, load.gravity = {0, 0, -9.80665};
  const auto matrix = [&](bool after_another) {
    toolkit::Rod rod(toolkit::RodSection::round(22e-6, 2.5e9, 0.39, 1140), std::vector<double>(kNodes - 1, 0.4e-3));
    std::vector<double> numbers(toolkit::RodState::size(kNodes)), gradient(4 * kNodes);
    toolkit::RodState s(kNodes, numbers.data());
    toolkit::Band<10> band(4 * kNodes);
    bent(20e-6, s);
    rod.start(s);
    if (after_another) {
      rod.prepare(s, load);
      rod.linearise(s, load, kLevel - 1, band.column(0), gradient.data());
    }
    bent(25e-6, s);
    rod.prepare(s, load);
    band.set_zero();
    rod.linearise(s, load, kLevel, band.column(0), gradient.data());
    return std::vector<double>(band.column(0), band.column(4 * kNodes - 1));
  };
  EXPECT_EQ(matrix(true), matrix(false));
}

/// A thread of 61 nodes, a little bent, whose first segment three ties of 1e5 N/m hold to a body of 0.5 mg: what both weigh together is
/// a millionth of what ties them. Where halves of blocks that differ by rounding were both used, the solution was another one.
TEST(BandedBlocks, LoseNothingBesideTiesToALightBody) {
  constexpr int kNodes = 61, kUnknowns = 4 * (kNodes + 2);
  constexpr double kPiece = 0.5e-3, kWire = 11e-6, kTie = 1e5, per_hh = 1e6;
  toolkit::Rod rod(toolkit::RodSection::round(2 * kWire, 2.5e9, 0.39, 25000), std::vector<double>(kNodes - 1, kPiece));
  std::vector<double> numbers(toolkit::RodState::size(kNodes));
  toolkit::RodState s(kNodes, numbers.data());
  for (int i = 0; i < kNodes; ++i) {
    const double u = kPiece * (i - 0.5);
    Eigen::Map<Vec3>(s.x + 3 * i) = Vec3(u, 0.03 * u, -0.02 * u - u * u);
  }
  rod.start(s);
  toolkit::RodLoad load;
  load.h = 1e-3, load.gravity = {0, 0, -9.80665};
  rod.step(s, load, 6, 1e-12);  // no edge is stretched any more
  toolkit::Band<10> band(4 * kNodes);
  std::vector<double> gradient(4 * kNodes);
  rod.prepare(s, load);
  rod.linearise(s, load, 0, band.column(0), gradient.data());
  band.at(4 * kNodes - 1, 4 * kNodes - 1) = 1;

  std::vector<BandedBlocks::Pair> pairs{{kNodes, kNodes + 1}};
  for (uint32_t i = 0; i < kNodes; ++i)
    for (uint32_t k = 1; k < 3 && i + k < kNodes; ++k) pairs.push_back({i + k, i});
  for (const uint32_t i : {0u, 1u})
    for (const uint32_t k : {61u, 62u}) pairs.push_back({i, k});
  BandedBlocks H(kNodes + 2, 40 * (kNodes + 2));
  ASSERT_TRUE(H.analyse(kNodes + 2, pairs));
  H.set_zero(true);
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using Numbers = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  Matrix exact = Matrix::Zero(kUnknowns, kUnknowns);
  for (int j = 0; j < 4 * kNodes; ++j)
    for (int i = j; i < std::min(4 * kNodes, j + 11); ++i) exact(i, j) = exact(j, i) = band.at(i, j);
  for (uint32_t j = 0; j < kNodes; ++j)
    for (uint32_t i = j; i < std::min<uint32_t>(kNodes, j + 3); ++i)
      H.add(i, j, exact.block<4, 4>(4 * static_cast<int>(i), 4 * static_cast<int>(j)).cast<double>());
  const Vec3 inertia(3e-12, 1e-12, 3.5e-12), centre(-2.5e-3, 0.9e-3, 0);  // kg m2, m
  BandedBlocks::Block mass = BandedBlocks::Block::Identity(), turn = mass;
  for (int r = 0; r < 3; ++r) mass(r, r) = 4.84e-7 * per_hh, turn(r, r) = inertia[r] * per_hh;
  H.add(kNodes, kNodes, mass), H.add(kNodes + 1, kNodes + 1, turn);
  exact.block<4, 4>(4 * kNodes, 4 * kNodes) = mass.cast<long double>();
  exact.block<4, 4>(4 * kNodes + 4, 4 * kNodes + 4) = turn.cast<long double>();
  const auto tie = [&](const Vec3& p, double share, const Vec3& arm, const Vec3& stiffness) {
    const BlockPoint body = body_point(kNodes, p - centre), thread = thread_point(0, 0, share, s.edge(0).normalized(), arm);
    add_contact(H, body, thread, kTie * Mat3(stiffness.asDiagonal()), true);
    Eigen::Matrix<long double, 3, Eigen::Dynamic> J = Eigen::Matrix<long double, 3, Eigen::Dynamic>::Zero(3, kUnknowns);
    for (uint32_t k = 0; k < 2; ++k) {
      J.middleCols<4>(4 * static_cast<int>(body.block[k])) += body.J[k].cast<long double>();
      J.middleCols<4>(4 * static_cast<int>(thread.block[k])) -= thread.J[k].cast<long double>();
    }
    const Matrix DJ = (kTie * stiffness.cast<long double>()).asDiagonal() * J;
    exact += J.transpose() * DJ;
  };
  tie(Vec3::Zero(), 0.5, Vec3::Zero(), Vec3::Ones());
  tie(s.node(0), 0, Vec3::Zero(), Vec3(0, 1, 1));
  tie(kWire * Vec3::UnitY(), 0.5, kWire * Vec3::UnitY(), Vec3(0, 0, 1));

  ASSERT_TRUE(H.factor());
  const Eigen::PartialPivLU<Matrix> inverse(exact);
  for (const int pushed : {2, 4 * 40 + 1, 4 * kNodes + 2, 4 * kNodes + 4}) {
    const Numbers f = 1e-6L * Numbers::Unit(kUnknowns, pushed), x = inverse.solve(f);
    Eigen::VectorXd y = f.cast<double>();
    H.solve(y.data());
    EXPECT_LT((y.cast<long double>() - x).norm(), 1e-7L * x.norm()) << pushed;
    EXPECT_LT((exact * y.cast<long double>() - f).norm(), 1e-7L * f.norm()) << pushed;
  }
}

TEST(BandedBlocks, AThreadAloneFillsNothingIn) {
  Knot k(100, 0, true, 1);
  EXPECT_EQ(k.blocks.fill(), 99u + 98u + 1u);  // two neighbours each, and the body's own pair
}

TEST(BandedBlocks, TellAnIndefiniteSystem) {
  Knot k(30, 0, true, 1);
  BandedBlocks::Block M = BandedBlocks::Block::Zero();
  M(1, 1) = -1000;
  k.blocks.add(17, 17, M);
  EXPECT_FALSE(k.blocks.factor());
  Knot other(30, 0, false, 1);
  other.blocks.add(17, 17, M);
  EXPECT_TRUE(other.blocks.factor());
  EXPECT_EQ(other.blocks.negative_pivots() % 2, 1u);
}

TEST(BandedBlocks, SayWhenThereIsNoRoom) {
  BandedBlocks blocks(10, 12);
  std::vector<BandedBlocks::Pair> all;
  for (uint32_t i = 0; i < 10; ++i)
    for (uint32_t j = 0; j < i; ++j) all.push_back({i, j});
  EXPECT_FALSE(blocks.analyse(10, all));
  EXPECT_FALSE(blocks.analyse(11, {}));
  EXPECT_TRUE(blocks.analyse(10, {}));
}

}  // namespace banded_blocks_test
}  // namespace swage::dynamics
