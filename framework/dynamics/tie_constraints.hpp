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

  /// Finds the sides of each tie and, on flexible bodies, the point that it pulls.
  void begin(std::span<Tie> ties) noexcept;
  void predict() noexcept;
  /// Stores the material points of each tie in the frames of its bodies, once it is known which sides can move.
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
