// SPDX-License-Identifier: Apache-2.0
//
// The environment of a lesson: what the file says, what a thread, a needle and free bodies feel of it. Each number is a closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/environment.hpp"
#include "thread_scene.hpp"
#include "toolkit/fluid_drag.hpp"

namespace {

using namespace swage;
using test::ThreadScene;
using toolkit::RodFluid;
using toolkit::Vec3;

constexpr double kPi = std::numbers::pi, kG = 9.80665;
constexpr RodFluid kWater{998, 1.0e-3};
constexpr double kDiameter = 22e-6, kMass = 1140 * kPi * 11e-6 * 11e-6;  // m, kg/m of 10-0 nylon

std::string environment(const std::string& keys) { return R"("environment": {)" + keys + "}, "; }
const std::string kUnderWater = environment(R"("medium": "water")");

// --- the file

assembly::LessonFile read(const std::string& keys, base::Problems& problems) {
  assembly::LessonFile file;
  assembly::parse_lesson(R"({"format": "swage-lesson/1", "id": "test.environment", "title": "T", "objects": [], )" + environment(keys) +
                             R"("lesson": {"plugin": "swage.lesson.look"}})",
                         "", file, problems);
  return file;
}

TEST(EnvironmentFile, a_medium_and_what_differs_from_it) {
  base::Problems problems;
  const swage_environment dry = read(R"("medium": "dry", "charge": "0.5 nC/m", "earthed_plane": "-1 mm", "linear_damping": "2e-5 N*s/m")", problems).environment;
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(dry.medium, static_cast<uint32_t>(SWAGE_MEDIUM_DRY));
  EXPECT_DOUBLE_EQ(dry.charge, 0.5e-9);
  EXPECT_EQ(dry.grounded, 1u);
  EXPECT_DOUBLE_EQ(dry.ground_z, -1e-3);
  EXPECT_DOUBLE_EQ(dry.linear_damping, 2e-5);
  EXPECT_DOUBLE_EQ(dry.density, 1.2);
  const swage_environment moist = read(R"("medium": "moist", "film": "50 um")", problems).environment;
  EXPECT_DOUBLE_EQ(moist.surface_tension, 0.072);
  EXPECT_DOUBLE_EQ(moist.film, 50e-6);
  const swage_environment water = read(R"("medium": "water", "viscosity": "1.5 mPa*s")", problems).environment;
  EXPECT_DOUBLE_EQ(water.density, 998);
  EXPECT_DOUBLE_EQ(water.viscosity, 1.5e-3);
  EXPECT_EQ(water.grounded, 0u);
  EXPECT_TRUE(problems.empty());
}

TEST(EnvironmentFile, mistakes_are_told) {
  for (const char* wrong : {R"("medium": "oil")", R"("density": "1 kg/m3")", R"("medium": "dry", "charge": "1 mm")",
                            R"("medium": "dry", "charge": "1e-3 C/m")", R"("medium": "water", "charge": "0.5 nC/m")",
                            R"("medium": "dry", "viscocity": "1e-3 Pa*s")"}) {
    base::Problems problems;
    read(wrong, problems);
    EXPECT_EQ(problems.size(), 1u) << wrong;
  }
}

// --- fluid

constexpr char kThread[] = R"({"name": "thread", "plugin": "swage.object.thread", "params": {"length": "20 mm"}})";

// (rho_s - rho_f) A g / c, c Lamb's at that speed
TEST(Fluid, a_horizontal_thread_sinks_at_0_29_mm_s) {
  // 0.29 mm/s is that of water of 1000 kg/m3; 998 bears it less, 0.296
  ThreadScene water(kThread, "", "", environment(R"("medium": "water", "density": "1000 kg/m3")")), air(kThread, "");
  ASSERT_TRUE(water.engine && air.engine);
  water.run(100), air.run(100);
  const double v = -water.chain().v(16).z();
  EXPECT_NEAR(v, 0.29e-3, 0.02 * 0.29e-3);
  const double weight = (1140 - 1000) * kPi * 11e-6 * 11e-6 * kG;
  EXPECT_NEAR(v, weight / toolkit::rod_drag({1000, 1.0e-3}, kDiameter, v), 1e-3 * v);
  EXPECT_GT(-air.chain().v(16).z(), 100 * v) << "in air it falls";
}

/// Speed of body 0 of a scene with one object after so many steps of 1 ms.
double falls(const std::string& object, const std::string& top, int steps = 1000) {
  ThreadScene s(object, "", "", top);
  if (!s.engine) return 0;
  s.run(steps);
  EXPECT_EQ(s.troubles(), "");
  return -s.engine->world().V_WB[0].v.z;
}

// speed v of a weight F in the drag c(v): c v = F
template <class Drag>
double terminal(double F, const Drag& c) {
  double low = 0, high = 10;
  for (int i = 0; i < 200; ++i) {
    const double v = 0.5 * (low + high);
    (c(v) * v < F ? low : high) = v;
  }
  return low;
}

TEST(Fluid, a_straight_needle_sinks_as_a_cylinder) {
  constexpr double d = 0.1e-3;
  for (const char* level : {"rigid", "bending"}) {
    const std::string needle = R"({"name": "needle", "plugin": "swage.object.needle", "params": {"arc": "straight", "size_of": "length", "size": "5 mm",
        "wire_diameter": "100 um", "density": "7800 kg/m3", "level": ")" + std::string(level) + R"("}})";
    const double v = falls(needle, kUnderWater);
    const double expected = terminal((7800 - 998) * 0.25 * kPi * d * d * kG, [&](double u) { return toolkit::rod_drag(kWater, d, u); });
    EXPECT_NEAR(v, expected, 0.005 * expected) << level;
    EXPECT_NEAR(falls(needle, "", 100), 0.1 * kG, 1e-3) << level << ": a lesson without a medium has no fluid";
  }
}

TEST(Fluid, a_bead_sinks_as_stokes_and_schiller_and_naumann_say_and_a_light_one_rises) {
  constexpr double d = 0.3e-3;
  for (const double density : {1050.0, 900.0}) {
    const std::string bead = R"({"name": "bead", "plugin": "swage.object.solids", "params": {"form": "sphere", "diameter": "0.3 mm", "density": ")" +
                             std::to_string(density) + R"( kg/m3"}})";
    const double v = falls(bead, kUnderWater), weight = (density - 998) * kPi / 6 * d * d * d * kG;
    const double expected = std::copysign(terminal(std::abs(weight), [&](double u) { return toolkit::sphere_drag(kWater, d, u); }), weight);
    EXPECT_NEAR(v, expected, 1e-3 * std::abs(expected)) << density;
  }
  // a bead of 20 um has lost its speed within a hundredth of a step, and does not turn round
  const double v = falls(R"({"name": "bead", "plugin": "swage.object.solids", "params": {"form": "sphere", "diameter": "20 um", "density": "1050 kg/m3"}})",
                         kUnderWater);
  EXPECT_NEAR(v, 52 * 20e-6 * 20e-6 * kG / (18 * 1e-3), 0.01 * 11.3e-6);  // Stokes, Re = 2e-4
}

// --- damping (4.15, 4.16)

constexpr char kBall[] = R"({"name": "ball", "plugin": "swage.object.solids", "params": {"form": "sphere", "diameter": "1 mm", "density": "1000 kg/m3"}})";
constexpr double kBallMass = 1000 * kPi / 6 * 1e-9, kBallInertia = 0.4 * kBallMass * 0.25e-6;

std::string damped(double k_v, double k_w, const char* rest = "") {
  return environment(R"("medium": "dry", "density": 0, "viscosity": 0, "linear_damping": )" + std::to_string(k_v * 1e9) + R"(e-9, "angular_damping": )" +
                     std::to_string(k_w * 1e18) + "e-18") + rest;
}

// v = g T (1 - exp(-t/T)), T = m / k, at every step; w = w0 exp(-k t / I). A time of a tenth of a step is no trouble
TEST(Damping, falls_and_spins_as_the_exponential) {
  for (const double T : {20e-3, 2e-3, 0.1e-3}) {
    ThreadScene s(kBall, "", "", damped(kBallMass / T, kBallInertia / T));
    ASSERT_TRUE(s.engine);
    s.rig->world.V_WB[0].w = {1, 2, 3};
    double worst = 0, worst_spin = 0;
    for (int i = 1; i <= 60; ++i) {
      s.run(1);
      const double t = 1e-3 * i, v = -s.engine->world().V_WB[0].v.z, w = s.engine->world().V_WB[0].w.z;
      worst = std::max(worst, std::abs(v - kG * T * -std::expm1(-t / T)) / (kG * T));
      worst_spin = std::max(worst_spin, std::abs(w - 3 * std::exp(-t / T)) / 3);
    }
    EXPECT_LT(worst, 1e-6) << T;
    EXPECT_LT(worst_spin, 1e-6) << T;
  }
}

// on the floor it presses with its whole weight, however strong the damping; without damping it falls freely
TEST(Damping, does_not_bear_what_lies_still) {
  const std::string floor = R"(, {"name": "floor", "plugin": "swage.object.solids", "pose": {"p": [0, 0, "-1.5005 mm"]},
                               "params": {"form": "box", "fixed": true, "size": ["20 mm", "20 mm", "2 mm"]}})";
  ThreadScene s(kBall + floor, R"({"plugin": "swage.coupling.contact", "between": ["ball", "floor"]})", "", damped(kBallMass / 1e-3, 0));
  ASSERT_TRUE(s.engine);
  s.run(300);
  EXPECT_NEAR(s.signal("contact.force"), kBallMass * kG, 0.01 * kBallMass * kG);
  EXPECT_NEAR(falls(kBall, "", 100), 0.1 * kG, 1e-9);
}

// --- charge

// strands that begin a diameter apart, at the charge at which air breaks down: 2.8 mN/m would throw them 6 mm in a step
TEST(Charge, does_not_throw_close_strands_apart) {
  ThreadScene s(R"({"name": "thread", "plugin": "swage.object.thread",
      "params": {"length": "20 mm", "segments": 40, "start": "path", "path": "0 0 0, 10 0 0, 10 0.5 0, 0 0.03 0 mm"}})",
                "", "", environment(R"("medium": "dry", "charge": "1.83 nC/m")"));
  ASSERT_TRUE(s.engine);
  double fastest = 0, before = 30e-6;
  for (int i = 0; i < 200; ++i) {
    s.run(1);
    const double apart = (s.chain().p(0) - s.chain().p(39)).norm();
    fastest = std::max(fastest, apart / before);
    before = apart;
    ASSERT_LT(apart, 25e-3);
  }
  EXPECT_GT(before, 1e-3) << "they part";
  EXPECT_EQ(s.troubles(), "");
  EXPECT_EQ(s.signal("thread.passed"), 0);
}

}  // namespace
