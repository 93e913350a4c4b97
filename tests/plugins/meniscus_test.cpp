// SPDX-License-Identifier: Apache-2.0
//
// A thread on a wet plate: what the film holds, how it lets go, and that it is stable where an explicit force is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/coupling_meniscus/bridge.hpp"
#include "thread_scene.hpp"

namespace meniscus_test {

using namespace swage;
using coupling_meniscus::bridge;
using coupling_meniscus::elastocapillary_length;
using coupling_meniscus::work_of_adhesion;
using test::ThreadScene;

constexpr double kPi = std::numbers::pi, kRadius = 11e-6, kGamma = 0.072;
constexpr double kBending = 2.5e9 * kPi / 4 * kRadius * kRadius * kRadius * kRadius, kLine = 1140 * kPi * kRadius * kRadius;  // N m2, kg/m

// 2 pi r gamma: 4.98 uN, 59 times the weight of 20 mm; sqrt(B/w) = 2.4 mm, of which the other definition sqrt(B / (pi r gamma)) is sqrt 2 times as much
TEST(Meniscus, pull_and_elastocapillary_length) {
  const double w = work_of_adhesion(kRadius, kGamma, 0);
  EXPECT_NEAR(w, 4.98e-6, 0.005e-6);
  EXPECT_NEAR(w / (kLine * 20e-3 * 9.80665), 59, 0.6);
  EXPECT_NEAR(work_of_adhesion(kRadius, kGamma, kPi / 3), 0.5 * w, 1e-12);
  EXPECT_NEAR(elastocapillary_length(kBending, w), 2.4e-3, 0.01e-3);
  EXPECT_NEAR(std::sqrt(2.0) * elastocapillary_length(kBending, w), 3.4e-3, 0.01e-3);
}

// what it costs to lift a bridge out of the film is w l
TEST(Meniscus, work_of_a_bridge) {
  const double w = work_of_adhesion(kRadius, kGamma, 0), l = 0.4e-3, H = 0.1e-3;
  const auto b = bridge(w, l, H);
  double work = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) work += std::min(b.stiffness * (i + 0.5) * H / n, b.pull) * H / n;
  EXPECT_NEAR(work, w * l, 1e-6 * w * l);
}

std::string moist(const char* film, const char* rest = "") {
  return std::string(R"("environment": {"medium": "moist", "film": ")") + film + R"("}, )" + rest;
}

/// A thread of 10 mm on a plate that is turned over after a twentieth of a second, under 100 times its weight.
struct TurnedOver : ThreadScene {
  explicit TurnedOver(const std::string& top) : ThreadScene(R"({"name": "thread", "plugin": "swage.object.thread", "pose": {"p": [0, 0, "0.011 mm"]}, "params": {"length": "10 mm", "segments": 20}},
                   {"name": "plate", "plugin": "swage.object.solids", "pose": {"p": ["5 mm", 0, "-1 mm"]},
                    "params": {"form": "box", "fixed": true, "size": ["28 mm", "10 mm", "2 mm"]}})",
                R"({"plugin": "swage.coupling.contact", "between": ["thread", "plate"], "params": {"friction": 0.2, "stiffness": "1e4 N/m"}},
                   {"plugin": "swage.coupling.meniscus", "between": ["thread", "plate"]})",
                "", top) {
    if (!engine) return;
    run(50);
    rig->world.gravity = {0, 0, 100 * 9.80665};
    run(200);
  }
};

/// How far it fell.
double fallen(const std::string& top) {
  TurnedOver s(top);
  if (!s.engine) return HUGE_VAL;
  EXPECT_EQ(s.troubles(), "");
  double away = 0, fastest = 0;
  for (uint32_t i = 0; i < s.chain().vertices(); ++i) away = std::max(away, std::abs(s.chain().p(i).z()));
  for (uint32_t i = 0; i < s.chain().vertices(); ++i) fastest = std::max(fastest, s.chain().v(i).norm());
  return away < 1e-3 ? away + fastest : away;  // m, and m/s: at rest nothing moves
}

// film of 5 um to 1 mm, 200 to 5000 steps a second: the thread hangs in it, still. Under its weight 4.25e-4 N/m against w / H
TEST(Meniscus, holds_a_thread_at_every_rate_and_thickness) {
  for (const char* rate : {"200", "1000", "5000"})
    for (const char* film : {"5 um", "20 um", "100 um", "500 um", "1 mm"}) {
      const double way = fallen(moist(film, (R"("rate_hz": )" + std::string(rate) + ", ").c_str()));
      EXPECT_LT(way, 0.3e-3) << rate << " Hz, " << film;
    }
  EXPECT_GT(fallen(""), 1e-3) << "without a film it falls";
}

// at rest each bridge pulls as in the step before, and the solve starts there: a search direction and one that confirms it
TEST(Meniscus, a_thread_at_rest_is_solved_at_once) {
  TurnedOver s(moist("100 um"));
  ASSERT_TRUE(s.engine);
  const uint64_t before = s.engine->stats().newton;
  s.run(200);
  EXPECT_LT(static_cast<double>(s.engine->stats().newton - before) / 200, 2.5);
}

/// The greatest way of a node on the spring of a bridge that starts in its middle, each step with the force of its beginning.
double explicit_way(double film, double h) {
  const double l = 0.4e-3, m = kLine * l;
  const auto b = bridge(work_of_adhesion(kRadius, kGamma, 0), l, film);
  double x = 0.1 * coupling_meniscus::kRamp * film, v = 0, most = 0;
  for (int i = 0; i < 2000 && most < 1; ++i) {
    v -= h / m * b.stiffness * x;  // not bounded by the pull: within the film
    x += h * v;
    most = std::max(most, std::abs(x));
  }
  return most / film;
}

// symplectic Euler breaks where h > 2 sqrt(m/k), whatever the length of a bridge: at 28 us for 0.1 mm of film, at 1 ms below 3.6 mm
TEST(Meniscus, an_explicit_force_breaks_where_theory_says) {
  const double w = work_of_adhesion(kRadius, kGamma, 0), l = 0.4e-3;
  for (const double film : {20e-6, 100e-6, 1e-3}) {
    const double limit = 2 * std::sqrt(kLine * l / bridge(w, l, film).stiffness);
    EXPECT_LT(explicit_way(film, 0.98 * limit), 1) << film;
    EXPECT_GT(explicit_way(film, 1.02 * limit), 1e3) << film;
    EXPECT_LT(limit, 0.3e-3) << "no lesson has so short a step";
  }
}

}  // namespace meniscus_test
