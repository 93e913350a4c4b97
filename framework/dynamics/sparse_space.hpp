// SPDX-License-Identifier: Apache-2.0
//
// An island in the displacements of its blocks, bands among them: H step = -F, sparse (banded_blocks.hpp). A band is one block of
// four unknowns per vertex, a rigid body two, (v, -) and (w, -), a hinge or a particle one; idle unknowns have a stiffness of 1.
// Threads (also in contact with themselves), needles and jaws are factored together. [rt]; built on [main].
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/banded_assembly.hpp"
#include "dynamics/banded_blocks.hpp"
#include "dynamics/displacement_space.hpp"
#include "dynamics/sparse_room.hpp"

namespace swage::dynamics {

class SparseSpace final : public DisplacementSpace {
 public:
  /// `max_unknowns`: of everything but bands.
  SparseSpace(uint32_t max_unknowns, const SparseRoom& room);

  size_t begin(const Island& island) noexcept override;
  bool start(double* d) noexcept override;
  bool search_direction(const double* d, bool same, double* step) noexcept override;
  int sign() const noexcept override;

 private:
  /// Sides of a constraint as the system has them: J = a - b.
  struct Sides {
    BlockPoint a, b;
  };
  static uint32_t blocks_of(const DofBlock& block) noexcept;
  BlockPoint point(uint32_t block, const Constraint& c, bool is_a) const noexcept;
  void find_pattern() noexcept;
  bool assemble(const double* d) noexcept;
  bool factor_early() noexcept;
  void add_block(uint32_t block) noexcept;

  BandedBlocks H_;
  bool ready_ = false, symmetric_ = true;
  bool early_ = false;           // blocks that nothing touches are eliminated
  std::vector<uint32_t> first_;  // block of H_ of each block of the island
  std::vector<Sides> sides_;     // per constraint
  std::vector<BandedBlocks::Pair> pair_, last_pair_;
  std::vector<uint8_t> late_, last_late_;  // per block of H_: a constraint or the drive of a hinge changes it
  uint32_t n_ = 0, last_n_ = 0;  // blocks of H_
  std::vector<double> x_;        // 4 per block of H_
};

}  // namespace swage::dynamics
