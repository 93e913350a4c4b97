// SPDX-License-Identifier: Apache-2.0
#include "dynamics/impulse.hpp"

#include <algorithm>

namespace swage::dynamics {

using scene::kNone;
using toolkit::raw;
using toolkit::vec;

namespace {

/// One side of a contact: velocity of its point, and its mobility along n.
struct Party {
  scene::World& world;
  const Motion& motion;
  uint32_t body, particle;
  Vec3 p_W;

  Vec3 velocity() const {
    if (particle != kNone) {
      const double* v = &world.particle_v_W[3 * particle];
      return {v[0], v[1], v[2]};
    }
    const swage_twist& V = world.V_WB[body];
    return vec(V.v) + vec(V.w).cross(p_W - vec(world.X_WB[body].p));
  }

  Vec3 arm() const { return p_W - vec(world.X_WB[body].p); }
  Vec3 turned_by(const Vec3& moment) const {  // I^-1 moment, in W
    const Quat q = toolkit::quat(world.X_WB[body].q);
    return q * motion.mass[body].inv_I.cwiseProduct(q.conjugate() * moment);
  }
  Vec3 hinge_arm(Vec3& axis) const {
    const scene::HingeInfo& info = world.hinge[world.body[body].hinge];
    const Pose X_WP(world.X_WB[info.parent]);
    axis = X_WP.q * vec(info.axis);
    return axis.cross(p_W - X_WP * vec(info.anchor));
  }

  /// Denominator of 4.43: 1/m + ((I^-1 (r x n)) x r) . n; zero for a side that cannot be moved.
  double mobility(const Vec3& n) const {
    if (particle != kNone) return 1 / world.particle_mass[particle];
    Vec3 axis;
    switch (world.body[body].motion) {
      case SWAGE_MOTION_DYNAMIC:
        return 1 / motion.mass[body].mass + turned_by(arm().cross(n)).cross(arm()).dot(n);
      case SWAGE_MOTION_HINGED: {
        const double Jt = hinge_arm(axis).dot(n);
        return Jt * Jt / world.hinge[world.body[body].hinge].inertia;
      }
      default:
        return 0;
    }
  }

  /// Applies an impulse: 4.41 and 4.42.
  void take(const Vec3& impulse) const {
    if (particle != kNone) {
      const Vec3 dv = impulse / world.particle_mass[particle];
      for (int i = 0; i < 3; ++i) world.particle_v_W[3 * particle + static_cast<uint32_t>(i)] += dv[i];
    } else if (world.body[body].motion == SWAGE_MOTION_DYNAMIC) {
      swage_twist& V = world.V_WB[body];
      V.v = raw(Vec3(vec(V.v) + impulse / motion.mass[body].mass));
      V.w = raw(Vec3(vec(V.w) + turned_by(arm().cross(impulse))));
    } else if (world.body[body].motion == SWAGE_MOTION_HINGED) {
      Vec3 axis;
      const uint32_t hinge = world.body[body].hinge;
      const double change = hinge_arm(axis).dot(impulse) / world.hinge[hinge].inertia;
      world.hinge_rate[hinge] += change;
      swage_twist& V = world.V_WB[body];
      const Pose X_WP(world.X_WB[world.hinge[hinge].parent]);
      const Vec3 anchor = X_WP * vec(world.hinge[hinge].anchor);
      V.w = raw(Vec3(vec(V.w) + change * axis));
      V.v = raw(Vec3(vec(V.v) + change * axis.cross(vec(world.X_WB[body].p) - anchor)));
    }
  }
};

}  // namespace

void respond_by_impulses(scene::World& world, Motion& motion, contact::ContactSet& contacts) noexcept {
  for (contact::Contact& c : contacts.contact) {
    c.bristle_W.setZero();
    c.f_a_W.setZero();
    c.slip = 0;
    if (!(c.gap < 0)) continue;
    const Party a{world, motion, c.body_a, c.particle_a, c.p_W},
        b{world, motion, c.body_b, c.particle_b, c.p_W};
    const Vec3 v = a.velocity() - b.velocity();
    const double approach = v.dot(c.n_W), give = a.mobility(c.n_W) + b.mobility(c.n_W);
    c.slip = (v - approach * c.n_W).norm();
    if (!(approach < 0) || !(give > 0)) continue;

    // 4.43
    const double j = -(1 + c.law.restitution) * approach / give;
    a.take(j * c.n_W);
    b.take(-j * c.n_W);
    c.f_a_W = j / world.dt * c.n_W;
  }
}

}  // namespace swage::dynamics
