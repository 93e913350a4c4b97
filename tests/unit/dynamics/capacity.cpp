// SPDX-License-Identifier: Apache-2.0
//
// Scenes with more contacts than the capacity: the deepest contacts, and those with a force in the
// last step, are solved; the others are counted. No island loses all its forces, and none reads the forces of another.
#include <gtest/gtest.h>

#include <memory>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "scene/kinematics.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {
namespace capacity_test {

constexpr double kLarge = 1e-3, kSmall = 20e-6;  // m, radii
constexpr double kStiffness = 1e6;               // N/m
constexpr double kMass = 4e-7;                   // kg

/// A ball whose mobility at its contact points is that of a free body that cannot rotate.
class Ball : public FlexibleBody {
 public:
  explicit Ball(uint32_t object) : object_(object) {}
  uint32_t object() const noexcept override { return object_; }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    asked = point.size();
    const size_t n = 3 * point.size();
    for (size_t i = 0; i < n; ++i) {
      v_free[i] = 0;
      for (size_t j = 0; j < n; ++j) W[i * n + j] = i % 3 == j % 3 ? 1 / kMass : 0;
    }
    return answers;
  }
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override {
    got.setZero();
    for (size_t i = 0; i < point.size(); ++i)
      got += Vec3(impulse[3 * i], impulse[3 * i + 1], impulse[3 * i + 2]);
  }
  size_t asked = 0;
  bool answers = true;
  Vec3 got = Vec3::Zero();  // N s

 private:
  uint32_t object_;
};

/// Two flexible balls that touch each other, each between so many pairs of fixed balls that press from
/// opposite sides; and, apart from them, a rigid ball on a fixed one.
struct Crowd {
  explicit Crowd(uint32_t pairs_each) : ball{Ball(0), Ball(1)} {
    add(0, Vec3(-kLarge + 0.5e-9, 0, 0), kLarge, SWAGE_MOTION_FLEXIBLE);
    add(1, Vec3(kLarge - 0.5e-9, 0, 0), kLarge, SWAGE_MOTION_FLEXIBLE);
    for (uint32_t b = 0; b < 2; ++b)
      for (uint32_t i = 0; i < pairs_each; ++i) {
        // deeper from pair to pair, 1 nm to 3 nm
        const double overlap = 1e-9 * (1 + 2.0 * i / pairs_each), angle = M_PI * (i + 0.3) / pairs_each;
        const Vec3 way = (kLarge + kSmall - overlap) * Vec3(0, std::cos(angle), std::sin(angle));
        for (const double sign : {1.0, -1.0})
          add(2, Vec3(b == 0 ? -kLarge : kLarge, 0, 0) + sign * way, kSmall, SWAGE_MOTION_FIXED);
      }
    apart = static_cast<uint32_t>(world.body.size());
    add(3, Vec3(0, 0, 20e-3), kLarge, SWAGE_MOTION_DYNAMIC);
    add(2, Vec3(0, 0, 20e-3 - 2 * kLarge + 2e-9), kLarge, SWAGE_MOTION_FIXED);
    world.gravity = {0, 0, 0};
    scene::reset(world);
  }
  void add(uint32_t object, const Vec3& p, double radius, int32_t motion) {
    scene::BodyInfo body;
    body.motion = motion, body.object = object;
    body.start = toolkit::Pose(p, toolkit::Quat::Identity()).abi();
    body.mass = kMass;
    for (double& I : body.inertia) I = 1e-13;
    scene::Shape shape;
    shape.body = static_cast<uint32_t>(world.body.size()), shape.object = object;
    shape.X_BS = toolkit::Pose{}.abi();
    shape.radius = shape.bounding_radius = radius;
    world.body.push_back(body);
    world.shape.push_back(shape);
  }
  void begin(const Options& options = {}) {
    const contact::Law law{0.3, kStiffness, 1};
    const std::vector<contact::Pair> pairs{{0, 2, law}, {1, 2, law}, {0, 1, law}, {3, 2, law}};
    detector = std::make_unique<contact::Detector>(world, pairs, contact::Options{});
    dynamics = std::make_unique<Dynamics>(world, options);
    detector->reserve(contacts);
  }
  void step() {
    if (!dynamics) begin();
    dynamics->free_motion(world);
    detector->detect(world, contacts);
    FlexibleBody* const self[] = {&ball[0], &ball[1]};
    dynamics->solve(world, contacts, self);
  }
  bool is_apart(const contact::Contact& c) const { return c.body_a >= apart || c.body_b >= apart; }

  Ball ball[2];
  scene::World world;
  uint32_t apart = 0;
  contact::ContactSet contacts;
  std::unique_ptr<contact::Detector> detector;
  std::unique_ptr<Dynamics> dynamics;
};

TEST(Capacity, AnIslandBeyondItKeepsItsDeepestContacts) {
  Crowd crowd(35);  // 70 + 70 + 1 constraints in one island of flexible bodies
  crowd.step();
  ASSERT_EQ(crowd.contacts.contact.size(), 142u);
  uint32_t bearing = 0;
  double deepest_idle = 0, shallowest_bearing = 1;
  for (const contact::Contact& c : crowd.contacts.contact) {
    const double f = c.f_a_W.norm();
    if (crowd.is_apart(c)) {
      EXPECT_GT(f, 1e-10) << "an island of its own";
      continue;
    }
    bearing += f > 0;
    double& edge = f > 0 ? shallowest_bearing : deepest_idle;
    edge = f > 0 ? std::min(edge, -c.gap) : std::max(edge, -c.gap);
  }
  EXPECT_EQ(bearing, 128u);
  EXPECT_LE(deepest_idle, shallowest_bearing * 1.05);
  const base::SolverHealth& health = crowd.dynamics->stats().health;
  EXPECT_EQ(health.dropped_contacts, 13u);
  EXPECT_EQ(health.steps, 1u);
  EXPECT_EQ(health.total(), 13u);
}

// contacts with a force keep their place when deeper ones appear
TEST(Capacity, WhatBearsForceStays) {
  Crowd crowd(35);
  crowd.step();
  std::vector<bool> bore;
  for (const contact::Contact& c : crowd.contacts.contact) bore.push_back(!c.f_a_W.isZero(0));
  // the contacts that were left out become deeper than all others
  for (size_t i = 0; i < bore.size(); ++i) {
    const contact::Contact& c = crowd.contacts.contact[i];
    if (bore[i] || crowd.is_apart(c)) continue;
    swage_vec3& p = crowd.world.X_WB[c.body_b].p;
    p = toolkit::raw(Vec3(toolkit::vec(p) + 5e-9 * c.n_W));
  }
  crowd.step();
  ASSERT_EQ(crowd.contacts.contact.size(), bore.size());
  for (size_t i = 0; i < bore.size(); ++i) {
    const contact::Contact& c = crowd.contacts.contact[i];
    if (crowd.is_apart(c)) continue;  // no longer in contact
    EXPECT_EQ(!c.f_a_W.isZero(0), bore[i]) << i;
  }
}

TEST(Capacity, WithRoomForAllNothingIsCounted) {
  Crowd crowd(35);
  scene::make_room(crowd.world.capacity, 100);
  EXPECT_EQ(crowd.world.capacity.points, 100u);
  EXPECT_EQ(crowd.world.capacity.rows, 200u);
  crowd.step();
  for (const contact::Contact& c : crowd.contacts.contact) EXPECT_GT(c.f_a_W.norm(), 1e-10);
  EXPECT_EQ(crowd.dynamics->stats().health.total(), 0u);
}

// contacts beyond the points of a flexible body are solved at the nearest point: their whole force is applied
TEST(Capacity, ContactsBeyondThePointsShareThem) {
  Crowd crowd(60);  // 120 contacts of each ball
  crowd.world.capacity.rows = 256;
  crowd.ball[0].answers = crowd.ball[1].answers = true;
  crowd.step();
  EXPECT_EQ(crowd.ball[0].asked, 96u);
  Vec3 on_ball = Vec3::Zero();
  for (const contact::Contact& c : crowd.contacts.contact) {
    EXPECT_GT(c.f_a_W.norm(), 1e-10);
    if (c.body_a == 0) on_ball += c.f_a_W;
  }
  EXPECT_LT((crowd.ball[0].got / crowd.world.dt - on_ball).norm(), 1e-6);
  EXPECT_EQ(crowd.dynamics->stats().health.shared_points, 2u * (121 - 96));
  EXPECT_EQ(crowd.dynamics->stats().health.total(), 2u * (121 - 96));
}

TEST(Capacity, WhoDoesNotAnswerIsCounted) {
  Crowd crowd(3);
  crowd.ball[1].answers = false;
  crowd.step();
  EXPECT_EQ(crowd.dynamics->stats().health.unanswered, 7u);
  EXPECT_EQ(crowd.dynamics->stats().health.steps, 1u);
}

// beyond the budget every island keeps forces, the same in every run
TEST(Capacity, PastTheBudgetForcesStay) {
  Crowd once(10), again(10);
  for (Crowd* crowd : {&once, &again}) {
    Options options;
    options.budget = 1;
    crowd->begin(options);
    crowd->step();
    EXPECT_EQ(crowd->dynamics->stats().health.over_budget, 1u);
    for (const contact::Contact& c : crowd->contacts.contact) EXPECT_GT(c.f_a_W.norm(), 1e-10);
  }
  for (size_t i = 0; i < once.contacts.contact.size(); ++i)
    EXPECT_EQ(once.contacts.contact[i].f_a_W, again.contacts.contact[i].f_a_W);
}

}  // namespace capacity_test
}  // namespace swage::dynamics
