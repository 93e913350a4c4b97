// SPDX-License-Identifier: Apache-2.0
//
// Newton's system of flexible bodies and of the rigid ones that they touch, H = A + J' D J, factored directly as a sparse matrix of
// 4 x 4 blocks. A thread of n nodes is n blocks (x, theta), each coupled to two on either side (its band); a contact couples the
// nodes under its two points, wherever along the thread these are; a rigid body is two blocks (v, -) and (w, -), the fourth
// unknowns idle. Contacts of a thread with itself, with rigid bodies and with other threads are treated alike, and the cost grows
// with the number of coupled blocks, not with the square of the number of contacts.
//
// analyse() orders the blocks for little fill-in (minimum degree, the lowest index of equals) and lists every update; it is
// repeated only when pairs change. Blocks that no contact touches come first: factor_early() eliminates them once for all
// the search directions of a solve, which differ by what contacts add to the late ones. factor() computes L U without pivoting, within the blocks too; for a symmetric H, L D L' of
// one half alone. Its order of operations is fixed: the same bits at every level of optimisation.
//
// Threads: built on [main]; the rest [rt], nothing allocates.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/banded_elimination.hpp"

namespace swage::dynamics {

class BandedBlocks {
 public:
  using Block = Eigen::Matrix4d;
  struct Pair {
    uint32_t a = 0, b = 0;
  };

  /// Reserves room for `max_blocks` blocks on the diagonal and `max_fill` blocks below it, fill-in included.
  BandedBlocks(uint32_t max_blocks, uint32_t max_fill);

  /// Sets the pattern: which blocks are coupled; pairs may repeat. `late`: one number per block, 1 for those that are eliminated last;
  /// empty: none. False: there is no room for the fill-in.
  bool analyse(uint32_t blocks, std::span<const Pair> coupled, std::span<const uint8_t> late = {}) noexcept;
  uint32_t blocks() const noexcept { return n_; }
  /// Number of blocks below the diagonal, and of block products in factor().
  size_t fill() const noexcept { return row_.size() < first_[n_] ? row_.size() : first_[n_]; }
  size_t late_fill() const noexcept { return first_[n_] - first_[early_]; }
  size_t work() const noexcept { return updates_; }
  /// Operations on blocks in factor() after take_late(), and in factor_early().
  size_t late_work() const noexcept {
    return updates_ - first_update_[early_] + 2 * size_t{first_[n_] - first_[early_]} + n_ - early_;
  }
  size_t early_work() const noexcept { return first_update_[early_] + 2 * size_t{first_[early_]} + early_; }

  /// `symmetric`: that of the H that is added next, of which only the lower half is kept then.
  void set_zero(bool symmetric) noexcept;
  /// H(a, b) += M. For a symmetric H the caller adds (a, b) or (b, a), not both; otherwise both, each by its own call.
  void add(uint32_t a, uint32_t b, const Block& M) noexcept;

  /// Eliminates all blocks that are not late from a symmetric H. False where it is not positive definite.
  bool factor_early() noexcept;
  /// Takes the late blocks as factor_early() left them, for additions to them alone. `symmetric`: whether these are.
  void take_late(bool symmetric) noexcept;
  /// Eliminates the late blocks, or all after set_zero(). False where a pivot is zero or not finite or, of a symmetric H, negative.
  bool factor() noexcept;
  /// x = H^-1 x, 4 numbers a block.
  void solve(double* x) const noexcept;

  // The system without the early unknowns, S = H_LL - H_LE H_EE^-1 H_EL. Vectors are in the order of elimination: y of all blocks, x, r of
  // the late ones.
  /// Number of early blocks, and the place of a block in the order of elimination.
  uint32_t early() const noexcept { return early_; }
  uint32_t place_of(uint32_t block) const noexcept { return at_[block]; }
  /// Index of the block at a row and a column in that order, row > column, which must be coupled; and all blocks in memory.
  uint32_t place_below(uint32_t row, uint32_t column) const noexcept { return place_[size_t{row} * n_ + column]; }
  BlockStore store() const noexcept;
  bool has_fours() const noexcept { return fours_; }
  /// After factor_early(): y_L -= H_LE H_EE^-1 y_E; y_E is left as solve_early() wants it.
  void condense(double* y) const noexcept;
  /// y_E = H_EE^-1 (y_E - H_EL y_L), y_E as condense() left it.
  void solve_early(double* y) const noexcept;
  /// r -= S x, without what was added after take_late().
  void take_product(const double* x, double* r) const noexcept;
  /// After factor(): x = H^-1 x, of the late blocks alone.
  void solve_late(double* x) const noexcept;
  /// The same of four vectors at once, side by side: four numbers to an unknown.
  void solve_four_late(double* X) const noexcept;
  /// Uses registers of two doubles even where the machine has four: for the test that both give the same bits.
  void work_by_twos() noexcept { fours_ = false; }
  /// Number of negative pivots: odd where det H < 0.
  uint32_t negative_pivots() const noexcept { return negative_; }

 private:
  using Blocks = std::vector<Block, Eigen::aligned_allocator<Block>>;

  bool order(std::span<const Pair> coupled, std::span<const uint8_t> late) noexcept;
  bool list_updates() noexcept;
  /// Index of the block at (row, column), both in elimination order.
  uint32_t& place(uint32_t row, uint32_t column) noexcept { return place_[size_t{row} * n_ + column]; }
  bool split(Block& D) noexcept;
  bool eliminate(uint32_t from, uint32_t to) noexcept;
  void forward(uint32_t from, uint32_t to, uint32_t base, double* y) const noexcept;
  void backward(uint32_t from, uint32_t to, uint32_t base, double* y) const noexcept;
  uint64_t* line(uint32_t i) noexcept { return near_.data() + size_t{i} * words_; }
  uint64_t* with_degree(uint32_t degree) noexcept { return of_degree_.data() + size_t{std::min(degree, kDegrees - 1)} * words_; }
  uint32_t least_degree() noexcept;
  // Degrees that order() tells apart. In a tight knot the most is 40; fewer only lets blocks of many neighbours come in another order.
  static constexpr uint32_t kDegrees = 128;

  uint32_t max_blocks_, max_fill_, words_;
  uint32_t n_ = 0;
  uint32_t early_ = 0, done_ = 0;  // blocks that are not late; those that are eliminated for good
  size_t updates_ = 0;
  bool symmetric_ = true;  // of what is added: one half is kept then, the lower
  uint32_t negative_ = 0;
  bool fours_ = toolkit::has_fours();
  std::vector<uint64_t> near_;              // neighbours of each block, one bit each
  std::vector<uint64_t> of_degree_;         // blocks of each degree that are still to be ordered, one bit each
  std::vector<uint32_t> at_, of_, degree_;  // per block: place in the elimination order; its inverse; degree
  std::vector<uint32_t> first_;             // per column in that order: index of its first block; n + 1
  std::vector<uint32_t> row_;               // per block below the diagonal: its row in that order
  std::vector<uint32_t> place_;             // index of the block at a row and column in that order
  std::vector<uint32_t> first_update_;
  std::vector<BlockUpdate> update_;
  Blocks diagonal_, lower_, upper_;         // upper_: blocks above the diagonal, transposed
  Blocks late_diagonal_, late_lower_;       // as factor_early() left them
  mutable std::vector<double> y_;
};

}  // namespace swage::dynamics
