// SPDX-License-Identifier: Apache-2.0
//
// From contacts to final poses. In passes: linearise the contacts at the present poses, solve each island of touching
// blocks (island.hpp), move, evaluate gaps and normals there, until the last correction is too small to matter.
//
// Threads: built on [main]; solve() is [rt] and neither allocates nor throws.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/flexible_body.hpp"
#include "dynamics/island.hpp"
#include "dynamics/lengths.hpp"
#include "dynamics/options.hpp"
#include "dynamics/placement.hpp"
#include "dynamics/tie.hpp"

namespace swage::dynamics {

/// A coupling that says stiffness 0 lets the two pass through each other there.
inline bool overlaps(const contact::Contact& c) { return c.gap < 0 && c.law.stiffness > 0; }

class ContactSolve {
 public:
  ContactSolve(const scene::World& world, const Options& options);

  /// Final poses and twists of all dynamic bodies, hinges and particles; results in `contacts` and `ties`; impulses to
  /// `self`.
  void solve(scene::World& world, Motion& motion, contact::ContactSet& contacts, std::span<Tie> ties,
             std::span<FlexibleBody* const> self, Stats& stats) noexcept;

 private:
  /// What this step knows of a contact beyond the contact set.
  struct ContactWorkspace {
    Side a, b;
    bool active = false;   // takes part: overlaps, or did in an earlier pass
    bool skipped = false;  // a flexible body has not been asked about it
    bool needed = false;   // it has been after all, because its block has no other point
    bool bore = false;     // bore force in the last step
    bool dropped = false;  // has no room in its island
    uint32_t constraint = scene::kNone;
    contact::Touch found;  // of the shapes, when the step began
  };
  /// What this step knows of a tie: its two sides and the material points that it holds, in their bodies.
  struct TieWorkspace {
    Side a, b;
    Vec3 p_A = Vec3::Zero(), p_B = Vec3::Zero();
    Vec3 p_W = Vec3::Zero();      // now
    Vec3 axis_A = Vec3::UnitX();  // its axis, in body a
    uint32_t constraint = scene::kNone;
    bool active = false;  // something that it holds can be moved
  };
  /// One island: a stretch of the blocks and of the constraints.
  struct IslandWorkspace {
    uint32_t first_block = 0, blocks = 0;
    uint32_t first_constraint = 0, constraints = 0;
    uint32_t unknowns = 0;
    double geometry_error = 0;  // m, by which its contacts are elsewhere than the linear problem said
    uint32_t passes = 0;
    double relaxation = 1;  // of the way that the last linear problem asked for
    bool converged = false, limits_hold = true, held = false, done = false;
    double remaining = 0;                          // m of that way that were not gone
    bool tied = false;                             // ties are among its constraints
    bool own = false;                              // flexible bodies are among its blocks
    bool stalled = false;                          // passes bring it no nearer
    double last_errors[2] = {HUGE_VAL, HUGE_VAL};  // m, one and two passes ago
  };

  /// How far points of a flexible body are from where they were expected [m]: most (1 + grows |p - middle|).
  struct PredictionError {
    double most = 0, grows = 0;  // m, 1/m
    Vec3 middle = Vec3::Zero();  // m, of the points that were asked about
  };

  void begin(scene::World& world, Motion& motion, contact::ContactSet& contacts, std::span<Tie> ties,
             std::span<FlexibleBody* const> self) noexcept;
  bool iterate(contact::ContactSet& contacts, Stats& stats) noexcept;
  void finish(Motion& motion, contact::ContactSet& contacts, Stats& stats) noexcept;
  bool release(contact::ContactSet& contacts) noexcept;
  void evaluate(contact::ContactSet& contacts, uint32_t contact) noexcept;
  bool refresh(contact::ContactSet& contacts) noexcept;

  IslandWorkspace* moving_island(const Side& side) noexcept;
  uint32_t root(uint32_t block) noexcept;
  uint32_t first_block(const ContactWorkspace& k) const noexcept;
  void find_islands(const contact::ContactSet& contacts) noexcept;
  void fill_island(const contact::ContactSet& contacts, uint32_t island) noexcept;
  void add_block(IslandWorkspace& island, uint32_t block) noexcept;
  void add_constraint(IslandWorkspace& island, const contact::ContactSet& contacts,
                      uint32_t contact) noexcept;

  // room for points and constraints: contact_solve_room.cpp
  void rank(const contact::ContactSet& contacts) noexcept;
  void make_room(const contact::ContactSet& contacts, uint32_t island) noexcept;
  void find_who_shares(const contact::ContactSet& contacts, std::span<const Tie> ties) noexcept;
  void share_points(const contact::ContactSet& contacts) noexcept;
  void count(const contact::ContactSet& contacts, Stats& stats) noexcept;
  void solve_island(contact::ContactSet& contacts, IslandWorkspace& island, Stats& stats) noexcept;
  void move_flexible(uint32_t block, std::span<const Constraint> constraints, double relaxation) noexcept;
  void relax(IslandWorkspace& island) noexcept;
  void linearise(const contact::Contact& c, const ContactWorkspace& k, Constraint& constraint) noexcept;
  const double* jacobian(const Side& side_a, const Side& side_b, const Vec3& p_W,
                         Constraint& constraint) noexcept;
  Vec3 carried_bristle(const contact::Contact& c, const ContactWorkspace& k) const noexcept;

  // points of objects with a solver of their own: contact_solve_points.cpp
  void add_flexible_points(const contact::ContactSet& contacts, std::span<const Tie> ties) noexcept;
  void add_flexible_points(const contact::Contact& c, ContactWorkspace& k) noexcept;
  bool may_skip(const contact::Contact& c, const ContactWorkspace& k) const noexcept;
  void start_at_predictions(contact::ContactSet& contacts) noexcept;
  void meet_surfaces(contact::ContactSet& contacts) noexcept;
  Vec3 off_shape(const Side& side, const Vec3& p_W) const noexcept;
  double off_shapes(const contact::Contact& c, const ContactWorkspace& k) const noexcept;
  bool missed_contact(contact::ContactSet& contacts, bool moved) noexcept;
  PredictionError prediction_error(const contact::ContactSet& contacts, uint32_t block) const noexcept;
  void restore_found(contact::ContactSet& contacts) noexcept;

  // ties: contact_solve_ties.cpp
  void begin_ties(std::span<Tie> ties) noexcept;
  void predict_ties() noexcept;
  void start_ties() noexcept;
  void mark_tied() noexcept;
  void join_tied_blocks() noexcept;
  void add_tie_islands() noexcept;
  void fill_ties(uint32_t island) noexcept;
  void refresh_ties() noexcept;
  Vec3 moved(const Side& side, const Vec3& p_own, const Vec3& p_W) const noexcept;
  void linearise(const Tie& tie, TieWorkspace& k, Constraint& constraint) noexcept;
  uint32_t first_block(const TieWorkspace& k) const noexcept;
  void linearise_ties(const IslandWorkspace& island) noexcept;
  void write_ties() noexcept;
  void mark_held_by_ties(Motion& motion) noexcept;
  void hold(Motion& motion, const Side& side) const noexcept;

  void clamp_velocity(const contact::ContactSet& contacts, const IslandWorkspace& island) noexcept;
  void write_back(Motion& motion, contact::ContactSet& contacts) noexcept;
  void write_contact(contact::Contact& c, const ContactWorkspace& k) noexcept;
  void mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept;

  const Options options_;
  const scene::Capacities room_;
  base::SolverHealth health_;  // of this step
  double h_ = 1e-3;            // s
  Lengths lengths_;
  double tolerance_ = 1e-10;  // m
  uint32_t n_ = 0;            // contacts that take part in this step
  uint32_t n_skipped_ = 0;    // of them, those that flexible bodies have not been asked about
  bool ask_all_ = false;

  Placement place_;
  IslandSolver solver_;
  std::vector<ContactWorkspace> contact_;  // per contact
  std::span<Tie> tie_;                     // of this step, those that fit
  std::vector<TieWorkspace> tie_workspace_;
  std::vector<Constraint> constraint_;  // island by island
  std::vector<double> J_;               // of the constraints of one island
  std::vector<double> move_;            // of the blocks of one island
  size_t J_used_ = 0;
  std::vector<IslandWorkspace> island_;
  std::vector<uint32_t> parent_;     // union-find, per block
  std::vector<uint32_t> island_of_;  // per block
  std::vector<uint32_t> member_;     // blocks, island by island
  std::vector<DofBlock*> member_block_;
  std::vector<uint32_t> local_;            // per block, its place in its island
  std::vector<uint8_t> solved_, touched_;  // per block
  std::vector<uint32_t> points_;           // per block, that contacts ask for
  std::vector<uint32_t> ranked_;           // contacts, those that must have room first
};

}  // namespace swage::dynamics
