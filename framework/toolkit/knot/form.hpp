// SPDX-License-Identifier: Apache-2.0
//
// Whether a throw is flat or slides. Both are the same knot; they differ in shape. In a flat throw both strands are bent alike; in one
// that slides, one strand runs straight through and the other is wound around it (a half hitch on a post). What counts is how far each
// strand turns where it lies beside the other. Header-only.
//
// Threads: [rt], pure, nothing allocates.
#pragma once

#include <numbers>

#include "toolkit/knot/word.hpp"
#include "toolkit/math.hpp"

namespace swage::toolkit {

class KnotForm {
 public:
  /// Below this share of the turning of the other strand, a strand is the straight core of a throw that slides.
  static constexpr double kCoreShare = 0.5;
  /// rad. A strand that turns by more does not run straight through, however often the other one goes about it: cores of random ties turn by up to
  /// 4.4 with the bends on both sides of their throws (tests/knots), strands of a tight throw in which the other one has a loop by 5.2 and more.
  /// Smaller: throws that slide are told as flat. Greater: such tight throws are told as sliding. The other strand has to turn by more: wound about
  /// a core it turns by 1.5 turns and more. In throws of a few nodes that are drawn down both may turn by less than a rad, which tells nothing.
  static constexpr double kStraight = 1.5 * std::numbers::pi;

  /// Measures a throw in a polyline of n nodes.
  KnotForm(const double* node, int n, const KnotThrow& tied) : node_(node), n_(n) {
    double sum = 0, count = 0;
    for (int k = 0; k < 2; ++k)
      for (int i = at_node(tied.strand[k].first); i <= at_node(tied.strand[k].last); ++i)
        sum += beside(i, tied.strand[1 - k]), count += 1;
    near_ = kNear * sum / count;
    for (int k = 0; k < 2; ++k) turned_[k] = turning(tied.strand[k], tied.strand[1 - k]);
  }
  /// Angle by which a strand turns beside the other [rad].
  double turned(int strand) const { return turned_[strand]; }
  /// The strand (0 or 1) that runs straight through, with the other one wound about it; -1: the throw is flat.
  int core() const {
    for (int k = 0; k < 2; ++k)
      if (turned_[k] < kStraight && turned_[1 - k] > kStraight && turned_[k] < kCoreShare * turned_[1 - k]) return k;
    return -1;
  }

 private:
  /// A place is beside the other strand when it is nearer to it than this many times the mean distance between the two.
  static constexpr double kNear = 1.2;

  Vec3 p(int i) const { return Eigen::Map<const Vec3>(node_ + 3 * i); }
  int at_node(double s) const { return std::clamp(static_cast<int>(std::lround(s)), 1, n_ - 2); }
  static double margin(const KnotThrow::Strand& s) { return 0.3 * (s.last - s.first) + 2; }
  /// Distance from a node to the other strand [m].
  double beside(int i, const KnotThrow::Strand& other) const {
    double best = HUGE_VAL;
    for (int j = at_node(other.first - margin(other)); j <= at_node(other.last + margin(other)); ++j) {
      if (std::abs(i - j) < 2) continue;
      const Vec3 e = p(j + 1) - p(j), r = p(i) - p(j);
      const double share = std::clamp(r.dot(e) / e.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (r - share * e).norm());
    }
    return best;
  }
  double turning(const KnotThrow::Strand& strand, const KnotThrow::Strand& other) const {
    double sum = 0;
    for (int i = at_node(strand.first - margin(strand)); i <= at_node(strand.last + margin(strand)); ++i) {
      if (beside(i, other) > near_) continue;
      const Vec3 e = p(i) - p(i - 1), f = p(i + 1) - p(i);
      sum += std::atan2(e.cross(f).norm(), e.dot(f));
    }
    return sum;
  }

  const double* node_;
  int n_;
  double near_ = 0;
  double turned_[2] = {};
};

}  // namespace swage::toolkit
