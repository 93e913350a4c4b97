// SPDX-License-Identifier: Apache-2.0
//
// The faces of a diagram: the regions of the sphere between its arcs. Arc i leads from visit i to the next one, the last arc through
// infinity. Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include "toolkit/knot/diagram.hpp"

namespace swage::toolkit {

class KnotFaces {
 public:
  static constexpr int kFaces = KnotDiagram::kCrossings + 2;

  /// Finds the faces of a diagram with renumbered crossings. False for a code that no diagram in the plane has.
  bool find(const KnotDiagram& d) {
    const int n = d.visits();
    count_ = 0;
    std::fill_n(face_.begin(), 2 * n, -1);
    for (int start = 0; start < 2 * n; ++start) {
      if (face_[at(start)] >= 0) continue;
      if (count_ == n / 2 + 2) return false;
      for (int side = start; face_[at(side)] < 0; side = next(d, side)) face_[at(side)] = count_;
      ++count_;
    }
    return count_ == n / 2 + 2;
  }
  int count() const { return count_; }
  int left(int arc) const { return face_[at(2 * arc)]; }
  int right(int arc) const { return face_[at(2 * arc + 1)]; }

 private:
  static size_t at(int i) { return static_cast<size_t>(i); }
  /// Side 2 i is the left of arc i, walked along; 2 i + 1 the right, walked back. With the face on the left, the walk turns left at
  /// each crossing.
  static int next(const KnotDiagram& d, int side) {
    const int n = d.visits(), arc = side / 2;
    const bool along = side % 2 == 0;
    const KnotVisit& met = d.visit(along ? (arc + 1) % n : arc);
    const int other = d.place(met.crossing, !met.over);
    const bool goes_left = (d.sign(met.crossing) > 0) == met.over;  // the other strand, as seen along this one
    return goes_left == along ? 2 * other : 2 * ((other + n - 1) % n) + 1;
  }

  std::array<int, 4 * KnotDiagram::kCrossings> face_;
  int count_ = 0;
};

}  // namespace swage::toolkit
