// SPDX-License-Identifier: Apache-2.0
#include "dynamics/motion.hpp"

#include <gtest/gtest.h>

#include "dynamics/rotation.hpp"
#include "scene/kinematics.hpp"

namespace swage::dynamics {
namespace motion_test {

using toolkit::vec;

scene::World one_body() {
  scene::World w;
  w.body.resize(1);
  w.body[0].motion = SWAGE_MOTION_DYNAMIC;
  w.body[0].mass = 4e-7;
  for (double& I : w.body[0].inertia) I = 1e-12;
  w.body[0].start.q.w = 1;
  return w;
}

TEST(Motion, RefusesWhatCannotMove) {
  scene::World w = one_body();
  w.body[0].mass = 0;
  EXPECT_THROW(Motion{w}, std::invalid_argument);
  w = one_body();
  w.body[0].inertia[2] = 0;
  EXPECT_THROW(Motion{w}, std::invalid_argument);

  w = one_body();
  w.body.resize(2);
  w.hinge.push_back({.parent = 0, .child = 1, .axis = {0, 0, 1}, .inertia = 1e-9});
  EXPECT_THROW(Motion{w}, std::invalid_argument);
}

// a free fall is exact for any step, with any previous steps
TEST(Motion, FreeFallIsExact) {
  scene::World w = one_body();
  w.gravity = {0, 0, -9.81};
  scene::reset(w);
  w.V_WB[0].v = {0.1, 0, 0.2};
  Motion motion(w);
  for (w.step = 1; w.step <= 100; ++w.step) motion.predict(w, FreeMotion::kSplitting4);
  const double t = 0.1;
  EXPECT_NEAR(w.X_WB[0].p.x, 0.1 * t, 1e-15);
  EXPECT_NEAR(w.X_WB[0].p.z, 0.2 * t - 0.5 * 9.81 * t * t, 1e-15);
  EXPECT_NEAR(w.V_WB[0].v.z, 0.2 - 9.81 * t, 1e-14);
}

TEST(Motion, HeldBodiesArePredictedToGoOn) {
  scene::World w = one_body();
  w.gravity = {0, 0, -9.81};
  scene::reset(w);
  w.V_WB[0].v = {1e-2, 0, 0};
  Motion motion(w);
  motion.held_body[0] = 1;
  motion.predict(w, FreeMotion::kSplitting4);
  EXPECT_DOUBLE_EQ(w.X_WB[0].p.x, 1e-5);
  EXPECT_EQ(w.X_WB[0].p.z, 0);
  EXPECT_LT(motion.X_free[0].p.z(), 0);
}

TEST(Motion, ParticlesFallAndTakeForces) {
  scene::World w;
  w.particle_mass = {1e-9};
  w.gravity = {0, 0, -10};
  scene::reset(w);
  w.particle_f_W = {1e-9, 0, 0};
  Motion motion(w);
  motion.predict(w, FreeMotion::kSplitting4);
  EXPECT_DOUBLE_EQ(w.particle_p_W[0], 0.5e-6);
  EXPECT_DOUBLE_EQ(w.particle_p_W[2], -5e-6);
  EXPECT_DOUBLE_EQ(w.particle_v_W[2], -1e-2);
}

// a hinged child moves with its parent: the velocity of its points is the derivative of its pose
TEST(Motion, HingedChildMovesWithItsParent) {
  scene::World w;
  w.body.resize(2);
  for (auto& body : w.body) body.start.q.w = 1;
  w.body[0].motion = SWAGE_MOTION_FOLLOWS;
  w.body[1].motion = SWAGE_MOTION_HINGED;
  w.body[1].hinge = 0;
  w.hinge.push_back({.parent = 0,
                     .child = 1,
                     .anchor = {1e-3, 0, 0},
                     .axis = {0, 1, 0},
                     .X_PC0 = {{5e-3, 0, 0}, {1, 0, 0, 0}},
                     .inertia = 3e-7,
                     .min = -1,
                     .max = 1});
  scene::reset(w);
  w.hinge_rate[0] = 0.2;
  Motion motion(w);
  const Pose before(w.X_WB[1]);
  scene::follow(w, 0, Pose(Vec3(1e-5, 0, 0), turn(Vec3(0, 0, 1e-4))));
  motion.predict(w, FreeMotion::kSplitting4);
  EXPECT_NEAR(w.hinge_angle[0], 0.2e-3, 1e-18);
  const Pose expected = scene::moved(before, w.V_WB[1], w.dt);
  EXPECT_LT((expected.p - vec(w.X_WB[1].p)).norm(), 1e-9);  // second order in the step
  EXPECT_LT((expected.q.coeffs() - toolkit::quat(w.X_WB[1].q).coeffs()).norm(), 1e-7);
}

}  // namespace motion_test
}  // namespace swage::dynamics
