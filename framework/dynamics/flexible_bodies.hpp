// SPDX-License-Identifier: Apache-2.0
//
// Flexible bodies inside the contact solve: the displacement of their points is u = u_free + h^2 W f, and they receive exactly the
// forces f of that displacement (contact_space.hpp). Banded ones have unknowns instead (banded_body.hpp): their points only report forces.
//
// Threads: built on [main]; the rest [rt].
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/banded_body.hpp"
#include "dynamics/dof_block.hpp"
#include "dynamics/flexible_body.hpp"
#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

class FlexibleBodies {
 public:
  explicit FlexibleBodies(const scene::World& world);

  /// Forgets the last step. `self`: the flexible bodies, one entry per object; `stiffer`: of each chain, kept from step to step.
  void begin(std::span<FlexibleBody* const> self, std::span<uint64_t> stiffer) noexcept;
  /// Index of the object among the flexible bodies of this step, or kNone when it is none of them.
  uint32_t slot(uint32_t object) const noexcept;
  /// Adds the point of a contact or tie; returns its index, or kNone beyond the capacity. `into`: unit normal into the object.
  uint32_t add_point(uint32_t slot, uint32_t body, uint32_t shape, const Vec3& p_W, const Vec3& into,
                     const contact::ChainPlace& place = {}) noexcept;
  /// The point nearest to p_W; kNone where there is none.
  uint32_t nearest(uint32_t slot, const Vec3& p_W) const noexcept;
  /// Asks every object with points for its mobility. h: s. Returns the number of points without a usable answer.
  uint32_t ask(double h) noexcept;
  /// Sets the displacement over the step [m] at which the object's solver expects a point.
  void expect(uint32_t slot, uint32_t point, const Vec3& displacement) noexcept;
  /// Puts all points at their expected displacement, without forces.
  void start() noexcept;
  /// Puts the points of one body at their free displacement. True where that moves them; never where displaced().
  bool release(uint32_t slot) noexcept;

  /// Most points of one object.
  uint32_t room(uint32_t slot) const noexcept {
    return object_[slot].band ? static_cast<uint32_t>(object_[slot].point.size()) : room_;
  }
  /// Place of a point when it was added [m], in W.
  Vec3 place(uint32_t slot, uint32_t point) const noexcept { return toolkit::vec(object_[slot].point[point].p_W); }
  /// The band of a banded body, or nullptr.
  BandedBody* band(uint32_t slot) const noexcept { return object_[slot].band; }
  /// Force on a point of a banded body [N], reported to its object.
  void report_force(uint32_t slot, uint32_t point, const Vec3& force) noexcept {
    for (uint32_t i = 0; i < 3; ++i) object_[slot].force[3 * point + i] += force[i];
  }
  /// Vertices of all chains that may be bands.
  uint32_t vertices() const noexcept;
  /// Number of objects of the scene with flexible bodies, and of those that answer in this step, which come first.
  uint32_t capacity() const noexcept { return static_cast<uint32_t>(object_.size()); }
  uint32_t count() const noexcept { return static_cast<uint32_t>(flexible_.size()); }
  uint32_t points(uint32_t slot) const noexcept { return object_[slot].points; }
  bool surface_is_shape(uint32_t slot) const noexcept { return flexible_[slot]->surface_is_shape(); }
  /// False where the body has no points or has failed: it does not move.
  bool gives(uint32_t slot) const noexcept { return object_[slot].sound; }
  PointMobility answer(uint32_t slot) const noexcept;
  /// Displacement of a point over the step [m]: all of it, its free part, and the rest.
  Vec3 displacement(uint32_t slot, uint32_t point) const noexcept {
    return u_free(slot, point) + extra(slot, point);
  }
  Vec3 u_free(uint32_t slot, uint32_t point) const noexcept {
    return object_[slot].h * at(object_[slot].v_free, point);
  }
  Vec3 extra(uint32_t slot, uint32_t point) const noexcept { return at(object_[slot].extra, point); }
  /// True where the surface counts as apart from the shapes, even where both coincide: elastic tissue under a load answers no displacement
  /// of its own, but its free motion over the step springs back from one that no shape shows.
  bool displaced(uint32_t slot) const noexcept { return object_[slot].displaced; }
  /// Distance of a point from its shape [m].
  Vec3 off_shape(uint32_t slot, uint32_t point) const noexcept {
    return extra(slot, point) + at(object_[slot].u, point);
  }

  /// Sets new forces in three calls: resets them; adds the force at each point [N]; takes the share `relaxation` of the change.
  void begin_forces(uint32_t slot) noexcept;
  void add_force(uint32_t slot, uint32_t point, const Vec3& force) noexcept;
  void go(uint32_t slot, double relaxation) noexcept;
  /// Passes the impulses, and the displacements of bands, to the objects.
  void apply_impulses() noexcept;

 private:
  struct Object {
    uint32_t points = 0;
    std::vector<swage_contact_point> point;
    std::vector<swage_chain_place> place;
    std::vector<double> v_free, u, W;
    std::vector<double> expected, extra;  // m, displacement beyond the free one: expected, and present
    std::vector<double> force, to;        // N: forces that give `extra`; new forces of this pass
    std::vector<double> impulse;          // N s
    double h = 0;
    bool displaced = false, sound = false;
    BandedBody* band = nullptr;  // of this step
    uint64_t* stiffer = nullptr;  // of the band
  };
  static bool nearer_first(const Object& o) noexcept;
  static Vec3 at(const std::vector<double>& v, uint32_t point) noexcept {
    return {v[3 * point], v[3 * point + 1], v[3 * point + 2]};
  }

  const uint32_t room_;
  std::span<FlexibleBody* const> flexible_;
  std::vector<Object> object_;
  std::vector<std::unique_ptr<BandedBody>> band_;  // of objects with one chain
};

}  // namespace swage::dynamics
