// SPDX-License-Identifier: Apache-2.0
//
// The contacts of the last step, and what those of this step take over from them: bristle, force, slip, law and weight.
//
// Units: SI. Frames: W. Threads: built on [main], all else on [rt]. Nothing allocates after the constructor.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "scene/world.hpp"

namespace swage::contact {

/// Least cosine between the normals of two contacts of which one takes over from the other, or which share a weight (chain_touch.hpp): a
/// face of a jaw and its edge do, two jaws do not. Larger: friction is forgotten at an edge. Smaller: one jaw inherits the other's.
inline constexpr double kAlike = 0.7;

/// Whether a contact is on a chain.
inline bool on_chain(const Contact& c) noexcept { return c.place_a.segment != scene::kNone || c.place_b.segment != scene::kNone; }

/// The chain of a contact on a chain: that of side a where both sides are chains.
inline const scene::Shape& chain_of(const scene::World& world, const Contact& c) noexcept {
  return world.shape[world.shape[c.shape_a].kind == SWAGE_SHAPE_CHAIN ? c.shape_a : c.shape_b];
}

/// Distance along the chain between two contacts of the same shapes [m]; the greater one where both shapes are chains.
inline double way_along(const Contact& a, const Contact& b) noexcept {
  double way = 0;
  if (a.place_a.segment != scene::kNone) way = std::abs(a.place_a.s - b.place_a.s);
  if (a.place_b.segment != scene::kNone) way = std::max(way, std::abs(a.place_b.s - b.place_b.s));
  return way;
}

class ContactMemory {
 public:
  /// [main] `capacity`: contacts of a step; `pairs`: of objects.
  ContactMemory(uint32_t capacity, size_t pairs);

  /// Takes the contacts out of the set, which is empty afterwards.
  void take(ContactSet& set) noexcept;

  /// Gives a new contact, which will be number `at` of its set, the bristle of the one that it follows: of the same features, or else the
  /// nearest. Its force and slip as well if the features are the same or the contact is on a chain.
  void give(const scene::World& world, Contact& contact, size_t at) noexcept;

  /// Of the new contacts from `first` on that follow the same one of the last step, leaves its force to the one of the same features, or else
  /// to the nearest along the chain. Where a thread slides round the edge of a jaw, several have its bristle; were all of them taken to bear its
  /// force, the solve would begin with three contacts for one.
  void leave_forces_to_one(ContactSet& set, size_t first) const noexcept;

  /// Gives the new contacts from `first` on the laws that the couplings gave to those of the same shapes, or else of the same objects.
  void give_laws(ContactSet& set, size_t first) const noexcept;

  /// Contact of the last step that number `at` of the new set follows, or nullptr.
  const Contact* before(size_t at) const noexcept { return heir_of_[at] != scene::kNone ? &last_[heir_of_[at]] : nullptr; }

  /// Contacts of a pair in the last step, and the features that each touches with.
  std::span<const Contact> contacts(uint32_t pair) const noexcept { return of(last_, pair); }
  std::span<const Candidate> candidates(uint32_t pair) const noexcept { return of(candidate_, pair); }

 private:
  template <class T>
  std::span<const T> of(const std::vector<T>& all, uint32_t pair) const noexcept {
    if (pair >= of_pair_.size()) return {};
    return std::span(all).subspan(of_pair_[pair].first, of_pair_[pair].count);
  }
  const Contact* predecessor(const scene::World& world, Contact& contact) const noexcept;
  const Contact* predecessor_along(const scene::World& world, Contact& contact) const noexcept;

  std::vector<Contact> last_;
  std::vector<Candidate> candidate_;
  std::vector<scene::Range> of_pair_;
  std::vector<uint32_t> heir_of_;  // per new contact: index in last_ of the contact that it follows, or kNone
};

}  // namespace swage::contact
