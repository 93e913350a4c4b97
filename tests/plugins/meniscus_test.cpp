// SPDX-License-Identifier: Apache-2.0
//
// A thread on a wet plate: what the film holds, how it lets go, and that it is stable where an explicit force is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "plugins/coupling_meniscus/bridge.hpp"
#include "thread_scene.hpp"

namespace {

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

/// A thread of 20 mm along x on a plate that ends at x = 14 mm, taken at 17 mm and lifted by 2 mm within 4 s.
ThreadScene lifted(const std::string& top, const std::string& tag) {
  const std::string hand = ::testing::TempDir() + "meniscus_hand_" + tag + ".json";
  std::ofstream(hand) << R"({"format": "swage-hand/1", "title": "Lifts", "keys": [
      {"t": "0 s", "p": ["17 mm", "-1 mm", "0.011 mm"], "axis": [0, 1, 0], "closing": [0, 0, 1], "closure": 0.4},
      {"t": "0.5 s", "closure": 0.4}, {"t": "0.8 s", "closure": 0.62}, {"t": "1 s"}, {"t": "5 s", "p": ["17 mm", "-1 mm", "2.011 mm"]}]})";
  return ThreadScene(
      R"({"name": "thread", "plugin": "swage.object.thread", "pose": {"p": [0, 0, "0.011 mm"]}, "params": {"length": "20 mm", "segments": 100}},
         {"name": "plate", "plugin": "swage.object.solids", "pose": {"p": [0, 0, "-1 mm"]},
          "params": {"form": "box", "fixed": true, "size": ["28 mm", "10 mm", "2 mm"]}},
         {"name": "holder", "plugin": "swage.object.jaws", "follows": {"pose": "hand", "closure": "hand"},
          "pose": {"p": ["17 mm", "-1 mm", "0.011 mm"], "rpy": [0, 0, "90 deg"]}})",
      R"({"name": "lies", "plugin": "swage.coupling.contact", "between": ["thread", "plate"], "params": {"friction": 0.2, "stiffness": "1e4 N/m"}},
         {"name": "grip", "plugin": "swage.coupling.contact", "between": ["holder", "thread"], "params": {"friction": 0.2, "stiffness": "1e5 N/m"}},
         {"plugin": "swage.coupling.grasp", "between": ["holder", "thread"]},
         {"name": "film", "plugin": "swage.coupling.meniscus", "between": ["thread", "plate"], "params": {"spacing": "0.2 mm", "most": 40}})",
      R"({"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")" + hand + R"("}})", top);
}

// where a thread is peeled off B k^2 / 2 = w (the energy that bending takes in is what adhesion gives up): radius sqrt(B / 2w) = 1.70 mm;
// a dry one is bent by its weight alone
TEST(Meniscus, a_thread_is_peeled_off_with_the_curvature_of_its_adhesion) {
  const double expected = std::sqrt(kBending / (2 * work_of_adhesion(kRadius, kGamma, 0)));
  for (const bool wet : {true, false}) {
    ThreadScene s = lifted(wet ? moist("40 um") : "", wet ? "wet" : "dry");
    ASSERT_TRUE(s.engine);
    s.run(3000);
    double sum = 0, begun = s.signal("meniscus.wet"), force = 0;
    for (int i = 0; i < 2000; ++i) {
      s.run(1);
      sum += 1 / s.signal("thread.bend_radius") / 2000;
      force = std::max(force, s.signal("meniscus.force"));
    }
    EXPECT_EQ(s.troubles(), "");
    if (wet) {
      EXPECT_NEAR(1 / sum, expected, 0.1 * expected);
      EXPECT_GT(begun, 5e-3);
      EXPECT_LT(s.signal("meniscus.wet"), begun - 0.2e-3) << "it comes off";
      EXPECT_EQ(s.signal("meniscus.left_out") > 0, s.signal("meniscus.wet") > 8e-3);
    } else {
      EXPECT_GT(1 / sum, 2 * expected);
      EXPECT_EQ(begun, 0);
      EXPECT_EQ(force, 0);
    }
  }
}

/// A thread of 10 mm on a wet plate that turns over: it hangs from the film, against 100 times its weight.
double fallen(const std::string& top) {
  ThreadScene s(R"({"name": "thread", "plugin": "swage.object.thread", "pose": {"p": [0, 0, "0.011 mm"]}, "params": {"length": "10 mm", "segments": 20}},
                   {"name": "plate", "plugin": "swage.object.solids", "pose": {"p": ["5 mm", 0, "-1 mm"]},
                    "params": {"form": "box", "fixed": true, "size": ["28 mm", "10 mm", "2 mm"]}})",
                R"({"plugin": "swage.coupling.contact", "between": ["thread", "plate"], "params": {"friction": 0.2, "stiffness": "1e4 N/m"}},
                   {"plugin": "swage.coupling.meniscus", "between": ["thread", "plate"]})",
                "", top);
  if (!s.engine) return HUGE_VAL;
  s.run(50);
  s.rig->world.gravity = {0, 0, 100 * 9.80665};
  s.run(200);
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

}  // namespace
