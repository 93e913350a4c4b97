// SPDX-License-Identifier: Apache-2.0
//
// What surrounds a thread, fluid and charge, and its levels of detail: catenary and point masses.
#include "thread_bench.hpp"

namespace swage::thread {
namespace {

TEST(Thread, SinksInWater) {
  Bench b;
  b.bench.set("around", 2.0);
  b.start();
  for (int k = 0; k < 100; ++k) b.advance();
  // 0.29 mm/s in water of 1000 kg/m3; the lighter 998 bears it less
  EXPECT_NEAR(-b.velocity(10).z(), 0.294e-3, 0.02 * 0.294e-3);
}

// the same by the environment of the lesson, which `around` overrules
TEST(Thread, TakesTheFluidOfTheLesson) {
  for (const bool overruled : {false, true}) {
    Bench b;
    b.bench.host.environment = kStillAir;
    b.bench.host.environment.medium = SWAGE_MEDIUM_WATER;
    b.bench.host.environment.density = 998, b.bench.host.environment.viscosity = 1.0e-3;
    if (overruled) b.bench.set("around", 1.0);  // air
    b.start();
    for (int k = 0; k < 100; ++k) b.advance();
    if (overruled)
      EXPECT_GT(-b.velocity(10).z(), 30e-3);
    else
      EXPECT_NEAR(-b.velocity(10).z(), 0.294e-3, 0.02 * 0.294e-3);
  }
}

/// Speed of a node after one step of 0.1 ms without weight and fluid, at a charge [C/m]; `plane`: height of an earthed plane, 1: none.
Vec3 pushed(double charge, const std::string& path, int segments, uint32_t node, double plane = 1) {
  Bench b;
  b.h = 1e-4;
  swage_environment& e = b.bench.host.environment;
  e.medium = SWAGE_MEDIUM_DRY, e.density = e.viscosity = 0, e.charge = charge;
  if (plane < 1) e.grounded = 1, e.ground_z = plane;
  b.bench.set("level", 1.0);  // catenary: nothing bends straight
  b.bench.set("start", path.empty() ? 0.0 : 3.0);
  b.bench.set_text("path", path);
  b.bench.set("segments", segments);
  b.bench.set("length", 0.5e-3 * segments);
  b.start();
  b.bench.step.gravity = {0, 0, 0};
  b.advance();
  return b.velocity(node);
}
constexpr double kLine = 1140 * M_PI * 11e-6 * 11e-6, kVacuum = 8.8541878128e-12;  // kg/m, F/m

// two strands of 10 mm at 1 mm: q^2 / (2 pi e0 d) per length, less by what is missing beyond their ends, L/2 / sqrt(d^2 + L^2/4)
TEST(Thread, StrandsOfOneChargePushEachOther) {
  constexpr double q = 0.5e-9, d = 1e-3, L = 10e-3;
  const char* u = "0 0 0, 10 0 0, 10 1 0, 0 1 0 mm";
  const double v = pushed(q, u, 42, 10).y();
  const double f = q * q / (2 * M_PI * kVacuum * d) * (0.5 * L) / std::hypot(d, 0.5 * L);
  EXPECT_NEAR(v, -f / kLine * 1e-4, 0.01 * f / kLine * 1e-4);
  EXPECT_EQ(pushed(0, u, 42, 10).y(), 0);
  EXPECT_NEAR(f, 4.4e-6, 0.05e-6);  // N/m: about its weight
}

// an earthed plane at 1 mm: q^2 / (4 pi e0 h), towards it, whatever the sign of the charge; none without a plane
TEST(Thread, IsDrawnToAnEarthedPlane) {
  constexpr double h = 1e-3, L = 20e-3;
  for (const double q : {0.5e-9, -0.5e-9}) {
    const double f = q * q / (4 * M_PI * kVacuum * h) * (0.5 * L) / std::hypot(2 * h, 0.5 * L);
    EXPECT_NEAR(pushed(q, "", 40, 20, -h).z(), -f / kLine * 1e-4, 0.01 * f / kLine * 1e-4);
    EXPECT_NEAR(pushed(q, "", 40, 20).norm(), 0, 1e-4 * f / kLine * 1e-4);
  }
}

// what hangs past the edge of an earthed tray is beside it, not in it: nothing draws it, and its image draws nothing
TEST(Thread, BelowAnEarthedPlaneIsNotDrawn) {
  constexpr double q = 0.5e-9, h = 1e-3;
  const double drawn = pushed(q, "", 40, 20, -h).norm();
  EXPECT_LT(pushed(q, "", 40, 20, h).norm(), 1e-4 * drawn);
  // its middle crosses the plane: the images of the lower half would lie within the upper one and push it aside, with twice its weight
  const double crossing = pushed(q, "0 0 10, 0.02 0 -10 mm", 40, 19, 0).head<2>().norm();
  EXPECT_LT(crossing, 0.1 * drawn);
}

/// Sag of a thread of 20 mm between two ends that are fixed 16 mm apart.
double sag(int level, double density) {
  Bench b;
  b.bench.set("level", level);
  b.bench.set("first", 1.0);
  b.bench.set("last", 1.0);
  b.bench.set("segments", 40);
  b.bench.set("density", density);
  b.bench.set("start", 3.0);
  b.bench.set_text("path", "0 0 0, 8 0 -6, 16 0 0 mm");  // two legs of 10 mm
  b.start();
  for (int k = 0; k < 4000; ++k) b.advance();
  double lowest = 0;
  for (uint32_t i = 0; i <= 40; ++i) lowest = std::min(lowest, b.node(i).z());
  return -lowest;
}

// a catenary: 2 a sinh(8 mm / a) = 20 mm, sag a (cosh(8 mm / a) - 1). A rod of 10-0 is far stiffer than its weight bends
TEST(Thread, AChainHangsAsACatenary) {
  double low = 1e-3, high = 100e-3;
  for (int i = 0; i < 100; ++i) {
    const double a = 0.5 * (low + high);
    (2 * a * std::sinh(8e-3 / a) > 20e-3 ? low : high) = a;
  }
  const double expected = low * (std::cosh(8e-3 / low) - 1);
  EXPECT_NEAR(sag(1, 1140), expected, 2e-3 * expected);
  EXPECT_GT(std::abs(sag(2, 1140) - expected), 0.02 * expected);
}

// a thread that hangs from its first end is pulled there by its weight; explicit springs swing about that, a tenth of it without damping
TEST(Thread, EveryLevelBearsItsWeight) {
  for (int level = 0; level < 4; ++level) {
    Bench b;
    b.bench.set("level", level);
    b.bench.set("start", 1.0);
    b.bench.set("first", 1.0);
    b.bench.set("segments", 8);
    b.bench.set("young", 0.5e9);
    b.start();
    double mean = 0;
    for (int k = 0; k < 200; ++k) {
      b.advance();
      if (k >= 100) mean += b.signal("thread.tension_first") / 100;
    }
    const double weight = kLine * 20e-3 * 9.81;
    EXPECT_NEAR(mean, weight, (level == 0 ? 0.1 : 0.07) * weight) << level;  // the first half segment hangs on the end itself
    EXPECT_LT(b.signal("thread.parted"), 1);
  }
}

// a push on a place of the level `thesis` moves the nodes beside it by their masses
TEST(Thread, MassesAnswerByTheirMasses) {
  Bench b;
  b.bench.set("level", 0.0);
  b.bench.set("segments", 8);
  b.bench.set("young", 0.5e9);
  b.start();
  b.bench.step.gravity = {0, 0, 0};
  b.advance();
  b.touch(3);
  b.ask();
  const double m = kLine * 20e-3 / 8;
  EXPECT_NEAR(b.W[0], 0.5 / m, 1e-9 / m);  // two halves of halves
  Eigen::VectorXd j(3);
  j << 0, 0, 1e-9;
  const Vec3 before = b.middle(3);
  b.apply_impulses(j);
  EXPECT_NEAR((b.middle(3) - before).z(), b.h * (b.v_free[2] + b.W[8] * 1e-9), 1e-12);
}

}  // namespace
}  // namespace swage::thread
