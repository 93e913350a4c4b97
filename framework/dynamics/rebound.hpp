// SPDX-License-Identifier: Apache-2.0
//
// Flight within a step: from touch to touch, each found anew at the poses of its time. A DYNAMIC body flies when it moves so far
// in the step that it may pass through something, or when nothing held it in the last step and it meets
// something with a restitution above 0. At a touch it gets Newton's impulse and flies on with the new velocity:
//
//     n . v+ = -e n . v-       |j_t| <= mu j_n, which stops the sliding of the touching point if it can
//
// A touch is slow, and is left to the contact solve, when its rebound would not last a step: 2 e |n . v-| < h |n . a|. This ends a
// series of bounces, infinitely many in finite time, where the bounces are 1 um high. Where a body flies fast, a touch is slow only if
// its gap closes by less than 2.5 um in a step (for a 1 mm scene); once it overlaps by as much, the body is stopped and moved back to
// the touch. No path is left unswept: a body whose touches do not end within the step moves as if it stuck to what it touches.
// Equations: README.md.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "contact/detector.hpp"
#include "dynamics/motion.hpp"
#include "scene/world.hpp"
#include "toolkit/fixed_vector.hpp"

namespace swage::dynamics {

/// A pose within the step of a body that flew or was hit. Between two of them the twist is constant.
struct Waypoint {
  uint32_t body;
  double t;  // s, since the start of the step
  Pose X_WB;
};

class Rebound {
  /// A prediction ends where a body has turned by this [rad]: the swept path, of a constant twist, is then off by at most 4 um from
  /// that of a needle of 2.5 mm. Larger: the error grows with its square. Smaller: more predictions.
  static constexpr double kTurn = 0.12;
  static constexpr double kResting = 1e-9;  // of the scene's length, per step: a smaller relative motion counts as rest

 public:
  Rebound(const scene::World& world, uint32_t max_contacts);

  /// Flies all bodies that fly in this step: writes their end poses to `motion` and `world`, their contacts there to `contacts`.
  /// tolerance: m, of the gap at a touch.
  /// False where the touches did not end within the budget of predictions.
  bool fly(scene::World& world, Motion& motion, contact::ContactSet& contacts, contact::Detector& detector,
           FreeMotion method, double tolerance) noexcept;
  /// After the contact solve: adds the impulses, divided by the step, to the forces of the contacts.
  void report(contact::ContactSet& contacts, double h) const noexcept;

  /// Of the last step; those of one body are in the order of time.
  std::span<const Waypoint> waypoints() const { return waypoint_; }

 private:
  /// One body in flight.
  struct Flyer {
    uint32_t body = scene::kNone;
    bool fast = false;  // may pass through something
    Vec3 f_W = Vec3::Zero(), t_W = Vec3::Zero();  // loads: N, N m
    RigidState s, end;                            // now, and at the end of the prediction if nothing is met
    Vec3 turn = Vec3::Zero();                     // rad, from now to then
  };
  /// A pair of shapes of which at least one flies.
  struct Meeting {
    uint32_t swept = 0;  // index among the detector's swept pairs
    uint32_t body_a = 0, body_b = 0;
    contact::Law law;
    double sunk = 0;       // m, overlap when the step began
    uint32_t touches = 0;  // in this step, without an impulse
    bool pushed = false;
  };
  struct Touching {
    uint32_t meeting = 0;
    contact::Candidate candidate;
  };
  /// A touch as its impulse needs it.
  struct Sides {
    Vec3 n, p;                         // unit normal from b to a; place [m]
    Flyer *a = nullptr, *b = nullptr;  // null: does not fly
    Vec3 v;                            // m/s, of a against b
    double gap = 0, coming = 0;  // m; approach speed, m/s
  };
  struct Impulse {
    uint32_t shape_a, shape_b;
    uint64_t feature;
    Vec3 on_a_W;  // N s
  };

  /// I^-1 moment, in W.
  static Vec3 turned_by(const RigidMass& mass, const Quat& q, const Vec3& moment) {
    return q * mass.inv_I.cwiseProduct(q.conjugate() * moment);
  }

  // which bodies fly
  void find_paths() noexcept;
  bool find_flyers(const contact::ContactSet& contacts) noexcept;
  void find_rebounding(const contact::ContactSet& contacts) noexcept;
  void find_fast(const contact::ContactSet& contacts) noexcept;
  void join_met() noexcept;
  void find_meetings(const contact::ContactSet& contacts) noexcept;
  void join(uint32_t body) noexcept;
  contact::Law law_of(const contact::ContactSet& contacts, uint32_t swept) const noexcept;

  // from touch to touch: rebound_touches.cpp
  bool fly_to_next() noexcept;
  void look_ahead() noexcept;
  void gather() noexcept;
  double time_of(const Touching& touching, bool& sinks) noexcept;
  double time_of_gap(const Touching& touching, double gap, double least) const noexcept;
  void advance(double t) noexcept;
  void push_all(const Touching* sunk) noexcept;
  void push(const Touching& touching, const Sides& sides, double restitution) noexcept;
  Vec3 added(const Sides& sides, const Vec3& j) const noexcept;
  Vec3 impulse(const Sides& sides, double restitution, double friction) const noexcept;
  bool fast(const Meeting& meeting) const noexcept;
  void lift(const Touching& touching) noexcept;
  bool comes(const Sides& sides) const noexcept;
  bool slow(const Meeting& meeting, const Sides& sides) const noexcept;

  // the end of the step
  void settle() noexcept;
  void carry_along() noexcept;
  void land(contact::ContactSet& contacts) noexcept;

  // poses and speeds within the step
  contact::Motion path(uint32_t body) const noexcept;
  RigidState state(const Flyer& flyer, double t) const noexcept;
  Pose pose(uint32_t body, double t) const noexcept;
  contact::Touch touch(const Touching& touching, double t) const noexcept;
  Sides sides(const Touching& touching, double t) noexcept;
  Flyer* flyer(uint32_t body) noexcept;

  scene::World* world_ = nullptr;
  Motion* motion_ = nullptr;
  contact::Detector* detector_ = nullptr;
  FreeMotion method_ = FreeMotion::kElliptic;
  double tolerance_ = 0, at_ = 0;  // m, s

  std::vector<contact::Motion> path_;  // of every body over the step, as predicted
  std::vector<uint32_t> flyer_of_;     // per body
  std::vector<Flyer> flyer_;
  std::vector<Meeting> meeting_;
  std::vector<uint8_t> moved_;  // per body
  std::vector<Impulse> impulse_;
  std::vector<contact::Detector::Struck> struck_;
  std::vector<Waypoint> waypoint_;

  // of one prediction
  double until_ = 0;             // s, its end
  double ahead_ = 0;             // s, time up to which nothing passes through anything
  uint32_t hit_ = scene::kNone;  // meeting that touches at ahead_
  toolkit::FixedVector<Touching, 64> touching_;
};

}  // namespace swage::dynamics
