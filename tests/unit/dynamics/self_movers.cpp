// SPDX-License-Identifier: Apache-2.0
#include "dynamics/self_movers.hpp"

#include <gtest/gtest.h>

namespace swage::dynamics {
namespace {

/// A free point mass that claims to have its own mechanics.
class PointMass : public SelfSolver {
 public:
  uint32_t object() const noexcept override { return 3; }
  bool compliance(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    const size_t n = 3 * point.size();
    for (size_t i = 0; i < n; ++i) {
      v_free[i] = i % 3 == 2 ? -0.01 : 0;
      for (size_t j = 0; j < n; ++j) W[i * n + j] = i % 3 == j % 3 ? 1 / mass : 0;
    }
    if (nonsense) W[0] = NAN;
    return answers;
  }
  void yield(std::span<const swage_contact_point> point, const double* impulse) noexcept override {
    for (size_t i = 0; i < point.size(); ++i)
      for (size_t k = 0; k < 3; ++k) got[k] += impulse[3 * i + k];
  }
  double mass = 4e-7;
  bool answers = true, nonsense = false;
  double got[3] = {0, 0, 0};
};

scene::World world_with_self_body() {
  scene::World w;
  w.body.resize(1);
  w.body[0].motion = SWAGE_MOTION_SELF;
  w.body[0].object = 3;
  return w;
}

TEST(SelfMovers, GoByTheirForcesAndAreGivenThose) {
  const scene::World w = world_with_self_body();
  SelfMovers movers(w);
  PointMass mass;
  SelfSolver* const all[] = {&mass};
  movers.begin(all);
  ASSERT_EQ(movers.slot(3), 0u);
  EXPECT_EQ(movers.slot(2), scene::kNone);
  movers.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
  movers.add_point(0, 0, 0, Vec3::UnitX(), Vec3::UnitZ());
  movers.ask(1e-3);
  ASSERT_TRUE(movers.gives(0));
  EXPECT_LT((movers.u_free(0, 1) - Vec3(0, 0, -1e-5)).norm(), 1e-20);

  // u = h^2 W f at both points, for a force at one of them
  const Vec3 f(1e-3, -2e-3, 5e-4), u = 1e-6 * f / mass.mass;
  movers.begin_forces(0);
  movers.add_force(0, 0, f);
  movers.go(0, 1);
  EXPECT_LT((movers.extra(0, 0) - u).norm(), 1e-15 * u.norm());
  EXPECT_LT((movers.extra(0, 1) - u).norm(), 1e-15 * u.norm());

  // half the way to three times as much, of which some at the other point: twice
  movers.begin_forces(0);
  movers.add_force(0, 0, f);
  movers.add_force(0, 1, f);
  movers.add_force(0, 1, f);
  movers.go(0, 0.5);
  EXPECT_LT((movers.extra(0, 1) - 2 * u).norm(), 1e-15 * u.norm());
  movers.yield();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(mass.got[i], 1e-3 * 2 * f[i], 1e-18);
}

// the solve begins where points are expected, whatever forces that takes
TEST(SelfMovers, StartsWherePointsAreExpected) {
  const scene::World w = world_with_self_body();
  SelfMovers movers(w);
  PointMass mass;
  SelfSolver* const all[] = {&mass};
  movers.begin(all);
  movers.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
  movers.add_point(0, 0, 0, Vec3::UnitX(), Vec3::UnitZ());
  movers.ask(1e-3);
  const Vec3 where(2e-6, -1e-6, 3e-6);
  for (const uint32_t point : {0u, 1u}) movers.expect(0, point, where);
  movers.start();
  for (const uint32_t point : {0u, 1u}) EXPECT_LT((movers.displacement(0, point) - where).norm(), 1e-18);

  // the next step asks anew and begins without forces
  movers.begin(all);
  movers.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
  movers.ask(1e-3);
  EXPECT_EQ(movers.extra(0, 0), Vec3::Zero());
  movers.yield();
  EXPECT_EQ(mass.got[2], 0);
}

TEST(SelfMovers, WhoFailsOrAnswersNonsenseStandsStill) {
  const scene::World w = world_with_self_body();
  for (const bool nonsense : {false, true}) {
    SelfMovers movers(w);
    PointMass mass;
    mass.answers = nonsense;
    mass.nonsense = nonsense;
    SelfSolver* const all[] = {&mass};
    movers.begin(all);
    movers.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
    movers.ask(1e-3);
    EXPECT_FALSE(movers.gives(0));
    movers.expect(0, 0, Vec3::UnitX());
    movers.start();
    EXPECT_EQ(movers.displacement(0, 0), Vec3::Zero());
  }
}

TEST(SelfMovers, RefusesPointsBeyondItsCapacity) {
  const scene::World w = world_with_self_body();
  SelfMovers movers(w);
  PointMass mass;
  SelfSolver* const all[] = {&mass};
  movers.begin(all);
  for (uint32_t i = 0; i < movers.room(); ++i)
    EXPECT_EQ(movers.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ()), i);
  EXPECT_EQ(movers.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ()), scene::kNone);
}

}  // namespace
}  // namespace swage::dynamics
