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
  /// The material points that each tie holds, once it is known who can be moved.
  void start() noexcept;
  /// Looks at the ties of everything that moved.
  void refresh(ContactIslands& islands) noexcept;
  /// What was put elsewhere than its constraints said.
  void linearise(const IslandWorkspace& island) noexcept;
  void write() noexcept;

 private:
  ContactProblem& p_;
};

}  // namespace swage::dynamics
