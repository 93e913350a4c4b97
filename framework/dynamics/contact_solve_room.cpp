// SPDX-License-Identifier: Apache-2.0
//
// What is solved where there is more than there is room for (scene/capacities.hpp). First those contacts that bore force in the
// last step, then the deepest. A flexible body is asked about so many points; contacts beyond them share the nearest point. An
// island with flexible bodies has so many constraints; contacts beyond them bear no force in this step. Both are counted.
#include <algorithm>

#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

/// Contacts in the order in which they are given room. Without allocation; the index makes the order total.
void ContactSolve::rank(const contact::ContactSet& contacts) noexcept {
  ranked_.clear();
  for (uint32_t i = 0; i < n_; ++i) ranked_.push_back(i);
  std::sort(ranked_.begin(), ranked_.end(), [&](uint32_t i, uint32_t j) {
    if (contact_[i].bore != contact_[j].bore) return contact_[i].bore;
    const double a = contacts.contact[i].gap, b = contacts.contact[j].gap;
    return a != b ? a < b : i < j;
  });
}

/// Rows of an island with flexible bodies: what is too much of them takes no part in this step. Ties always do.
void ContactSolve::make_room(const contact::ContactSet& contacts, uint32_t index) noexcept {
  const auto in_island = [&](uint32_t block) { return block != kNone && island_of_[block] == index; };
  bool flexible = false;
  uint32_t constraints = 0, ties = 0;
  for (uint32_t m = 0; m < parent_.size(); ++m)
    flexible = flexible || (in_island(m) && place_.is_flexible(m));
  if (!flexible) return;
  for (uint32_t i = 0; i < n_; ++i) constraints += contact_[i].active && in_island(first_block(contact_[i]));
  for (uint32_t i = 0; i < tie_.size(); ++i)
    ties += tie_workspace_[i].active && in_island(first_block(tie_workspace_[i]));
  if (constraints + ties <= room_.rows) return;

  rank(contacts);
  uint32_t left = room_.rows - std::min(ties, room_.rows);
  for (const uint32_t i : ranked_) {
    ContactWorkspace& k = contact_[i];
    if (!k.active || !in_island(first_block(k))) continue;
    if (left > 0) {
      --left;
    } else {
      k.active = false, k.dropped = true;
    }
  }
}

/// Contacts that flexible bodies have no room for: they share the points of others.
void ContactSolve::find_who_shares(const contact::ContactSet& contacts, std::span<const Tie> ties) noexcept {
  const size_t n_ties = std::min<size_t>(ties.size(), room_.ties);
  const uint32_t room = place_.flexible().room();
  const auto fits = [&](uint32_t n) { return n + 2 * n_ties <= room; };
  if (std::all_of(points_.begin(), points_.end(), fits)) return;
  // points of ties come first
  std::fill(points_.begin(), points_.end(), 0u);
  for (const Tie& tie : ties.first(n_ties))
    for (const uint32_t body : {tie.body_a, tie.body_b}) {
      const uint32_t block = body == kNone ? kNone : place_.side(body, kNone).block;
      if (place_.is_flexible(block)) ++points_[block];
    }
  rank(contacts);
  for (const uint32_t i : ranked_) {
    ContactWorkspace& k = contact_[i];
    if (k.skipped) continue;
    for (Side* s : {&k.a, &k.b})
      if (place_.is_flexible(s->block)) s->shares = ++points_[s->block] > room;
  }
}

void ContactSolve::share_points(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i)
    for (Side* s : {&contact_[i].a, &contact_[i].b}) {
      if (!s->shares) continue;
      s->point = place_.flexible().nearest(place_.block(s->block).index, contacts.contact[i].p_W);
      ++health_.shared_points;
    }
}

/// What this step fell short of.
void ContactSolve::count(const contact::ContactSet& contacts, Stats& stats) noexcept {
  health_.dropped_contacts += contacts.dropped + (contacts.contact.size() - n_);
  for (uint32_t i = 0; i < n_; ++i) health_.dropped_contacts += contact_[i].dropped;
  health_.over_budget += solver_.over_budget();
  health_.steps = health_.total() > 0;
  for (const auto& field : base::kSolverHealthFields) stats.health.*field.count += health_.*field.count;
  stats.health.steps += health_.steps;
  stats.work += solver_.work();
  stats.most_work = std::max(stats.most_work, solver_.work());
}

}  // namespace swage::dynamics
