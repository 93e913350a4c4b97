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

#include "dynamics/contact_islands.hpp"
#include "dynamics/flexible_points.hpp"
#include "dynamics/options.hpp"
#include "dynamics/tie_constraints.hpp"

namespace swage::dynamics {

class ContactSolve {
 public:
  ContactSolve(const scene::World& world, const Options& options);

  /// Most contacts and ties at which an island with threads is solved in contact space, for its forces; 0: never. [main]
  void set_few(uint32_t contacts) noexcept { few_ = contacts; }

  /// Final poses and twists of all dynamic bodies, hinges and particles; results in `contacts` and `ties`; impulses to
  /// `self`.
  void solve(scene::World& world, Motion& motion, contact::ContactSet& contacts, std::span<Tie> ties,
             std::span<FlexibleBody* const> self, Stats& stats) noexcept;

 private:
  void begin(scene::World& world, Motion& motion, contact::ContactSet& contacts, std::span<Tie> ties,
             std::span<FlexibleBody* const> self, bool ask_all) noexcept;
  bool iterate(contact::ContactSet& contacts, Stats& stats) noexcept;
  bool release(contact::ContactSet& contacts) noexcept;
  void solve_island(contact::ContactSet& contacts, IslandWorkspace& island, Stats& stats) noexcept;
  const double* jacobian(const Side& side_a, const Side& side_b, const Vec3& p_W,
                         Constraint& constraint) noexcept;
  bool ends(IslandWorkspace& island, bool settled) noexcept;
  void begin_with_last_limits(std::span<Constraint> constraints, IslandWorkspace& island) noexcept;
  void relax(IslandWorkspace& island) noexcept;
  void move_flexible(uint32_t block, std::span<const Constraint> constraints, double relaxation) noexcept;
  bool refresh(contact::ContactSet& contacts) noexcept;

  // contact_results.cpp
  void finish(Motion& motion, contact::ContactSet& contacts, Stats& stats) noexcept;
  void clamp_velocity(const contact::ContactSet& contacts, const IslandWorkspace& island) noexcept;
  void write_back(Motion& motion, contact::ContactSet& contacts) noexcept;
  void report_forces(const contact::ContactSet& contacts) noexcept;
  void write_contact(contact::Contact& c, const ContactWorkspace& k) noexcept;
  void mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept;
  void hold(Motion& motion, const Side& side) const noexcept;
  double strayed(const contact::ContactSet& contacts) const noexcept;
  void count(const contact::ContactSet& contacts, Stats& stats) noexcept;

  const Options options_;
  uint32_t few_ = 16;  // beyond, the dense matrix of the forces costs more than the sparse one of the displacements
  ContactProblem p_;
  ContactIslands islands_;
  FlexiblePoints points_;
  TieConstraints ties_;
  IslandSolver solver_;
  std::vector<double> J_;     // Jacobians of the constraints of one island
  std::vector<double> move_;  // displacements of the blocks of one island
  size_t J_used_ = 0;
  std::vector<uint8_t> touched_;  // per block
};

}  // namespace swage::dynamics
