// SPDX-License-Identifier: Apache-2.0
//
// One test for the laws of all constraints: where an energy is, the force is minus its gradient; the tangent is minus the derivative
// of the force. Contacts with Coulomb's and with held limits, ties and hinge drives, at random displacements on every piece of them.
#include "dynamics/constraint_law.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "base/rng.hpp"

namespace swage::dynamics {
namespace constraint_law_test {

/// A law of n coordinates as the test sees it, in units in which displacements and forces are about 1.
struct Law {
  using Point = std::array<double, 3>;
  using Matrix = std::array<Point, 3>;
  std::size_t n = 3;
  std::function<Point(const Point&)> force;
  std::function<Matrix(const Point&)> tangent;  // -d force[i] / d x[j]
  std::function<double(const Point&)> energy;   // empty: none
};

Law::Matrix matrix(const Tangent& D) { return {{{D.nn, 0, 0}, {D.n1, D.t11, D.t12}, {D.n2, D.t12, D.t22}}}; }

Law law_of(const Constraint& c, Friction friction, double limit) {
  const auto u = [](const Law::Point& x) { return Displacement{x[0], x[1], x[2]}; };
  const auto force = [=](const Law::Point& x) {
    double now = limit;
    const Force f = constraint_force(c, u(x), friction, now);
    return Law::Point{f.fn, f.f1, f.f2};
  };
  const auto tangent = [=](const Law::Point& x) {
    double now = limit;
    const Force f = constraint_force(c, u(x), friction, now);
    return matrix(constraint_tangent(c, u(x), f, friction, now));
  };
  Law law{3, force, tangent, {}};
  if (c.tie || friction == Friction::kTresca)
    law.energy = [=](const Law::Point& x) { return constraint_energy(c, u(x), limit); };
  return law;
}

Law law_of(const HingeDrive& drive) {
  return {1,
          [=](const Law::Point& x) {
            return Law::Point{drive.torque(x[0]), 0, 0};
          },
          [=](const Law::Point& x) {
            Law::Matrix D{};
            D[0][0] = drive.stiffness(x[0]);
            return D;
          },
          [=](const Law::Point& x) { return drive.energy(x[0]); }};
}

/// Whether differences over d find the law smooth at x: its tangent is the same on all sides.
bool smooth(const Law& law, const Law::Point& x, double d) {
  for (std::size_t k = 0; k < law.n; ++k) {
    Law::Point to = x, from = x;
    to[k] += 2 * d, from[k] -= 2 * d;
    const Law::Matrix a = law.tangent(to), b = law.tangent(from);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (std::abs(a[i][j] - b[i][j]) > 0.01) return false;
  }
  return true;
}

/// Checks derivatives at a point; false where the law has a kink.
bool check(const Law& law, const Law::Point& x) {
  constexpr double d = 1e-5, near = 1e-6;
  if (!smooth(law, x, d)) return false;
  const Law::Point f = law.force(x);
  const Law::Matrix D = law.tangent(x);
  for (std::size_t k = 0; k < law.n; ++k) {
    Law::Point to = x, from = x;
    to[k] += d, from[k] -= d;
    const Law::Point a = law.force(to), b = law.force(from);
    for (std::size_t i = 0; i < law.n; ++i) EXPECT_NEAR(-(a[i] - b[i]) / (2 * d), D[i][k], near) << i << " by " << k;
    if (law.energy) {
      EXPECT_NEAR(-(law.energy(to) - law.energy(from)) / (2 * d), f[k], near) << k;
    }
  }
  return true;
}

TEST(ConstraintLaw, EachIsTheDerivativeOfTheNext) {
  base::Xoshiro256 rng(5);
  uint32_t checked[4] = {}, loose = 0, slips = 0, sticks = 0;
  for (int i = 0; i < 4000; ++i) {
    const Law::Point x{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
    Constraint contact, tie;
    contact.surface = {rng.uniform(0.5, 2), rng.uniform(0.5, 2), rng.uniform(0, 1.5)};
    const TieLaw law{rng.uniform(0.5, 2), rng.uniform(0.5, 2), rng.uniform(0.5, 2), rng.uniform(0.5, 2),
                     rng.uniform(0.5, 2)};
    tie.tie = &law;
    HingeDrive drive;
    drive.t0 = rng.uniform(-1, 1), drive.kappa = rng.uniform(0.5, 2), drive.max = rng.uniform(0.5, 2);
    drive.low = -1, drive.high = 1, drive.stop = 3;
    checked[0] += check(law_of(contact, Friction::kCoulomb, 0), x);
    checked[1] += check(law_of(contact, Friction::kTresca, x[0] < 0 ? rng.uniform(0.1, 1) : 0.0), x);
    checked[2] += check(law_of(tie, Friction::kCoulomb, 0), x);
    checked[3] += check(law_of(drive), x);
    const Force f = coulomb(contact.surface, {x[0], x[1], x[2]});
    loose += f.fn == 0, slips += f.fn > 0 && f.slips, sticks += f.fn > 0 && !f.slips;
  }
  for (const uint32_t n : checked) EXPECT_GT(n, 3500u) << "points away from kinks";
  for (const uint32_t n : {loose, slips, sticks}) EXPECT_GT(n, 200u);
}

}  // namespace constraint_law_test
}  // namespace swage::dynamics
