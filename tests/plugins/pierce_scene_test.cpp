// SPDX-License-Identifier: Apache-2.0
//
// A needle goes through tissue: forces against the insertion model of Okamura, Simone and O'Leary (2004), guidance, wrong angles, release,
// tears, exits, and that no energy comes from any of it.
#include "pierce_scene.hpp"

namespace swage::test {
namespace {

constexpr double kDeg = M_PI / 180;
constexpr double kR = PierceScene::kRadius, kWire = PierceScene::kWire;

/// Turned about its circle's centre, which lies in the surface: square to it all the way. 1 rad/s is 2.5 mm/s.
Path about_its_centre(double rate, double from, double upto) {
  return [=](double t) { return PierceScene::turned({-kR, 0, 0}, std::min(from + rate * t, upto)); };
}

// a hand that gives so little that it does not show
const char* const kFirm = R"("stiffness": "50000 N/m")";

TEST(PierceScene, AlongItsOwnArcItIsFreeUpToFrictionAndCutting) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "4 mm", "friction": 0)";
  s.leash = kFirm;
  s.duration = 2.2;
  s.make(about_its_centre(1, -0.12, 2));
  double worst = 0;
  s.run_until(2.2, [&] {
    if (s.signal("pierce.state") != 2 || s.signal("pierce.depth") < 0.6e-3) return;
    const double expected = 8e-3 + 5 * s.signal("pierce.depth");
    if (s.engine->world().time() < 2.1)
      worst = std::max(worst, std::abs(s.signal("pierce.force") - expected));
  });
  EXPECT_EQ(s.count("pierce.entered"), 1);
  EXPECT_LT(s.value("pierce.entered"), 5 * kDeg);
  EXPECT_NEAR(s.signal("pierce.peak_entry"), 20e-3, 0.5e-3);
  EXPECT_LT(worst, 0.6e-3) << "cutting force plus drag times inserted length";
  EXPECT_NEAR(s.signal("pierce.depth"), 2 * kR, 0.05e-3);
  EXPECT_LT(s.signal("pierce.angle"), 1 * kDeg);
  EXPECT_LT(s.signal("pierce.wound"), 1.2);
  EXPECT_LT(s.signal("pierce.area_ratio"), 1.2);
  EXPECT_EQ(s.count("pierce.exited"), 0);
  EXPECT_NEAR(s.signal("pierce.entry_x"), 0, 20e-6);
}

// 8.13 of the reference: f = a1 x + a2 x^2 up to 25 mN at 1 mm, then 8 mN + 5 N/m x; out again -5 N/m x. The length that is in
// is that of the centre line, so it lacks the radius of the point.
TEST(PierceScene, ForcesAreThoseOfTheInsertionModel) {
  PierceScene s;
  s.tissue =
      R"("level": "plane", "thickness": "4 mm", "backing": "10 mm", "stiffness": 20, "stiffening": 5000,
    "puncture_force": "25 mN", "cutting_force": "8 mN", "drag": 5, "friction": 0)";
  s.pierce = R"("null_angle": "80 deg")";  // the arc comes at an angle of its own at 1 mm
  s.leash = kFirm;
  s.duration = 2.4;
  s.make([](double t) {  // in for 1.2 s, then out
    return PierceScene::turned({-kR, 0, 0}, -0.05 + (t < 1.2 ? t : 2.4 - t));
  });
  double before = 0, out = 0;
  s.run_until(2.2, [&] {
    const double force = s.signal("pierce.force"), depth = s.signal("pierce.depth"),
                 t = s.engine->world().time();
    if (s.signal("pierce.state") == 1) {
      const double x = kWire - s.tip().z();
      const double normal = force / std::cos(s.signal("pierce.angle"));
      before = std::max(before, std::abs(normal - (20 * x + 5000 * x * x)));
    }
    if (t > 1.25 && depth > 0.2e-3) out = std::max(out, std::abs(force + 5 * depth));
  });
  EXPECT_LT(before, 0.4e-3);
  EXPECT_NEAR(s.signal("pierce.peak_entry"), 25e-3, 0.2e-3);
  EXPECT_LT(out, 0.4e-3) << "only friction holds it back on the way out";
  s.run_until(2.4);
  EXPECT_EQ(s.count("pierce.back_out"), 1);
  EXPECT_NEAR(s.value("pierce.back_out"), kR * 1.15, 0.05e-3) << "the arc that had been in";
  EXPECT_EQ(s.signal("pierce.state"), 0);
  EXPECT_LT(s.signal("pierce.wound"), 1.2);
}

// A track keeps four holds however long it grows, so it thins them out again and again: what they bear does not show when
TEST(PierceScene, WhatATrackBearsIsContinuous) {
  for (const char* level : {"plane", "compliant"})
    for (const double friction : {0.0, 0.2, 0.5})
      for (const double off : {0.0, 40e-6}) {
        PierceScene s;
        s.tissue = std::string(R"("level": ")") + level +
                   R"(", "stiffening": 0, "thickness": "6 mm", "friction": )" + std::to_string(friction);
        s.leash = kFirm;
        s.duration = 2.2;
        // about a centre that is a little off, so that the track bears it sideways as well
        s.make([=](double t) {
          return PierceScene::turned({-kR + off * t, off * t, 0}, std::min(-0.12 + t, 2.0));
        });
        double before = 0, worst = 0, at = 0;
        s.run_until(2.0, [&] {
          const double force = s.signal("pierce.force");
          if (s.signal("pierce.state") == 2 && s.signal("pierce.depth") > 0.3e-3 && before > 0) {
            const double jump = std::abs(force - before) / before;
            if (jump > worst) worst = jump, at = s.signal("pierce.depth");
          }
          before = s.signal("pierce.depth") > 0.3e-3 ? force : 0;
        });
        EXPECT_EQ(s.signal("pierce.state"), 2);
        EXPECT_LT(worst, 0.02) << level << ", friction " << friction << ", off " << off << ": at " << at;
      }
}

/// As the surface gives way the force falls to what cutting takes and no further: the tissue stays dented by that, and does not jump
/// back past it (Okamura: cutting force plus friction from the puncture on).
TEST(PierceScene, AtThePunctureTheForceFallsToThatOfCuttingAndNotBelow) {
  for (const char* level : {"plane", "compliant"}) {
    PierceScene s;
    s.tissue = std::string(R"("level": ")") + level + R"(", "thickness": "4 mm", "backing": "10 mm",
      "puncture_force": "20 mN", "cutting_force": "8 mN", "drag": 5, "friction": 0)";
    s.pierce = R"("null_angle": "80 deg")";
    s.leash = kFirm;
    s.duration = 0.8;
    s.make([](double t) { return PierceScene::turned({-kR, 0, 0}, -0.05 + t); });
    double off = 0;
    int inside = 0;
    s.run_until(0.6, [&] {
      if (s.signal("pierce.state") < 2 || ++inside == 1) return;  // the first one bore what let it in
      const double along = 5 * s.signal("pierce.depth");
      off = std::max(off, std::abs(s.signal("pierce.force") - 8e-3) - along);
    });
    EXPECT_GT(inside, 100) << level;
    EXPECT_LT(off, 0.2e-3) << level << ": friction may hold it back or, as the dent goes, push it on";
  }
}

/// Comes straight along its point's direction at an angle to the inward normal.
Path straight(double angle, double speed, double distance) {
  return [=](double t) {
    const Vec3 way(-std::sin(angle), 0, -std::cos(angle));
    // the point of the needle turned by `angle` is at c + R (cos, 0, -sin)
    const Vec3 point = Vec3(0, 0, 0.06e-3) - 0.1e-3 * way + std::min(speed * t, distance) * way;
    return PierceScene::turned(point - kR * Vec3(std::cos(angle), 0, -std::sin(angle)), angle);
  };
}

TEST(PierceScene, AtAWrongAngleAFirmHandNeedsMoreForce) {
  double peak[3];
  const double angles[3] = {0, 40, 60};
  for (int i = 0; i < 3; ++i) {
    PierceScene s;
    s.tissue = R"("level": "plane", "stiffening": 0, "stiffness": 300, "friction": 0.6, "thickness": "4 mm")";
    s.duration = 1;
    s.make(straight(angles[i] * kDeg, 1.5e-3, 1.4e-3));
    s.run_until(1);
    ASSERT_EQ(s.count("pierce.entered"), 1) << angles[i];
    EXPECT_NEAR(s.value("pierce.entered"), angles[i] * kDeg, 6 * kDeg);
    peak[i] = s.signal("pierce.peak_entry");
    const double law = angles[i] <= 15 ? 0 : 60e-3 * (s.value("pierce.entered") / kDeg - 15) / 75;
    EXPECT_NEAR(peak[i], 20e-3 + law, 1.5e-3) << angles[i];
  }
  EXPECT_GT(peak[2], peak[1]);
}

TEST(PierceScene, AtAWrongAngleALooseHandIsDeflected) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "stiffness": 300, "thickness": "4 mm")";
  s.leash = R"("strength": "12 mN")";
  s.duration = 1;
  s.make(straight(60 * kDeg, 1.5e-3, 1.4e-3));
  s.run_until(1);
  EXPECT_EQ(s.count("pierce.entered"), 0);
  EXPECT_GE(s.count("pierce.deflected"), 1);
  EXPECT_GT(s.value("pierce.deflected"), 45 * kDeg);
  // it has twisted in the hand: its point is above where the hand wanted it
  EXPECT_GT(s.tip().z(), 0.06e-3 - 1.3e-3 * std::cos(60 * kDeg) + 0.2e-3);
}

TEST(PierceScene, ReleasedInTheMiddleItStays) {
  PierceScene s;
  s.tissue = R"("level": "compliant", "thickness": "4 mm")";
  s.duration = 1;
  s.make(about_its_centre(1, -0.12, 0.6));
  s.rig->world.gravity = {0, 0, -9.80665};
  s.run_until(1);
  ASSERT_EQ(s.signal("pierce.state"), 2);
  ASSERT_TRUE(s.hold(0));
  s.run_until(8);  // what the tissue had stretched comes back, with 0.83 s
  const Pose rest = s.needle_pose();
  const double d = 2 * kWire;
  double worst = 0;
  s.run_until(68, [&] {
    const Pose now = s.needle_pose();
    worst = std::max({worst, (now.p - rest.p).norm(), (now * Vec3(0, kR, 0) - rest * Vec3(0, kR, 0)).norm()});
  });
  EXPECT_LT(worst, 0.01 * d) << "a minute";
  EXPECT_EQ(s.signal("pierce.state"), 2);
  EXPECT_EQ(s.engine->stats().health.not_converged, 0u);
}

TEST(PierceScene, PushedAboutItTearsAndTheWoundTellsByHowMuch) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "4 mm")";
  s.duration = 1.6;
  s.leash = kFirm;
  const double push = 0.3e-3;
  s.make([push](double t) {
    Pose X = PierceScene::turned({-kR, 0, 0}, std::min(-0.12 + t, 0.6));
    X.p.y() += push * std::clamp((t - 1) / 0.5, 0.0, 1.0);
    return X;
  });
  s.run_until(1);
  const double wound = s.signal("pierce.wound");
  EXPECT_EQ(s.count("pierce.torn"), 0);
  s.run_until(1.6);
  EXPECT_EQ(s.count("pierce.torn"), 1);
  EXPECT_GT(s.signal("pierce.wound"), wound + 2);
  // the surface is crossed by a wire that came 0.3 mm, less what hand and tissue gave
  const double way = kWire * (s.signal("pierce.wound") - 1), area = M_PI * kWire * kWire + 2 * kWire * way;
  EXPECT_NEAR(way, push, 0.2 * push);
  EXPECT_NEAR(s.signal("pierce.area"), area, 0.15 * area);
  EXPECT_GT(s.signal("pierce.swept"), 0);
  EXPECT_GT(s.signal("pierce.pull"), 5e-3);
  std::array<snapshot::Snapshot, 1> shot;
  s.engine->fill(shot[0]);
  const std::vector<swage_visual> tears = drawn(shot[0], SWAGE_VISUAL_TEAR), wounds = drawn(shot[0], SWAGE_VISUAL_WOUND);
  ASSERT_GE(tears.size(), 1u);
  ASSERT_EQ(wounds.size(), 1u);
  const swage_visual& torn = wounds[0];
  EXPECT_EQ(torn.strength, 1);
  EXPECT_EQ(torn.group, tears[0].group);
  EXPECT_NEAR(M_PI * torn.radius * torn.radius, s.signal("pierce.area"), 1e-9 * s.signal("pierce.area"));
  EXPECT_NEAR(torn.a.x, s.signal("pierce.at_x"), 0.05 * kWire);
  EXPECT_NEAR(torn.a.y, s.signal("pierce.at_y"), 0.05 * kWire);
  EXPECT_NEAR(depth_of(torn), s.signal("pierce.depth"), 0.1 * depth_of(torn));
  EXPECT_LT(torn.direction.z, -0.8) << "down into the tissue, less what the needle leans";
}

TEST(PierceScene, TheTearThatIsDrawnMeetsTheNeedle) {
  for (const char* sweep : {"needle", "tissue"}) {
    PierceScene s;
    s.tissue = R"("level": "compliant", "stiffening": 0, "thickness": "4 mm")";
    s.pierce = std::string(R"("sweep": ")") + sweep + R"(")";
    s.duration = 1.6;
    s.leash = kFirm;
    s.make([](double t) {
      Pose X = PierceScene::turned({-kR, 0, 0}, std::min(-0.12 + t, 0.6));
      X.p.y() += 0.3e-3 * std::clamp((t - 1) / 0.5, 0.0, 1.0);
      return X;
    });
    s.run_until(1.6);
    std::array<snapshot::Snapshot, 1> shot;
    s.engine->fill(shot[0]);
    const std::vector<swage_visual> wounds = drawn(shot[0], SWAGE_VISUAL_WOUND);
    ASSERT_EQ(wounds.size(), 1u);
    const swage_visual& wound = wounds[0];
    EXPECT_NEAR(wound.a.x, s.signal("pierce.at_x"), 0.05 * kWire) << sweep;
    EXPECT_NEAR(wound.a.y, s.signal("pierce.at_y"), 0.05 * kWire) << sweep;
    EXPECT_NEAR(wound.a.z, 0, 0.05 * kWire) << sweep << ": dents go on top";
    EXPECT_GT(wound.a.y, 4 * kWire) << sweep << ": it was pushed";
  }
}

TEST(PierceScene, ThroughTheFarSideThereIsASecondPeak) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "0.8 mm", "backing": 0)";
  s.duration = 1.4;
  s.make(about_its_centre(1, -0.12, 1.2));
  s.run_until(1.4);
  EXPECT_EQ(s.count("pierce.exited"), 1);
  EXPECT_EQ(s.signal("pierce.state"), 3);
  EXPECT_NEAR(s.signal("pierce.peak_exit"), 14e-3, 1e-3);
  EXPECT_NEAR(s.signal("pierce.exit_z"), -0.8e-3, 0.02e-3);
  // the chord between the surfaces: asin(0.8/2.5) of the arc
  EXPECT_NEAR(s.signal("pierce.depth"), kR * std::asin(0.8 / 2.5), 0.02e-3);
  EXPECT_GE(s.signal("pierce.exit_wound"), 1);
  EXPECT_LT(s.signal("pierce.exit_wound"), 1.6) << "it leaves at an angle, and else along its arc";
}

TEST(PierceScene, BackThroughTheSurfaceWhereTheArcComesUp) {
  PierceScene s;
  s.tissue = R"("level": "plane", "stiffening": 0, "thickness": "6 mm")";
  s.duration = 3.5;
  s.make(about_its_centre(1, -0.12, 3.3));
  s.run_until(3.5);
  EXPECT_EQ(s.count("pierce.exited"), 1);
  EXPECT_NEAR(s.signal("pierce.exit_x"), -2 * kR, 0.05e-3);
  EXPECT_NEAR(s.signal("pierce.exit_z"), 0, 0.02e-3);
  EXPECT_LT(s.value("pierce.exited"), 6 * kDeg);
}

TEST(PierceScene, TheSameBitsFromASavedState) {
  PierceScene s;
  s.tissue = R"("level": "compliant", "thickness": "4 mm")";
  s.duration = 1;
  s.make(about_its_centre(1, -0.12, 0.8));
  s.run_until(0.6);
  ASSERT_EQ(s.signal("pierce.state"), 2);
  std::vector<std::byte> image(s.engine->image_size());
  ASSERT_TRUE(s.engine->save(image));
  s.run_until(0.7);
  const uint64_t hash = s.engine->hash();
  ASSERT_TRUE(s.engine->restore(image));
  s.run_until(0.7);
  EXPECT_EQ(s.engine->hash(), hash);
}

/// The fastest that the needle's centre goes beyond what its hand does [m/s].
double excess(PierceScene& s, double until, double hand) {
  double most = 0;
  s.run_until(until, [&] {
    most = std::max(most, toolkit::vec(s.engine->world().V_WB[s.body("needle")].v).norm() - hand);
  });
  return most;
}

// What a hand of 3 x 2000 N/m stores under the 20 mN of a puncture, F^2/(2 k), can move 0.5 mg by F / sqrt(k m) = 0.37 m/s: more
// than that would be made of nothing.
constexpr double kGivenBack = 0.37;

TEST(PierceScene, NoSpeedCreatesEnergy) {
  for (const double speed : {2e-3, 10e-3, 50e-3, 100e-3}) {
    for (const char* level : {"plane", "compliant"}) {
      PierceScene s;
      s.tissue = std::string(R"("thickness": "4 mm", "level": ")") + level + "\"";
      s.duration = 2 * 1.1 * kR / speed;
      const double half = 0.5 * s.duration, rate = speed / kR;
      s.make([=](double t) {
        return PierceScene::turned({-kR, 0, 0}, -0.1 + rate * (t < half ? t : 2 * half - t));
      });
      EXPECT_LT(excess(s, s.duration, speed), 0.5 * speed + kGivenBack) << speed << " " << level;
      EXPECT_EQ(s.count("pierce.entered"), 1) << speed << " " << level;
    }
  }
}

TEST(PierceScene, GrazingAnglesNeverThrowIt) {
  for (const double angle : {75.0, 82.0, 86.0, 89.0}) {
    PierceScene s;
    s.tissue = R"("level": "plane", "thickness": "4 mm")";
    s.duration = 0.8;
    s.make(straight(angle * kDeg, 5e-3, 3e-3));
    EXPECT_LT(excess(s, 0.8, 5e-3), 10e-3) << angle;
  }
}

/// Tissue of another stiffness: softer tissue is as much weaker, stiffer tissue as strong as the usual one.
std::string tissue_of(double young, double strength) {
  char text[300];
  std::snprintf(text, sizeof text,
                R"("level": "compliant", "thickness": "4 mm", "size": ["8 mm", "8 mm"], "young": "%g Pa",
    "side_stiffness": %g, "puncture_force": "%g mN", "cutting_force": "%g mN", "drag": %g, "failure_stress": "%g kPa")",
                young, young, 20 * strength, 8 * strength, 5 * strength, 420 * strength);
  return text;
}

TEST(PierceScene, StiffnessOverFourDecades) {
  for (const double young : {1e4, 1e5, 1e6, 1e8}) {
    PierceScene s;
    s.tissue = tissue_of(young, std::min(1.0, young / 1e6));
    s.duration = 1.2;
    s.make(about_its_centre(2, -0.12, 1.2));
    EXPECT_LT(excess(s, 1.2, 5e-3), kGivenBack) << young;
    EXPECT_EQ(s.signal("pierce.state"), 2) << young;
    ASSERT_TRUE(s.hold(0));
    EXPECT_LT(excess(s, 1.4, 0), 2 * kGivenBack) << young;
    s.run_until(1.6);
    EXPECT_LT(s.needle_energy(), 1e-13) << young << ": it comes to rest";
    EXPECT_EQ(s.engine->stats().health.not_converged, 0u) << young;
  }
}

// Pressed into soft tissue with the force of stiff tissue, it is displaced by six times what the touch is wide. Its axis turns within a
// step: solved with the axis that it had before, it swings to and fro for ever.
TEST(PierceScene, InTissueMuchTooSoftItComesToRestAsWell) {
  PierceScene s;
  s.tissue =
      R"("level": "compliant", "thickness": "4 mm", "size": ["8 mm", "8 mm"], "young": "100 kPa", "side_stiffness": 1e5,
    "puncture_force": "1 mN")";
  s.duration = 1.2;
  s.make(about_its_centre(2, -0.12, 1.2));
  s.run_until(1.2);
  ASSERT_TRUE(s.hold(0));
  s.run_until(2);
  const Pose rest = s.needle_pose();
  double twitch = 0;
  s.run_until(2.4, [&, before = rest.p]() mutable {
    twitch = std::max(twitch, (s.needle_pose().p - before).norm());
    before = s.needle_pose().p;
  });
  EXPECT_LT(twitch, 0.5e-6) << "only what the tissue creeps in a step";
  EXPECT_LT(s.needle_energy(), 1e-13);
  EXPECT_EQ(s.engine->stats().health.not_converged, 0u);
}

}  // namespace
}  // namespace swage::test
