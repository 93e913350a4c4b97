// SPDX-License-Identifier: Apache-2.0
//
// What surrounds a thread, in formulas: Lamb's drag, the water that goes along, fields of charges, the drag of rigid bodies, and the
// explicit springs of the level `thesis`. Each against a closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "plugins/thread/masses.hpp"
#include "toolkit/fluid_drag.hpp"
#include "toolkit/line_charge.hpp"
#include "toolkit/rod.hpp"

namespace swage::toolkit {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr RodFluid kAir{1.2, 1.8e-5}, kWater{998, 1.0e-3}, kWaterCarried{998, 1.0e-3, 998};
constexpr double kDiameter = 22e-6, kMass = 1140 * kPi * 11e-6 * 11e-6;  // m, kg/m of 10-0 nylon

// Lamb: 4 pi mu / (1/2 - gamma - ln(Re/8)) at 10 mm/s
TEST(Fluid, drag_of_a_thread) {
  EXPECT_NEAR(rod_drag(kAir, kDiameter, 10e-3), 3.6e-5, 0.02 * 3.6e-5);
  EXPECT_NEAR(rod_drag(kWater, kDiameter, 10e-3), 3.57e-3, 0.01 * 3.57e-3);
}

// a viscosity that is rounded to nothing makes the Reynolds number infinite, and the drag stays that of inertia or less
TEST(Fluid, drag_without_viscosity_is_bounded) {
  for (const double viscosity : {1e-12, 1e-100, 1e-310, 5e-324}) {
    const double inertia = 0.5 * 1000 * kDiameter * 10e-3 * 1.11 * 1.01;  // C_D = 1.11 far beyond the drag crisis, which the law leaves out
    EXPECT_LE(rod_drag({1000, viscosity}, kDiameter, 10e-3), inertia) << viscosity;
    EXPECT_GE(rod_drag({1000, viscosity}, kDiameter, 10e-3), 0) << viscosity;
    EXPECT_TRUE(std::isfinite(sphere_drag({1000, viscosity}, kDiameter, 10e-3))) << viscosity;
  }
}

/// Rate at which a thread at 10 mm/s broadside loses its speed [1/s].
double slowing(const RodFluid& fluid) {
  constexpr double h = 1e-6, v = 10e-3;
  const std::vector<double> rest(10, 1e-3);
  Rod rod(RodSection::round(kDiameter, 2.5e9, 0.39, 1140), rest);
  std::vector<double> numbers(RodState::size(11));
  RodState s(11, numbers.data());
  for (int i = 0; i <= 10; ++i) s.x[3 * i] = 1e-3 * i;
  rod.start(s);
  for (int i = 0; i <= 10; ++i) s.v[3 * i + 2] = v;
  RodLoad load;
  load.h = h;
  load.fluid = fluid;
  EXPECT_TRUE(rod.step(s, load, 8, 1e-15).settled);
  return (v / s.velocity(5).z() - 1) / h;  // backward Euler: v0 / v1 = 1 + rate h
}

// its own mass and the water that goes along, over Lamb's drag: 0.23 ms; without that water 0.12 ms
TEST(Fluid, a_thread_in_water_stops_within_a_quarter_of_a_millisecond) {
  const double c = rod_drag(kWater, kDiameter, 10e-3), carried = 998 * kPi * 11e-6 * 11e-6;
  EXPECT_NEAR((kMass + carried) / c, 0.23e-3, 0.005e-3);
  EXPECT_NEAR(1 / slowing(kWaterCarried), (kMass + carried) / c, 1e-3 * 0.23e-3);
  EXPECT_NEAR(1 / slowing(kWater), kMass / c, 1e-3 * 0.12e-3);
}

// E = q / (2 pi e0 d) beside a long thread, and that of two equal rods end to end and side by side (Griffiths, ex. 2.2)
TEST(Charge, field_of_a_straight_piece) {
  constexpr double q = 0.5e-9, d = 1e-3;
  const Vec3 a(-1, 0, 0), b(1, 0, 0);
  const double far = q / (2 * kPi * kVacuumPermittivity * d);
  EXPECT_NEAR(charged_piece_field(a, b, q, {0, d, 0}, 1e-6).y(), far, 1e-5 * far);
  EXPECT_NEAR(q * far, 4.5e-6, 0.01 * 4.5e-6);  // N/m: about its weight, 4.25 uN/m
  constexpr double L = 4e-3;
  const Vec3 E = charged_piece_field({0, 0, 0}, {L, 0, 0}, q, {L + d, 0, 0}, 1e-6);
  EXPECT_NEAR(E.x(), q / (4 * kPi * kVacuumPermittivity) * (1 / d - 1 / (L + d)), 1e-9 * E.x());
  // cut into pieces it is the same
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 8; ++i) sum += charged_piece_field({L * i / 8, 0, 0}, {L * (i + 1) / 8, 0, 0}, q, {0.3 * L, d, 0}, 1e-6);
  EXPECT_LT((sum - charged_piece_field({0, 0, 0}, {L, 0, 0}, q, {0.3 * L, d, 0}, 1e-6)).norm(), 1e-9 * sum.norm());
}


/// A ball of 1 mm and 0.52 mg in the drag of the fluid, by itself.
RigidMotion ball(double h, double force, RigidMotion V, const RodFluid& fluid, int steps) {
  constexpr double d = 1e-3, m = 1000 * kPi / 6 * d * d * d;
  const Mat3 I = 0.1 * m * d * d * Mat3::Identity();
  for (int i = 0; i < steps; ++i) {
    FluidDrag drag(fluid, V);
    drag.add_sphere(d);
    const RigidMotion after = drag.after(m, I, {0, 0, force}, h);
    const auto F = drag.force(after);
    // as a host integrates it
    V.v += h / m * (Vec3(0, 0, force) + F.head<3>()), V.w += h * (I.inverse() * F.tail<3>());
    EXPECT_LT((V.v - after.v).norm(), 1e-12 * after.v.norm() + 1e-18);
  }
  return V;
}

// Stokes: 3 pi mu d v = F in the end, whatever the step; pi mu d^3 against spin. In a fluid of 1 Pa s a step of 1 ms is 18 times m/c
TEST(FluidDrag, a_ball_in_a_thick_fluid_is_stable_and_ends_as_stokes_says) {
  constexpr RodFluid thick{1e-6, 1.0};
  constexpr double d = 1e-3, F = 5e-6;
  for (const double h : {1e-5, 1e-3, 1e-1}) {
    const RigidMotion V = ball(h, F, {{0, 0, 1}, {0, 0, 1}}, thick, 200);
    EXPECT_NEAR(V.v.z(), F / (3 * kPi * d), 1e-6 * F / (3 * kPi * d) + (h < 1e-4 ? 1e-4 : 0)) << h;
    EXPECT_GT(V.w.z(), -1e-15) << "it does not turn round";
  }
  // slowly: I w' = -pi mu d^3 w
  constexpr double m = 1000 * kPi / 6 * d * d * d, T = 0.1 * m * d * d / (kPi * d * d * d);
  EXPECT_NEAR(ball(T / 1000, 0, {{}, {0, 0, 1}}, thick, 1000).w.z(), std::exp(-1.0), 1e-3);
}

// across itself a rod bears twice as much as along, and a couple that turns it about its middle c L^3 / 12
TEST(FluidDrag, a_rod_across_along_and_about_its_middle) {
  constexpr double L = 5e-3, d = 0.1e-3;
  constexpr int n = 40;
  const auto of = [&](const RigidMotion& V) {
    FluidDrag drag(kWater, {});  // the coefficient of rest, the same everywhere
    for (int i = 0; i < n; ++i) drag.add_piece({((i + 0.5) / n - 0.5) * L, 0, 0}, Vec3::UnitX(), L / n, d);
    return drag.force(V);
  };
  const double c = rod_drag(kWater, d, 0);
  EXPECT_NEAR(of({{0, 1, 0}, {}})[1], -c * L, 1e-9 * c * L);
  EXPECT_NEAR(of({{1, 0, 0}, {}})[0], -0.5 * c * L, 1e-9 * c * L);
  EXPECT_NEAR(of({{}, {1, 0, 0}})[3], -4 * kPi * 1.0e-3 * 0.25 * d * d * L, 1e-20);
  EXPECT_NEAR(of({{}, {0, 0, 1}})[5], -c * L * L * L / 12, 1e-3 * c * L * L * L / 12);
}

/// The greatest stretch that a little disturbance of a chain of 20 pieces grows to, in 5000 explicit steps.
double stretch(const thread::Springs& springs, double dt) {
  constexpr int n = 21;
  std::vector<double> x(3 * n), v(3 * n), room(3 * n);
  for (int i = 0; i < n; ++i) x[static_cast<size_t>(3 * i)] = springs.rest * i;
  x[31] = 1e-9, x[30] += 1e-9;
  double most = 0;
  for (int k = 0; k < 5000 && most < 1; ++k) {
    thread::explicit_step(springs, n, x.data(), v.data(), dt, Vec3::Zero(), 1, {}, {}, room.data(), [](int) { return false; }, [](int) { return true; });
    for (size_t j = 0; j + 1 < n; ++j) most = std::max(most, std::abs((x[3 * j + 3] - x[3 * j]) / springs.rest - 1));
  }
  return most;
}

// dt < 2 / w of the fastest mode, w = 2 sqrt(k/m): neighbours against each other. 0.42 us for the 0.625 mm of 118
TEST(Springs, an_explicit_step_breaks_where_theory_says) {
  for (const double l : {0.1e-3, 0.625e-3, 2e-3}) {
    const thread::Springs springs(RodSection::round(kDiameter, 2.5e9, 0.39, 1140), l);
    EXPECT_NEAR(springs.limit(), l * std::sqrt(1140 / 2.5e9), 1e-9 * springs.limit());  // the speed of sound of nylon
    EXPECT_LT(stretch(springs, 0.99 * springs.limit()), 1e-4) << l;
    EXPECT_GT(stretch(springs, 1.01 * springs.limit()), 0.1) << l;
    EXPECT_LT(1e-3 / springs.parts(1e-3), springs.limit());
  }
}

// a bob on one piece, and what the chain keeps: momentum always, energy on average (symplectic)
TEST(Springs, keep_momentum_and_energy) {
  const thread::Springs springs(RodSection::round(kDiameter, 2.5e9, 0.39, 1140), 1e-3);
  constexpr int n = 6;
  std::vector<double> x(3 * n), v(3 * n), room(3 * n);
  for (int i = 0; i < n; ++i) x[static_cast<size_t>(3 * i)] = 1e-3 * i, v[static_cast<size_t>(3 * i)] = i % 2 != 0 ? 0.1 : -0.1;
  const auto energy = [&] {
    double E = 0;
    for (size_t i = 0; i < n; ++i)
      E += 0.5 * (i == 0 || i == n - 1 ? 0.5 : 1) * springs.mass * Eigen::Map<const Vec3>(v.data() + 3 * i).squaredNorm();
    for (size_t j = 0; j + 1 < n; ++j) E += 0.5 * springs.stiffness * std::pow(x[3 * j + 3] - x[3 * j] - springs.rest, 2);
    return E;
  };
  const double begun = energy();
  double least = begun, most = begun;
  for (int k = 0; k < 100000; ++k) {
    thread::explicit_step(springs, n, x.data(), v.data(), 0.05 * springs.limit(), Vec3::Zero(), 1, {}, {}, room.data(), [](int) { return false; }, [](int) { return true; });
    least = std::min(least, energy()), most = std::max(most, energy());
  }
  // the energy that symplectic Euler keeps differs from this one by w dt / 2 = 5 % of it at most, to and fro
  EXPECT_GT(least, 0.9 * begun);
  EXPECT_LT(most, 1.1 * begun);
  double p = 0;
  for (size_t i = 0; i < n; ++i) p += (i == 0 || i == n - 1 ? 0.5 : 1) * springs.mass * v[3 * i];
  EXPECT_NEAR(p, 0, 1e-9 * springs.mass * 0.1);
}

}  // namespace
}  // namespace swage::toolkit
