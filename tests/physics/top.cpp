// SPDX-License-Identifier: Apache-2.0
//
// Torque-free tops against their closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "dynamics/free_motion.hpp"

namespace swage::dynamics {
namespace top_test {

constexpr double kStep = 1e-3;  // s

RigidState spun(const Vec3& w) { return {Vec3::Zero(), Quat::Identity(), Vec3::Zero(), w}; }
Vec3 body_rate(const RigidState& s) { return s.q_WB.conjugate() * s.w_W; }

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean (Abramowitz, Stegun 17.6): K = pi / 2 M.
double complete_elliptic(double k2) {
  double a = 1, b = std::sqrt(1 - k2);
  for (int i = 0; i < 40 && std::abs(a - b) > 1e-16 * a; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 0.5 * std::numbers::pi / a;
}

// Equal moments across (Landau, Lifshitz, Mechanics, section 33): in the body w turns about the axis with (I3 - I1) / I1 w3, in
// the world the axis turns about L with |L| / I1, at the constant angle atan(I1 w1 / I3 w3) to it.
TEST(SymmetricTop, PrecessesAsItsClosedForm) {
  const Vec3 I(1e-12, 1e-12, 0.5e-12), w0(1, 0, 10);
  const RigidMass m(4e-7, I);
  const Vec3 L = I.cwiseProduct(w0);
  EXPECT_NEAR(L.norm() / I.x(), 5.0990195, 1e-7);
  RigidState s = spun(w0);
  for (int n = 1; n <= 60000; ++n) {
    move_free(FreeMotion::kElliptic, m, Vec3::Zero(), Vec3::Zero(), kStep, s);
    if (n % 6000) continue;
    const double t = n * kStep, in_body = 5 * t;
    const Vec3 expected(std::cos(in_body), -std::sin(in_body), 10);
    EXPECT_LT((body_rate(s) - expected).norm(), 1e-8) << t;
    // the axis of the body about L
    const Vec3 axis = s.q_WB * Vec3::UnitZ(), l = L.normalized();
    const Vec3 start = Vec3::UnitZ() - l.z() * l;
    const double turned = L.norm() / I.x() * t;
    const Vec3 turned_axis = l.z() * l + std::cos(turned) * start + std::sin(turned) * l.cross(start);
    EXPECT_LT((axis - turned_axis).norm(), 1e-8) << t;
  }
}

// A straight needle, moments 2710 : 1, about its own wire and tumbling.
TEST(SymmetricTop, AWireKeepsItsMomentum) {
  const Vec3 I(1.34036e-12, 4.9450e-16, 1.34036e-12);
  const RigidMass m(4e-7, I);
  for (const Vec3& w0 : {Vec3(0, 5000, 1), Vec3(30, 100, -20)}) {
    RigidState s = spun(w0);
    const Vec3 L = I.cwiseProduct(w0);
    for (int n = 0; n < 10000; ++n) move_free(FreeMotion::kElliptic, m, Vec3::Zero(), Vec3::Zero(), kStep, s);
    const Vec3 w = body_rate(s);
    EXPECT_LT((s.q_WB * I.cwiseProduct(w) - L).norm(), 1e-10 * L.norm());
    EXPECT_NEAR(w.dot(I.cwiseProduct(w)) / w0.dot(L), 1, 1e-10);
  }
}

// Three moments (Landau, Lifshitz, section 37), I1 < I2 < I3 and L^2 > 2 E I2: the middle rate repeats after
//   T = 4 K(k) sqrt(I1 I2 I3 / ((I3 - I2) (L^2 - 2 E I1))),  k^2 = (I2 - I1) (2 E I3 - L^2) / ((I3 - I2) (L^2 - 2 E I1))
// The start, almost about the middle axis, is the hardest: k^2 = 0.9998.
double period(const Vec3& I, const Vec3& w) {
  const double E2 = w.dot(I.cwiseProduct(w)), L2 = I.cwiseProduct(w).squaredNorm();
  const double below = (I[2] - I[1]) * (L2 - E2 * I[0]);
  return 4 * complete_elliptic((I[1] - I[0]) * (E2 * I[2] - L2) / below) *
         std::sqrt(I[0] * I[1] * I[2] / below);
}

struct Flips {
  double period = 0, energy = 0;
};
Flips flips(FreeMotion method, double spin, double seconds) {
  const Vec3 I(1e-12, 2e-12, 3e-12), w0 = spin * Vec3(0.01, 1, 0.01).normalized();
  const RigidMass m(4e-7, I);
  RigidState s = spun(w0);
  const double E = w0.dot(I.cwiseProduct(w0));
  Flips r;
  std::vector<double> crossing;
  double before = w0.y();
  for (int n = 1; n <= static_cast<int>(seconds / kStep); ++n) {
    move_free(method, m, Vec3::Zero(), Vec3::Zero(), kStep, s);
    const Vec3 w = body_rate(s);
    r.energy = std::max(r.energy, std::abs(w.dot(I.cwiseProduct(w)) / E - 1));
    if (before * w.y() < 0) crossing.push_back((n - 1 + before / (before - w.y())) * kStep);
    before = w.y();
  }
  if (crossing.size() > 2)
    r.period = 2 * (crossing.back() - crossing.front()) / static_cast<double>(crossing.size() - 1);
  return r;
}

TEST(AsymmetricTop, FlipsInItsPeriod) {
  const Vec3 I(1e-12, 2e-12, 3e-12), one = Vec3(0.01, 1, 0.01).normalized();
  EXPECT_NEAR(period(I, 10 * one), 3.910964458, 1e-8);  // an independent evaluation
  for (const double spin : {10.0, 30.0, 100.0}) {
    const Flips r = flips(FreeMotion::kElliptic, spin, 60);
    const double exact = period(I, spin * one);
    EXPECT_NEAR(r.period / exact, 1, 1e-6) << spin;
    EXPECT_LT(r.energy, 1e-11) << spin;
  }
}

// explicit Euler, as the thesis has it, spins up until nothing is left of the motion: the check can fail
TEST(AsymmetricTop, ExplicitEulerDoesNot) {
  const Flips r = flips(FreeMotion::kThesis, 100, 10);
  const double exact = period(Vec3(1e-12, 2e-12, 3e-12), 100 * Vec3(0.01, 1, 0.01).normalized());
  EXPECT_GT(std::abs(r.period / exact - 1), 1e-2);
  EXPECT_GT(r.energy, 1e-2);
}

}  // namespace top_test
}  // namespace swage::dynamics
