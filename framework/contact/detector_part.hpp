// SPDX-License-Identifier: Apache-2.0
//
// What the detector tests against what, where chains are. Room-internal.
#pragma once

#include "contact/detector.hpp"

namespace swage::contact {

/// One side of a query: a piece of a chain, or a whole shape.
/// A contact at the end of a piece is reported by the next piece if the gap falls into that by more than kFalls. Of two pieces that meet in a
/// lowest vertex the first reports it; an end is a place within the share kEnd of the piece.
struct Detector::Part {
  static constexpr double kFalls = 1e-6, kEnd = 1e-9;

  const Solid* solid = nullptr;
  Frame X;
  Motion motion;
  const ChainTree* chain = nullptr;
  uint32_t segment = 0;
  uint32_t number = 0;  // of what is reported: the segment, or of a sphere its vertex
  bool sphere = false;
  Frame X_BS;  // piece in its body

  /// Place of a contact on the chain, n pointing into this side: on the centre line, from the touch by the radius and half the gap along n.
  ChainPlace place(const Touch& t, const Vec3& n) const {
    return chain != nullptr ? chain->place(segment, t.p_W + (solid->radius + 0.5 * t.gap) * n) : ChainPlace{};
  }
  /// Whether the next piece reports this contact.
  bool left_to_next(double share, const Vec3& n) const {
    if (chain == nullptr || sphere) return false;
    if (share > kEnd && share < 1 - kEnd) return false;
    const Vec3 onward = chain->onward(segment, share >= 1 - kEnd);
    if (onward.isZero(0)) return false;
    return share <= kEnd || n.dot(onward) < -kFalls;
  }
};

}  // namespace swage::contact
