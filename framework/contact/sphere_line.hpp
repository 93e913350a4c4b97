// SPDX-License-Identifier: Apache-2.0
//
// The spheres of one wire that lie on one face are one contact, as the points of an exact wire are: each has its share of the stiffness, so
// that the wire is as stiff there as its coupling says, whatever the number of its spheres. The thesis's response is an impulse (4.3) and
// names no stiffness: its wire, too, is stopped once and not sphere by sphere.
#pragma once

#include <algorithm>
#include <span>

#include "contact/contact_set.hpp"
#include "contact/sphere_tree.hpp"

namespace swage::contact {

/// Shares the weight among the contacts of spheres of one pair of objects, from `first` on. `fades` [m]: a sphere so much higher than the
/// deepest one does not count, and one between them in part: a sphere that comes or goes changes the shares of the others smoothly.
inline void share_sphere_lines(std::span<const SphereTree> chains, double fades, ContactSet& set, size_t first) noexcept {
  const auto is_sphere = [&](uint32_t shape) { return !chains[shape].node.empty(); };
  const auto other = [&](const Contact& c) { return is_sphere(c.shape_a) ? c.shape_b : c.shape_a; };
  const std::span<Contact> all(set.contact.data() + first, set.contact.size() - first);
  for (Contact& c : all) {
    if (!is_sphere(c.shape_a) && !is_sphere(c.shape_b)) continue;
    double deepest = c.gap, count = 0;
    for (const Contact& k : all)
      if (other(k) == other(c)) deepest = std::min(deepest, k.gap);
    for (const Contact& k : all)
      if (other(k) == other(c)) count += std::max(0.0, 1 - (k.gap - deepest) / fades);
    c.weight = 1 / count;
  }
}

}  // namespace swage::contact
