// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_islands.hpp"

#include <algorithm>

namespace swage::dynamics {

using scene::kNone;

ContactIslands::ContactIslands(ContactProblem& problem) : p_(problem) {
  const size_t blocks = p_.place.blocks();
  island_.reserve(blocks + 1);
  parent_.assign(blocks, 0), island_of_.assign(blocks, kNone);
  member_.assign(blocks, 0), member_block_.assign(blocks, nullptr);
  local_.assign(blocks, 0);
}

uint32_t ContactIslands::root(uint32_t block) noexcept {
  while (parent_[block] != block) block = parent_[block] = parent_[parent_[block]];
  return block;
}

/// Finds blocks linked by active contacts and ties; islands are in the order of their first contact.
void ContactIslands::find(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = i, island_of_[i] = kNone;
  for (uint32_t i = 0; i < p_.n; ++i) {
    const ContactWorkspace& k = p_.contact[i];
    if (!k.active || !p_.place.moves(k.a.block) || !p_.place.moves(k.b.block)) continue;
    const uint32_t a = root(k.a.block), b = root(k.b.block);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  join_ties();

  island_.clear();
  for (uint32_t i = 0; i < p_.n; ++i) {
    const uint32_t m = p_.first_block(p_.contact[i]);
    if (!p_.contact[i].active || m == kNone) continue;
    const uint32_t r = root(m);
    if (island_of_[r] != kNone) continue;
    island_of_[r] = static_cast<uint32_t>(island_.size());
    island_.push_back({});
  }
  add_tie_islands();
  for (uint32_t m = 0; m < parent_.size(); ++m) island_of_[m] = island_of_[root(m)];
  for (uint32_t i = 0; i < island_.size(); ++i) fill(contacts, i);
}

/// Adds blocks in the order in which contacts name them, and constraints in the order of the contacts.
void ContactIslands::fill(const contact::ContactSet& contacts, uint32_t index) noexcept {
  IslandWorkspace& island = island_[index];
  if (index > 0) {
    const IslandWorkspace& before = island_[index - 1];
    island.first_block = before.first_block + before.blocks;
    island.first_constraint = before.first_constraint + before.constraints;
  }
  make_room(contacts, index);
  for (uint32_t i = 0; i < p_.n; ++i) {
    const uint32_t m = p_.first_block(p_.contact[i]);
    if (p_.contact[i].active && m != kNone && island_of_[m] == index) add_constraint(island, contacts, i);
  }
  fill_ties(index);
}

void ContactIslands::add_constraint(IslandWorkspace& island, const contact::ContactSet& contacts,
                                    uint32_t contact) noexcept {
  ContactWorkspace& k = p_.contact[contact];
  if (p_.place.moves(k.a.block)) add_block(island, k.a.block);
  if (p_.place.moves(k.b.block)) add_block(island, k.b.block);
  k.constraint = island.first_constraint + island.constraints++;
  p_.constraint[k.constraint].contact = contact;
  p_.constraint[k.constraint].tie = nullptr;
  p_.linearise(contacts.contact[contact], k, p_.constraint[k.constraint]);
}

void ContactIslands::add_block(IslandWorkspace& island, uint32_t block) noexcept {
  const auto first = member_.begin() + island.first_block, last = first + island.blocks;
  if (std::find(first, last, block) != last) return;
  DofBlock& m = p_.place.block(block);
  m.offset = island.unknowns;
  island.unknowns += m.size;
  island.own = island.own || (p_.place.is_flexible(block) && !p_.place.is_banded(block));
  island.banded = island.banded || p_.place.is_banded(block);
  local_[block] = island.blocks;
  member_[island.first_block + island.blocks] = block;
  member_block_[island.first_block + island.blocks] = &m;
  ++island.blocks;
  p_.solved[block] = 1;
}

void ContactIslands::join_ties() noexcept {
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    const TieWorkspace& k = p_.tie_workspace[i];
    if (!p_.place.moves(k.a.block) || !p_.place.moves(k.b.block)) continue;
    const uint32_t a = root(k.a.block), b = root(k.b.block);
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

/// Adds islands of blocks that no contact names, after the others.
void ContactIslands::add_tie_islands() noexcept {
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    if (!p_.tie_workspace[i].active) continue;
    const uint32_t r = root(p_.first_block(p_.tie_workspace[i]));
    if (island_of_[r] != kNone) continue;
    island_of_[r] = static_cast<uint32_t>(island_.size());
    island_.push_back({});
  }
}

void ContactIslands::fill_ties(uint32_t index) noexcept {
  IslandWorkspace& island = island_[index];
  for (uint32_t i = 0; i < p_.tie.size(); ++i) {
    TieWorkspace& k = p_.tie_workspace[i];
    if (!k.active || island_of_[p_.first_block(k)] != index) continue;
    if (p_.place.moves(k.a.block)) add_block(island, k.a.block);
    if (p_.place.moves(k.b.block)) add_block(island, k.b.block);
    k.constraint = island.first_constraint + island.constraints++;
    Constraint& constraint = p_.constraint[k.constraint];
    constraint.contact = i;
    constraint.tie = &p_.tie[i].law;
    constraint.limit = 0;
    island.tied = true;
    p_.linearise(p_.tie[i], k, constraint);
  }
}

/// The island that moved this side in this pass.
IslandWorkspace* ContactIslands::moving(const Side& side) noexcept {
  if (!p_.place.moves(side.block) || island_of_[side.block] == kNone) return nullptr;
  IslandWorkspace& island = island_[island_of_[side.block]];
  return island.done ? nullptr : &island;
}

/// Limits the rows of an island that is solved in contact space: contacts beyond the room are dropped in this step, ties never.
void ContactIslands::make_room(const contact::ContactSet& contacts, uint32_t index) noexcept {
  const auto in_island = [&](uint32_t block) { return block != kNone && island_of_[block] == index; };
  bool flexible = false;
  uint32_t constraints = 0, ties = 0;
  for (uint32_t m = 0; m < parent_.size(); ++m)
    flexible = flexible || (in_island(m) && p_.place.is_flexible(m) && !p_.place.is_banded(m));
  if (!flexible) return;  // an island of banded bodies alone is solved sparse and has no such limit
  for (uint32_t i = 0; i < p_.n; ++i)
    constraints += p_.contact[i].active && in_island(p_.first_block(p_.contact[i]));
  for (uint32_t i = 0; i < p_.tie.size(); ++i)
    ties += p_.tie_workspace[i].active && in_island(p_.first_block(p_.tie_workspace[i]));
  if (constraints + ties <= p_.room.rows) return;

  p_.rank(contacts);
  uint32_t left = p_.room.rows - std::min(ties, p_.room.rows);
  for (const uint32_t i : p_.ranked) {
    ContactWorkspace& k = p_.contact[i];
    if (!k.active || !in_island(p_.first_block(k))) continue;
    if (left > 0) {
      --left;
    } else {
      k.active = false, k.dropped = true;
    }
  }
}

}  // namespace swage::dynamics
