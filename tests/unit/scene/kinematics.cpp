// SPDX-License-Identifier: Apache-2.0
#include "scene/kinematics.hpp"

#include <gtest/gtest.h>

namespace swage::scene {
namespace {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

TEST(Kinematics, TwistBetweenLeadsFromOnePoseToTheOther) {
  const double dt = 1e-3;
  // from turns that single precision would lose to turns of a quarter circle per step
  for (const double angle : {0.0, 1e-12, 1e-6, 1e-3, 1.5}) {
    const Pose X0(Vec3(1e-3, 2e-3, -1e-3), Quat(0.5, 0.5, -0.5, 0.5));
    const Vec3 axis = Vec3(1, -2, 0.5).normalized();
    const Pose X1(X0.p + Vec3(1e-5, 0, -2e-5), toolkit::exp_rotation(angle * axis) * X0.q);
    const swage_twist V = twist_between(X0, X1, dt);
    EXPECT_NEAR((toolkit::vec(V.w) - angle / dt * axis).norm(), 0, 1e-9 * angle / dt + 1e-12);

    const Pose back = moved(X0, V, dt);
    EXPECT_LT((back.p - X1.p).norm(), 1e-18);
    EXPECT_LT((back.q.coeffs() - X1.q.coeffs()).norm(), 1e-15);
  }
}

TEST(Kinematics, FollowKeepsTheStartOfTheStepInTheTwist) {
  World w;
  w.body.resize(1);
  w.body[0].motion = SWAGE_MOTION_FOLLOWS;
  w.body[0].start.q.w = 1;
  reset(w);
  const Pose X0(w.X_WB[0]);
  const Pose X1(Vec3(3e-5, 0, 1e-6), toolkit::exp_rotation(Vec3(0, 1e-4, 0)));
  follow(w, 0, X1);

  swage_twist back = w.V_WB[0];
  for (double* v : {&back.v.x, &back.v.y, &back.v.z, &back.w.x, &back.w.y, &back.w.z}) *v = -*v;
  const Pose start = moved(Pose(w.X_WB[0]), back, w.dt);
  EXPECT_LT((start.p - X0.p).norm(), 1e-19);
  EXPECT_LT((start.q.coeffs() - X0.q.coeffs()).norm(), 1e-15);
}

TEST(Kinematics, HingedChildTurnsAboutTheAnchor) {
  HingeInfo hinge;
  hinge.anchor = {1, 0, 0};
  hinge.axis = {0, 0, 1};
  hinge.X_PC0 = {{3, 0, 0}, {1, 0, 0, 0}};
  const Pose X_WP(Vec3(0, 0, 5), toolkit::exp_rotation(Vec3(M_PI / 2, 0, 0)));

  EXPECT_LT((hinged(hinge, X_WP, 0).p - Vec3(3, 0, 5)).norm(), 1e-15);
  // a quarter turn in the parent: (1, 2, 0), which the parent's own turn about x lifts to (1, 0, 2)
  EXPECT_LT((hinged(hinge, X_WP, M_PI / 2).p - Vec3(1, 0, 7)).norm(), 1e-14);
}

TEST(Kinematics, ResetPutsEverythingAtItsStart) {
  World w;
  w.body.resize(2);
  for (auto& body : w.body) body.start.q.w = 1;
  w.body[1].motion = SWAGE_MOTION_HINGED;
  w.hinge.push_back({.parent = 0, .child = 1, .axis = {0, 0, 1}, .X_PC0 = {{1e-3, 0, 0}, {1, 0, 0, 0}}});
  w.plugin_state = {1, 2};
  reset(w);
  EXPECT_EQ(w.X_WB[1].p.x, 1e-3);
  EXPECT_EQ(w.drive.size(), 1u);
  EXPECT_EQ(w.plugin_state[1], 0);
}

}  // namespace
}  // namespace swage::scene
