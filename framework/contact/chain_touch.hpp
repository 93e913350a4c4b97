// SPDX-License-Identifier: Apache-2.0
//
// Contacts that are one contact on the uncut chain share one weight, which changes gradually.
#pragma once

#include <cmath>

#include "contact/contact_memory.hpp"
#include "contact/wire_feature.hpp"

namespace swage::contact {

/// Gives the contacts of a chain with one shape, from `first` on, their weights.
inline void share_chain_touches(const scene::World& world, const ContactMemory& memory, ContactSet& set, size_t first) noexcept {
  // Touches nearer to each other along the chain than this many radii, with gaps that differ by less than this share of the scene's length
  // (0.1 um for a 1 mm scene, what 0.1 N presses in), share the weight of one: where a thread bends towards a surface, both pieces of a
  // joint come near to it, and would be twice as stiff as one.
  constexpr double kShare = 2, kShareGap = 1e-4;
  // Share of its last weight that a contact of a thread with anything but a thread keeps. The weight of a touch beside a line follows the tilt
  // of its piece, and the tilt follows the weight one step later. 0: a thread pinched with 0.3 N over the edge of a jaw swings by 20 um from
  // step to step. 0.5 and more: weights lag by 2 ms and more. Contacts of thread with thread keep nothing: touches go from piece to piece
  // there, and with weights that lag a twisted pair unwinds.
  constexpr double kWeightKept = 1.0 / 3;

  const auto is_touch = [](const Contact& c) { return (c.feature & 0xF) == 0; };
  for (size_t i = first; i < set.contact.size(); ++i) {
    Contact& c = set.contact[i];
    if (!is_touch(c)) continue;
    const double near = kShare * chain_of(world, c).radius;
    double all = 0;
    for (size_t k = first; k < set.contact.size(); ++k) {
      const Contact& other = set.contact[k];
      if (!is_touch(other) || other.n_W.dot(c.n_W) < kAlike) continue;
      const double deeper = std::abs(c.gap - other.gap);
      all += (1 - ramp(way_along(c, other), 0, near)) * (1 - ramp(deeper, 0, kShareGap * world.length));
    }
    c.weight = set.candidate[i].weight / all;
  }
  for (size_t i = first; i < set.contact.size(); ++i) {
    Contact& c = set.contact[i];
    const bool threads = c.place_a.segment != scene::kNone && c.place_b.segment != scene::kNone;
    const Contact* before = threads ? nullptr : memory.before(i);
    if (before != nullptr && before->feature == c.feature) c.weight += kWeightKept * (before->weight - c.weight);
    set.candidate[i].weight = c.weight;
  }
}

}  // namespace swage::contact
