// SPDX-License-Identifier: Apache-2.0
#include "contact/contact_memory.hpp"

#include <algorithm>

namespace swage::contact {
namespace {

/// A contact without a predecessor of the same features takes the bristle of the nearest one within this share of the scene's length: 0.2 mm
/// for a 1 mm scene. The points of a line across a jaw are nearer, and a thread rolls that far in a step at 0.2 m/s. So a touch that slides
/// from a face to its edge, or spreads into a line, continues to stick. Larger: the bristle of another touch is taken.
constexpr double kReach = 0.2;

bool bears(const Contact& c) { return !c.f_a_W.isZero(0) || !c.bristle_W.isZero(0); }

bool of_same_shapes(const Contact& a, const Contact& b) { return a.shape_a == b.shape_a && a.shape_b == b.shape_b; }

}  // namespace

ContactMemory::ContactMemory(uint32_t capacity, size_t pairs) : heir_of_(capacity, scene::kNone) {
  last_.reserve(capacity);
  candidate_.reserve(capacity);
  of_pair_.reserve(pairs);
}

void ContactMemory::take(ContactSet& set) noexcept {
  last_.swap(set.contact);
  candidate_.swap(set.candidate);
  of_pair_.swap(set.of_pair);
  set.contact.clear(), set.candidate.clear(), set.of_pair.clear();
}

void ContactMemory::give(const scene::World& world, Contact& contact, size_t at) noexcept {
  const Contact* before = on_chain(contact) ? predecessor_along(world, contact) : predecessor(world, contact);
  heir_of_[at] = before != nullptr ? static_cast<uint32_t>(before - last_.data()) : scene::kNone;
  if (before == nullptr) return;
  contact.bristle_W = before->bristle_W;
  // couplings read the values of the last solve before this one writes
  contact.f_a_W = before->f_a_W;
  contact.slip = before->slip;
}

/// Contact of the same features. Without one the bristle of the nearest is taken, where its place on b is now.
const Contact* ContactMemory::predecessor(const scene::World& world, Contact& contact) const noexcept {
  const swage_twist& V = world.V_WB[contact.body_b];
  const Vec3 v = toolkit::vec(V.v), w = toolkit::vec(V.w), x = toolkit::vec(world.X_WB[contact.body_b].p);
  double nearest = kReach * world.length;
  for (const Contact& old : contacts(contact.pair)) {
    if (!of_same_shapes(old, contact)) continue;
    if (old.feature == contact.feature) return &old;
    const Vec3 moved = old.p_W + world.dt * (v + w.cross(old.p_W - x));
    const double distance = (moved - contact.p_W).norm();
    if (distance >= nearest || old.n_W.dot(contact.n_W) < kAlike) continue;
    nearest = distance;
    contact.bristle_W = old.bristle_W;
  }
  return nullptr;
}

/// Friction memory travels with the material: the contact of the same pieces, or else the nearest along the chain that bears.
const Contact* ContactMemory::predecessor_along(const scene::World& world, Contact& contact) const noexcept {
  const Contact* best = nullptr;
  double nearest = kReach * world.length;
  for (const Contact& old : contacts(contact.pair)) {
    if (!of_same_shapes(old, contact)) continue;
    if (old.feature == contact.feature) {
      if (bears(old)) return &old;
      // the contact existed without load: only its immediate neighbours count
      nearest = std::min(nearest, chain_of(world, old).radius);
      if (best != nullptr && way_along(*best, contact) > nearest) best = nullptr;
      continue;
    }
    if (!bears(old) || old.n_W.dot(contact.n_W) < kAlike) continue;
    const double way = way_along(old, contact);
    if (way > nearest) continue;
    nearest = way, best = &old;
  }
  return best;
}

void ContactMemory::leave_forces_to_one(ContactSet& set, size_t first) const noexcept {
  const auto way_from = [&](size_t i, const Contact& old) {
    const Contact& c = set.contact[i];
    return c.feature == old.feature ? -1 : way_along(old, c);
  };
  for (size_t i = first; i < set.contact.size(); ++i) {
    if (heir_of_[i] == scene::kNone) continue;
    const Contact& old = last_[heir_of_[i]];
    const double way = way_from(i, old);
    for (size_t k = first; way >= 0 && k < set.contact.size(); ++k) {
      const double other = k != i && heir_of_[k] == heir_of_[i] ? way_from(k, old) : HUGE_VAL;
      if (!(other < way || (other == way && k < i))) continue;
      set.contact[i].f_a_W.setZero(), set.contact[i].slip = 0;
      break;
    }
  }
}

void ContactMemory::give_laws(ContactSet& set, size_t first) const noexcept {
  for (size_t i = first; i < set.contact.size(); ++i) {
    Contact& c = set.contact[i];
    const Contact* like = nullptr;
    for (const Contact& old : contacts(c.pair)) {
      const bool same = of_same_shapes(old, c);
      if (!like || same) like = &old;
      if (same && old.feature == c.feature) break;
    }
    if (like) c.law = like->law;
    if (!(c.weight > 0)) c.law.stiffness = 0;
  }
}

}  // namespace swage::contact
