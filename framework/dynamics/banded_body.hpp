// SPDX-License-Identifier: Apache-2.0
//
// A chain whose mechanics is a band (swage.object.band/1), in one step. The unknowns q are the displacements of its vertices and
// the rotations of its segments about their axes, from the state to which the chain advanced. With the contact forces J' f,
//
//     A q + g = J' f,    A = M/h^2 + K,    g = M/h^2 (x - x_free) + dE/dx
//
// A point of its surface moves with the two vertices of its segment and turns with the segment: 8 consecutive unknowns.
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
  static constexpr uint32_t kUnknowns = 4;       // per vertex: 3 of displacement, 1 of rotation
  static constexpr uint32_t kOfPoint = 8;        // per point of the surface: those of two vertices
  static constexpr double kHeld = 1e30;          // N/m, stiffness of a fixed vertex: 1 N moves it by less than an atom

  BandedBody(uint32_t object, uint32_t vertices);

  uint32_t object() const noexcept { return object_; }
  uint32_t vertices() const noexcept { return vertices_; }
  uint32_t unknowns() const noexcept { return kUnknowns * vertices_; }

  /// Begins a step, at the state to which the chain advanced.
  void begin() noexcept;
  /// Asks its object for A and g and factors A, the softest that can be factored. False: the object has no such step. `from_last`: A is
  /// eliminated from the last vertex on, and the columns of vertices near the first one are short; otherwise from the first vertex on.
  /// `stiffer`: how stiff A had to be made (0 to SWAGE_BAND_STIFFER) in the last step, and in this one; the search begins one below the last.
  bool linearise(FlexibleBody& object, bool from_last, uint64_t& stiffer) noexcept;
  /// q += d.
  void go(const double* d) noexcept;
  /// Moves to the state without contacts. False when it is there already.
  bool release() noexcept;
  const double* change() const noexcept { return q_.data(); }

  // of DofBlock, `unknowns` numbers each
  /// A (q + d) + g.
  void residual(const double* d, double* F) const noexcept;
  /// Step from q to the state without contacts.
  void to_free(double* d) const noexcept;
  /// d = A^-1 F by substitution. Not as a sum of column()s: those of forces that balance each other are large and cancel.
  void apply_inverse(const double* F, double* d) const noexcept {
    std::copy_n(F, unknowns(), d);
    solve(d);
  }
  /// F' A^-1 F.
  double merit(const double* F) const noexcept;
  void add_stiffness(BandedBlocks& H, uint32_t first_block, bool symmetric) noexcept;
  /// The four columns of A^-1 for forces on the unknowns of one vertex: four numbers per unknown, valid for the vertices from `least`
  /// to `most`, of which it is one. Solved for once per step.
  const double* column(uint32_t vertex, uint32_t least, uint32_t most) noexcept;

  /// Displacement of a point of the surface at q, and in the state without contacts [m]: `turn` = tangent x arm [m].
  toolkit::Vec3 moved(const contact::ChainPlace& at, const toolkit::Vec3& turn) const noexcept {
    return moved(at, turn, q_.data());
  }
  toolkit::Vec3 moved_free(const contact::ChainPlace& at, const toolkit::Vec3& turn) const noexcept {
    return moved(at, turn, free_.data());
  }

 private:
  using Matrix = toolkit::Band<10>;
  static toolkit::Vec3 moved(const contact::ChainPlace& at, const toolkit::Vec3& turn, const double* q) noexcept;
  /// All unknowns at once, two in a register.
  Eigen::Map<Eigen::VectorXd> line(double* x) const noexcept { return {x, static_cast<Eigen::Index>(unknowns())}; }
  Eigen::Map<const Eigen::VectorXd> line(const double* x) const noexcept { return {x, static_cast<Eigen::Index>(unknowns())}; }
  enum class Attempt : uint8_t { kFactored, kTooSoft, kUnsound };
  /// Asks for A at one level and factors it; kUnsound: what the object gave is no number.
  Attempt attempt(FlexibleBody& object, uint64_t stiffer) noexcept;
  void hold() noexcept;
  void take_factors() noexcept;
  void solve(double* x) const noexcept;
  int first_of(const double* x) const noexcept;
  void find_blocks() noexcept;

  const uint32_t object_, vertices_;
  Matrix A_, factors_;
  std::vector<BandedBlocks::Block, Eigen::aligned_allocator<BandedBlocks::Block>> block_;  // A by blocks: the diagonal and 2 below it
  bool has_blocks_ = false;            // block_ holds the A of this step
  bool from_last_ = false;             // factors_ have the unknowns in the reverse order
  std::vector<double> column_, side_;  // columns of A^-1, vertex by vertex; those of one vertex, in the order of the factors
  std::vector<uint32_t> column_from_;  // per vertex: first vertex, in that order, from which its columns are known in this step
  std::vector<double> gradient_, free_, q_;
  mutable std::vector<double> line_;
};

}  // namespace swage::dynamics
