// SPDX-License-Identifier: Apache-2.0
//
// Edges of a slit that can close: each half of the wall moves along x as a whole, on a spring, and edges that meet press on each
// other. Left is the half at x < 0. Units SI, O's x axis. Header-only, pure, [rt].
#pragma once

#include <array>
#include <cstddef>

namespace swage::tissue {

struct SlitEdges {
  double give = 0;  // m/N, compliance of one edge; 0: they do not move
  double slit = 0;  // m, width of the gap without forces

  /// Values of the left and the right edge, along +x.
  using Pair = std::array<double, 2>;

  bool move() const { return give > 0; }
  /// True when the edges meet under the forces f [N].
  bool meet(const Pair& f) const { return give * (f[0] - f[1]) >= slit; }
  /// Displacements of the edges, m.
  Pair displaced(const Pair& f) const {
    const double overlap = give * (f[0] - f[1]) - slit, back = overlap > 0 ? 0.5 * overlap : 0;
    return {give * f[0] - back, give * f[1] + back};
  }
  /// Width of the gap, m; 0 where they meet.
  double gap(const Pair& f) const {
    const Pair x = displaced(f);
    return slit + x[1] - x[0];
  }
  /// Displacement of one edge per force on another, m/N: edges that meet move together.
  double between(size_t i, size_t j, bool meeting) const { return meeting ? 0.5 * give : i == j ? give : 0; }
  /// Displacements without f, m, linearised about the state under f: whether the edges meet stays as it is under f.
  Pair without(const Pair& f) const {
    Pair x = displaced(f);
    const bool meeting = meet(f);
    for (size_t i = 0; i < 2; ++i)
      for (size_t j = 0; j < 2; ++j) x[i] -= between(i, j, meeting) * f[j];
    return x;
  }
};

}  // namespace swage::tissue
