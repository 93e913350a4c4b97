// SPDX-License-Identifier: Apache-2.0
//
// An island solved for its forces and solved for its displacements has the same solution; and a flexible body with the mobility of a
// rigid body moves like one.
#include <gtest/gtest.h>

#include <memory>

#include "base/rng.hpp"
#include "contact/detector.hpp"
#include "dynamics/axes.hpp"
#include "dynamics/constraint_law.hpp"
#include "dynamics/dynamics.hpp"
#include "dynamics/island.hpp"
#include "three_balls.hpp"

namespace swage::dynamics {
namespace contact_space_test {

// Tolerance for rounding: stiffness times compliance, 1e6 N/m of 5 m/N, times the last bit.
constexpr double kSame = 1e-8;

/// A needle that hangs in ties and lies between a jaw on a hinge and a fixed body.
struct Bite {
  static constexpr uint32_t kContacts = 14, kTies = 5, kRows = kContacts + kTies;

  explicit Bite(uint64_t seed) : rng(seed) {
    needle.m_hh = 0.4;
    needle.I_hh = Vec3(1.3e-6, 5e-10, 1.3e-6).asDiagonal();
    needle.inv_I_hh = needle.I_hh.inverse();
    needle.x = 1e-6 * any();
    needle.a = 1e-3 * any();
    needle.b = needle.I_hh * (needle.a + 1e-3 * any());
    jaw.kind = DofBlock::Kind::kHinge;
    jaw.size = 1;
    jaw.offset = 6;
    jaw.drive.kappa = 30, jaw.drive.t0 = 0.01 * draw(), jaw.drive.max = 0.02;
    jaw.drive.low = -0.1, jaw.drive.high = 0.1, jaw.drive.stop = 1e6;
    jaw.drive.inertia_hh = jaw.m_hh = 3;
    jaw.drive.x_hat = 1e-4 * draw();
    for (uint32_t i = 0; i < kRows; ++i) lay(i);
  }
  double draw() { return rng.uniform(-1, 1); }
  Vec3 any() { return {draw(), draw(), draw()}; }

  /// Contacts press from above, where the jaw is, or from below; ties hold along the wire and across it.
  void lay(uint32_t i) {
    Constraint& r = constraint[i];
    const bool tie = i >= kContacts, above = draw() > 0;
    r.contact = i;
    r.n = tie ? Vec3(0.1 * any() + Vec3::UnitY()) : Vec3(0.05 * any() + (above ? -1 : 1) * Vec3::UnitZ());
    r.n.normalize();
    axes_across(r.n, r.t1, r.t2);
    r.block_a = 0, r.size_a = 6;
    if (above && !tie) r.block_b = 1, r.size_b = 1, r.offset_b = 6;
    if (tie) {
      law[i - kContacts] = {50, 300, 4e-5 * rng.uniform(0, 3), 1e-4 * rng.uniform(0, 3), 1e-4};
      r.tie = &law[i - kContacts];
      r.at = {1e-6 * draw(), 1e-6 * draw(), 1e-6 * draw()};
    } else {
      r.surface = {1e6, 0.82e6, 0.3};
      r.at = {-1e-7 * (0.5 + draw()), 3e-8 * draw(), 3e-8 * draw()};
    }
    const Vec3 arm(0, 2e-3 * draw(), above ? 5e-5 : -5e-5), hinge_arm(0, 12e-3, 0);
    const Vec3* axis[3] = {&r.n, &r.t1, &r.t2};
    const uint32_t columns = r.size_a + r.size_b;
    for (uint32_t k = 0; k < 3; ++k) {
      const Vec3 moment = arm.cross(*axis[k]);
      for (uint32_t c = 0; c < 3; ++c) {
        J[i][k * columns + c] = (*axis[k])[c];
        J[i][k * columns + 3 + c] = moment[c];
      }
      if (r.size_b > 0) J[i][k * columns + 6] = -Vec3::UnitX().cross(hinge_arm + arm).dot(*axis[k]);
    }
    r.J = J[i];
  }

  Outcome solve(bool contact_space) {
    IslandSolver solver(12, kRows, 1);
    const Outcome outcome =
        solver.solve({blocks, constraint, 7, contact_space}, {1e-13, 2e-10, 1e-7}, Limits::kCoulomb);
    std::copy(solver.d().begin(), solver.d().end(), d);
    return outcome;
  }

  base::Xoshiro256 rng;
  DofBlock needle, jaw;
  DofBlock* blocks[2] = {&needle, &jaw};
  TieLaw law[kTies];
  Constraint constraint[kRows];
  double J[kRows][21], d[7];
};

TEST(ContactSpace, EndsWhereDisplacementsDo) {
  uint32_t alike = 0, sticks = 0, slips = 0, opens = 0, slides = 0, tears = 0;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    Bite by_movers(seed), by_forces(seed);
    const Outcome a = by_movers.solve(false), b = by_forces.solve(true);
    // where Newton stalls there may be several solutions
    if (!a.converged || !b.converged || a.fell_back || b.fell_back) continue;
    ++alike;
    double most = 0, way = 0;
    for (const Constraint& r : by_movers.constraint) {
      most = std::max(most, std::hypot(r.f.fn, r.f.f1, r.f.f2));
      way = std::max(way, std::hypot(r.u.g, r.u.s1, r.u.s2));
    }
    // rotations, scaled by the wire's radius
    for (int i = 0; i < 7; ++i)
      EXPECT_NEAR(by_forces.d[i], by_movers.d[i], kSame * way / (i < 3 ? 1 : 5e-5)) << seed << " " << i;
    for (uint32_t i = 0; i < Bite::kRows; ++i) {
      const Constraint &r = by_movers.constraint[i], &s = by_forces.constraint[i];
      EXPECT_NEAR(s.f.fn, r.f.fn, kSame * most) << seed << " " << i;
      EXPECT_NEAR(s.f.f1, r.f.f1, kSame * most) << seed << " " << i;
      EXPECT_NEAR(s.f.f2, r.f.f2, kSame * most) << seed << " " << i;
      EXPECT_NEAR(s.u.g, r.u.g, kSame * way) << seed << " " << i;
      EXPECT_NEAR(s.u.s1, r.u.s1, kSame * way) << seed << " " << i;
      EXPECT_NEAR(s.u.s2, r.u.s2, kSame * way) << seed << " " << i;
      EXPECT_EQ(s.f.slips, r.f.slips);
      // the force passed to a flexible body is that of the law
      const Vec3 f = s.f.fn * s.n + s.f.f1 * s.t1 + s.f.f2 * s.t2;
      EXPECT_LT((s.y - f).norm(), 1e-6 * most);
      if (r.tie) {
        slides += r.f.fn == -r.tie->forward_limit || r.f.fn == r.tie->backward_limit, tears += r.f.slips;
      } else {
        opens += r.f.fn == 0, slips += r.f.fn > 0 && r.f.slips, sticks += r.f.fn > 0 && !r.f.slips;
      }
    }
  }
  EXPECT_GT(alike, 150u);
  for (const uint32_t n : {sticks, slips, opens, slides, tears}) EXPECT_GT(n, 100u);
}

/// Largest force or moment over the wire's radius that is not balanced, where every force is that of Coulomb's law [N].
double unbalanced(const Bite& bite) {
  double F[7], worst = 0;
  for (const DofBlock* block : bite.blocks) block->residual(bite.d + block->offset, F + block->offset);
  for (const Constraint& c : bite.constraint) {
    double limit = 0;
    const Force f = constraint_force(c, c.u, Friction::kCoulomb, limit);
    const double along[] = {f.fn, f.f1, f.f2};
    const uint32_t columns = c.size_a + c.size_b;
    for (uint32_t k = 0; k < 3; ++k)
      for (uint32_t i = 0; i < columns; ++i) F[i] -= c.J[k * columns + i] * along[k];
  }
  for (int i = 0; i < 7; ++i) worst = std::max(worst, std::abs(F[i]) / (i < 3 ? 1 : i < 6 ? 5e-5 : 12e-3));
  return worst;
}

// Where Newton's method does not converge with ties either, the path does but for one island in twenty, and ends at a solution.
TEST(ContactSpace, TiesFollowThePathWhereNewtonsMethodStalls) {
  for (const bool forces : {false, true}) {
    uint32_t fell_back = 0, held = 0;
    for (uint64_t seed = 1; seed <= 300; ++seed) {
      Bite bite(seed);
      const Outcome outcome = bite.solve(forces);
      fell_back += outcome.fell_back, held += outcome.held;
      if (!outcome.converged || outcome.held) continue;
      double most = 0;
      for (const Constraint& c : bite.constraint) most = std::max(most, std::hypot(c.f.fn, c.f.f1, c.f.f2));
      EXPECT_LT(unbalanced(bite), 1e-6 * most) << seed;
    }
    EXPECT_GT(fell_back, 100u) << forces;
    EXPECT_LT(20 * held, fell_back) << forces;
  }
}

/// A ball with the mobility of a free body that cannot rotate, or one set by the test.
class Ball : public FlexibleBody {
 public:
  uint32_t object() const noexcept override { return 0; }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override {
    const size_t n = 3 * point.size();
    for (size_t i = 0; i < n; ++i) {
      v_free[i] = v[static_cast<Eigen::Index>(i % 3)];
      for (size_t j = 0; j < n; ++j) W[i * n + j] = i % 3 == j % 3 ? gives / kMass : 0;
    }
    return answers;
  }
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override {
    for (size_t i = 0; i < point.size(); ++i)
      for (size_t k = 0; k < 3; ++k) v[static_cast<Eigen::Index>(k)] += impulse[3 * i + k] / kMass;
  }
  static constexpr double kMass = 4e-7;  // kg
  Vec3 v = Vec3::Zero();                 // m/s
  double gives = 1;
  bool answers = true;
};

/// A ball on a fixed one, under another on a hinge that presses, held by a tie.
struct Stack {
  Stack(int32_t motion, const Vec3& v, bool tied) : world(make(motion, v)) {
    ball.v = v;
    detector = std::make_unique<contact::Detector>(
        world, std::vector<contact::Pair>{contact::Pair{0, 1, {0.3, 1e6, 0}}}, contact::Options{});
    dynamics = std::make_unique<Dynamics>(world, Options());
    detector->reserve(contacts);
    if (tied) {
      tie.resize(1);
      tie[0].body_a = 0;
      tie[0].axis_W = Vec3::UnitX();
      tie[0].law = {100, 1000, 5e-4, 2e-3, 2e-3};
      tie[0].offset_W = 1e-3 * v;
    }
  }
  void step() {
    dynamics->free_motion(world);
    detector->detect(world, contacts);
    FlexibleBody* const self[] = {&ball};
    dynamics->solve(world, contacts, self, tie);
  }
  static scene::World make(int32_t motion, const Vec3& v) {
    constexpr double kRadius = 10;  // m: nearly flat, so that normals do not rotate
    scene::World w = three_balls(kRadius, -0.1e-6, -0.2e-6);
    w.body[0].motion = motion;
    w.body[0].mass = Ball::kMass;
    for (double& I : w.body[0].inertia) I = 1e6;  // cannot rotate
    scene::reset(w);
    if (motion != SWAGE_MOTION_DYNAMIC && motion != SWAGE_MOTION_FLEXIBLE) return w;
    w.V_WB[0].v = toolkit::raw(v);
    // as its flexible body would have advanced it
    if (motion == SWAGE_MOTION_FLEXIBLE) w.X_WB[0].p = toolkit::raw(Vec3(1e-3 * v));
    return w;
  }

  Ball ball;
  scene::World world;
  contact::ContactSet contacts;
  std::unique_ptr<contact::Detector> detector;
  std::unique_ptr<Dynamics> dynamics;
  std::vector<Tie> tie;
};

TEST(ContactSpace, WhoAnswersAsABodyMovesAsOne) {
  for (const Vec3& v :
       {Vec3(0, 0, 0), Vec3(1e-5, 0, -1e-4), Vec3(2e-3, 1e-3, 0), Vec3(0, 0, 1e-3), Vec3(2e-3, 0, -2e-4)})
    for (const bool tied : {false, true}) {
      Stack own(SWAGE_MOTION_FLEXIBLE, v, tied), body(SWAGE_MOTION_DYNAMIC, v, tied);
      own.step(), body.step();
      ASSERT_EQ(own.contacts.contact.size(), body.contacts.contact.size());
      double most = 1e-9;
      for (const contact::Contact& c : body.contacts.contact) most = std::max(most, c.f_a_W.norm());
      for (size_t i = 0; i < own.contacts.contact.size(); ++i)
        EXPECT_LT((own.contacts.contact[i].f_a_W - body.contacts.contact[i].f_a_W).norm(), 1e-6 * most)
            << v.transpose() << " " << i;
      for (size_t i = 0; i < own.tie.size(); ++i)
        EXPECT_LT((own.tie[i].f_a_W - body.tie[i].f_a_W).norm(), 1e-6 * most) << v.transpose();
      EXPECT_LT((own.ball.v - toolkit::vec(body.world.V_WB[0].v)).norm(), 1e-6 * (v.norm() + 1e-3))
          << v.transpose();
      EXPECT_EQ(own.dynamics->stats().health.not_converged, 0u);
    }
}

// without mobility, or without an answer, the body is treated as fixed
TEST(ContactSpace, WhoGivesNowhereStandsStill) {
  Stack still(SWAGE_MOTION_FIXED, Vec3::Zero(), true);
  still.step();
  for (const bool answers : {true, false}) {
    Stack own(SWAGE_MOTION_FLEXIBLE, Vec3::Zero(), true);
    own.ball.gives = 0, own.ball.answers = answers;
    own.step();
    EXPECT_EQ(own.tie[0].f_a_W, still.tie[0].f_a_W);
    EXPECT_EQ(own.dynamics->stats().health.not_converged, 0u);
  }
}

}  // namespace contact_space_test
}  // namespace swage::dynamics
