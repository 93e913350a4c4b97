// SPDX-License-Identifier: Apache-2.0
//
// Where the first throw of a knot ends and the loop that it is tied around begins. A diagram tells where strands cross; in some views the legs of the
// loop cross in the place of the strands, and the throw is seen with a part of the loop in it. In a throw that is drawn down the strands touch, and the
// loop touches nothing: it is the longest stretch of the thread within the throw that does not touch it. Where an eye that is left in a strand is longer
// than the loop, that is told as the loop. Header-only.
//
// Threads: [rt], pure, nothing allocates.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolkit/knot/word.hpp"
#include "toolkit/math.hpp"

namespace swage::toolkit {

class KnotTouch {
 public:
  /// Of the mean distance between two nodes. Centre lines of strands that touch are a diameter apart; a strand that turns by a right angle at each node
  /// is up to 0.21 of a piece away from the middle of that piece, and so may the other one be. Smaller: strands that touch count as the loop. Greater:
  /// the legs of a narrow loop count as the throw. 8-0 nylon in pieces of 0.4 mm: 0.24 mm; strands that touch are told as 0.05 to 0.15 mm apart, the legs
  /// of a loop about a wound as 0.37 to 1.2 mm.
  static constexpr double kCorners = 0.5;

  /// A polyline of n nodes, x y z each [m], of a thread with that diameter [m].
  KnotTouch(const double* node, int n, double diameter) : node_(node), n_(n) {
    double length = 0;
    for (int i = 0; i + 1 < n; ++i) {
      const double piece = (p(i + 1) - p(i)).norm();
      length += piece, longest_ = std::max(longest_, piece);
    }
    const double mean = length / (n - 1);
    touch_ = diameter + kCorners * mean;
    // a thread that comes so near to itself has turned by half a circle at least
    apart_ = 1 + static_cast<int>(std::ceil(0.5 * std::numbers::pi * touch_ / mean));
  }
  /// Distance up to which strands touch [m].
  double touch() const { return touch_; }

  /// The first throw of a knot with its strands up to the loop and from it on; as it is where nothing in it touches, or all.
  KnotThrow up_to_loop(const KnotThrow& tied) const {
    const int from = std::max(0, static_cast<int>(std::ceil(tied.strand[0].first)));
    const int to = std::min(n_ - 1, static_cast<int>(std::floor(tied.strand[1].last)));
    int begin = 0, length = 0;
    for (int i = from, run = 0; i <= to; ++i) {
      run = touches(i, from, to) ? 0 : run + 1;
      if (run > length) length = run, begin = i + 1 - run;
    }
    const int end = begin + length;
    if (length == 0 || begin == from || end > to) return tied;
    KnotThrow out = tied;
    out.strand[0].last = leaves(begin - 1, begin, from, to);
    out.strand[1].first = leaves(end, end - 1, from, to);
    return out;
  }

 private:
  Vec3 p(int i) const { return Eigen::Map<const Vec3>(node_ + 3 * i); }
  bool neighbours(int i, int piece) const { return piece > i - apart_ - 1 && piece < i + apart_; }
  double distance(int i, int piece) const {
    const Vec3 e = p(piece + 1) - p(piece), r = p(i) - p(piece);
    const double squared = e.squaredNorm();
    return (r - (squared > 0 ? std::clamp(r.dot(e) / squared, 0.0, 1.0) : 0) * e).norm();
  }
  /// Whether a node touches a piece between two nodes. From a piece that is far away no near one can be reached within a few pieces.
  bool touches(int i, int from, int to) const {
    for (int j = from; j < to;) {
      if (neighbours(i, j)) {
        j = i + apart_;
        continue;
      }
      const double d = distance(i, j);
      if (d <= touch_) return true;
      j += std::max(1, static_cast<int>((d - touch_) / longest_));
    }
    return false;
  }
  double nearest(int i, int from, int to) const {
    double best = 2 * touch_;
    for (int j = from; j < to; ++j)
      if (!neighbours(i, j)) best = std::min(best, distance(i, j));
    return best;
  }
  /// The place between a node that touches and its neighbour that does not.
  double leaves(int touching, int free, int from, int to) const {
    const double a = nearest(touching, from, to), b = nearest(free, from, to);
    return touching + (free - touching) * (touch_ - a) / (b - a);
  }

  const double* node_;
  int n_, apart_ = 2;
  double touch_ = 0, longest_ = 0;  // m
};

}  // namespace swage::toolkit
