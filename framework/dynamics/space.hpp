// SPDX-License-Identifier: Apache-2.0
//
// Unknowns in which an island is solved. Newton's method, its line search and its path (island.hpp) work with a point z, the
// constraints there and a search direction; z belongs to one of three spaces:
//
//     DisplacementSpace     displacements of the blocks: few where many contacts hold one body
//     SparseSpace           the same where bands are among the blocks: sparse, and only of what a constraint touches
//     ContactSpace          forces of the constraints: flexible bodies answer with a mobility for these
//
// All take the same steps but for rounding. [rt]; built on [main].
#pragma once

#include <cstddef>
#include <cstdint>

namespace swage::dynamics {

struct Island;
struct Tangent;

class Space {
 public:
  virtual ~Space() = default;

  /// Sets the island, which must stay as it is until the next begin(). Returns the size of a point z.
  virtual size_t begin(const Island& island) noexcept = 0;
  /// Sets z to the pose of the linearisation. False: z becomes consistent only after a whole step from here.
  virtual bool start(double* z) noexcept = 0;

  /// Fills u of every constraint.
  virtual void displace(const double* z) noexcept = 0;
  /// From f of every constraint: the residual F, and its energy F' A^-1 F [J].
  virtual void residual(const double* z) noexcept = 0;
  virtual double merit() noexcept = 0;
  /// Newton's step from z, by u, f and D of every constraint; after residual(). `same`: every D is that of the last call.
  virtual bool search_direction(const double* z, bool same, double* step) noexcept = 0;
  /// The same with D in place of the tangent of one constraint, all others those of the last search_direction() or as this set them since. False where
  /// there is no such direction, or none that costs less than a new one.
  virtual bool corrected_direction(const double* /*z*/, uint32_t /*constraint*/, const Tangent& /*D*/, double* /*step*/) noexcept {
    return false;
  }
  /// Sign of det H of the last direction.
  virtual int sign() const noexcept = 0;

  /// Fills `along` of every constraint: its displacement along a step.
  virtual void set_search_direction(const double* step) noexcept = 0;
  /// Work along a step, at z, of all forces but those of constraints [J].
  virtual double slope(const double* z, const double* step) noexcept = 0;
  /// The farthest that a centre or a constraint moves along a step [m].
  virtual double length(const double* step) noexcept = 0;

  /// The farthest that a centre or a constraint is from the pose of the linearisation, at z [m].
  virtual double moved(const double* z) noexcept = 0;
  /// Ends the solve at z: displacements of the blocks, and of every constraint the force y.
  virtual void finish(const double* z, double* d) noexcept = 0;

  /// Multiply-adds of matrix operations since it was last set to 0, which the budget counts.
  uint64_t work = 0;
};

}  // namespace swage::dynamics
