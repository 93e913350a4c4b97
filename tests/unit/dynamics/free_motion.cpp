// SPDX-License-Identifier: Apache-2.0
#include "dynamics/free_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swage::dynamics {
namespace free_motion_test {

const Vec3 kMoments(1e-12, 2e-12, 3e-12);

RigidState spun(const Vec3& w) { return {Vec3::Zero(), Quat::Identity(), Vec3::Zero(), w}; }

double attitude_error(const Quat& a, const Quat& b) {
  const Quat d = a.conjugate() * b;
  return 2 * d.vec().norm();
}

RigidState after(FreeMotion method, const Vec3& t_W, double h, double seconds) {
  const RigidMass m(4e-7, kMoments);
  RigidState s = spun(Vec3(3, 20, -10));
  const int n = static_cast<int>(std::lround(seconds / h));
  for (int i = 0; i < n; ++i) move_free(method, m, Vec3::Zero(), t_W, h, s);
  return s;
}

/// Order of convergence in attitude, from the errors at h and h / 2 against a far finer run.
double order(FreeMotion method, const Vec3& t_W, double h) {
  const double seconds = 0.2;
  const RigidState exact = after(FreeMotion::kRungeKutta4, t_W, 2e-5, seconds);
  const double coarse = attitude_error(after(method, t_W, h, seconds).q_WB, exact.q_WB);
  const double fine = attitude_error(after(method, t_W, h / 2, seconds).q_WB, exact.q_WB);
  return std::log2(coarse / fine);
}

TEST(FreeMotion, OrdersOfConvergence) {
  const Vec3 none = Vec3::Zero();
  EXPECT_NEAR(order(FreeMotion::kThesis, none, 5e-4), 1, 0.15);
  EXPECT_NEAR(order(FreeMotion::kSymplecticEuler, none, 5e-4), 1, 0.15);
  EXPECT_NEAR(order(FreeMotion::kRungeKutta4, none, 4e-3), 4, 0.2);
  EXPECT_NEAR(order(FreeMotion::kSplitting2, none, 2e-3), 2, 0.1);
  EXPECT_NEAR(order(FreeMotion::kSplitting4, none, 4e-3), 4, 0.2);
  EXPECT_NEAR(order(FreeMotion::kTaylor, none, 8e-3), 5, 0.5);
}

// the closed form is as exact with long steps as with short ones: it divides those that its series cannot bear
TEST(FreeMotion, ClosedFormHasNoStep) {
  const RigidState exact = after(FreeMotion::kRungeKutta4, Vec3::Zero(), 2e-5, 0.2);
  for (const double h : {1e-3, 4e-3, 8e-3, 2e-2, 0.2})
    EXPECT_LT(attitude_error(after(FreeMotion::kElliptic, Vec3::Zero(), h, 0.2).q_WB, exact.q_WB), 1e-9) << h;
}

TEST(FreeMotion, OrdersUnderATorque) {
  const Vec3 t_W(2e-11, -1e-11, 3e-11);
  EXPECT_NEAR(order(FreeMotion::kRungeKutta4, t_W, 4e-3), 4, 0.2);
  EXPECT_NEAR(order(FreeMotion::kSplitting2, t_W, 2e-3), 2, 0.1);
  EXPECT_NEAR(order(FreeMotion::kSplitting4, t_W, 2e-3), 2, 0.1);
  EXPECT_NEAR(order(FreeMotion::kTaylor, t_W, 2e-3), 2, 0.1);
  EXPECT_NEAR(order(FreeMotion::kElliptic, t_W, 2e-3), 2, 0.1);
}

// axes in any order: the splittings choose their own, the answer must not
TEST(FreeMotion, AxesMayStandInAnyOrder) {
  const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (const FreeMotion method :
       {FreeMotion::kSplitting2, FreeMotion::kSplitting4, FreeMotion::kTaylor, FreeMotion::kElliptic}) {
    for (const auto& o : orders) {
      Vec3 I, w;
      for (int k = 0; k < 3; ++k) I[k] = kMoments[o[k]], w[k] = Vec3(3, 20, -10)[o[k]];
      const RigidMass m(4e-7, I);
      RigidState s = spun(w), exact = spun(w);
      for (int i = 0; i < 100; ++i) move_free(method, m, Vec3::Zero(), Vec3::Zero(), 1e-3, s);
      for (int i = 0; i < 10000; ++i)
        move_free(FreeMotion::kRungeKutta4, m, Vec3::Zero(), Vec3::Zero(), 1e-5, exact);
      const double good = method == FreeMotion::kSplitting2 ? 1e-3 : 1e-6;
      EXPECT_LT(attitude_error(s.q_WB, exact.q_WB), good);
    }
  }
}

TEST(FreeMotion, TranslationIsExactBeyondTheEulerMethods) {
  const RigidMass m(4e-7, kMoments);
  const Vec3 f(4e-7, 0, -8e-7);  // 1 and -2 m/s2
  const double h = 1e-3;
  for (const FreeMotion method : {FreeMotion::kRungeKutta4, FreeMotion::kSplitting2, FreeMotion::kTaylor}) {
    RigidState s = spun(Vec3::Zero());
    s.v_W = Vec3(0, 1, 0);
    for (int i = 0; i < 1000; ++i) move_free(method, m, f, Vec3::Zero(), h, s);
    EXPECT_LT((s.p_W - Vec3(0.5, 1, -1)).norm(), 1e-12);
  }
  RigidState s = spun(Vec3::Zero());
  for (int i = 0; i < 1000; ++i) move_free(FreeMotion::kThesis, m, f, Vec3::Zero(), h, s);
  EXPECT_NEAR(s.p_W.x(), 0.5 * (1 - h), 1e-12);  // explicit Euler is half a step late
}

}  // namespace free_motion_test
}  // namespace swage::dynamics
