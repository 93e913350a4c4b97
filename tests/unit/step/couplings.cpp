// SPDX-License-Identifier: Apache-2.0
#include "step/couplings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "fake_scene.hpp"

namespace swage::step {
namespace {

// the tool comes up against the ball at 10 mm/s: after 400 steps they touch
void push_up(FakeScene& s) {
  s.device_.exchange = [](const swage_command* c, swage_sample* out) {
    out->pose = {{0, 0, std::min(4.2e-3, 0.01 * c->time_s)}, {1, 0, 0, 0}};
    out->valid = SWAGE_VALID_POSE;
    return swage_result{SWAGE_OK};
  };
}

constexpr int kTouch = 400;

TEST(Couplings, SeeTheContactFromTheirOwnSide) {
  for (const bool exchanged : {false, true}) {
    FakeScene s;
    push_up(s);
    if (exchanged) std::swap(s.rig.couplings[0].object_a, s.rig.couplings[0].object_b);
    double force = 0, normal = 0;
    s.coupling_.coupling_finish = [&](const swage_coupling_step* step) {
      for (uint32_t i = 0; i < step->n_contact; ++i) {
        force += step->contact[i].f_a_W.z;
        normal = step->contact[i].n_W.z;
        EXPECT_EQ(step->contact[i].body_a, 0u);
        EXPECT_EQ(step->contact[i].body_b, 0u);
      }
      return swage_result{SWAGE_OK};
    };
    s.run(kTouch + 20);
    // the ball is pushed up, the tool is pushed down; n points from b into a
    EXPECT_NEAR(normal, exchanged ? 1 : -1, 1e-9);
    EXPECT_LT(exchanged ? -force : force, 0);
    EXPECT_GT(s.ball().p.z, 5e-3);
  }
}

TEST(Couplings, SeeLastStepsForceWhileTheyResolve) {
  FakeScene s;
  push_up(s);
  double last = 0;
  int compared = 0;
  s.coupling_.resolve = [&](const swage_coupling_step* step) {
    if (step->n_contact == 1 && last != 0) {
      EXPECT_EQ(step->contact[0].f_a_W.z, last);
      ++compared;
    }
    return swage_result{SWAGE_OK};
  };
  s.coupling_.coupling_finish = [&](const swage_coupling_step* step) {
    last = step->n_contact == 1 ? step->contact[0].f_a_W.z : 0;
    return swage_result{SWAGE_OK};
  };
  s.ball_.forces = [](const swage_object_step* step) {
    step->F_B_W[0].f.z = -1e-4;  // keeps it on the tool
    return swage_result{SWAGE_OK};
  };
  s.run(kTouch + 100);
  EXPECT_GT(compared, 10);
}

// the law is the coupling's: a stiffness a hundred times smaller lets the ball sink in a hundred times deeper
TEST(Couplings, ChangeTheLaw) {
  double depth[2] = {0, 0};
  for (int soft = 0; soft < 2; ++soft) {
    FakeScene s;
    push_up(s);
    s.coupling_.resolve = [soft](const swage_coupling_step* step) {
      for (uint32_t i = 0; i < step->n_contact; ++i) step->contact[i].stiffness = soft ? 10 : 1000;
      return swage_result{SWAGE_OK};
    };
    s.ball_.forces = [](const swage_object_step* step) {
      step->F_B_W[0].f.z = -1e-4;
      return swage_result{SWAGE_OK};
    };
    s.run(1500);
    depth[soft] = 1e-3 - (s.ball().p.z - s.tool().p.z);
  }
  EXPECT_NEAR(depth[0], 1e-4 / 1000, 1e-9);
  EXPECT_NEAR(depth[1], 1e-4 / 10, 1e-8);
}

TEST(Couplings, ALawWithoutSenseCostsTheCoupling) {
  for (int fault = 0; fault < 4; ++fault) {
    FakeScene s;
    push_up(s);
    s.coupling_.resolve = [fault](const swage_coupling_step* step) {
      if (step->n_contact == 0) return swage_result{SWAGE_OK};
      swage_contact& c = step->contact[0];
      if (fault == 0) c.friction = -0.1;
      if (fault == 1) c.stiffness = std::numeric_limits<double>::quiet_NaN();
      if (fault == 2) c.stiffness = -1;
      if (fault == 3) c.restitution = 1.5;
      return swage_result{SWAGE_OK};
    };
    s.run(kTouch + 20);
    EXPECT_EQ(s.rig.couplings[0].instance->fault_call.load(), host::Call::kResolve) << fault;
  }
}

// in quarantine a coupling holds nothing: the tool goes through the ball
TEST(Couplings, AreReleasedInQuarantine) {
  for (int who = 0; who < 3; ++who) {
    FakeScene s;
    push_up(s);
    const auto fail = [](const auto*) { return swage_result{SWAGE_ERROR}; };
    if (who == 0) s.coupling_.resolve = fail;
    if (who == 1) s.ball_.forces = fail;
    if (who == 2) s.tool_.finish = fail;
    s.run(kTouch + 50);
    EXPECT_EQ(s.ball().p.z, 5e-3) << who;
    EXPECT_TRUE(s.engine().contacts().contact.empty()) << who;
    EXPECT_EQ(s.engine().quarantined(), 1u);
  }
  FakeScene healthy;
  push_up(healthy);
  healthy.run(kTouch + 50);
  EXPECT_GT(healthy.ball().p.z, 5e-3);
}

/// What a coupling of the next test draws.
struct Drawn {
  static inline std::vector<swage_visual> list;
  static swage_result draw(swage_instance*, const swage_object_step* object, const swage_coupling_step* step, uint32_t capacity, swage_visual* out,
                           uint32_t* n) {
    if (object != nullptr || step == nullptr) return SWAGE_ERROR;
    *n = static_cast<uint32_t>(std::min<size_t>(capacity, list.size()));
    std::copy_n(list.begin(), *n, out);
    return SWAGE_OK;
  }
  static constexpr swage_visuals table{draw};
};

// what a coupling draws: in every snapshot, in the world, for the left hand mirrored, and none of it when a number has no sense
TEST(Couplings, DrawOnObjectB) {
  const swage_visual wound{SWAGE_VISUAL_WOUND, SWAGE_NONE, 3, 0, {2e-3, 0, 0}, {2.24e-3, 0, -3.2e-4}, {0.6, 0, -0.8}, 2e-4, 1};
  const swage_visual disc{SWAGE_VISUAL_DISC, 0, 0, SWAGE_TONE_INK, {0, 0, 1e-3}, {0, 0, 1e-3}, {0, 0, 1}, 1e-3, 0.5};
  FakeScene s;
  s.rig.couplings[0].visuals = &Drawn::table;
  const uint32_t b = s.rig.couplings[0].object_b;
  s.engine();  // poses are there from then on
  swage_pose& X_WB = s.rig.world.X_WB[s.rig.objects[b].body.first];
  X_WB = {{1e-3, 2e-3, 3e-3}, {M_SQRT1_2, 0, M_SQRT1_2, 0}};  // z to x
  const auto shot = std::make_unique<snapshot::Snapshot>();
  for (const double sign : {1.0, -1.0}) {
    Drawn::list = {wound, disc};
    s.rig.mirror = sign < 0;
    s.engine().fill(*shot);
    ASSERT_EQ(shot->n_visual, 2u);
    const snapshot::VisualMark &told = shot->visual[0], &on_body = shot->visual[1];
    EXPECT_EQ(told.object, b);
    EXPECT_EQ(told.coupling, 0u);
    EXPECT_EQ(told.visual.group, 3u);
    EXPECT_EQ(told.visual.strength, 1);
    EXPECT_EQ(told.visual.a.x, sign * 2e-3);
    EXPECT_EQ(told.visual.b.x, sign * 2.24e-3);
    EXPECT_EQ(told.visual.direction.x, sign * 0.6);
    EXPECT_NEAR(on_body.visual.a.x, sign * 2e-3, 1e-15);
    EXPECT_NEAR(on_body.visual.a.z, 3e-3, 1e-15);
    EXPECT_NEAR(on_body.visual.direction.x, sign, 1e-12);
  }
  const auto drawn = [&](const auto& spoil) {
    Drawn::list = {wound, disc};
    spoil(Drawn::list[1]);
    s.engine().fill(*shot);
    return shot->n_visual;
  };
  EXPECT_EQ(drawn([](swage_visual&) {}), 2u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.a.z = std::numeric_limits<double>::quiet_NaN(); }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.direction.z = std::numeric_limits<double>::infinity(); }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.kind = 99; }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.tone = 99; }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.body = 99; }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.radius = -1e-3; }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.strength = 1.01; }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.direction = {0, 0, 0}; }), 0u);
  EXPECT_EQ(drawn([](swage_visual& v) { v.direction = {0, 0, 2}; }), 0u);
  Drawn::list.assign(200, disc);
  s.engine().fill(*shot);
  EXPECT_EQ(shot->n_visual, snapshot::kMaxVisualsOfOne);
}

// what a picture lacks is counted; the first faulty primitive is remembered with its member
TEST(Couplings, DrawingsLeftOutAreCounted) {
  const swage_visual disc{SWAGE_VISUAL_DISC, 0, 0, SWAGE_TONE_INK, {0, 0, 1e-3}, {0, 0, 1e-3}, {0, 0, 1}, 1e-3, 0.5};
  FakeScene s;
  s.rig.couplings[0].visuals = &Drawn::table;
  const auto shot = std::make_unique<snapshot::Snapshot>();
  const base::DrawingHealth& health = shot->health.visuals;
  const auto draw = [&](std::size_t n, std::size_t faulty, const auto& spoil) {
    Drawn::list.assign(n, disc);
    if (faulty < n) spoil(Drawn::list[faulty]);
    s.engine().fill(*shot);
  };
  const auto nothing = [](swage_visual&) {};
  draw(snapshot::kMaxVisualsOfOne, 99, nothing);
  EXPECT_EQ(health.faulty + health.cut, 0u);
  draw(snapshot::kMaxVisualsOfOne + 1, 99, nothing);
  EXPECT_EQ(health.cut, 1u);
  EXPECT_EQ(health.faulty, 0u);

  draw(3, 2, [](swage_visual& v) { v.direction = {0, 0, 0}; });
  EXPECT_EQ(health.faulty, 1u);
  EXPECT_EQ(health.object, s.rig.couplings[0].object_b);
  EXPECT_EQ(health.coupling, 0u);
  EXPECT_EQ(health.index, 2u);
  EXPECT_STREQ(base::visual_kind(health.kind), "disc");
  EXPECT_STREQ(base::visual_member(health.member), "direction");
  // later ones count, and the first stays
  draw(1, 0, [](swage_visual& v) { v.b.y = std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_EQ(health.faulty, 2u);
  EXPECT_EQ(health.index, 2u);
  EXPECT_EQ(base::text(health), "2 drawings left out for a faulty primitive, 1 drawings cut for lack of room");
}

TEST(Couplings, TheFaultyMemberOfADrawingIsNamed) {
  const swage_visual line{SWAGE_VISUAL_LINE, 0, 0, SWAGE_TONE_INK, {0, 0, 0}, {0, 0, 1e-3}, {0, 0, 0}, 1e-4, 1};
  const auto member = [&](const auto& spoil) {
    FakeScene s;
    s.rig.couplings[0].visuals = &Drawn::table;
    Drawn::list = {line};
    spoil(Drawn::list[0]);
    const auto shot = std::make_unique<snapshot::Snapshot>();
    s.engine().fill(*shot);
    return std::string(base::visual_member(shot->health.visuals.member));
  };
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(member([](swage_visual&) {}), "");
  EXPECT_EQ(member([](swage_visual& v) { v.kind = 99; }), "kind");
  EXPECT_EQ(member([](swage_visual& v) { v.tone = 99; }), "tone");
  EXPECT_EQ(member([](swage_visual& v) { v.body = 99; }), "body");
  EXPECT_EQ(member([](swage_visual& v) { v.a.z = kNaN; }), "a.z");
  EXPECT_EQ(member([](swage_visual& v) { v.b.x = 1e7; }), "b.x");
  EXPECT_EQ(member([](swage_visual& v) { v.direction.y = kNaN; }), "direction.y");
  EXPECT_EQ(member([](swage_visual& v) { v.radius = kNaN; }), "radius");
  EXPECT_EQ(member([](swage_visual& v) { v.radius = -1e-3; }), "radius");
  EXPECT_EQ(member([](swage_visual& v) { v.strength = kNaN; }), "strength");
}

TEST(Couplings, TellEventsOfTheirOwn) {
  FakeScene s;
  s.coupling_.coupling_finish = [](const swage_coupling_step* step) {
    step->event(step, 0, 3.5);
    step->event(step, 1, 9);  // not theirs
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  ASSERT_EQ(s.engine().events().size(), 1u);
  EXPECT_EQ(s.engine().events()[0].event, 0u);
  EXPECT_EQ(s.engine().events()[0].value, 3.5);
}

}  // namespace
}  // namespace swage::step
