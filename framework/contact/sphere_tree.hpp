// SPDX-License-Identifier: Apache-2.0
//
// The thesis's needle: a chain of spheres under a tree of bounding spheres (thesis 4.2.9, 4.2.10). Kept as a level of
// detail to compare with; the exact arc replaces it.
#pragma once

#include <cstdint>
#include <vector>

#include "toolkit/arc.hpp"
#include "toolkit/math.hpp"

namespace swage::contact {

using toolkit::Vec3;

/// Spheres of one radius in the order of the tree's leaves, and the tree in preorder. Built on [main], read on [rt].
struct SphereTree {
  struct Node {
    Vec3 centre = Vec3::Zero();     // m, centre of mass of the spheres below
    double radius = 0;              // m, encloses them
    uint32_t skip = 0;              // next node that is not below this one
    uint32_t first = 0, count = 0;  // spheres below
    bool leaf = true;
  };
  double radius = 0;             // m, of each sphere
  std::vector<Vec3> centre;      // m, in the order of the leaves
  std::vector<uint32_t> number;  // number of each of these spheres along the arc, counted from its start
  std::vector<Node> node;        // node[0] is the root

  /// Calls visit(i) for each sphere i below nodes for which near(centre, radius) holds.
  template <class Near, class Visit>
  void visit(Near&& near, Visit&& visit_sphere) const {
    for (uint32_t k = 0; k < node.size();) {
      const Node& n = node[k];
      const bool open = near(n.centre, n.radius);
      if (open && n.leaf)
        for (uint32_t i = n.first; i < n.first + n.count; ++i) visit_sphere(i);
      k = open ? k + 1 : n.skip;
    }
  }
};

/// Limits at which a node is not split further.
struct SphereTreeLimits {
  int levels = 5;            // the root alone is 1 level
  uint32_t few_spheres = 4;  // or when no more than these are below
};

/// [main] Centres of `count` spheres, evenly from one end of the arc to the other.
std::vector<Vec3> sphere_chain(const toolkit::Arc& arc, int count);

/// [main] Centres of those of `count` spheres, evenly along a wire, that are on the arc: its part between the shares `from` and `to`;
/// the middle of the arc where there is none.
std::vector<Vec3> sphere_chain_part(const toolkit::Arc& arc, int count, double from, double to);

/// [main] Grows the tree as in thesis 4.2.10: a leaf starts at the sphere farthest from its parent's centre with half its
/// parent's radius, takes in what it encloses, moves to the new centre of mass, until nothing more comes in; then it
/// shrinks to the smallest radius that holds its spheres.
SphereTree build_sphere_tree(const std::vector<Vec3>& centres, double radius,
                             const SphereTreeLimits& limits = {});

}  // namespace swage::contact
