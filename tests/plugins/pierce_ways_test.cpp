// SPDX-License-Identifier: Apache-2.0
//
// Ways of a needle: through two tissues, to the rim, let go and taken again, in a second time, and all the way through.
#include "pierce_scene.hpp"

namespace swage::test {
namespace {

constexpr double kR = PierceScene::kRadius, kWire = PierceScene::kWire;
const char* const kFirm = R"("stiffness": "50000 N/m")";

Pose about(double angle) { return PierceScene::turned({-kR, 0, 0}, angle); }

TEST(PierceWays, ThroughTwoTissuesItIsHeldByBoth) {
  PierceScene s;
  const char* const wall =
      R"("level": "compliant", "thickness": "0.8 mm", "backing": 0, "size": ["8 mm", "8 mm"])";
  s.tissue = wall;
  s.extra_objects =
      std::string(R"(, {"name": "second", "plugin": "swage.object.tissue", "pose": {"p": [0, 0, "-1 mm"]},
    "params": {)") +
      wall + "}}";
  s.extra_couplings =
      R"(, {"name": "pierce2", "plugin": "swage.coupling.pierce", "between": ["needle", "second"]})";
  s.duration = 1.2;
  s.make([](double t) { return about(std::min(-0.12 + t, 0.95)); });
  s.run_until(1.2);
  EXPECT_EQ(s.signal("pierce.state", "pierce"), 3);
  EXPECT_EQ(s.signal("pierce.state", "pierce2"), 3);
  EXPECT_EQ(s.count("pierce.entered"), 2);
  EXPECT_EQ(s.count("pierce.exited"), 2);
  // chords between the faces: asin(z / R) along the arc
  const auto arc = [](double z) { return kR * std::asin(z / kR); };
  EXPECT_NEAR(s.signal("pierce.depth", "pierce"), arc(0.8e-3), 0.03e-3);
  EXPECT_NEAR(s.signal("pierce.depth", "pierce2"), arc(1.8e-3) - arc(1e-3), 0.03e-3);
  ASSERT_TRUE(s.hold(0));
  const Vec3 before = s.needle_pose().p;
  s.run_until(4);
  EXPECT_LT((s.needle_pose().p - before).norm(), 40e-6) << "what the walls had given";
  EXPECT_LT(s.needle_energy(), 1e-15);
}

TEST(PierceWays, ATearThatComesToTheRimLetsItGo) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "4 mm", "size": ["8 mm", "1.6 mm"])";
  s.leash = kFirm;
  s.duration = 1.4;
  s.make([](double t) {
    Pose X = about(std::min(-0.12 + 2 * t, 0.5));
    X.p.y() += 2e-3 * std::clamp(t - 0.4, 0.0, 0.8);
    return X;
  });
  s.run_until(0.7);
  EXPECT_EQ(s.count("pierce.torn"), 1);
  EXPECT_EQ(s.count("pierce.cut_out"), 0) << "0.6 mm of the 0.8 mm to the rim";
  s.run_until(1.4);
  ASSERT_EQ(s.count("pierce.cut_out"), 1);
  // the tear is as long as the way to the rim; what still holds deeper is stretched behind the needle
  EXPECT_NEAR(s.value("pierce.cut_out") * kWire, 0.8e-3, 0.3e-3);
  EXPECT_EQ(s.signal("pierce.state"), 0);
  EXPECT_EQ(s.signal("pierce.lateral"), 0);
  EXPECT_EQ(s.count("pierce.back_out"), 0);
}

/// Drives to `in`, lets go, takes it again and goes on to `upto`.
void take_again(PierceScene& s, double in, double upto) {
  s.duration = 2.2;
  s.make([=](double t) {
    return about(t < 1.4 ? std::min(-0.12 + 2 * t, in) : std::min(in + (t - 1.4), upto));
  });
  s.run_until(1.2);
  ASSERT_TRUE(s.hold(0));
  s.run_until(1.39);
  const double held = s.signal("pierce.depth");
  s.run_until(1.391);
  EXPECT_NEAR(s.signal("pierce.depth"), held, 1e-7) << "let go, it stays";
  ASSERT_TRUE(s.hold(2000));
  s.run_until(2.2);
}

TEST(PierceWays, TakenAgainBehindItGoesOnAlongTheSameTrack) {
  PierceScene s;
  s.tissue = R"("level": "compliant", "thickness": "4 mm", "size": ["8 mm", "8 mm"])";
  take_again(s, 0.5, 0.9);
  EXPECT_EQ(s.count("pierce.entered"), 1);
  EXPECT_NEAR(s.signal("pierce.depth"), 0.9 * kR, 0.1e-3);
  EXPECT_LT(s.signal("pierce.wound"), 1.6);
}

TEST(PierceWays, TakenAgainOnTheOtherSideItIsPulledThrough) {
  PierceScene s;
  s.tissue = R"("level": "compliant", "thickness": "0.8 mm", "backing": 0, "size": ["8 mm", "8 mm"])";
  take_again(s, 0.9, 1.5);
  EXPECT_EQ(s.signal("pierce.state"), 3);
  EXPECT_NEAR(s.signal("pierce.s"), 1.5 / M_PI, 0.04) << "it slid through";
  EXPECT_NEAR(s.signal("pierce.depth"), kR * std::asin(0.8e-3 / kR), 0.05e-3)
      << "and no more of it is inside";
  EXPECT_LT(s.signal("pierce.exit_wound"), 2);
}

TEST(PierceWays, ASecondEntryIsAWoundOfItsOwn) {
  for (const double beside : {0.0, 0.6e-3}) {
    PierceScene s;
    s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "4 mm", "size": ["8 mm", "8 mm"])";
    s.duration = 1.6;
    s.make([=](double t) {
      const double u = t < 0.8 ? t : t - 0.8;  // twice the same, 0.8 s each
      Pose X = about(-0.12 + 2 * (u < 0.4 ? std::min(u, 0.3) : std::max(0.0, 0.3 - (u - 0.4))));
      X.p.y() += beside * std::clamp((t - 0.72) / 0.06, 0.0, 1.0);
      return X;
    });
    s.run_until(0.79);
    EXPECT_EQ(s.count("pierce.back_out"), 1);
    EXPECT_EQ(s.signal("pierce.state"), 0);
    s.run_until(1.15);
    EXPECT_EQ(s.signal("pierce.entries"), 2);
    EXPECT_EQ(s.signal("pierce.state"), 2);
    EXPECT_NEAR(s.signal("pierce.entry_y"), beside, 10e-6);
    EXPECT_LT(s.signal("pierce.wound"), 1.3) << "each is a hole of its own size";
    std::array<snapshot::Snapshot, 1> shot;
    s.engine->fill(shot[0]);
    std::vector<uint32_t> wounds;
    for (const swage_visual& tear : drawn(shot[0], SWAGE_VISUAL_TEAR)) wounds.push_back(tear.group);
    std::sort(wounds.begin(), wounds.end());
    wounds.erase(std::unique(wounds.begin(), wounds.end()), wounds.end());
    EXPECT_EQ(wounds.size(), beside > 0 ? 2u : 1u) << "in the old hole it is the old wound";
    const std::vector<swage_visual> open = drawn(shot[0], SWAGE_VISUAL_WOUND);
    ASSERT_EQ(open.size(), wounds.size());
    for (size_t i = 0; i < open.size(); ++i) {
      EXPECT_EQ(open[i].strength, i + 1 == open.size() ? 1 : 0) << "the old hole is empty";
      EXPECT_GT(depth_of(open[i]), 0.1e-3) << "and stays as deep as it was";
    }
  }
}

TEST(PierceWays, PulledThroughItsEndFollowsTheSameTrack) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "6 mm")";
  s.leash = kFirm;
  s.duration = 6.8;
  // all the way round but for the last 0.1 mm, and out along the tangent before its point comes down again
  static constexpr double kRound = 2 * M_PI - 0.05;
  s.make([](double t) {
    Pose X = about(std::min(-0.12 + t, kRound));
    X.p.z() += 2e-3 * std::max(0.0, t - 0.12 - kRound);
    return X;
  });
  double off = 0, wound = 0;
  s.run_until(6.8, [&] {
    if (s.count("pierce.passed") == 0 || s.time() > kRound || s.signal("pierce.state") != 3) return;
    const Vec3 r = s.end() - Vec3(-kR, 0, 0);
    off = std::max({off, std::abs(r.norm() - kR), std::abs(r.y())});
    wound = s.signal("pierce.wound");
  });
  EXPECT_EQ(s.count("pierce.entered"), 1);
  EXPECT_EQ(s.count("pierce.exited"), 1);
  ASSERT_EQ(s.count("pierce.passed"), 1) << "its end went in where its point had";
  EXPECT_LT(s.value("pierce.passed"), 1.3);
  EXPECT_LT(off, 0.2 * kWire) << "and stayed on the circle that the point had cut";
  EXPECT_LT(wound, 1.3);
  EXPECT_LT(s.signal("pierce.exit_wound"), 1.5);
  EXPECT_EQ(s.signal("pierce.state"), 0) << "and it is out";
}

/// Its blunt end too is held until it is out, and then nothing is left to push it: the hand feels no blow, though the wall, drawn along
/// with the needle, springs back.
TEST(PierceWays, WhatIsInIsHeldUntilItIsOut) {
  static constexpr double kWall = 0.8e-3;
  PierceScene s;
  s.tissue = R"("level": "compliant", "thickness": "0.8 mm", "backing": 0, "size": ["8 mm", "8 mm"])";
  s.duration = 4;
  s.make([](double t) { return about(std::min(-0.12 + t, 3.8)); });
  Vec3 felt = Vec3::Zero();
  double jump = 0, aside = 0, end_at = HUGE_VAL;
  s.run_until(4, [&] {
    Vec3 now = Vec3::Zero();
    for (const dynamics::Tie& tie : s.engine->ties())
      if (tie.body_a == s.rig->objects[0].body.first) now += tie.f_a_W;
    if (s.count("pierce.passed") > 0) {
      jump = std::max(jump, (now - felt).norm());
      const Vec3 off(s.signal("pierce.at_x") - s.signal("pierce.entry_x"), s.signal("pierce.at_y") - s.signal("pierce.entry_y"),
                     s.signal("pierce.at_z") - s.signal("pierce.entry_z"));
      aside = std::max(aside, off.norm());
      if (s.signal("pierce.state") == 0 && end_at == HUGE_VAL) end_at = s.end().z();
    }
    felt = now;
  });
  ASSERT_EQ(s.count("pierce.passed"), 1);
  EXPECT_LT(end_at, -kWall + 0.2 * kWire) << "it was let go with " << end_at + kWall << " m of it inside";
  EXPECT_GT(end_at, -kWall - kWire);
  // what a hold bore goes as the blunt end leaves it: drag of 5 N/m over 0.1 to 0.2 mm
  EXPECT_LT(jump, 1e-3) << "N, from step to step";
  EXPECT_LT(aside, kWire) << "pierce.at is where it crosses the entry, not where its blunt end is";
  EXPECT_EQ(s.signal("tissue.force"), 0);
}

}  // namespace
}  // namespace swage::test
