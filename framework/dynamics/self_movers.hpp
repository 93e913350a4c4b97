// SPDX-License-Identifier: Apache-2.0
//
// Objects with their own mechanics inside the contact solve. Their answer u = u_free + h^2 W f becomes r unknowns y of unit
// mass: with W = L L' (pivoted Cholesky, r its rank) u = u_free + h L y and y = L' (h f), which is the minimum of y'y/2 minus
// the work of f. No inverse of W is needed, so it may be singular.
//
// Threads: built on [main]; the rest [rt].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/self_solver.hpp"
#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Vec3;

class SelfMovers {
 public:
  /// Contact points of one object and step that are solved together; more are refused and counted.
  static constexpr uint32_t kMaxPoints = 96;

  explicit SelfMovers(const scene::World& world);

  /// Forgets the last step. `self`: who answers, one per object.
  void begin(std::span<SelfSolver* const> self) noexcept;
  /// Place of the object among the movers of this step, or kNone when nobody answers for it.
  uint32_t slot(uint32_t object) const noexcept;
  /// Adds a touch; returns its point, or kNone beyond the capacity. `into`: unit normal into the object.
  uint32_t add_point(uint32_t slot, uint32_t body, uint32_t shape, const Vec3& p_W,
                     const Vec3& into) noexcept;
  /// Asks every object with points for its compliance and factors it. h: s.
  void ask(double h) noexcept;
  /// Where its solver expects a point at the end of the step: displacement over the step [m].
  void expect(uint32_t slot, uint32_t point, const Vec3& displacement) noexcept;
  /// Sets the unknowns so that the points are where they are expected, as far as forces can bring them there.
  void start() noexcept;

  /// Objects of the scene with SELF bodies; those that answer in this step come first.
  uint32_t capacity() const noexcept { return static_cast<uint32_t>(object_.size()); }
  uint32_t count() const noexcept { return static_cast<uint32_t>(self_.size()); }
  uint32_t points(uint32_t slot) const noexcept { return object_[slot].points; }
  bool shows_itself(uint32_t slot) const noexcept { return self_[slot]->shows_itself(); }
  /// Unknowns of a slot; 0: it has no points or has failed, and stands still.
  uint32_t rank(uint32_t slot) const noexcept { return object_[slot].rank; }
  double* y(uint32_t slot) noexcept { return object_[slot].y.data(); }
  /// Displacement over the step [m] of a point with the unknowns as they are, and its free part alone.
  Vec3 displacement(uint32_t slot, uint32_t point) const noexcept {
    return u_free(slot, point) + extra(slot, point);
  }
  Vec3 extra(uint32_t slot, uint32_t point) const noexcept;
  /// Some point's surface is not where its shape is.
  bool displaced(uint32_t slot) const noexcept { return object_[slot].displaced; }
  /// How far a point is from where its shape is [m].
  Vec3 off_shape(uint32_t slot, uint32_t point) const noexcept {
    const double* u = object_[slot].u.data() + 3 * point;
    return extra(slot, point) + Vec3(u[0], u[1], u[2]);
  }
  Vec3 u_free(uint32_t slot, uint32_t point) const noexcept;
  /// Row i (0..2) of h L at a point: d(displacement) / dy, `rank` numbers.
  const double* columns(uint32_t slot, uint32_t point, int i) const noexcept;

  void add_impulse(uint32_t slot, uint32_t point, const Vec3& impulse) noexcept;
  /// Hands the impulses over.
  void yield() noexcept;

 private:
  struct Object {
    uint32_t points = 0, rank = 0;
    std::vector<swage_contact_point> point;
    std::vector<double> v_free, u, W, L, y, impulse;  // L: 3 points x rank, stride 3 points, times h
    std::vector<double> expected;                     // m, beyond the free displacement
    std::vector<uint32_t> order;                      // row in which each column of L begins
    double h = 0;
    bool displaced = false;
  };
  static void balance(Object& object) noexcept;

  std::span<SelfSolver* const> self_;
  std::vector<Object> object_;
};

}  // namespace swage::dynamics
