// SPDX-License-Identifier: Apache-2.0
//
// What chains meet between where contacts were looked for and where the solve has put them. What was not near then has no contact, and a
// thin thread that is snatched comes out on its far side.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <vector>

#include "contact/detector.hpp"
#include "scene/world.hpp"

namespace swage::step {

class ChainWatch {
 public:
  ChainWatch(scene::World& world, contact::Detector& detector);

  /// After detect: where the vertices are.
  void keep() noexcept;
  /// After the solve: whether a chain is deep in what `known` does not name.
  bool met_unseen(const contact::ContactSet& known) noexcept;

 private:
  bool went_far() const noexcept;
  void look_along_the_way() noexcept;
  bool unseen(const contact::Contact& met, const contact::ContactSet& known) const noexcept;

  scene::World& world_;
  contact::Detector& detector_;
  std::vector<double> p_looked_;     // m, vertices of all chains where contacts were looked for
  std::vector<double> v_;            // m/s, their velocities, while the detector is shown others
  std::vector<swage_twist> V_;       // of the bodies, the same
  contact::ContactSet on_the_way_;
};

}  // namespace swage::step
