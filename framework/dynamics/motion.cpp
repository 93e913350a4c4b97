// SPDX-License-Identifier: Apache-2.0
#include "dynamics/motion.hpp"

#include <stdexcept>

#include "dynamics/damping.hpp"
#include "dynamics/rotation.hpp"
#include "scene/kinematics.hpp"

namespace swage::dynamics {

using toolkit::raw;
using toolkit::vec;

Motion::Motion(const scene::World& world) {
  const size_t bodies = world.body.size(), hinges = world.hinge.size(),
               particles = world.particle_mass.size();
  mass.resize(bodies);
  for (size_t i = 0; i < bodies; ++i) {
    const scene::BodyInfo& info = world.body[i];
    if (info.motion != SWAGE_MOTION_DYNAMIC) continue;
    const Vec3 I(info.inertia[0], info.inertia[1], info.inertia[2]);
    if (!(info.mass > 0) || !(I.minCoeff() > 0))
      throw std::invalid_argument("body \"" + info.name +
                                  "\": a dynamic body needs mass and moments of inertia above 0");
    mass[i] = RigidMass(info.mass, I);
  }
  for (const scene::HingeInfo& info : world.hinge) {
    const int32_t motion = world.body[info.parent].motion;
    if (motion != SWAGE_MOTION_FIXED && motion != SWAGE_MOTION_FOLLOWS)
      throw std::invalid_argument("hinge of \"" + world.body[info.child].name +
                                  "\": its parent must be FIXED or FOLLOWS");
    if (!(info.inertia > 0))
      throw std::invalid_argument("hinge of \"" + world.body[info.child].name +
                                  "\": its inertia must be above 0");
  }
  for (const double m : world.particle_mass)
    if (!(m > 0)) throw std::invalid_argument("a particle needs a mass above 0");

  X0.resize(bodies), X_free.resize(bodies);
  v_free.assign(bodies, Vec3::Zero()), w_free.assign(bodies, Vec3::Zero()), v0 = w0 = w_free;
  held_body.assign(bodies, 0), flown.assign(bodies, 0);
  q0.assign(hinges, 0), q_free.assign(hinges, 0), rate0.assign(hinges, 0);
  drive.resize(hinges);
  held_hinge.assign(hinges, 0);
  p0.assign(particles, Vec3::Zero()), p_free.assign(particles, Vec3::Zero()),
      v_free_p.assign(particles, Vec3::Zero());
  held_particle.assign(particles, 0);
  stiffer.assign(world.chain.size(), 0);
}

void Motion::predict(scene::World& world, FreeMotion method) noexcept {
  const bool damped = world.environment.linear_damping > 0 || world.environment.angular_damping > 0;
  for (uint32_t i = 0; i < world.body.size(); ++i) {
    if (world.body[i].motion != SWAGE_MOTION_DYNAMIC) continue;
    if (damped) damp(world, i, held_body[i] != 0);
    predict_body(world, i, method);
  }
  for (uint32_t i = 0; i < world.hinge.size(); ++i) predict_hinge(world, i);
  for (uint32_t i = 0; i < world.particle_mass.size(); ++i) predict_particle(world, i);
}

void Motion::go_free(scene::World& world) noexcept {
  for (uint32_t i = 0; i < held_body.size(); ++i) {
    if (!held_body[i]) continue;
    world.X_WB[i] = X_free[i].abi();
    world.V_WB[i] = {raw(v_free[i]), raw(w_free[i])};
    held_body[i] = 0;
  }
  for (uint32_t i = 0; i < held_hinge.size(); ++i) {
    if (!held_hinge[i]) continue;
    place_hinge(world, *this, i, q_free[i]);
    held_hinge[i] = 0;
  }
  for (uint32_t i = 0; i < held_particle.size(); ++i) {
    if (!held_particle[i]) continue;
    for (uint32_t k = 0; k < 3; ++k) {
      world.particle_p_W[3 * i + k] = p_free[i][k];
      world.particle_v_W[3 * i + k] = v_free_p[i][k];
    }
    held_particle[i] = 0;
  }
}

void Motion::predict_body(scene::World& world, uint32_t body, FreeMotion method) noexcept {
  const Pose start(world.X_WB[body]);
  const Vec3 v_start = vec(world.V_WB[body].v), w_start = vec(world.V_WB[body].w);
  RigidState s{start.p, start.q, v_start, w_start};
  const RigidMass& m = mass[body];
  const Vec3 f = vec(world.F_B_W[body].f) + m.mass * vec(world.gravity);
  move_free(method, m, f, vec(world.F_B_W[body].t), world.dt, s);
  X0[body] = start;
  X_free[body] = {s.p_W, s.q_WB};
  v_free[body] = s.v_W;
  w_free[body] = s.w_W;
  v0[body] = v_start, w0[body] = w_start;

  if (held_body[body]) {
    // contacts held it against its weight and probably will again: detect them where its present twist takes it
    const double h = world.dt;
    Quat q = turn(h * w_start) * start.q;
    renormalise(q);
    world.X_WB[body] = Pose(start.p + h * v_start, q).abi();
  } else {
    world.X_WB[body] = X_free[body].abi();
    world.V_WB[body] = {raw(s.v_W), raw(s.w_W)};
  }
}

void Motion::predict_hinge(scene::World& world, uint32_t hinge) noexcept {
  const scene::HingeInfo& info = world.hinge[hinge];
  X0[info.child] = Pose(world.X_WB[info.child]);
  q0[hinge] = world.hinge_angle[hinge];

  // torque about the axis of the forces on the child
  const Pose X_WP(world.X_WB[info.parent]);
  const Vec3 anchor = X_WP * vec(info.anchor), axis = X_WP.q * vec(info.axis);
  const swage_wrench& F = world.F_B_W[info.child];
  const double torque = axis.dot(vec(F.t) + (X0[info.child].p - anchor).cross(vec(F.f)));

  const double rate = rate0[hinge] = world.hinge_rate[hinge];
  drive[hinge] = HingeDrive(info, world.drive[hinge], q0[hinge], rate, torque, world.dt);
  q_free[hinge] = q0[hinge] + drive[hinge].free();
  place_hinge(world, *this, hinge, held_hinge[hinge] ? q0[hinge] + world.dt * rate : q_free[hinge]);
}

void Motion::predict_particle(scene::World& world, uint32_t i) noexcept {
  double *p = &world.particle_p_W[3 * i], *v = &world.particle_v_W[3 * i];
  const double h = world.dt;
  const Vec3 v_start(v[0], v[1], v[2]);
  const Vec3 f(world.particle_f_W[3 * i], world.particle_f_W[3 * i + 1], world.particle_f_W[3 * i + 2]);
  p0[i] = Vec3(p[0], p[1], p[2]);
  v_free_p[i] = v_start + h * (vec(world.gravity) + f / world.particle_mass[i]);
  p_free[i] = p0[i] + 0.5 * h * (v_start + v_free_p[i]);

  const Vec3 at = held_particle[i] ? Vec3(p0[i] + h * v_start) : p_free[i];
  const Vec3& speed = held_particle[i] ? v_start : v_free_p[i];
  for (int k = 0; k < 3; ++k) p[k] = at[k], v[k] = speed[k];
}

void place_hinge(scene::World& world, const Motion& motion, uint32_t hinge, double angle) noexcept {
  const scene::HingeInfo& info = world.hinge[hinge];
  const Pose X_WP(world.X_WB[info.parent]);
  const Pose X_WC = scene::hinged(info, X_WP, angle);
  world.hinge_angle[hinge] = angle;
  world.hinge_rate[hinge] = (angle - motion.q0[hinge]) / world.dt;
  world.X_WB[info.child] = X_WC.abi();

  // the child moves with its parent and turns about the axis
  const Vec3 w_P = vec(world.V_WB[info.parent].w), axis = X_WP.q * vec(info.axis);
  const Vec3 w = w_P + world.hinge_rate[hinge] * axis;
  const Vec3 anchor = X_WP * vec(info.anchor);
  const Vec3 v = vec(world.V_WB[info.parent].v) + w_P.cross(anchor - X_WP.p) + w.cross(X_WC.p - anchor);
  world.V_WB[info.child] = {raw(v), raw(w)};
}

}  // namespace swage::dynamics
