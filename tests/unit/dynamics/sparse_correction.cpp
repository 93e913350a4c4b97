// SPDX-License-Identifier: Apache-2.0
//
// Directions after changes of a few tangents compared with those of a dense matrix that has the changed tangents.
#include "dynamics/sparse_correction.hpp"

#include <gtest/gtest.h>

#include "random_system.hpp"

namespace swage::dynamics {
namespace {

using banded_blocks_test::Knot;
using toolkit::Mat3;

/// A factored system, its contacts as the correction wants them, and the same as a dense matrix in the order of elimination.
struct Corrected {
  explicit Corrected(bool symmetric, unsigned seed = 5)
      : k(60, 9, symmetric, seed, true), correction(4 * size_t{k.blocks.blocks()}), dense(k.dense) {
    EXPECT_TRUE(k.blocks.factor());
    for (const Knot::Contact& c : k.all) contacts.emplace_back(k.blocks, c.a, c.b).begin_late(k.blocks.early());
    const uint32_t n = k.blocks.blocks(), early = k.blocks.early();
    size = size_t{4} * (n - early);
    late.resize(size);
    for (uint32_t block = 0; block < n; ++block)
      for (uint32_t r = 0; k.blocks.place_of(block) >= early && r < 4; ++r)
        late[4 * (k.blocks.place_of(block) - early) + r] = static_cast<int>(4 * block + r);
  }
  /// Changes the tangent of a contact by E; `since`: by how much it has changed since the system was factored. False: solve() would not.
  bool change(uint32_t contact, const Mat3& E, const Mat3& since) {
    dense += k.rows(k.all[contact]).transpose() * E * k.rows(k.all[contact]);
    double rows[3][3];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) rows[r][c] = since(r, c);
    // forces on late unknowns alone: H^-1 b of these is that of the whole system
    b = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(size), -1, 3), x = b;
    return correction.solve(k.blocks, contacts, contact, rows, x.data(), size);
  }
  /// How far x is from the solution of the dense system, over its length.
  double off() const {
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(dense.rows());
    whole(late) = b;
    const Eigen::VectorXd exact = Eigen::VectorXd(dense.partialPivLu().solve(whole))(late);
    return (x - exact).norm() / exact.norm();
  }
  /// Sign of det H.
  int sign() const { return correction.sign() * (k.blocks.negative_pivots() % 2 == 0 ? 1 : -1); }

  Knot k;
  std::vector<BlockContact> contacts;
  SparseCorrection correction;
  Eigen::MatrixXd dense;
  std::vector<int> late;
  size_t size = 0;
  Eigen::VectorXd b, x;
};

Mat3 slip() {
  Mat3 D = 0.5 * Mat3::Identity();
  D(1, 0) = -0.7, D(2, 0) = 0.4, D(1, 2) = D(2, 1) = 0.2;
  return D;
}

TEST(SparseCorrection, SolvesAsASystemWithTheChangedTangentsDoes) {
  for (const bool symmetric : {true, false}) {
    Corrected c(symmetric);
    for (const uint32_t contact : {0u, 3u, 4u, 8u}) {
      ASSERT_TRUE(c.change(contact, slip(), slip())) << contact;
      EXPECT_LT(c.off(), 1e-11) << contact;
    }
    // one that changes again, and one that opens
    ASSERT_TRUE(c.change(3, slip(), 2 * slip()));
    EXPECT_LT(c.off(), 1e-11);
    ASSERT_TRUE(c.change(8, -c.k.all[8].D - slip(), -c.k.all[8].D));
    EXPECT_LT(c.off(), 1e-10);
  }
}

TEST(SparseCorrection, SaysWhenThereAreTooManyAndBeginsAnew) {
  Corrected c(true);
  for (uint32_t contact = 0; contact < SparseCorrection::kMost; ++contact) ASSERT_TRUE(c.change(contact, slip(), slip()));
  EXPECT_FALSE(c.change(SparseCorrection::kMost, slip(), slip()));
  Corrected other(true);
  ASSERT_TRUE(other.change(1, slip(), slip()));
  other.correction.clear();
  other.dense = other.k.dense;
  ASSERT_TRUE(other.change(2, slip(), slip()));
  EXPECT_LT(other.off(), 1e-11);
}

/// A tangent below zero makes det H change its sign, and a second one takes it back.
TEST(SparseCorrection, KnowsTheSignOfTheDeterminant) {
  int signs[2] = {};
  for (const double stiffness : {-30.0, -100.0, -1000.0, 3.0}) {
    Corrected c(true);
    Mat3 E = Mat3::Zero();
    E(1, 1) = stiffness;
    for (const uint32_t contact : {2u, 6u}) {
      ASSERT_TRUE(c.change(contact, E, E));
      const Eigen::PartialPivLU<Eigen::MatrixXd> exact(c.dense);
      const int sign = exact.determinant() > 0 ? 1 : -1;
      EXPECT_EQ(c.sign(), sign) << stiffness << " " << contact;
      ++signs[sign > 0];
    }
  }
  EXPECT_GT(signs[0], 0);
  EXPECT_GT(signs[1], 0);
}

}  // namespace
}  // namespace swage::dynamics
