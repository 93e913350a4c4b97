// SPDX-License-Identifier: Apache-2.0
//
// The contact problem of one step: a workspace for each contact and tie, and their constraints at the present poses. The parts of
// the solve work on it: contact_islands.hpp (islands), flexible_points.hpp (points of flexible bodies), tie_constraints.hpp,
// contact_solve.hpp (passes).
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/solver_health.hpp"
#include "contact/contact_set.hpp"
#include "dynamics/island.hpp"
#include "dynamics/placement.hpp"
#include "dynamics/scales.hpp"
#include "dynamics/tie.hpp"

namespace swage::dynamics {

/// True when a contact overlaps and pushes. Stiffness 0: a coupling lets the two bodies pass through each other there.
inline bool overlaps(const contact::Contact& c) { return c.gap < 0 && c.law.stiffness > 0; }

/// The workspace of a contact in this step, beside the contact set.
struct ContactWorkspace {
  Side a, b;
  bool active = false;   // takes part in the solve: overlaps, or did in an earlier pass
  bool skipped = false;  // no flexible body has been asked about it
  bool needed = false;   // asked about only because its block has no other point
  bool bore = false;     // bore force in the last step
  double normal_before = 0;  // N, of that force
  bool dropped = false;  // has no room in its island
  uint32_t constraint = scene::kNone;
  contact::Touch found;  // gap, place and normal of the shapes when the step began
};

/// The workspace of a tie in this step: its two sides and the material points that it holds, in their bodies.
struct TieWorkspace {
  Side a, b;
  Vec3 p_A = Vec3::Zero(), p_B = Vec3::Zero();
  Vec3 p_W = Vec3::Zero();      // present place of the tie
  Vec3 axis_A = Vec3::UnitX();  // its axis, in body a
  uint32_t constraint = scene::kNone;
  bool active = false;  // at least one of its sides can be moved
};

/// One island: a range of the blocks and one of the constraints.
struct IslandWorkspace {
  uint32_t first_block = 0, blocks = 0;
  uint32_t first_constraint = 0, constraints = 0;
  uint32_t unknowns = 0;
  double geometry_error = 0;  // m, distance of its contacts from where the linear problem predicted them
  uint32_t passes = 0;
  double relaxation = 1;  // share taken of the last linear problem's step
  bool converged = false, limits_hold = true, held = false, done = false;
  bool begins_anew = false, began_anew = false;  // in the next pass, with the limits of the last step; once
  double remaining = 0;                          // m, the part of that step that was not taken
  bool tied = false;                             // ties are among its constraints
  bool own = false;                              // flexible bodies other than bands are among its blocks
  bool banded = false;                           // bands are among its blocks
  bool stalled = false;                          // passes no longer converge
  double last_errors[2] = {HUGE_VAL, HUGE_VAL};  // m, one and two passes ago
};

struct ContactProblem {
  explicit ContactProblem(const scene::World& world);

  /// Begins a step: contacts and their sides. [rt]
  void begin(scene::World& world, Motion& motion, const contact::ContactSet& contacts,
             std::span<FlexibleBody* const> self) noexcept;

  /// Whether a contact is active from the start.
  bool takes_part(const contact::Contact& c, const ContactWorkspace& k) const noexcept;
  /// Activates contacts of strands with strands that are about to touch, where threads are wound.
  void expect_touches(const contact::ContactSet& contacts) noexcept;
  /// Gap, place and normal of a contact at the present poses.
  void evaluate(contact::ContactSet& contacts, uint32_t contact) noexcept;
  /// Axes, law, gap and tangential displacement of a constraint at the present poses.
  void linearise(const contact::Contact& c, const ContactWorkspace& k, Constraint& constraint) noexcept;
  void linearise(const Tie& tie, TieWorkspace& k, Constraint& constraint) noexcept;

  /// Distance of the surface from the shape on which a contact was found: of one side, and of both along the normal [m].
  Vec3 off_shape(const Side& side, const Vec3& p_W) const noexcept;
  double off_shapes(const contact::Contact& c, const ContactWorkspace& k) const noexcept;

  /// The first block of a contact or tie that can be moved, or kNone.
  template <class Workspace>
  uint32_t first_block(const Workspace& k) const noexcept {
    return place.moves(k.a.block) ? k.a.block : place.moves(k.b.block) ? k.b.block : scene::kNone;
  }
  /// Fills `ranked`: contacts in the order in which they are given room.
  void rank(const contact::ContactSet& contacts) noexcept;

  const scene::Capacities room;
  base::SolverHealth health;  // of this step
  double h = 1e-3;            // s
  Scales scales;
  uint32_t n = 0;  // contacts of this step that there is room for
  Placement place;
  std::vector<ContactWorkspace> contact;  // per contact
  std::span<Tie> tie;                     // of this step, those that fit
  std::vector<TieWorkspace> tie_workspace;
  std::vector<Constraint> constraint;  // island by island
  std::vector<uint8_t> solved;         // per block: an island has moved it
  std::vector<uint32_t> ranked;        // contacts in the order in which they are given room

 private:
  Vec3 carried_bristle(const contact::Contact& c, const ContactWorkspace& k) const noexcept;
  Vec3 moved(const Side& side, const Vec3& p_own, const Vec3& p_W) const noexcept;
};

}  // namespace swage::dynamics
