// SPDX-License-Identifier: Apache-2.0
//
// Contacts of particles, laid by an object with nodes of its own: against a fixed plane and against a body.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "dynamics/dynamics.hpp"
#include "scene/kinematics.hpp"

namespace swage::dynamics {
namespace particles_test {

constexpr double kMass = 1e-8, kRadius = 25e-6;  // kg, m: a bead of thread
constexpr double kStiffness = 1e4, kFriction = 0.3;

/// A particle over body 0, whose top is the plane z = 0 of its frame.
struct Bead {
  scene::World world;
  contact::ContactSet contacts;
  std::unique_ptr<Dynamics> dynamics;

  explicit Bead(int32_t motion, double mass = 1) {
    world.length = 1e-3, world.dt = 1e-3;
    world.body.resize(1);
    world.body[0].start = toolkit::Pose{}.abi();
    world.body[0].motion = motion;
    world.body[0].mass = mass;
    for (double& I : world.body[0].inertia) I = 0.4 * mass * 1e-6;
    world.particle_mass = {kMass}, world.particle_radius = {kRadius}, world.particle_object = {1};
    scene::reset(world);
    world.particle_p_W = {0, 0, kRadius};
    dynamics = std::make_unique<Dynamics>(world, Options());
  }
  Vec3 place() const { return {world.particle_p_W[0], world.particle_p_W[1], world.particle_p_W[2]}; }
  Vec3 velocity() const { return {world.particle_v_W[0], world.particle_v_W[1], world.particle_v_W[2]}; }

  /// Lays the contact at the predicted poses, with its stored state.
  void lay() {
    contact::Contact c;
    if (!contacts.contact.empty()) c.bristle_W = contacts.contact[0].bristle_W;
    contact::Candidate found;
    found.a.kind = contact::Feature::kPoint, found.a.tube = kRadius;
    found.b.kind = contact::Feature::kPlane, found.b.u = Vec3::UnitZ();
    found.touch =
        reevaluate(found, toolkit::Frame(place(), toolkit::Mat3::Identity()), toolkit::Frame(world.X_WB[0]));
    c.particle_a = 0;
    c.body_a = c.shape_a = c.shape_b = scene::kNone, c.body_b = 0;
    c.p_W = found.touch.p_W, c.n_W = found.touch.n_W, c.gap = found.touch.gap;
    c.law = {kFriction, kStiffness, 0};
    contacts.contact.assign(1, c);
    contacts.candidate.assign(1, found);
  }
  void step(const Vec3& f_W = Vec3::Zero()) {
    for (int k = 0; k < 3; ++k) world.particle_f_W[static_cast<size_t>(k)] = f_W[k];
    dynamics->free_motion(world);
    lay();
    dynamics->solve(world, contacts, {});
    dynamics->finish(world);
    ++world.step;
  }
};

TEST(Particles, LieAtTheDepthOfTheirLoad) {
  Bead s(SWAGE_MOTION_FIXED);
  s.world.gravity = {0, 0, -9.81};
  const double load = 1e-3, pushed = load + 9.81 * kMass;
  for (int i = 0; i < 100; ++i) s.step({0, 0, -load});
  EXPECT_NEAR(s.place().z(), kRadius - pushed / kStiffness, 1e-6 * pushed / kStiffness);
  EXPECT_NEAR(s.contacts.contact[0].f_a_W.z(), pushed, 1e-6 * pushed);
  EXPECT_LT(s.velocity().norm(), 1e-9);
}

TEST(Particles, StickBelowTheCoulombLimitAndSlideAboveIt) {
  const double load = 1e-3;
  for (const double relaxation : {0.98, 1.02}) {
    Bead s(SWAGE_MOTION_FIXED);
    s.world.gravity = {0, 0, 0};
    for (int i = 0; i < 100; ++i) s.step({0, 0, -load});
    const double start = s.place().x();
    constexpr int kSteps = 50;
    for (int i = 0; i < kSteps; ++i) s.step({relaxation * kFriction * load, 0, -load});
    const double way = s.place().x() - start;
    if (relaxation < 1) {
      // elastic: mu N / k_t
      EXPECT_NEAR(way, relaxation * kFriction * load / (kTangentRatio * kStiffness), 1e-12);
      EXPECT_LT(s.velocity().norm(), 1e-9);
    } else {
      // what friction leaves accelerates it, from when the bristle bears no more
      const double a = (relaxation - 1) * kFriction * load / kMass, t = kSteps * s.world.dt;
      EXPECT_NEAR(s.velocity().x(), a * t, 0.05 * a * t);
      EXPECT_GT(way, 0.4 * a * t * t);
    }
  }
}

// without external forces: the momentum lost by the particle is gained by the body
TEST(Particles, PushABodyAsItPushesThem) {
  Bead s(SWAGE_MOTION_DYNAMIC, 10 * kMass);
  s.world.gravity = {0, 0, 0};
  s.world.particle_p_W[2] = kRadius + 1e-6;
  s.world.particle_v_W = {0.002, 0, -0.01};
  const Vec3 before = kMass * s.velocity();
  double pressed = 0;
  for (int i = 0; i < 50; ++i) {
    s.step();
    pressed = std::max(pressed, s.contacts.contact[0].f_a_W.z());
    const Vec3 now = kMass * s.velocity() + 10 * kMass * toolkit::vec(s.world.V_WB[0].v);
    EXPECT_LT((now - before).norm(), 1e-9 * before.norm()) << i;
  }
  EXPECT_GT(pressed, 0);
  EXPECT_GT(s.velocity().z(), -0.0095);
}

// without a contact the particle falls through, so that the checks above can fail
TEST(Particles, FallThroughWhereNoContactIsLaid) {
  Bead s(SWAGE_MOTION_FIXED);
  s.world.gravity = {0, 0, -9.81};
  for (int i = 0; i < 100; ++i) {
    s.dynamics->free_motion(s.world);
    s.dynamics->solve(s.world, s.contacts, {});
    s.dynamics->finish(s.world);
    ++s.world.step;
  }
  EXPECT_LT(s.place().z(), -1e-3);
}

}  // namespace particles_test
}  // namespace swage::dynamics
