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
#include "dynamics/options.hpp"
#include "dynamics/placement.hpp"
#include "dynamics/self_solver.hpp"

namespace swage::dynamics {

class ContactSolve {
 public:
  ContactSolve(const scene::World& world, const Options& options);

  /// Final poses and twists of all dynamic bodies, hinges and particles; results in `contacts`; impulses to `self`.
  void solve(scene::World& world, Motion& motion, contact::ContactSet& contacts,
             std::span<SelfSolver* const> self, Stats& stats) noexcept;

 private:
  /// What this step knows of a contact beyond the contact set.
  struct Known {
    Side a, b;
    bool active = false;  // takes part: overlaps, or did in an earlier pass
    uint32_t row = scene::kNone;
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
    bool stuck = false;                           // passes bring it no nearer
    double off_before[2] = {HUGE_VAL, HUGE_VAL};  // m, one and two passes ago
  };

  void begin(scene::World& world, Motion& motion, contact::ContactSet& contacts,
             std::span<SelfSolver* const> self, Stats& stats) noexcept;
  void add_self_points(const contact::Contact& c, Known& k, Stats& stats) noexcept;
  void wake_self_points(contact::ContactSet& contacts) noexcept;
  void let_go(contact::ContactSet& contacts) noexcept;
  void evaluate(contact::ContactSet& contacts, uint32_t contact) noexcept;
  bool refresh(contact::ContactSet& contacts) noexcept;

  Group* moving_group(const Side& side) noexcept;
  uint32_t root(uint32_t mover) noexcept;
  uint32_t first_mover(const Known& k) const noexcept;
  void find_islands(const contact::ContactSet& contacts, Stats& stats) noexcept;
  void fill_island(const contact::ContactSet& contacts, uint32_t island, Stats& stats) noexcept;
  void add_mover(Group& group, uint32_t mover) noexcept;
  void solve_island(contact::ContactSet& contacts, Group& group, Stats& stats) noexcept;
  void relax(Group& group) noexcept;
  void look(const contact::Contact& c, const Known& k, Row& row) noexcept;
  const double* jacobian(const contact::Contact& c, const Known& k, Row& row) noexcept;
  Vec3 carried_bristle(const contact::Contact& c, const Known& k) const noexcept;

  void calm(const contact::ContactSet& contacts, const Group& group) noexcept;
  void write_back(Motion& motion, contact::ContactSet& contacts) noexcept;
  void write_contact(contact::Contact& c, const Known& k) noexcept;
  void mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept;

  Options options_;
  double h_ = 1e-3;           // s
  double tolerance_ = 1e-10;  // m
  uint32_t n_ = 0;            // contacts that take part in this step

  Placement place_;
  IslandSolver solver_;
  std::vector<Known> known_;  // per contact
  std::vector<Row> row_;      // island by island
  std::vector<double> J_;     // of the rows of one island
  std::vector<double> move_;  // of the movers of one island
  size_t J_used_ = 0;
  std::vector<Group> island_;
  std::vector<uint32_t> parent_;     // union-find, per mover
  std::vector<uint32_t> island_of_;  // per mover
  std::vector<uint32_t> member_;     // movers, island by island
  std::vector<Mover*> member_mover_;
  std::vector<uint8_t> solved_, touched_;  // per mover
};

}  // namespace swage::dynamics
