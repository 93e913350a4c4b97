// SPDX-License-Identifier: Apache-2.0
//
// Finds chains that passed through something within a step. Contacts are detected where the chain advanced to; a part that then moves
// farther than the detection reached has no contact with what it meets, and a thin thread that is pulled quickly passes through it. For a
// chain with itself the whole step is tested, each vertex on a straight path: in a loop of few pieces these turn so far that a contact
// found on the path no longer tells on which side they ended.
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

  /// Store the vertices: begin() before free motion, keep() after detect.
  void begin() noexcept { copy_to(p_begun_); }
  void keep() noexcept { copy_to(p_looked_); }
  /// After the solve: whether a chain overlaps something deeply without a contact in `known`.
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
  std::vector<double> p_looked_;     // m, the same when contacts were detected
  std::vector<double> boxes_;        // work space of toolkit::passages
  std::vector<uint8_t> alone_;       // per chain: 1 where no pair lets it touch itself, or its vertices only; it may pass
  std::vector<double> v_;            // m/s, velocities of the chains, while the detector is given others
  std::vector<swage_twist> V_;       // velocities of the bodies, the same
  contact::ContactSet on_the_way_;
};

}  // namespace swage::step
