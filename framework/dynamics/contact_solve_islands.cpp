// SPDX-License-Identifier: Apache-2.0
//
// Which blocks and contacts are solved together.
#include <algorithm>

#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

uint32_t ContactSolve::root(uint32_t block) noexcept {
  while (parent_[block] != block) block = parent_[block] = parent_[parent_[block]];
  return block;
}

uint32_t ContactSolve::first_block(const ContactWorkspace& k) const noexcept {
  return place_.moves(k.a.block) ? k.a.block : place_.moves(k.b.block) ? k.b.block : kNone;
}

/// Movers linked by active contacts; islands in the order of their first contact.
void ContactSolve::find_islands(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = i, island_of_[i] = kNone;
  for (uint32_t i = 0; i < n_; ++i) {
    const ContactWorkspace& k = contact_[i];
    if (!k.active || !place_.moves(k.a.block) || !place_.moves(k.b.block)) continue;
    const uint32_t a = root(k.a.block), b = root(k.b.block);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  join_tied_blocks();

  island_.clear();
  for (uint32_t i = 0; i < n_; ++i) {
    const uint32_t m = first_block(contact_[i]);
    if (!contact_[i].active || m == kNone) continue;
    const uint32_t r = root(m);
    if (island_of_[r] != kNone) continue;
    island_of_[r] = static_cast<uint32_t>(island_.size());
    island_.push_back({});
  }
  add_tie_islands();
  for (uint32_t m = 0; m < parent_.size(); ++m) island_of_[m] = island_of_[root(m)];
  for (uint32_t i = 0; i < island_.size(); ++i) fill_island(contacts, i);
}

/// Movers in the order in which contacts name them; a contact's constraint in the contacts' order.
void ContactSolve::fill_island(const contact::ContactSet& contacts, uint32_t index) noexcept {
  IslandWorkspace& island = island_[index];
  if (index > 0) {
    const IslandWorkspace& before = island_[index - 1];
    island.first_block = before.first_block + before.blocks;
    island.first_constraint = before.first_constraint + before.constraints;
  }
  make_room(contacts, index);
  for (uint32_t i = 0; i < n_; ++i) {
    const uint32_t m = first_block(contact_[i]);
    if (contact_[i].active && m != kNone && island_of_[m] == index) add_constraint(island, contacts, i);
  }
  fill_ties(index);
}

void ContactSolve::add_constraint(IslandWorkspace& island, const contact::ContactSet& contacts,
                                  uint32_t contact) noexcept {
  ContactWorkspace& k = contact_[contact];
  if (place_.moves(k.a.block)) add_block(island, k.a.block);
  if (place_.moves(k.b.block)) add_block(island, k.b.block);
  k.constraint = island.first_constraint + island.constraints++;
  constraint_[k.constraint].contact = contact;
  constraint_[k.constraint].tie = nullptr;
  linearise(contacts.contact[contact], k, constraint_[k.constraint]);
}

void ContactSolve::add_block(IslandWorkspace& island, uint32_t block) noexcept {
  const auto first = member_.begin() + island.first_block, last = first + island.blocks;
  if (std::find(first, last, block) != last) return;
  DofBlock& m = place_.block(block);
  m.offset = island.unknowns;
  island.unknowns += m.size;
  island.own = island.own || place_.is_flexible(block);
  local_[block] = island.blocks;
  member_[island.first_block + island.blocks] = block;
  member_block_[island.first_block + island.blocks] = &m;
  ++island.blocks;
  solved_[block] = 1;
}

}  // namespace swage::dynamics
