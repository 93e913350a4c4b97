// SPDX-License-Identifier: Apache-2.0
//
// From contacts to final poses. In passes: linearise the contacts at the present poses, solve each island of touching
// movers (island.hpp), move, evaluate gaps and normals there, until the last correction is too small to matter.
//
// Threads: built on [main]; solve() is [rt] and neither allocates nor throws.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/island.hpp"
#include "dynamics/lengths.hpp"
#include "dynamics/options.hpp"
#include "dynamics/placement.hpp"
#include "dynamics/self_solver.hpp"
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
             std::span<SelfSolver* const> self, Stats& stats) noexcept;

 private:
  /// What this step knows of a contact beyond the contact set.
  struct Known {
    Side a, b;
    bool active = false;  // takes part: overlaps, or did in an earlier pass
    bool waits = false;   // an own solver has not been asked about it
    bool lonely = false;  // it has been after all, because its mover has no other point
    bool bore = false;    // bore force in the last step
    bool dropped = false;  // has no room in its island
    uint32_t row = scene::kNone;
    contact::Touch found;  // of the shapes, when the step began
  };
  /// What this step knows of a tie: its two sides and the material points that it holds, in their bodies.
  struct KnownTie {
    Side a, b;
    Vec3 p_A = Vec3::Zero(), p_B = Vec3::Zero();
    Vec3 p_W = Vec3::Zero();      // now
    Vec3 axis_A = Vec3::UnitX();  // its axis, in body a
    uint32_t row = scene::kNone;
    bool active = false;  // something that it holds can be moved
  };
  /// One island: a stretch of the movers and of the rows.
  struct Group {
    uint32_t first_mover = 0, movers = 0;
    uint32_t first_row = 0, rows = 0;
    uint32_t unknowns = 0;
    double off = 0;  // m, by which its contacts are elsewhere than the linear problem said
    uint32_t passes = 0;
    double share = 1;  // of the way that the last linear problem asked for
    bool converged = false, limits_hold = true, held = false, done = false;
    double left = 0;                              // m of that way that were not gone
    bool tied = false;                            // ties are among its rows
    bool own = false;                             // own solvers are among its movers
    bool stuck = false;                           // passes bring it no nearer
    double off_before[2] = {HUGE_VAL, HUGE_VAL};  // m, one and two passes ago
  };

  /// How far points of an own solver are from where they were expected [m]: most (1 + grows |p - middle|).
  struct Strayed {
    double most = 0, grows = 0;  // m, 1/m
    Vec3 middle = Vec3::Zero();  // m, of the points that were asked about
  };

  void begin(scene::World& world, Motion& motion, contact::ContactSet& contacts, std::span<Tie> ties,
             std::span<SelfSolver* const> self) noexcept;
  bool settle(contact::ContactSet& contacts, Stats& stats) noexcept;
  void finish(Motion& motion, contact::ContactSet& contacts, Stats& stats) noexcept;
  bool let_go(contact::ContactSet& contacts) noexcept;
  void evaluate(contact::ContactSet& contacts, uint32_t contact) noexcept;
  bool refresh(contact::ContactSet& contacts) noexcept;

  Group* moving_group(const Side& side) noexcept;
  uint32_t root(uint32_t mover) noexcept;
  uint32_t first_mover(const Known& k) const noexcept;
  void find_islands(const contact::ContactSet& contacts) noexcept;
  void fill_island(const contact::ContactSet& contacts, uint32_t island) noexcept;
  void add_mover(Group& group, uint32_t mover) noexcept;
  void add_row(Group& group, const contact::ContactSet& contacts, uint32_t contact) noexcept;

  // room for points and rows: contact_room.cpp
  void rank(const contact::ContactSet& contacts) noexcept;
  void make_room(const contact::ContactSet& contacts, uint32_t island) noexcept;
  void find_who_shares(const contact::ContactSet& contacts, std::span<const Tie> ties) noexcept;
  void share_points(const contact::ContactSet& contacts) noexcept;
  void count(const contact::ContactSet& contacts, Stats& stats) noexcept;
  void solve_island(contact::ContactSet& contacts, Group& group, Stats& stats) noexcept;
  void move_own(uint32_t mover, std::span<const Row> rows, double share) noexcept;
  void relax(Group& group) noexcept;
  void look(const contact::Contact& c, const Known& k, Row& row) noexcept;
  const double* jacobian(const Side& side_a, const Side& side_b, const Vec3& p_W, Row& row) noexcept;
  Vec3 carried_bristle(const contact::Contact& c, const Known& k) const noexcept;

  // points of objects with a solver of their own: contact_solve_own.cpp
  void add_own_points(const contact::ContactSet& contacts, std::span<const Tie> ties) noexcept;
  void add_own_points(const contact::Contact& c, Known& k) noexcept;
  bool may_wait(const contact::Contact& c, const Known& k) const noexcept;
  void wake_own_points(contact::ContactSet& contacts) noexcept;
  void meet_surfaces(contact::ContactSet& contacts) noexcept;
  Vec3 off_shape(const Side& side, const Vec3& p_W) const noexcept;
  double off_shapes(const contact::Contact& c, const Known& k) const noexcept;
  bool wait_in_vain(contact::ContactSet& contacts, bool moved) noexcept;
  Strayed strayed(const contact::ContactSet& contacts, uint32_t mover) const noexcept;
  void as_found(contact::ContactSet& contacts) noexcept;

  // ties: contact_solve_ties.cpp
  void begin_ties(std::span<Tie> ties) noexcept;
  void expect_ties() noexcept;
  void start_ties() noexcept;
  void touch_ties() noexcept;
  void join_ties() noexcept;
  void found_ties() noexcept;
  void fill_ties(uint32_t island) noexcept;
  void refresh_ties() noexcept;
  Vec3 moved(const Side& side, const Vec3& p_own, const Vec3& p_W) const noexcept;
  void look(const Tie& tie, KnownTie& k, Row& row) noexcept;
  uint32_t first_mover(const KnownTie& k) const noexcept;
  void look_again(const Group& group) noexcept;
  void write_ties() noexcept;
  void mark_held_by_ties(Motion& motion) noexcept;
  void hold(Motion& motion, const Side& side) const noexcept;

  void calm(const contact::ContactSet& contacts, const Group& group) noexcept;
  void write_back(Motion& motion, contact::ContactSet& contacts) noexcept;
  void write_contact(contact::Contact& c, const Known& k) noexcept;
  void mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept;

  const Options options_;
  const scene::Capacities room_;
  base::SolverHealth health_;  // of this step
  double h_ = 1e-3;           // s
  Lengths lengths_;
  double tolerance_ = 1e-10;  // m
  uint32_t n_ = 0;            // contacts that take part in this step
  uint32_t waiting_ = 0;      // of them, those that own solvers have not been asked about
  bool ask_all_ = false;

  Placement place_;
  IslandSolver solver_;
  std::vector<Known> known_;  // per contact
  std::span<Tie> tie_;        // of this step, those that fit
  std::vector<KnownTie> known_tie_;
  std::vector<Row> row_;      // island by island
  std::vector<double> J_;     // of the rows of one island
  std::vector<double> move_;  // of the movers of one island
  size_t J_used_ = 0;
  std::vector<Group> island_;
  std::vector<uint32_t> parent_;     // union-find, per mover
  std::vector<uint32_t> island_of_;  // per mover
  std::vector<uint32_t> member_;     // movers, island by island
  std::vector<Mover*> member_mover_;
  std::vector<uint32_t> local_;            // per mover, its place in its island
  std::vector<uint8_t> solved_, touched_;  // per mover
  std::vector<uint32_t> points_;           // per mover, that contacts ask for
  std::vector<uint32_t> ranked_;           // contacts, those that must have room first
};

}  // namespace swage::dynamics
