// SPDX-License-Identifier: Apache-2.0
//
// Islands: blocks and constraints that active contacts and ties link, and that are solved together.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/contact_problem.hpp"

namespace swage::dynamics {

class ContactIslands {
 public:
  explicit ContactIslands(ContactProblem& problem);

  /// Finds the islands of the active contacts and ties and fills in their constraints.
  void find(const contact::ContactSet& contacts) noexcept;

  std::vector<IslandWorkspace>& all() noexcept { return island_; }
  const std::vector<IslandWorkspace>& all() const noexcept { return island_; }
  /// The island that moves a side in this pass, or nullptr.
  IslandWorkspace* moving(const Side& side) noexcept;
  IslandWorkspace& of(uint32_t block) noexcept { return island_[island_of_[block]]; }
  /// Blocks of an island: their indices, and themselves.
  std::span<const uint32_t> members(const IslandWorkspace& island) const noexcept {
    return {member_.data() + island.first_block, island.blocks};
  }
  std::span<DofBlock* const> blocks(const IslandWorkspace& island) const noexcept {
    return {member_block_.data() + island.first_block, island.blocks};
  }
  /// Place of a block in its island.
  uint32_t local(uint32_t block) const noexcept { return local_[block]; }

 private:
  uint32_t root(uint32_t block) noexcept;
  void fill(const contact::ContactSet& contacts, uint32_t island) noexcept;
  void add_block(IslandWorkspace& island, uint32_t block) noexcept;
  void add_constraint(IslandWorkspace& island, const contact::ContactSet& contacts,
                      uint32_t contact) noexcept;
  void join_ties() noexcept;
  void add_tie_islands() noexcept;
  void fill_ties(uint32_t island) noexcept;
  void make_room(const contact::ContactSet& contacts, uint32_t island) noexcept;

  ContactProblem& p_;
  std::vector<IslandWorkspace> island_;
  std::vector<uint32_t> parent_;     // union-find, per block
  std::vector<uint32_t> island_of_;  // per block
  std::vector<uint32_t> member_;     // blocks, island by island
  std::vector<DofBlock*> member_block_;
  std::vector<uint32_t> local_;  // per block
};

}  // namespace swage::dynamics
