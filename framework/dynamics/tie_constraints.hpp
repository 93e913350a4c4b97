// SPDX-License-Identifier: Apache-2.0
//
// Ties beside contacts: constraints of the same islands, always active, with constant limits.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <span>

#include "dynamics/contact_islands.hpp"

namespace swage::dynamics {

class TieConstraints {
 public:
  explicit TieConstraints(ContactProblem& problem) : p_(problem) {}

  /// Sides and, where a flexible body answers for itself, its points.
  void begin(std::span<Tie> ties) noexcept;
  void predict() noexcept;
  /// Finds the material points that each tie holds, once the movable sides are known.
  void start() noexcept;
  /// Updates the constraints of all ties whose sides moved.
  void refresh(ContactIslands& islands) noexcept;
  /// Linearises the ties of an island at the present poses.
  void linearise(const IslandWorkspace& island) noexcept;
  void write() noexcept;

 private:
  ContactProblem& p_;
};

}  // namespace swage::dynamics
