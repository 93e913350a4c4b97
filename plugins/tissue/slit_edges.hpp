// SPDX-License-Identifier: Apache-2.0
//
// The two edges of a slit that come together: each half of the wall gives along x as a whole, on a spring, and edges that meet bear on each
// other. Left is the half at x < 0. Units SI, O's x axis. Header-only, pure, [rt].
#pragma once

#include <array>
#include <cstddef>

namespace swage::tissue {

struct SlitEdges {
  double give = 0;  // m/N, of one edge; 0: they stand still
  double slit = 0;  // m, width of the gap when nothing pulls

  /// Left and right, along +x.
  using Pair = std::array<double, 2>;

  bool move() const { return give > 0; }
  /// Whether they meet under forces f [N].
  bool meet(const Pair& f) const { return give * (f[0] - f[1]) >= slit; }
  /// By what they are displaced, m.
  Pair displaced(const Pair& f) const {
    const double overlap = give * (f[0] - f[1]) - slit, back = overlap > 0 ? 0.5 * overlap : 0;
    return {give * f[0] - back, give * f[1] + back};
  }
  /// m, 0 where they meet.
  double gap(const Pair& f) const {
    const Pair x = displaced(f);
    return slit + x[1] - x[0];
  }
  /// Displacement of one per force on another, m/N: those that meet go together.
  double between(size_t i, size_t j, bool meeting) const { return meeting ? 0.5 * give : i == j ? give : 0; }
  /// Where edges that were displaced by f would be without it, were they to give on as they do there, m.
  Pair without(const Pair& f) const {
    Pair x = displaced(f);
    const bool meeting = meet(f);
    for (size_t i = 0; i < 2; ++i)
      for (size_t j = 0; j < 2; ++j) x[i] -= between(i, j, meeting) * f[j];
    return x;
  }
};

}  // namespace swage::tissue
