// SPDX-License-Identifier: Apache-2.0
//
// A chain as the detector sees it: a tree of boxes over ranges of arc length, with the pieces of the chain (its segments) in the
// leaves. The tree is built once and refitted each step, so its order, and that of the contacts, is always the same.
//
// Units: m. Frame: W. Threads: built on [main], the rest [rt]; nothing allocates or throws.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/solid.hpp"
#include "contact/sweep.hpp"
#include "scene/chain.hpp"

namespace swage::contact {

using scene::ChainPlace;

/// A box along the axes of W.
struct Box {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);

  void add(const Vec3& p) { low = low.cwiseMin(p), high = high.cwiseMax(p); }
  void add(const Box& b) { low = low.cwiseMin(b.low), high = high.cwiseMax(b.high); }
  void grow(double by) { low.array() -= by, high.array() += by; }
  Vec3 centre() const { return 0.5 * (low + high); }
  double half() const { return 0.5 * (high - low).norm(); }
  bool near(const Box& b, double margin) const {
    return ((low - b.high).array() <= margin).all() && ((b.low - high).array() <= margin).all();
  }
  bool near(const Vec3& p, double margin) const {
    return (p - p.cwiseMax(low).cwiseMin(high)).squaredNorm() <= margin * margin;
  }
};

/// Adds the binary tree of `count` parts of a chain from `first` on, halves of halves down to `leaf` parts. Returns its root. [main]
template <class Node>
uint32_t add_halves(std::vector<Node>& nodes, uint32_t first, uint32_t count, uint32_t leaf) {
  const auto at = static_cast<uint32_t>(nodes.size());
  nodes.emplace_back();
  nodes[at].first = first, nodes[at].count = count;
  if (count <= leaf) return at;
  const uint32_t half = count / 2;
  add_halves(nodes, first, half, leaf);
  const uint32_t right = add_halves(nodes, first + half, count - half, leaf);
  nodes[at].right = right;
  return at;
}

class ChainTree {
 public:
  /// [main] `shape`: of kind CHAIN.
  ChainTree(const scene::World& world, uint32_t shape);

  /// Refits pieces and boxes to the vertices. Each box encloses its pieces, with their radius, over the whole step, in the frame
  /// that moves with the mean velocity of the vertices.
  void refit(const scene::World& world) noexcept;

  uint32_t segments() const { return segments_; }
  /// False where the chain is cut, and for a piece without length.
  bool there(uint32_t i) const { return i < segments_ && piece_[i].radius > 0; }
  double radius(uint32_t i) const { return piece_[i].radius; }
  const Vec3& vertex(uint32_t i) const { return i < segments_ ? piece_[i].p0 : piece_[i - 1].p1; }
  const Vec3& velocity(uint32_t i) const { return i < segments_ ? piece_[i].v0 : piece_[i - 1].v1; }
  /// The piece to which a vertex belongs: that which begins there, or the one before; kNone where both are cut out.
  uint32_t piece_at(uint32_t i) const { return there(i) ? i : i > 0 && there(i - 1) ? i - 1 : scene::kNone; }
  const Box& all() const { return node_[0].box; }
  /// The largest displacement of a vertex in the step relative to that frame, and the displacement of the frame, m.
  double moves() const { return moves_; }
  double drift() const { return drift_.norm(); }
  const Vec3& drift_W() const { return drift_; }
  /// Two places closer than this along the chain are not tested against each other, m: half a circle of the least radius of
  /// curvature. A wire bent no tighter cannot meet itself within that length.
  double exclusion() const { return exclusion_; }

  /// Whether the centre lines of piece i and of piece j of the other chain are farther apart than both radii and the margin [m].
  bool apart(uint32_t i, const ChainTree& other, uint32_t j, double margin) const {
    const toolkit::Segment p{piece_[i].p0, piece_[i].p1}, q{other.piece_[j].p0, other.piece_[j].p1};
    const toolkit::SegmentPair at = closest(p, q);
    const double reach = piece_[i].radius + other.piece_[j].radius + margin;
    return (p.point(at.s) - q.point(at.t)).squaredNorm() > reach * reach;
  }

  /// Unit vector from the first or, where `end`, the last vertex of piece i into the neighbouring piece; zero where there is none.
  Vec3 onward(uint32_t i, bool end) const;
  /// The place of piece i nearest to p_W.
  ChainPlace place(uint32_t i, const Vec3& p_W) const;
  double s(uint32_t i) const { return piece_[i].s0; }

  /// Writes piece i as a capsule about its middle with the axes of W, its frame, and its motion over the step.
  void solid_of(uint32_t i, double dt, Solid& solid, Frame& X_WS, Motion& motion) const;

  /// Calls f(i) for all pieces in boxes for which near(box), in the order of the chain.
  template <class Near, class F>
  void visit(const Near& near, const F& f, uint32_t node = 0) const {
    const Node& n = node_[node];
    if (!near(n.box)) return;
    if (n.right == 0) {
      for (uint32_t i = n.first; i < n.first + n.count; ++i)
        if (there(i)) f(i);
      return;
    }
    visit(near, f, node + 1);
    visit(near, f, n.right);
  }
  /// Calls f(i, j) for all pieces i of this and j of the other whose boxes are within the margin of each other.
  template <class F>
  void visit_pairs(const ChainTree& other, double margin, const F& f) const {
    pairs(0, other, 0, margin, 0, f);
  }
  /// The same for pairs of pieces of this chain, i < j, without those closer than exclusion() along it.
  template <class F>
  void visit_self(double margin, const F& f, uint32_t node = 0) const {
    const Node& n = node_[node];
    if (n.right == 0 || n.s_high - n.s_low < exclusion_) return leaf_pairs(n, f);
    visit_self(margin, f, node + 1);
    visit_self(margin, f, n.right);
    pairs(node + 1, *this, n.right, margin, exclusion_, f);
  }

 private:
  struct Piece {
    Vec3 p0, p1, v0, v1;  // m, m/s
    double radius = 0;    // m; 0: no piece
    double s0 = 0, s1 = 0;
  };
  struct Node {
    Box box;
    uint32_t first = 0, count = 0;
    uint32_t right = 0;  // the left child follows its parent; 0: a leaf
    double s_low = 0, s_high = 0;
  };
  /// Pieces per leaf. More: fewer boxes, more pairs tested in vain.
  static constexpr uint32_t kLeaf = 2;

  bool apart_along(uint32_t i, uint32_t j, double exclusion) const {
    return j > i + 1 && piece_[j].s1 - piece_[i].s0 >= exclusion;
  }
  template <class F>
  void leaf_pairs(const Node& n, const F& f) const {
    if (n.s_high - n.s_low < exclusion_) return;
    for (uint32_t i = n.first; i < n.first + n.count; ++i)
      for (uint32_t j = i + 2; j < n.first + n.count; ++j)
        if (there(i) && there(j) && apart_along(i, j, exclusion_)) f(i, j);
  }
  template <class F>
  void pairs(uint32_t a, const ChainTree& other, uint32_t b, double margin, double exclusion,
             const F& f) const {
    const Node &na = node_[a], &nb = other.node_[b];
    if (exclusion > 0 && nb.s_high - na.s_low < exclusion) return;
    if (!na.box.near(nb.box, margin)) return;
    if (na.right == 0 && nb.right == 0) {
      for (uint32_t i = na.first; i < na.first + na.count; ++i)
        for (uint32_t j = nb.first; j < nb.first + nb.count; ++j)
          if (there(i) && other.there(j) && (exclusion == 0 || apart_along(i, j, exclusion))) f(i, j);
      return;
    }
    if (nb.right == 0 || (na.right != 0 && na.count >= nb.count)) {
      pairs(a + 1, other, b, margin, exclusion, f);
      pairs(na.right, other, b, margin, exclusion, f);
    } else {
      pairs(a, other, b + 1, margin, exclusion, f);
      pairs(a, other, nb.right, margin, exclusion, f);
    }
  }

  uint32_t chain_ = 0;  // index in World::chain
  uint32_t segments_ = 0;
  double exclusion_ = 0, moves_ = 0;
  Vec3 drift_ = Vec3::Zero();
  std::vector<Piece> piece_;
  std::vector<Node> node_;
};

}  // namespace swage::contact
