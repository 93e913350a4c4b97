// SPDX-License-Identifier: Apache-2.0
//
// Which movers and contacts are solved together.
#include <algorithm>

#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

uint32_t ContactSolve::root(uint32_t mover) noexcept {
  while (parent_[mover] != mover) mover = parent_[mover] = parent_[parent_[mover]];
  return mover;
}

uint32_t ContactSolve::first_mover(const Known& k) const noexcept {
  return place_.moves(k.a.mover) ? k.a.mover : place_.moves(k.b.mover) ? k.b.mover : kNone;
}

/// Movers linked by active contacts; islands in the order of their first contact.
void ContactSolve::find_islands(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = i, island_of_[i] = kNone;
  for (uint32_t i = 0; i < n_; ++i) {
    const Known& k = known_[i];
    if (!k.active || !place_.moves(k.a.mover) || !place_.moves(k.b.mover)) continue;
    const uint32_t a = root(k.a.mover), b = root(k.b.mover);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  join_ties();

  island_.clear();
  for (uint32_t i = 0; i < n_; ++i) {
    const uint32_t m = first_mover(known_[i]);
    if (!known_[i].active || m == kNone) continue;
    const uint32_t r = root(m);
    if (island_of_[r] != kNone) continue;
    island_of_[r] = static_cast<uint32_t>(island_.size());
    island_.push_back({});
  }
  found_ties();
  for (uint32_t m = 0; m < parent_.size(); ++m) island_of_[m] = island_of_[root(m)];
  for (uint32_t i = 0; i < island_.size(); ++i) fill_island(contacts, i);
}

/// Movers in the order in which contacts name them; a contact's row in the contacts' order.
void ContactSolve::fill_island(const contact::ContactSet& contacts, uint32_t island) noexcept {
  Group& group = island_[island];
  if (island > 0) {
    const Group& before = island_[island - 1];
    group.first_mover = before.first_mover + before.movers;
    group.first_row = before.first_row + before.rows;
  }
  make_room(contacts, island);
  for (uint32_t i = 0; i < n_; ++i) {
    const uint32_t m = first_mover(known_[i]);
    if (known_[i].active && m != kNone && island_of_[m] == island) add_row(group, contacts, i);
  }
  fill_ties(island);
}

void ContactSolve::add_row(Group& group, const contact::ContactSet& contacts, uint32_t contact) noexcept {
  Known& k = known_[contact];
  if (place_.moves(k.a.mover)) add_mover(group, k.a.mover);
  if (place_.moves(k.b.mover)) add_mover(group, k.b.mover);
  k.row = group.first_row + group.rows++;
  row_[k.row].contact = contact;
  row_[k.row].tie = nullptr;
  look(contacts.contact[contact], k, row_[k.row]);
}

void ContactSolve::add_mover(Group& group, uint32_t mover) noexcept {
  const auto first = member_.begin() + group.first_mover, last = first + group.movers;
  if (std::find(first, last, mover) != last) return;
  Mover& m = place_.mover(mover);
  m.offset = group.unknowns;
  group.unknowns += m.size;
  group.own = group.own || place_.is_self(mover);
  local_[mover] = group.movers;
  member_[group.first_mover + group.movers] = mover;
  member_mover_[group.first_mover + group.movers] = &m;
  ++group.movers;
  solved_[mover] = 1;
}

}  // namespace swage::dynamics
