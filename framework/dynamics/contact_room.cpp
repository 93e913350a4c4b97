// SPDX-License-Identifier: Apache-2.0
//
// What is solved where there is more than there is room for (scene/capacities.hpp). First those contacts that bore force in the
// last step, then the deepest. A flexible body is asked about so many points; contacts beyond them share the nearest point. An
// island with flexible bodies has so many rows; contacts beyond them bear no force in this step. Both are counted.
#include <algorithm>

#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

/// Contacts in the order in which they are given room. Without allocation; the index makes the order total.
void ContactSolve::rank(const contact::ContactSet& contacts) noexcept {
  ranked_.clear();
  for (uint32_t i = 0; i < n_; ++i) ranked_.push_back(i);
  std::sort(ranked_.begin(), ranked_.end(), [&](uint32_t i, uint32_t j) {
    if (known_[i].bore != known_[j].bore) return known_[i].bore;
    const double a = contacts.contact[i].gap, b = contacts.contact[j].gap;
    return a != b ? a < b : i < j;
  });
}

/// Rows of an island with flexible bodies: what is too much of them takes no part in this step. Ties always do.
void ContactSolve::make_room(const contact::ContactSet& contacts, uint32_t island) noexcept {
  const auto in_island = [&](uint32_t mover) { return mover != kNone && island_of_[mover] == island; };
  bool flexible = false;
  uint32_t rows = 0, ties = 0;
  for (uint32_t m = 0; m < parent_.size(); ++m) flexible = flexible || (in_island(m) && place_.is_self(m));
  if (!flexible) return;
  for (uint32_t i = 0; i < n_; ++i) rows += known_[i].active && in_island(first_mover(known_[i]));
  for (uint32_t i = 0; i < tie_.size(); ++i) ties += known_tie_[i].active && in_island(first_mover(known_tie_[i]));
  if (rows + ties <= room_.rows) return;

  rank(contacts);
  uint32_t left = room_.rows - std::min(ties, room_.rows);
  for (const uint32_t i : ranked_) {
    Known& k = known_[i];
    if (!k.active || !in_island(first_mover(k))) continue;
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
  const uint32_t room = place_.self().room();
  const auto fits = [&](uint32_t n) { return n + 2 * n_ties <= room; };
  if (std::all_of(points_.begin(), points_.end(), fits)) return;
  // points of ties come first
  std::fill(points_.begin(), points_.end(), 0u);
  for (const Tie& tie : ties.first(n_ties))
    for (const uint32_t body : {tie.body_a, tie.body_b}) {
      const uint32_t mover = body == kNone ? kNone : place_.side(body, kNone).mover;
      if (place_.is_self(mover)) ++points_[mover];
    }
  rank(contacts);
  for (const uint32_t i : ranked_) {
    Known& k = known_[i];
    if (k.waits) continue;
    for (Side* s : {&k.a, &k.b})
      if (place_.is_self(s->mover)) s->shares = ++points_[s->mover] > room;
  }
}

void ContactSolve::share_points(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i)
    for (Side* s : {&known_[i].a, &known_[i].b}) {
      if (!s->shares) continue;
      s->point = place_.self().nearest(place_.mover(s->mover).index, contacts.contact[i].p_W);
      ++health_.shared_points;
    }
}

/// What this step fell short of.
void ContactSolve::count(const contact::ContactSet& contacts, Stats& stats) noexcept {
  health_.dropped_contacts += contacts.dropped + (contacts.contact.size() - n_);
  for (uint32_t i = 0; i < n_; ++i) health_.dropped_contacts += known_[i].dropped;
  health_.over_budget += solver_.over_budget();
  health_.steps = health_.total() > 0;
  for (const auto& field : base::kSolverHealthFields) stats.health.*field.count += health_.*field.count;
  stats.health.steps += health_.steps;
  stats.work += solver_.work();
  stats.most_work = std::max(stats.most_work, solver_.work());
}

}  // namespace swage::dynamics
