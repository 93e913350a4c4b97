// SPDX-License-Identifier: Apache-2.0
//
// An island with bands among its blocks, sparse (banded_blocks.hpp). A band is one block of four unknowns per vertex, a rigid body
// two, (v, -) and (w, -), a hinge or a particle one; idle unknowns have a stiffness of 1. Threads (also in contact with themselves),
// needles and jaws are factored together.
//
// Unknowns are the displacements of the blocks that a constraint or the drive of a hinge touches: the late ones, L. What nothing touches,
// E, is linear, and is eliminated once for all directions of a solve:
//
//     H_EE d_E = -F_E - H_EL d_L       S = H_LL - H_LE H_EE^-1 H_EL,  F = S d_L + F_L - H_LE H_EE^-1 F_E - J' f
//
// A point z is d_L in the order of elimination, four numbers a block. In a knot of 444 vertices 55 of them are late. [rt]; built on [main].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics/banded_assembly.hpp"
#include "dynamics/banded_blocks.hpp"
#include "dynamics/island.hpp"
#include "dynamics/space.hpp"
#include "dynamics/sparse_correction.hpp"
#include "dynamics/sparse_room.hpp"

namespace swage::dynamics {

class SparseSpace final : public Space {
 public:
  /// `max_unknowns`: of everything but bands.
  SparseSpace(uint32_t max_unknowns, const SparseRoom& room);

  size_t begin(const Island& island) noexcept override;
  bool start(double* z) noexcept override;
  void displace(const double* z) noexcept override;
  void residual(const double* z) noexcept override;
  double merit() noexcept override;
  bool search_direction(const double* z, bool same, double* step) noexcept override;
  bool corrected_direction(const double* z, uint32_t constraint, const Tangent& D, double* step) noexcept override;
  int sign() const noexcept override;
  void set_search_direction(const double* step) noexcept override;
  double slope(const double* z, const double* step) noexcept override;
  double length(const double* step) noexcept override;
  double moved(const double* z) noexcept override { return length(z); }
  void finish(const double* z, double* d) noexcept override;

 private:
  static uint32_t blocks_of(const DofBlock& block) noexcept;
  BlockPoint point(uint32_t block, const Constraint& c, bool is_a) const noexcept;
  void find_pattern() noexcept;
  bool analyse() noexcept;
  bool eliminate_early() noexcept;
  void condense_residual() noexcept;
  void add_block(uint32_t block) noexcept;
  void forces_of_blocks(const double* z) noexcept;
  bool same_drives(const double* z) noexcept;
  bool assemble(const double* z) noexcept;
  Displacement along(const BlockContact& c, const double* z) const noexcept;
  /// First number of a block of H_ in z.
  uint32_t in_z(uint32_t block) const noexcept { return 4 * (H_.place_of(block) - H_.early()); }
  /// Calls entry(number of the island, number of H_) for every unknown.
  template <class Entry>
  void each(const Entry& entry) const noexcept;

  const Island* island_ = nullptr;
  BandedBlocks H_;
  SparseCorrection correction_;
  bool ready_ = false, symmetric_ = true;
  bool factored_ = false;        // H_ holds the factors of the last system
  std::vector<uint32_t> first_;  // block of H_ of each block of the island
  std::vector<std::array<BlockPoint, 2>> sides_;  // per constraint
  std::vector<BlockContact> contact_;             // the same in the system
  std::vector<BandedBlocks::Pair> pair_, last_pair_;
  std::vector<uint8_t> late_, last_late_;  // per block of H_: a constraint or the drive of a hinge changes it
  uint32_t n_ = 0, last_n_ = 0;  // blocks of H_
  size_t size_ = 0;              // of z
  std::vector<double> x_;        // 4 per block of H_, in the order of elimination: early unknowns as condense_residual() left them
  std::vector<double> F0_, F_;   // residual at z = 0 without constraints, and that of the last point; as z
  std::vector<double> whole_;    // of the whole island, in its order
};

}  // namespace swage::dynamics
