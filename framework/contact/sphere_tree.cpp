// SPDX-License-Identifier: Apache-2.0
#include "contact/sphere_tree.hpp"

#include <algorithm>
#include <numeric>

namespace swage::contact {
namespace {

class Builder {
 public:
  Builder(const std::vector<Vec3>& centres, double radius, const SphereTreeLimits& limits)
      : centres_(centres), limits_(limits) {
    tree_.radius = radius;
    std::vector<uint32_t> all(centres.size());
    std::iota(all.begin(), all.end(), 0u);
    if (!all.empty()) add_node(all, 1);
  }
  SphereTree take() { return std::move(tree_); }

 private:
  using Spheres = std::vector<uint32_t>;

  Vec3 centre_of_mass(const Spheres& spheres) const {
    Vec3 sum = Vec3::Zero();
    for (const uint32_t i : spheres) sum += centres_[i];
    return sum / static_cast<double>(spheres.size());
  }
  double reach(const Vec3& centre, const Spheres& spheres) const {
    double most = 0;
    for (const uint32_t i : spheres) most = std::max(most, (centres_[i] - centre).norm());
    return most + tree_.radius;
  }

  void add_node(const Spheres& spheres, int level) {
    const size_t k = tree_.node.size();
    SphereTree::Node node;
    node.centre = centre_of_mass(spheres);
    node.radius = reach(node.centre, spheres);
    node.first = static_cast<uint32_t>(tree_.centre.size());
    node.count = static_cast<uint32_t>(spheres.size());
    node.leaf = level >= limits_.levels || spheres.size() <= std::max(1u, limits_.few_spheres);
    tree_.node.push_back(node);
    if (node.leaf) {
      for (const uint32_t i : spheres) tree_.centre.push_back(centres_[i]), tree_.number.push_back(i);
    } else {
      Spheres rest = spheres;
      while (!rest.empty()) add_node(grow_leaf(rest, node), level + 1);
    }
    tree_.node[k].skip = static_cast<uint32_t>(tree_.node.size());
  }

  /// Moves the spheres of one new leaf out of `rest`.
  Spheres grow_leaf(Spheres& rest, const SphereTree::Node& parent) const {
    const auto farthest = std::max_element(rest.begin(), rest.end(), [&](uint32_t a, uint32_t b) {
      return (centres_[a] - parent.centre).squaredNorm() < (centres_[b] - parent.centre).squaredNorm();
    });
    Spheres leaf{*farthest};
    rest.erase(farthest);
    for (size_t before = 0; before != leaf.size();) {
      before = leaf.size();
      const Vec3 centre = centre_of_mass(leaf);
      const auto outside = [&](uint32_t i) {
        return (centres_[i] - centre).norm() + tree_.radius > 0.5 * parent.radius;
      };
      const auto inside = std::stable_partition(rest.begin(), rest.end(), outside);
      leaf.insert(leaf.end(), inside, rest.end());
      rest.erase(inside, rest.end());
    }
    std::sort(leaf.begin(), leaf.end());
    return leaf;
  }

  const std::vector<Vec3>& centres_;
  const SphereTreeLimits limits_;
  SphereTree tree_;
};

}  // namespace

std::vector<Vec3> sphere_chain(const toolkit::Arc& arc, int count) {
  std::vector<Vec3> centres;
  for (int i = 0; i < count; ++i)
    centres.push_back(arc.point(arc.at(static_cast<double>(i) / std::max(1, count - 1))));
  return centres;
}

std::vector<Vec3> sphere_chain_part(const toolkit::Arc& arc, int count, double from, double to) {
  std::vector<Vec3> centres;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / std::max(1, count - 1);
    // a sphere where two arcs meet belongs to the second, the last sphere to the last arc
    if (share >= from && (share < to || to >= 1)) centres.push_back(arc.point(arc.at((share - from) / (to - from))));
  }
  if (centres.empty()) centres.push_back(arc.point(arc.at(0.5)));
  return centres;
}

SphereTree build_sphere_tree(const std::vector<Vec3>& centres, double radius,
                             const SphereTreeLimits& limits) {
  return Builder(centres, radius, limits).take();
}

}  // namespace swage::contact
