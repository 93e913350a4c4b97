// SPDX-License-Identifier: Apache-2.0
//
// Ties: the law by itself, then bodies that hang on ties, compared with closed forms.
#include "dynamics/tie.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "dynamics/dynamics.hpp"

namespace swage::dynamics {
namespace tie_test {

using toolkit::vec;

TEST(TieLaw, SlidesAtItsLimitsAndRemembersTheRest) {
  const TieLaw law{100, 1000, 2e-3, 5e-3, 1e-3};
  // 3 um along: stalled. 8 um: 5 mN and 3 um slid. Backwards less is held
  EXPECT_NEAR(tie_force(law, {3e-6, 0, 0}).fn, -3e-3, 1e-15);
  EXPECT_NEAR(tie_force(law, {8e-6, 0, 0}).fn, -5e-3, 1e-15);
  EXPECT_NEAR(tie_force(law, {-8e-6, 0, 0}).fn, 1e-3, 1e-15);
  const Displacement far{8e-6, 30e-6, 40e-6};
  const Force f = tie_force(law, far);
  EXPECT_NEAR(f.f1, -2e-3 * 0.6, 1e-15);
  EXPECT_NEAR(f.f2, -2e-3 * 0.8, 1e-15);
  const Displacement slid = tie_plastic_slip(law, far, f);
  EXPECT_NEAR(slid.g, 3e-6, 1e-18);
  EXPECT_NEAR(slid.s1, 0.6 * 30e-6, 1e-18);  // of 50 um the spring keeps 20
  EXPECT_NEAR(slid.s2, 0.8 * 30e-6, 1e-18);
}

// on its own range each piece is the law; a hair before a kink the old pieces hold, a hair behind it the new ones
TEST(TieLaw, PiecesAreTheLawAndEndAtTheirKinks) {
  const TieLaw law{100, 1000, 2e-3, 5e-3, 1e-3};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-10e-6, 10e-6), across(-40e-6, 40e-6);
  int kinks[2] = {};
  for (int i = 0; i < 3000; ++i) {
    const Displacement u{along(random), across(random), across(random)}, e{along(random), across(random), across(random)};
    const TiePieces on = tie_pieces(law, u);
    const Force f = tie_force(law, u);
    const double spring = law.k_across * std::hypot(u.s1, u.s2), share = std::min(1.0, law.strength / spring);
    ASSERT_NEAR(f.fn, std::clamp(-law.k_along * u.g, -law.forward_limit, law.backward_limit), 1e-15);
    ASSERT_NEAR(f.f1, -share * law.k_across * u.s1, 1e-15);
    ASSERT_NEAR(f.f2, -share * law.k_across * u.s2, 1e-15);
    const auto at = [&](double t) {
      return tie_pieces(law, {u.g + t * e.g, u.s1 + t * e.s1, u.s2 + t * e.s2});
    };
    const TieKink k = tie_kink(on, law, u, e);
    const auto same = [](const TiePieces& a, const TiePieces& b) { return a.along == b.along && a.across == b.across; };
    ASSERT_TRUE(same(at(0.999999 * std::min(k.t, 1e3)), on)) << i;
    if (!std::isfinite(k.t)) continue;
    ASSERT_TRUE(same(at(1.000001 * k.t), k.next)) << i;
    ++kinks[k.next.along != on.along];
  }
  EXPECT_GT(kinks[0], 500);
  EXPECT_GT(kinks[1], 500);
}

TEST(TieLaw, ThePiecesOfAForceAreThoseThatItWasOn) {
  const TieLaw law{100, 1000, 2e-3, 5e-3, 1e-3};
  for (const Displacement& u : {Displacement{3e-6, 0, 0}, Displacement{8e-6, 3e-6, 0}, Displacement{-8e-6, 30e-6, 40e-6}}) {
    const TiePieces on = tie_pieces(law, u), then = tie_pieces_before(law, tie_force(law, u));
    EXPECT_EQ(on.along, then.along);
    EXPECT_EQ(on.across, then.across);
  }
  // without limits nothing slips
  const TieLaw firm{100, 1000};
  EXPECT_EQ(tie_pieces_before(firm, {1e9, 1e9, 0}).along, Along::kStick);
  EXPECT_EQ(tie_kink({}, firm, {0, 0, 0}, {1, 1, 1}).t, HUGE_VAL);
}

// a film that was slack is continued as slack and one that pulled with its limit as pulling, on whichever side of rest the prediction lies
TEST(TieLaw, SlipContinuesOnTheSideOnWhichItWas) {
  const TieLaw film{0, 1000, HUGE_VAL, 5e-3, 0};
  const TiePieces slack = tie_pieces_before(film, {0, 0, 0}), pulls = tie_pieces_before(film, {-5e-3, 0, 0});
  for (const double g : {-1e-6, 1e-6, 1e-3}) {
    EXPECT_EQ(tie_force_on(slack, film, {g, 0, 0}).fn, 0) << g;
    EXPECT_EQ(tie_force_on(pulls, film, {g, 0, 0}).fn, -5e-3) << g;
  }
  // both end where the spring of the film begins
  EXPECT_NEAR(tie_kink(slack, film, {-1e-6, 0, 0}, {1e-6, 0, 0}).t, 1, 1e-12);
  EXPECT_NEAR(tie_kink(pulls, film, {9e-6, 0, 0}, {-1e-6, 0, 0}).t, 4, 1e-12);
  EXPECT_EQ(tie_kink(slack, film, {-1e-6, 0, 0}, {1e-6, 0, 0}).next.along, Along::kStick);
  EXPECT_EQ(tie_kink(pulls, film, {9e-6, 0, 0}, {-1e-6, 0, 0}).next.along, Along::kStick);
  EXPECT_EQ(tie_kink(slack, film, {-1e-6, 0, 0}, {-1e-6, 0, 0}).t, HUGE_VAL);
  EXPECT_EQ(tie_kink(pulls, film, {9e-6, 0, 0}, {1e-6, 0, 0}).t, HUGE_VAL);
}

/// A body in a world; ties are laid before each step by the test, which plays the coupling.
struct Scene {
  scene::World world;
  std::unique_ptr<Dynamics> dynamics;
  contact::ContactSet contacts;

  uint32_t add(double mass, Vec3 inertia, Vec3 p, int32_t motion = SWAGE_MOTION_DYNAMIC) {
    scene::BodyInfo body;
    body.motion = motion;
    body.object = static_cast<uint32_t>(world.body.size());
    body.mass = mass;
    for (int i = 0; i < 3; ++i) body.inertia[i] = inertia[i];
    world.body.push_back(body);
    world.X_WB.push_back({toolkit::raw(p), {1, 0, 0, 0}});
    world.V_WB.push_back({});
    world.F_B_W.push_back({});
    return static_cast<uint32_t>(world.body.size() - 1);
  }
  void step(std::span<Tie> ties) {
    if (!dynamics) dynamics = std::make_unique<Dynamics>(world, Options());
    dynamics->free_motion(world);
    for (const auto& lay : before) lay();
    dynamics->solve(world, contacts, {}, ties);
    dynamics->finish(world);
    ++world.step;
  }
  std::vector<std::function<void()>> before;  // run at the predicted poses
  toolkit::Pose pose(uint32_t body) const { return toolkit::Pose(world.X_WB[body]); }
};

// 8.3 of the reference: hung by a point at a distance d from its centre, T = (2/pi) K(sin(A/2)) 2 pi sqrt(I/(m g d)) with I
// about the point. A tie is a stiff spring: it stretches by 0.4 nm under the needle's weight.
TEST(Ties, PendulumSwingsWithThePeriodOfTheClosedForm) {
  const double m = 4e-7, d = 2.7259e-3, T0 = 123.02285e-3, g = 9.80665;
  const double I_pivot = m * g * d * std::pow(T0 / (2 * M_PI), 2), I = I_pivot - m * d * d;
  for (const double amplitude : {5.0, 90.0}) {
    const double expected = amplitude == 5.0 ? 123.08143e-3 : 145.20887e-3;
    Scene s;
    s.world.dt = 1e-5;
    const double a = amplitude * M_PI / 180;
    const uint32_t body = s.add(m, {0.5 * I, I, 0.7 * I}, d * Vec3(std::sin(a), 0, -std::cos(a)));
    s.world.X_WB[body].q = toolkit::raw(toolkit::exp_rotation({0, -a, 0}));
    const Vec3 hook_B(0, 0, d);
    Tie tie;
    tie.body_a = body;
    tie.law.k_across = tie.law.k_along = 1e4;
    s.before.push_back([&] { tie.p_W = tie.offset_W = s.pose(body) * hook_B; });
    // a quarter swing ends where it hangs straight down
    double before = s.pose(body).p.x(), quarter = 0;
    for (int i = 0; quarter == 0 && i < 100000; ++i) {
      s.step({&tie, 1});
      const double x = s.pose(body).p.x();
      if (x <= 0) quarter = s.world.dt * (i + before / (before - x));
      before = x;
    }
    EXPECT_NEAR(4 * quarter, expected, 4e-4 * expected) << amplitude;
    EXPECT_EQ(s.dynamics->stats().health.not_converged, 0u);
  }
}

TEST(Ties, HoldUpToTheirDragAndNoFarther) {
  const double m = 4e-7, drag = 2e-3;
  for (const double relaxation : {0.999, 1.001}) {
    Scene s;
    s.world.gravity = {0, 0, 0};
    const uint32_t body = s.add(m, {1e-13, 1e-13, 1e-13}, Vec3::Zero());
    Tie tie;
    tie.body_a = body;
    tie.law = {100, 1000, HUGE_VAL, drag, drag};
    Vec3 rest = Vec3::Zero();
    s.before.push_back([&] { tie.p_W = s.pose(body).p, tie.offset_W = tie.p_W - rest; });
    for (int i = 0; i < 1000; ++i) {
      s.world.F_B_W[body].f.x = relaxation * drag;
      s.step({&tie, 1});
      rest += tie.plastic_slip_W;
    }
    const double x = s.pose(body).p.x(), stretch = drag / 1000;
    if (relaxation < 1) {
      EXPECT_NEAR(x, relaxation * stretch, 1e-12);
      EXPECT_EQ(rest.x(), 0);
    } else {
      // the force beyond the drag accelerates it; the start takes a few steps
      EXPECT_NEAR(x, stretch + 0.5 * (relaxation - 1) * drag / m, 0.02 * x);
      EXPECT_NEAR(tie.f_a_W.x(), -drag, 1e-15);
    }
  }
}

TEST(Ties, LinkBodiesIntoOneIslandAndKeepMomentum) {
  Scene s;
  s.world.gravity = {0, 0, 0};
  const uint32_t a = s.add(1e-6, {1e-13, 2e-13, 2e-13}, {0, 0, 0}),
                 b = s.add(3e-6, {4e-13, 4e-13, 4e-13}, {1e-3, 0, 0});
  s.world.V_WB[a] = {{0.02, 0.01, 0}, {0, 0, 3}};
  const Vec3 hook_A(0.5e-3, 0, 0), hook_B(-0.5e-3, 0, 0);
  Tie tie;
  tie.body_a = a, tie.body_b = b;
  tie.law.k_across = tie.law.k_along = 500;
  s.before.push_back([&] {
    tie.p_W = s.pose(a) * hook_A;
    tie.offset_W = tie.p_W - s.pose(b) * hook_B;
  });
  const Vec3 momentum = 1e-6 * vec(s.world.V_WB[a].v);
  double energy = HUGE_VAL;
  for (int i = 0; i < 500; ++i) {
    s.step({&tie, 1});
    const Vec3 now = 1e-6 * vec(s.world.V_WB[a].v) + 3e-6 * vec(s.world.V_WB[b].v);
    ASSERT_LT((now - momentum).norm(), 1e-12 * momentum.norm());
    const double kinetic =
        0.5e-6 * vec(s.world.V_WB[a].v).squaredNorm() + 1.5e-6 * vec(s.world.V_WB[b].v).squaredNorm();
    EXPECT_LT(kinetic, 1e-3);
    energy = kinetic;
  }
  EXPECT_LT(energy, 0.5e-6 * (0.02 * 0.02 + 0.01 * 0.01));
  EXPECT_LT((s.pose(a) * hook_A - s.pose(b) * hook_B).norm(), 2e-6);
  EXPECT_GT(vec(s.world.V_WB[b].v).norm(), 1e-3) << "the other one is pulled along";
}

// Held at the axis that it had, a tie whose body turns within the step is a follower force, and feeds what swings.
TEST(Ties, TheAxisTurnsWithA) {
  Scene s;
  s.world.gravity = {0, 0, 0};
  const uint32_t a = s.add(4e-7, {1e-12, 1e-12, 1e-12}, Vec3::Zero());
  const Vec3 arm(1e-3, 0, 0);
  Tie tie;
  tie.body_a = a;
  tie.p_W = arm;
  tie.axis_W = Vec3::UnitX();
  tie.offset_W = Vec3(0, 0.3e-3, 0);
  tie.law.k_across = 50, tie.law.k_along = 10;
  s.step({&tie, 1});
  const Vec3 now = s.pose(a).q * Vec3::UnitX();
  EXPECT_GT(std::acos(now.x()), 0.05) << "it was pulled round";
  EXPECT_LT((tie.axis_W - now).norm(), 1e-9);
  // and the force is that of the law at the axis as it stands
  const Vec3 stretch = s.pose(a) * arm - arm + tie.offset_W;
  const double along = now.dot(stretch);
  EXPECT_LT((tie.f_a_W + 10 * along * now + 50 * (stretch - along * now)).norm(), 1e-6 * tie.f_a_W.norm());
  EXPECT_EQ(s.dynamics->stats().health.not_converged, 0u);
}

TEST(Ties, BetweenWhatCannotMoveStillTellTheirForce) {
  Scene s;
  const uint32_t tool = s.add(0, Vec3::Zero(), Vec3::Zero(), SWAGE_MOTION_FIXED);
  Tie tie;
  tie.body_a = tool;
  tie.offset_W = Vec3(1e-6, 0, 2e-6);
  tie.law = {100, 1000, HUGE_VAL, 5e-4, 5e-4};
  s.step({&tie, 1});
  EXPECT_NEAR(tie.f_a_W.x(), -5e-4, 1e-12);
  EXPECT_NEAR(tie.f_a_W.z(), -2e-4, 1e-12);
  EXPECT_NEAR(tie.plastic_slip_W.x(), 0.5e-6, 1e-15);
}

TEST(Ties, BeyondTheCapacityAreCountedAndHoldNothing) {
  Scene s;
  const uint32_t body = s.add(4e-7, {1e-13, 1e-13, 1e-13}, Vec3::Zero());
  std::vector<Tie> ties(scene::Capacities().ties + 3);
  for (Tie& tie : ties)
    tie.body_a = body, tie.law.k_across = tie.law.k_along = 10, tie.offset_W = Vec3(0, 0, 1e-6);
  s.step(ties);
  EXPECT_EQ(s.dynamics->stats().health.dropped_ties, 3u);
  EXPECT_EQ(s.dynamics->stats().health.steps, 1u);
  EXPECT_NE(ties[0].f_a_W.z(), 0);
  EXPECT_EQ(ties.back().f_a_W.z(), 0);
}

}  // namespace tie_test
}  // namespace swage::dynamics
