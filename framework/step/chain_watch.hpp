// SPDX-License-Identifier: Apache-2.0
//
// Finds chains that passed through something within a step. Contacts are searched where the chain stood; a part that moved farther than
// that search reached has no contact with what it met, and a thin thread that is pulled quickly comes out on the far side. Of a chain with
// itself the whole step is tested, each vertex on a straight path: in a loop of few pieces these turn so far that a contact found on the
// path no longer tells on which side they ended.
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

  /// Before free motion, and after detect: where the vertices are.
  void begin() noexcept { copy_to(p_begun_); }
  void keep() noexcept { copy_to(p_looked_); }
  /// After the solve: whether a chain is deep in what `known` does not name.
  bool met_unseen(const contact::ContactSet& known) noexcept;
  /// After the solve: whether a chain has passed through itself since begin().
  bool passed_itself() noexcept;

 private:
  void copy_to(std::vector<double>& p) const noexcept;
  bool went_far() const noexcept;
  void look_along_the_way() noexcept;
  bool unseen(const contact::Contact& met, const contact::ContactSet& known) const noexcept;

  scene::World& world_;
  contact::Detector& detector_;
  std::vector<double> p_begun_;      // m, vertices of all chains at the beginning of the step
  std::vector<double> p_looked_;     // m, the same where contacts were looked for
  std::vector<double> boxes_;        // room of toolkit::passages
  std::vector<uint8_t> alone_;       // chains that no contact joins with themselves: they may pass
  std::vector<double> v_;            // m/s, their velocities, while the detector is shown others
  std::vector<swage_twist> V_;       // of the bodies, the same
  contact::ContactSet on_the_way_;
};

}  // namespace swage::step
