// SPDX-License-Identifier: Apache-2.0
#include "dynamics/flexible_bodies.hpp"

#include <gtest/gtest.h>

namespace swage::dynamics {
namespace flexible_bodies_test {

/// A free point mass as a flexible body.
class PointMass : public FlexibleBody {
 public:
  uint32_t object() const noexcept override { return 3; }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    const size_t n = 3 * point.size();
    for (size_t i = 0; i < n; ++i) {
      v_free[i] = i % 3 == 2 ? -0.01 : 0;
      for (size_t j = 0; j < n; ++j) W[i * n + j] = i % 3 == j % 3 ? 1 / mass : 0;
    }
    if (nonsense) W[0] = NAN;
    return answers;
  }
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override {
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
  w.body[0].motion = SWAGE_MOTION_FLEXIBLE;
  w.body[0].object = 3;
  return w;
}

TEST(FlexibleBodies, GoByTheirForcesAndAreGivenThose) {
  const scene::World w = world_with_self_body();
  FlexibleBodies blocks(w);
  PointMass mass;
  FlexibleBody* const all[] = {&mass};
  blocks.begin(all, {});
  ASSERT_EQ(blocks.slot(3), 0u);
  EXPECT_EQ(blocks.slot(2), scene::kNone);
  blocks.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
  blocks.add_point(0, 0, 0, Vec3::UnitX(), Vec3::UnitZ());
  blocks.ask(1e-3);
  ASSERT_TRUE(blocks.gives(0));
  EXPECT_LT((blocks.u_free(0, 1) - Vec3(0, 0, -1e-5)).norm(), 1e-20);

  // u = h^2 W f at both points, for a force at one of them
  const Vec3 f(1e-3, -2e-3, 5e-4), u = 1e-6 * f / mass.mass;
  blocks.begin_forces(0);
  blocks.add_force(0, 0, f);
  blocks.go(0, 1);
  EXPECT_LT((blocks.extra(0, 0) - u).norm(), 1e-15 * u.norm());
  EXPECT_LT((blocks.extra(0, 1) - u).norm(), 1e-15 * u.norm());

  // half the way to three times as much, of which some at the other point: twice
  blocks.begin_forces(0);
  blocks.add_force(0, 0, f);
  blocks.add_force(0, 1, f);
  blocks.add_force(0, 1, f);
  blocks.go(0, 0.5);
  EXPECT_LT((blocks.extra(0, 1) - 2 * u).norm(), 1e-15 * u.norm());
  blocks.apply_impulses();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(mass.got[i], 1e-3 * 2 * f[i], 1e-18);
}

// the solve starts at the expected positions of the points, whatever the forces for that
TEST(FlexibleBodies, StartsWherePointsAreExpected) {
  const scene::World w = world_with_self_body();
  FlexibleBodies blocks(w);
  PointMass mass;
  FlexibleBody* const all[] = {&mass};
  blocks.begin(all, {});
  blocks.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
  blocks.add_point(0, 0, 0, Vec3::UnitX(), Vec3::UnitZ());
  blocks.ask(1e-3);
  const Vec3 where(2e-6, -1e-6, 3e-6);
  for (const uint32_t point : {0u, 1u}) blocks.expect(0, point, where);
  blocks.start();
  for (const uint32_t point : {0u, 1u}) EXPECT_LT((blocks.displacement(0, point) - where).norm(), 1e-18);

  // the next step queries anew and starts without forces
  blocks.begin(all, {});
  blocks.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
  blocks.ask(1e-3);
  EXPECT_EQ(blocks.extra(0, 0), Vec3::Zero());
  blocks.apply_impulses();
  EXPECT_EQ(mass.got[2], 0);
}

TEST(FlexibleBodies, WhoFailsOrAnswersNonsenseStandsStill) {
  const scene::World w = world_with_self_body();
  for (const bool nonsense : {false, true}) {
    FlexibleBodies blocks(w);
    PointMass mass;
    mass.answers = nonsense;
    mass.nonsense = nonsense;
    FlexibleBody* const all[] = {&mass};
    blocks.begin(all, {});
    blocks.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ());
    blocks.ask(1e-3);
    EXPECT_FALSE(blocks.gives(0));
    blocks.expect(0, 0, Vec3::UnitX());
    blocks.start();
    EXPECT_EQ(blocks.displacement(0, 0), Vec3::Zero());
  }
}

TEST(FlexibleBodies, RefusesPointsBeyondItsCapacity) {
  const scene::World w = world_with_self_body();
  FlexibleBodies blocks(w);
  PointMass mass;
  FlexibleBody* const all[] = {&mass};
  blocks.begin(all, {});
  for (uint32_t i = 0; i < blocks.room(0); ++i)
    EXPECT_EQ(blocks.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ()), i);
  EXPECT_EQ(blocks.add_point(0, 0, 0, Vec3::Zero(), Vec3::UnitZ()), scene::kNone);
}

}  // namespace flexible_bodies_test
}  // namespace swage::dynamics
