// SPDX-License-Identifier: Apache-2.0
//
// A chain whose mechanics is a band (swage.object.band/1), in one step: unknowns q are the changes of its vertices, and the
// rotations of its pieces about themselves, from where it advanced to. With the contact forces J' f,
//
//     A q + g = J' f,    A = M/h^2 + K,    g = M/h^2 (x - x_free) + dE/dx
//
// A point of its surface moves with the two vertices of its piece and turns with the piece: 8 unknowns side by side.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/banded_blocks.hpp"
#include "toolkit/band.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

class FlexibleBody;

class BandedBody {
 public:
  static constexpr uint32_t kUnknowns = 4;       // of a vertex
  static constexpr uint32_t kOfPoint = 8;        // of a point: those of two vertices
  static constexpr double kHeld = 1e30;          // N/m, of a fixed vertex: 1 N moves it by less than an atom

  BandedBody(uint32_t object, uint32_t vertices);

  uint32_t object() const noexcept { return object_; }
  uint32_t vertices() const noexcept { return vertices_; }
  uint32_t unknowns() const noexcept { return kUnknowns * vertices_; }

  /// Begins a step, at the state to which the chain advanced.
  void begin() noexcept;
  /// Asks its object for A and g. False: there is no such step. `from_last`: it is eliminated from its last vertex on, and columns of
  /// vertices near the first one are short; else the other way round.
  bool linearise(FlexibleBody& object, bool from_last = false) noexcept;
  /// q += d.
  void go(const double* d) noexcept;
  /// Moves to the state without contacts. False when it is there already.
  bool release() noexcept;
  const double* change() const noexcept { return q_.data(); }

  // of DofBlock, `unknowns` numbers each
  /// A (q + d) + g.
  void residual(const double* d, double* F) const noexcept;
  /// From q to where it goes without contacts.
  void to_free(double* d) const noexcept;
  /// d = A^-1 F. Not from columns: forces that balance each other move little, and columns a great deal that must cancel.
  void apply_inverse(const double* F, double* d) const noexcept {
    std::copy_n(F, unknowns(), d);
    solve(d);
  }
  /// F' A^-1 F.
  double merit(const double* F) const noexcept;
  void add_stiffness(BandedBlocks& H, uint32_t first_block, bool symmetric) noexcept;
  /// How unknowns go with forces on those of one vertex: a column of A^-1, four numbers an unknown, of the vertices from `least` to
  /// `most`, of which it is one. Solved for once a step.
  const double* column(uint32_t vertex, uint32_t least, uint32_t most) noexcept;

  /// The Jacobian of a point with respect to q: `turn` = tangent x arm.
  toolkit::Vec3 moved(const contact::ChainPlace& at, const toolkit::Vec3& turn) const noexcept {
    return moved(at, turn, q_.data());
  }
  toolkit::Vec3 moved_free(const contact::ChainPlace& at, const toolkit::Vec3& turn) const noexcept {
    return moved(at, turn, free_.data());
  }

 private:
  using Matrix = toolkit::Band<10>;
  static toolkit::Vec3 moved(const contact::ChainPlace& at, const toolkit::Vec3& turn, const double* q) noexcept;
  void hold() noexcept;
  void take_factors() noexcept;
  void solve(double* x) const noexcept;
  void find_blocks() noexcept;

  const uint32_t object_, vertices_;
  Matrix A_, factors_;
  std::vector<BandedBlocks::Block, Eigen::aligned_allocator<BandedBlocks::Block>> block_;  // A, 3 below each other per vertex
  bool has_blocks_ = false;            // of this step
  bool from_last_ = false;             // factors_ have the unknowns in the reverse order
  std::vector<double> column_, side_;  // of A^-1, vertex by vertex; one of them, in the order of the factors
  std::vector<uint32_t> column_from_;  // of this step, per vertex: the first vertex, in that order, of which it is there
  std::vector<double> gradient_, free_, q_;
  mutable std::vector<double> line_;
};

}  // namespace swage::dynamics
