// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.swage: a thread in a needle, rigid and bending: what it bears hanging, bent, thrown, pulled off and set back.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "thread_scene.hpp"
#include "toolkit/rod.hpp"

namespace {

using namespace swage;
using test::ThreadScene;
using toolkit::Vec3;

constexpr double kG = 9.80665;      // m/s2
constexpr double kLine = 4.333e-7;  // kg/m, of 10-0 nylon

/// Half a circle of 2.5 mm, of which the blunt end is at the origin of W and looks along x, or down. The thread is in it by `depth`.
struct Held {
  bool down = false, bending = false, held = true;
  double length = 20e-3, depth = 0.25e-3;  // m
  int segments = 40;
  std::string start = "straight", thread = R"("memory": 0)", swage = R"("depth": "0.25 mm")", keys, needle;

  std::string number(double x) const {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", x);
    return text;
  }
  ThreadScene scene() const {
    const std::string at = down ? R"("p": [0, "-2.5 mm", "2.5 mm"])" : R"("p": ["-2.5 mm", "2.5 mm", 0])";
    // x of the needle's frame is against the way out: turned about y, or by half a turn about z
    const std::string turn = down ? R"("rpy": [0, "-90 deg", 0])" : R"("rpy": [0, 0, "180 deg"])";
    const std::string thread_at = down ? R"([0, 0, )" + number(depth) + "]" : "[" + number(-depth) + ", 0, 0]";
    std::string objects = R"({"name": "thread", "plugin": "swage.object.thread", "pose": {"p": )" + thread_at +
                          R"(}, "params": {"start": ")" + start + R"(", "length": )" + number(length) +
                          R"(, "segments": )" + std::to_string(segments) + ", " + thread + R"(}},
      {"name": "needle", "plugin": "swage.object.needle", "pose": {)" + at + ", " + turn +
                          R"(}, "params": {"arc": "4/8", "size": "5 mm", "level": ")" + (bending ? "bending" : "rigid") + "\"" +
                          needle + "}}";
    std::string couplings =
        R"({"name": "end", "plugin": "swage.coupling.swage", "between": ["needle", "thread"], "params": {)" + swage + "}}";
    if (!held) return {objects, couplings};
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const std::string hand = testing::TempDir() + "swage_" + info->name() + ".json";
    std::ofstream(hand) << R"({"format": "swage-hand/1", "title": "Holds", "keys": [
      {"t": "0 s", "p": [0, 0, 0], "axis": [1, 0, 0], "closing": [0, 0, 1], "closure": 0})"
                        << keys << "]}";
    objects += R"(, {"name": "holder", "plugin": "swage.object.jaws", "follows": {"pose": "hand"}})";
    couplings = R"({"plugin": "test.coupling.leash", "between": ["holder", "needle"], "params": {"stiffness": "2e4 N/m"}}, )" + couplings;
    return {objects, couplings, R"({"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")" + hand + R"("}})"};
  }
};

double heard(const ThreadScene& s, const std::string& id) {
  for (const judge::Event& e : s.engine->events())
    if (s.rig->script.events[e.event].id == id) return e.value;
  return std::nan("");
}

TEST(SwageInScene, bears_the_weight_of_a_hanging_thread) {
  for (const bool bending : {false, true}) {
    Held held;
    held.down = true, held.start = "hanging", held.bending = bending;
    ThreadScene s = held.scene();
    ASSERT_TRUE(s.engine);
    s.run(1500);
    const double weight = kLine * 20e-3 * kG;
    EXPECT_NEAR(s.signal("swage.tension"), weight, 0.01 * weight) << bending;
    EXPECT_LT(s.signal("swage.angle"), 0.01) << bending;
    EXPECT_EQ(s.signal("swage.attached"), 1);
    EXPECT_EQ(s.troubles(), "");
  }
}

/// The heavy elastica (G = 1, L = 18.910 mm) beyond the mouth, half a segment inside: place of its end, pull and moment.
TEST(SwageInScene, holds_the_direction_of_a_cantilever) {
  constexpr double kBeyond = 18.910e-3, kSegment = kBeyond / 25.5;
  for (const bool bending : {false, true}) {
    Held held;
    held.bending = bending;
    held.segments = 26, held.length = 26 * kSegment, held.depth = 0.5 * kSegment;
    held.swage = R"("depth": )" + held.number(held.depth);
    ThreadScene s = held.scene();
    ASSERT_TRUE(s.engine);
    s.run(4000);
    const scene::ChainView chain = s.chain();
    EXPECT_LT((chain.p(26) / kBeyond - Vec3(0.991246, 0, -0.123471)).norm(), 2e-3) << bending;
    const double weight = kLine * held.length * kG;
    EXPECT_NEAR(s.signal("swage.tension"), weight, 0.01 * weight);
    EXPECT_NEAR(s.signal("swage.angle"), M_PI / 2, 0.01);
    double moment = 0;
    for (uint32_t i = 0; i <= 26; ++i) moment += kLine * kSegment * (i == 0 || i == 26 ? 0.5 : 1) * kG * chain.p(i).x();
    EXPECT_NEAR(s.signal("swage.moment"), moment, 0.01 * moment);
    EXPECT_EQ(s.troubles(), "");
  }
}

/// A thread as it curled in its packet goes round with the needle that turns about its hole.
TEST(SwageInScene, holds_the_turn) {
  Held held;
  held.thread = R"("memory": 75)";
  held.keys = R"(, {"t": "0.3 s"}, {"t": "1.3 s", "axis": [1, 0, 0], "closing": [0, -1, 0]})";
  ThreadScene s = held.scene();
  ASSERT_TRUE(s.engine);
  s.run(250);
  const auto normal = [&] {
    const scene::ChainView c = s.chain();
    return Vec3((c.p(1) - c.p(0)).cross(c.p(12) - c.p(1)).normalized());
  };
  const Vec3 before = normal();
  s.run(1550);
  // a quarter of a turn about x
  const Vec3 turned(before.x(), -before.z(), before.y());
  EXPECT_GT(normal().dot(turned), 0.9);
  EXPECT_LT(std::abs(normal().dot(before)), 0.4);
}

/// Needle and 30 mm of thread fall. What is lost to the air is what Lamb's drag takes: 0.4 % of a thread this heavy.
TEST(SwageInScene, loses_no_momentum) {
  for (const bool bending : {false, true}) {
    Held held;
    held.held = false, held.bending = bending;
    held.length = 30e-3, held.segments = 60;
    held.thread = R"("memory": 0, "density": 25000)";
    ThreadScene s = held.scene();
    ASSERT_TRUE(s.engine);
    const scene::World& world = s.rig->world;
    uint32_t needle = 0;
    while (world.body[needle].name != "needle") ++needle;
    const double line = kLine * 25000 / 1140, thread = line * 30e-3, segment = 0.5e-3;
    // of steel, 7850 kg/m3: a wire of 0.1 mm, half a circle of 2.5 mm
    const double steel = 7850 * M_PI * 0.25e-8 * M_PI * 2.5e-3;
    for (int k = 0; k < 5; ++k) {
      s.run(1);
      Vec3 p = steel * toolkit::vec(s.engine->world().V_WB[needle].v);
      for (uint32_t i = 0; i <= 60; ++i) p += line * segment * (i == 0 || i == 60 ? 0.5 : 1) * s.chain().v(i);
      const double whole = (steel + thread) * kG * 1e-3 * (k + 1);
      EXPECT_NEAR((p + whole * Vec3::UnitZ()).norm(), 0, 0.02 * whole) << k << bending;
    }
    s.run(100);
    // they fall as one: the mouth is where the thread is
    EXPECT_LT(s.chain().p(0).z(), -0.03);
    EXPECT_LT(s.signal("swage.tension"), thread * kG);
    EXPECT_EQ(s.signal("swage.attached"), 1);
    EXPECT_EQ(s.troubles(), "");
  }
}

/// Its other end is fixed and the needle is drawn away: 10-0 nylon comes out at 140 mN, or at what the scene says; then it is free.
TEST(SwageInScene, comes_out_at_its_strength) {
  for (const double strength : {0.14, 0.02}) {
    Held held;
    held.thread = R"("suture": "nylon_10_0.json", "memory": 0, "last": "fixed")";
    if (strength < 0.1) held.swage += R"(, "strength": "20 mN")";
    held.keys = R"(, {"t": "0.1 s"}, {"t": "1.1 s", "p": ["-5 mm", 0, 0]})";
    ThreadScene s = held.scene();
    ASSERT_TRUE(s.engine);
    double most = 0, value = std::nan("");
    int at = 0;
    for (; at < 1500 && std::isnan(value); ++at) {
      most = std::max(most, s.signal("swage.tension"));
      s.run(1);
      value = heard(s, "swage.pulled_off");
    }
    EXPECT_NEAR(value, strength, 0.02 * strength + 1e-3);
    EXPECT_LE(most, 1.02 * strength);
    s.run(1);
    EXPECT_EQ(s.signal("swage.tension"), 0);
    EXPECT_EQ(s.signal("swage.attached"), 0);
    // the thread springs back and bears nothing
    s.run(200);
    EXPECT_LT(s.signal("thread.tension"), 0.01 * strength);
    EXPECT_EQ(s.signal("thread.parted"), 0);
    s.engine->reset();
    s.run(1);
    EXPECT_EQ(s.signal("swage.attached"), 1);
  }
}

/// Elsewhere it is not snatched there.
TEST(SwageInScene, takes_no_thread_that_is_not_there) {
  Held held;
  held.depth = -2e-3;  // it begins 2 mm before the needle
  ThreadScene s = held.scene();
  ASSERT_TRUE(s.engine);
  s.run(2);
  EXPECT_EQ(s.signal("swage.attached"), 0);
  EXPECT_LT(s.chain().v(0).norm(), 0.03);
}

/// A thread that lies bent with sharp corners, beyond its hole and half a millimetre or a millimetre from there: it stays in the needle, and nothing is put in quarantine.
TEST(SwageInScene, a_thread_may_start_bent) {
  for (const bool bending : {false, true})
    for (const char* path : {"0 0 0, 0.5 0 0, 4 0 3, 4 6 3, 0 12 0 mm", "0 0 0, 1 0 0, 1 0 -3, 1 4 -3, 3 8 -3 mm"}) {
      Held held;
      held.bending = bending;
      held.start = "path", held.thread = std::string(R"("memory": 0, "path": ")") + path + "\"";
      ThreadScene s = held.scene();
      ASSERT_TRUE(s.engine);
      s.run(500);
      EXPECT_EQ(s.troubles(), "") << bending << " " << path;
      EXPECT_EQ(s.signal("swage.attached"), 1) << bending << " " << path;
      EXPECT_LT(s.signal("swage.tension"), 50e-3) << bending << " " << path;
      EXPECT_EQ(s.engine->quarantined(), 0u) << bending << " " << path;
    }
}

/// A thread that leads from its needle back over the wire of that, 3.9 mm along it from the hole, and on to where its other end is fixed below.
/// The needle goes up until the thread, softer than nylon so that it does not spring from its bends, bears kTight.
constexpr double kTight = 2e-3;  // N
struct Drawn {
  double force = 0;            // N, greatest of all touches of the wire in a step
  double deep = 0;             // m, greatest once it is tight
  double deepest = 0;          // m, at any time: it snaps over the wire at up to 0.8 m/s, and a contact is a plane within a step
  double in_hole = 0;          // N, summed, of touches within three depths of the hole
  std::string troubles;
};
Drawn drawn_over_the_wire(bool bending, const std::string& touch) {
  Held held;
  held.bending = bending, held.segments = 60, held.length = 15e-3, held.start = "path";
  held.swage = R"("depth": "0.25 mm", "touch": ")" + touch + "\"";
  held.thread = R"("memory": 0, "young": "0.1 GPa", "last": "fixed", "path": "0 0 0, 0.7 0 0, 1.3 0.2 0.2, 1.8 0.7 0.6, 2 1.3 0.9, 1.7 2 1, 1 2.2 0.9, 0 2.2 0.7, -2.4 2.6 0.1, -6 6 -1.8 mm")";
  held.keys = R"(, {"t": "0.2 s"}, {"t": "3.2 s", "p": [0, 0, "12 mm"]})";
  ThreadScene s = held.scene();
  Drawn out;
  EXPECT_TRUE(s.engine);
  if (!s.engine) return out;
  s.run(1000);  // it starts with corners, and springs a little; then it lies on the wire
  int tight = 0;  // steps
  for (int k = 0; k < 2200 && tight < 100; ++k) {
    s.run(1);
    tight = tight > 0 || s.signal("thread.tension") >= kTight ? tight + 1 : 0;
    double force = 0, deep = 0;
    for (const contact::Contact& c : s.engine->contacts().contact) {
      const double f = c.f_a_W.norm();
      (c.law.stiffness > 0 ? force : out.in_hole) += f;
      if (f > 0) deep = std::max(deep, -c.gap);
    }
    out.force = std::max(out.force, force), out.deepest = std::max(out.deepest, deep);
    if (tight > 0) out.deep = std::max(out.deep, deep);
  }
  EXPECT_EQ(tight, 100) << "it is drawn tight";
  out.troubles = s.troubles();
  return out;
}

// It touches the needle that it is in, bears on it, and does not pass through; where the touch is soft it sinks in. On its way it snaps over the
// wire, at another moment and speed with every change of the solver, and may slide off a rigid one: the depth of that moment says little.
TEST(SwageInScene, a_thread_lies_on_its_own_needle) {
  for (const bool bending : {false, true}) {
    const Drawn hard = drawn_over_the_wire(bending, "1e5 N/m"), soft = drawn_over_the_wire(bending, "500 N/m");
    EXPECT_GT(hard.force, 0.5 * kTight) << bending;
    EXPECT_LT(hard.deep, 1e-6) << bending;
    EXPECT_TRUE(!bending || soft.deep > 4 * hard.deep) << soft.deep << " m, " << hard.deep << " m";
    EXPECT_LT(hard.deepest, 11e-6) << bending << ": the radius of the thread";
    EXPECT_EQ(hard.in_hole, 0) << bending;
    EXPECT_EQ(hard.troubles, "") << bending;
  }
}

}  // namespace
