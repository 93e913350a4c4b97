// SPDX-License-Identifier: Apache-2.0
//
// The needle that bends (plugins/needle) in a scene of our own rooms, without a host around it. SI units.
#pragma once

#include "dynamics/flexible_body.hpp"
#include "plugins/needle/bending.hpp"
#include "swage_world.hpp"

namespace swage::bench {

class BendingBody final : public dynamics::FlexibleBody {
 public:
  /// The first of its bodies in the world; it has the frame N of the rigid needle.
  static constexpr uint32_t kFirst = kBodies;

  /// Puts its bodies, shapes and state into `world`, in place of the rigid needle's. A straight needle is an arc of a radius of
  /// 300 m: over the width of the jaws its sagitta is 0.1 nm. [main]
  BendingBody(scene::World& world, const Setup& setup, int pieces);

  /// Unbent, at this pose and speed.
  void put(const Pose& X_WN, const Vec3& v_W, const Vec3& w_W);
  /// Free motion of the step, before contacts are looked for. [rt]
  void advance();

  uint32_t object() const noexcept override { return kNeedleObject; }
  bool surface_is_shape() const noexcept override { return true; }
  bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept override;
  void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept override;
  /// Stress over yield, bend and the like, after the step.
  needle::Bending::Reading read();
  /// Turn of its first body against the middle of the wire per couple on it, about the axes of N [rad / N m], in closed form: l/EI and
  /// l/GJ of the length l between the middle of that piece and of the piece beyond the wire's middle; none where they are one.
  Vec3 gives() const;

 private:
  swage_object_step view();
  std::span<const swage_contact_point> local(std::span<const swage_contact_point> point) noexcept;

  scene::World& world_;
  const Needle needle_;
  Vec3 moments_;  // kg m2, in N
  needle::Bending bending_;
  std::vector<Pose> X_NP_;  // of the unbent pieces; of the one that body 0 carries: identity
  std::vector<swage_contact_point> point_;
};

}  // namespace swage::bench
