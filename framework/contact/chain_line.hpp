// SPDX-License-Identifier: Apache-2.0
//
// A bending needle is several arcs, each on a body of its own. Where they lie on one face, their contacts are one line contact: the
// weight of each arc is its share of the line's length, so that the pressure along the line is even and the stiffness is that of
// one wire.
#pragma once

#include "contact/contact_set.hpp"
#include "scene/world.hpp"
#include "toolkit/fixed_vector.hpp"

namespace swage::contact {

/// Contact points of each arc in such a line. Two are enough: an even number of equal parts gives the friction moment of an even
/// pressure exactly.
inline constexpr int kChainPoints = 2;

/// True for an arc on a body that is moved by its object.
inline bool in_chain(const scene::World& world, uint32_t shape) noexcept {
  const scene::Shape& s = world.shape[shape];
  return s.kind == SWAGE_SHAPE_ARC && world.body[s.body].motion == SWAGE_MOTION_FLEXIBLE;
}

/// Shares the weight of lines among the arcs of a chain, over the contacts of one pair of objects, from `first` on. Beyond
/// kMost contacts it leaves the rest as they are.
inline void share_chain_lines(const scene::World& world, ContactSet& set, size_t first) noexcept {
  constexpr int kMost = 128;
  struct Line {
    size_t contact = 0;  // first of its two points
    uint32_t arc = 0;    // shape whose line it is
    uint32_t other = 0;  // shape on which it lies
    double length = 0;   // m
  };
  toolkit::FixedVector<Line, kMost> line;  // not initialised: few scenes have a chain
  for (size_t i = first; i + 1 < set.contact.size() && !line.full(); ++i) {
    const Contact &c = set.contact[i], &next = set.contact[i + 1];
    const bool two = (c.feature & 0xF) == 1 && next.feature == c.feature + 1 && c.shape_a == next.shape_a &&
                     c.shape_b == next.shape_b;
    const bool chain_a = in_chain(world, c.shape_a), chain_b = in_chain(world, c.shape_b);
    if (!two || chain_a == chain_b) continue;
    const uint32_t arc = chain_a ? c.shape_a : c.shape_b, other = chain_a ? c.shape_b : c.shape_a;
    line.add({i, arc, other, kChainPoints * (next.p_W - c.p_W).norm()});
  }
  for (const Line& part : line) {
    double whole = 0, of_arc = 0;  // m; an arc that goes round an edge has a line on either side of it
    for (const Line& other : line) {
      if (other.other != part.other) continue;
      whole += other.length;
      if (other.arc == part.arc) of_arc += other.length;
    }
    if (!(whole > 0)) continue;
    for (size_t i = part.contact; i < part.contact + kChainPoints; ++i) set.contact[i].weight *= of_arc / whole;
  }
}

}  // namespace swage::contact
