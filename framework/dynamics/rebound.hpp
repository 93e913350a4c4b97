// SPDX-License-Identifier: Apache-2.0
//
// Restitution of what flies free. A body or particle that nothing held in the last step and that meets something immovable with
// a restitution above 0 flies to the time of the touch, takes Newton's impulse there, and flies on:
//
//     n . v+ = -e n . v-       |j_t| <= mu j_n, which stops the point that touches if it can
//
// It rests, and is left to the contact solve, when its rebound would not last a step: 2 e |n . v-| < h |n . a|. So the end of a
// row of bounces, infinitely many in finite time, is cut off where the bounces are 1 um high. Equations: README.md.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/motion.hpp"
#include "scene/world.hpp"

namespace swage::dynamics {

class Rebound {
 public:
  Rebound(const scene::World& world, uint32_t max_contacts);

  /// Flies everything that rebounds in this step: its end of the step in `motion` and `world`, gaps there in `contacts`. tolerance:
  /// m, of the gap at which it touches.
  void fly(scene::World& world, Motion& motion, contact::ContactSet& contacts, FreeMotion method,
           double tolerance) noexcept;
  /// After the contact solve: adds what was pushed, over the step, to the forces of the contacts.
  void report(contact::ContactSet& contacts, double h) const noexcept;

 private:
  /// One thing in flight.
  struct Flight {
    uint32_t body = scene::kNone, particle = scene::kNone;
    RigidMass mass;
    Vec3 f_W = Vec3::Zero(), t_W = Vec3::Zero();  // loads
    RigidState s;
    double at = 0;  // s, since the start of the step
    bool is_a(const contact::Contact& c) const {
      return particle != scene::kNone ? c.particle_a == particle : c.body_a == body;
    }
    bool is_b(const contact::Contact& c) const {
      return particle != scene::kNone ? c.particle_b == particle : c.body_b == body;
    }
  };
  struct Impulse {
    uint32_t contact;
    Vec3 on_a_W;  // N s
  };

  bool take_off(const Motion& motion, uint32_t body, uint32_t particle, Flight& flight) const noexcept;
  void fly_one(Motion& motion, contact::ContactSet& contacts, Flight& flight) noexcept;
  bool immovable(uint32_t body, uint32_t particle) const noexcept;
  RigidState after(const Flight& flight, double t) const noexcept;
  contact::Touch touch(const contact::ContactSet& contacts, uint32_t i, const Flight& flight,
                       const RigidState& s, double t) const noexcept;
  toolkit::Frame frame(uint32_t body, double t) const noexcept;
  Vec3 approach(const contact::Contact& c, const contact::Touch& touch, const Flight& flight,
                const RigidState& s) const noexcept;
  double time_of_touch(const contact::ContactSet& contacts, uint32_t i, const Flight& flight) const noexcept;
  bool push(contact::ContactSet& contacts, uint32_t i, Flight& flight) noexcept;
  void land(Motion& motion, contact::ContactSet& contacts, const Flight& flight) noexcept;

  scene::World* world_ = nullptr;
  FreeMotion method_ = FreeMotion::kElliptic;
  double tolerance_ = 0;
  std::vector<uint64_t> flown_body_, flown_particle_;  // step in which it was looked at
  std::vector<Impulse> impulse_;
};

}  // namespace swage::dynamics
