// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "base/rng.hpp"

namespace swage::dynamics {
namespace contact_system_test {

constexpr int kConstraints = 12, kDrives = 2, kNumbers = 3 * kConstraints + kDrives;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// An island of random constraints. W is J J' of rank 20, as few bodies make it.
struct RandomSystem {
  explicit RandomSystem(uint64_t seed) : rng(seed), W(kNumbers, kNumbers), system(kConstraints, kDrives) {
    const RowMajor J = RowMajor::NullaryExpr(kNumbers, 20, [this] { return 30 * between(-1, 1); });
    W = J * J.transpose();
    for (int h = 0; h < kDrives; ++h) set_drive(h, 1);
    for (int i = 0; i < kConstraints; ++i) stick(i);
    system.begin(W.data(), kConstraints, kDrives);
  }
  double between(double low, double high) { return low + (high - low) * rng.uniform(); }
  Vec3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

  void stick(int i) {
    ContactSystem::Factors& f = system.of(static_cast<size_t>(i));
    f.rank = 3, f.spring = true;
    for (int a = 0; a < 3; ++a) f.R[a] = f.S[a] = 300 * Vec3::Unit(a);
  }
  /// As Coulomb's law slides: what pushes back along the normal drags along, so S is not R.
  void slide(int i) {
    ContactSystem::Factors& f = system.of(static_cast<size_t>(i));
    f.rank = 2, f.spring = false;
    f.R[0] = f.S[0] = 300 * Vec3::UnitX();
    f.S[0] += 60 * vector();
    f.R[1] = f.S[1] = between(1, 30) * vector();
  }
  void open(int i) { system.of(static_cast<size_t>(i)).rank = 0; }
  void set_drive(int h, double stiffness) {
    ContactSystem::Factors& f = system.of(static_cast<size_t>(kConstraints + h));
    f.rank = stiffness > 0 ? 1 : 0, f.spring = true;
    f.R[0] = f.S[0] = {std::sqrt(stiffness), 0, 0};
  }
  void change_some() {
    for (int i = 0; i < kConstraints; ++i) {
      const double draw = rng.uniform();
      if (draw < 0.1) stick(i);
      if (draw > 0.1 && draw < 0.3) slide(i);
      if (draw > 0.3 && draw < 0.4) open(i);
    }
    if (rng.uniform() < 0.3) set_drive(rng.uniform() < 0.5 ? 0 : 1, rng.uniform() < 0.5 ? 0 : 2);
  }
  /// D = S R' of all.
  RowMajor D() {
    RowMajor D = RowMajor::Zero(kNumbers, kNumbers);
    for (int i = 0; i < kConstraints + kDrives; ++i) {
      const ContactSystem::Factors& f = system.of(static_cast<size_t>(i));
      const bool drive = i >= kConstraints;
      const int at = drive ? 2 * kConstraints + i : 3 * i, n = drive ? 1 : 3;
      for (uint32_t a = 0; a < f.rank; ++a) D.block(at, at, n, n) += f.S[a].head(n) * f.R[a].head(n).transpose();
    }
    return D;
  }

  base::Xoshiro256 rng;
  RowMajor W;
  ContactSystem system;
};

// y = -D (1 + W D)^-1 b: the same as the dense whole, whatever was kept of the directions before
TEST(ContactSystem, SolvesWhatTheWholeSolves) {
  int inside_out = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    RandomSystem random(seed);
    for (int direction = 0; direction < 12; ++direction) {
      const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(kNumbers, [&random] { return random.between(-1, 1); });
      Eigen::VectorXd y = Eigen::VectorXd::Zero(kNumbers);
      ASSERT_TRUE(random.system.factor());
      random.system.solve(b.data(), y.data());
      const RowMajor D = random.D(), whole = RowMajor::Identity(kNumbers, kNumbers) + random.W * D;
      const Eigen::VectorXd v = b + random.W * y;
      const double scale = (D.cwiseAbs() * v.cwiseAbs()).maxCoeff() + y.cwiseAbs().maxCoeff();
      EXPECT_LT((y + D * v).cwiseAbs().maxCoeff(), 1e-6 * scale) << seed << " " << direction;
      EXPECT_EQ(random.system.sign(), whole.determinant() > 0 ? 1 : -1) << seed << " " << direction;
      inside_out += random.system.sign() < 0;
      random.change_some();
    }
  }
  EXPECT_GT(inside_out, 10);
}

TEST(ContactSystem, SaysWhereItIsSingular) {
  ContactSystem system(1, 0);
  RowMajor W = RowMajor::Identity(3, 3);
  system.begin(W.data(), 1, 0);
  ContactSystem::Factors& f = system.of(0);
  f.rank = 1, f.R[0] = Vec3::UnitX(), f.S[0] = -Vec3::UnitX();  // 1 - 1
  EXPECT_FALSE(system.factor());
  W(0, 0) = NAN;
  f.spring = true, f.S[0] = f.R[0];
  system.begin(W.data(), 1, 0);
  EXPECT_FALSE(system.factor());
}

TEST(ContactSystem, WithNothingThatPushesBackLeavesTheForcesAsTheyAre) {
  ContactSystem system(1, 1);
  RowMajor W = RowMajor::Identity(4, 4);
  system.begin(W.data(), 1, 1);
  const double b[4] = {1, 2, 3, 4};
  double y[4] = {5, 6, 7, 8};
  ASSERT_TRUE(system.factor());
  system.solve(b, y);
  EXPECT_EQ(system.sign(), 1);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(y[i], 5 + i);
}

}  // namespace contact_system_test
}  // namespace swage::dynamics
