// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A bent wire made of several arcs on bodies of their own, drawn as one wire. Free of Qt3D.
#pragma once

#include <span>
#include <vector>

#include "snapshot/scene_card.hpp"

namespace swage::console {

struct WireChain {
  uint32_t object = 0;
  double radius = 0;                       // m
  double taper = 0;                        // m, length of the drawn point; 0: none
  std::vector<snapshot::CardShape> piece;  // arcs, from the point to the swage

  /// Centre line as x y z [m, world] through the pieces in their bodies' present poses. No point lies on a joint, so that a tube
  /// through them is smooth there.
  std::vector<double> centre_line(std::span<const swage_pose> X_WB) const;
};

/// Objects with arcs on more than one body, in order along each.
std::vector<WireChain> find_chains(const snapshot::SceneCard& card);

/// The part [from, to] (0..1 by length) of a polyline x y z.
std::vector<double> part_of_line(const std::vector<double>& line, double from, double to);

}  // namespace swage::console
