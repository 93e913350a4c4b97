// SPDX-License-Identifier: Apache-2.0
//
// The spheres of a chain that is touched at its vertices only (thesis 4.2.1), under a tree of bounding spheres (4.2.9): a node is the
// centre of mass of the spheres below it and the least radius about that which encloses them all. The thesis grows the tree of a needle from
// its shape (4.2.10, sphere_tree.hpp); a thread has none that lasts: its tree is cut into halves of its arc length, down to a few spheres,
// and refitted each step.
//
// Units: m. Frame: W. Threads: built on [main], the rest [rt]; nothing allocates or throws.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/chain.hpp"

namespace swage::contact {

class ChainSpheres {
 public:
  struct Node {
    Vec3 centre = Vec3::Zero();
    double radius = -1;             // m, encloses the spheres below; below 0: there are none
    uint32_t first = 0, count = 0;  // vertices
    uint32_t right = 0;             // the left child follows its parent; 0: a leaf
  };

  /// [main] A tree for so many vertices.
  explicit ChainSpheres(uint32_t vertices) {
    node_.reserve(2 * size_t{vertices});
    add_halves(node_, 0, vertices, kLeaf);
  }

  /// Refits it to the vertices of a chain, itself refitted.
  void refit(const ChainTree& chain) noexcept {
    for (Node& n : node_) {
      Vec3 sum = Vec3::Zero();
      int there = 0;
      each(chain, n, [&](const Vec3& p, double) { sum += p, ++there; });
      n.radius = -1;
      if (there == 0) continue;
      n.centre = sum / there;
      each(chain, n, [&](const Vec3& p, double r) { n.radius = std::max(n.radius, (p - n.centre).norm() + r); });
    }
  }

  const Node& root() const { return node_[0]; }

  /// Calls f(i) for the vertices in the leaves for which near(centre, radius), in the order of the chain.
  template <class Near, class F>
  void visit(const Near& near, const F& f, uint32_t node = 0) const {
    const Node& n = node_[node];
    if (n.radius < 0 || !near(n.centre, n.radius)) return;
    if (n.right != 0) {
      visit(near, f, node + 1);
      visit(near, f, n.right);
      return;
    }
    for (uint32_t i = n.first; i < n.first + n.count; ++i) f(i);
  }
  /// Calls f(i, j) for vertices i of this and j of the other that are in leaves within the margin of each other.
  template <class F>
  void visit_pairs(const ChainSpheres& other, double margin, const F& f, uint32_t a = 0, uint32_t b = 0) const {
    const Node &na = node_[a], &nb = other.node_[b];
    if (apart(na, nb, margin)) return;
    if (na.right == 0 && nb.right == 0) {
      for (uint32_t i = na.first; i < na.first + na.count; ++i)
        for (uint32_t j = nb.first; j < nb.first + nb.count; ++j) f(i, j);
    } else if (nb.right == 0 || (na.right != 0 && na.count >= nb.count)) {
      visit_pairs(other, margin, f, a + 1, b);
      visit_pairs(other, margin, f, na.right, b);
    } else {
      visit_pairs(other, margin, f, a, b + 1);
      visit_pairs(other, margin, f, a, nb.right);
    }
  }
  /// The same for pairs of this chain, i < j.
  template <class F>
  void visit_self(double margin, const F& f, uint32_t node = 0) const {
    const Node& n = node_[node];
    if (n.radius < 0) return;
    if (n.right == 0) {
      for (uint32_t i = n.first; i < n.first + n.count; ++i)
        for (uint32_t j = i + 1; j < n.first + n.count; ++j) f(i, j);
      return;
    }
    visit_self(margin, f, node + 1);
    visit_self(margin, f, n.right);
    visit_pairs(*this, margin, f, node + 1, n.right);
  }

 private:
  /// Spheres per leaf, as SphereTreeLimits has.
  static constexpr uint32_t kLeaf = 4;

  template <class F>
  static void each(const ChainTree& chain, const Node& n, const F& f) {
    for (uint32_t i = n.first; i < n.first + n.count; ++i)
      if (const uint32_t piece = chain.piece_at(i); piece != scene::kNone) f(chain.vertex(i), chain.radius(piece));
  }
  /// gamma of (4.17) is below -margin.
  static bool apart(const Node& a, const Node& b, double margin) {
    const double reach = a.radius + b.radius + margin;
    return a.radius < 0 || b.radius < 0 || (a.centre - b.centre).squaredNorm() > reach * reach;
  }

  std::vector<Node> node_;
};

}  // namespace swage::contact
