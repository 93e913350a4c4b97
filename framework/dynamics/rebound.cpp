// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rebound.hpp"

#include <algorithm>
#include <cmath>

#include "contact/candidate.hpp"
#include "dynamics/rotation.hpp"

namespace swage::dynamics {

using scene::kNone;
using toolkit::Frame;
using toolkit::raw;
using toolkit::vec;

namespace {

constexpr uint32_t kPushes = 16;  // of one thing in one step; normal: one per point of a line that touches
constexpr uint32_t kSecants = 40;
constexpr double kNever = HUGE_VAL;

}  // namespace

Rebound::Rebound(const scene::World& world, uint32_t max_contacts)
    : flown_body_(world.body.size(), UINT64_MAX), flown_particle_(world.particle_mass.size(), UINT64_MAX) {
  impulse_.reserve(size_t{max_contacts} * 2);
}

void Rebound::fly(scene::World& world, Motion& motion, contact::ContactSet& contacts, FreeMotion method,
                  double tolerance) noexcept {
  impulse_.clear();
  world_ = &world, method_ = method, tolerance_ = tolerance;
  for (const contact::Contact& c : contacts.contact) {
    if (!(c.law.restitution > 0) || !(c.gap < 0)) continue;
    Flight flight;
    if (immovable(c.body_b, c.particle_b) && take_off(motion, c.body_a, c.particle_a, flight))
      fly_one(motion, contacts, flight);
    else if (immovable(c.body_a, c.particle_a) && take_off(motion, c.body_b, c.particle_b, flight))
      fly_one(motion, contacts, flight);
  }
}

void Rebound::report(contact::ContactSet& contacts, double h) const noexcept {
  for (const Impulse& j : impulse_) contacts.contact[j.contact].f_a_W += j.on_a_W / h;
}

bool Rebound::immovable(uint32_t body, uint32_t particle) const noexcept {
  if (particle != kNone) return false;
  const int32_t motion = world_->body[body].motion;
  return motion == SWAGE_MOTION_FIXED || motion == SWAGE_MOTION_FOLLOWS;
}

/// The start of the step of something that can rebound; once a step.
bool Rebound::take_off(const Motion& motion, uint32_t body, uint32_t particle,
                       Flight& flight) const noexcept {
  const double h = world_->dt;
  flight.body = body, flight.particle = particle;
  if (particle != kNone) {
    const double* f = &world_->particle_f_W[3 * particle];
    flight.mass.mass = world_->particle_mass[particle];
    flight.mass.inv_I.setZero();
    flight.f_W = Vec3(f[0], f[1], f[2]) + flight.mass.mass * vec(world_->gravity);
    flight.s = {motion.p0[particle], Quat::Identity(),
                motion.v_free_p[particle] - h / flight.mass.mass * flight.f_W, Vec3::Zero()};
    return !motion.held_particle[particle] && flown_particle_[particle] != world_->step;
  }
  if (world_->body[body].motion != SWAGE_MOTION_DYNAMIC) return false;
  flight.mass = motion.mass[body];
  flight.f_W = vec(world_->F_B_W[body].f) + flight.mass.mass * vec(world_->gravity);
  flight.t_W = vec(world_->F_B_W[body].t);
  flight.s = {motion.X0[body].p, motion.X0[body].q, motion.v_free[body] - h / flight.mass.mass * flight.f_W,
              motion.w0[body]};
  return !motion.held_body[body] && flown_body_[body] != world_->step;
}

/// From touch to touch, the earliest first, to the end of the step.
void Rebound::fly_one(Motion& motion, contact::ContactSet& contacts, Flight& flight) noexcept {
  (flight.particle != kNone ? flown_particle_[flight.particle] : flown_body_[flight.body]) = world_->step;
  uint32_t pushes = 0;
  for (; pushes < kPushes; ++pushes) {
    double first = kNever;
    uint32_t hit = kNone;
    for (uint32_t i = 0; i < contacts.contact.size(); ++i) {
      const double t = time_of_touch(contacts, i, flight);
      if (t < first) first = t, hit = i;
    }
    if (hit == kNone) break;
    flight.s = after(flight, first);
    flight.at = first;
    if (!push(contacts, hit, flight)) break;
  }
  if (pushes > 0) land(motion, contacts, flight);
}

RigidState Rebound::after(const Flight& flight, double t) const noexcept {
  RigidState s = flight.s;
  const double dt = t - flight.at;
  if (flight.particle == kNone) {
    move_free(method_, flight.mass, flight.f_W, flight.t_W, dt, s);
  } else {
    s.p_W += dt * s.v_W + 0.5 * dt * dt / flight.mass.mass * flight.f_W;
    s.v_W += dt / flight.mass.mass * flight.f_W;
  }
  return s;
}

/// Where an immovable body is at the time t of the step that ends at its pose in the world.
Frame Rebound::frame(uint32_t body, double t) const noexcept {
  const double back = world_->dt - t;
  const Pose X(world_->X_WB[body]);
  return Frame(Pose(X.p - back * vec(world_->V_WB[body].v), turn(-back * vec(world_->V_WB[body].w)) * X.q));
}

contact::Touch Rebound::touch(const contact::ContactSet& contacts, uint32_t i, const Flight& flight,
                              const RigidState& s, double t) const noexcept {
  const contact::Contact& c = contacts.contact[i];
  const Frame own(Pose(s.p_W, s.q_WB));
  return flight.is_a(c) ? reevaluate(contacts.candidate[i], own, frame(c.body_b, t))
                        : reevaluate(contacts.candidate[i], frame(c.body_a, t), own);
}

/// Velocity of the flying point against the other, at the touch [m/s].
Vec3 Rebound::approach(const contact::Contact& c, const contact::Touch& touch, const Flight& flight,
                       const RigidState& s) const noexcept {
  const uint32_t other = flight.is_a(c) ? c.body_b : c.body_a;
  const swage_twist& V = world_->V_WB[other];
  return s.v_W + s.w_W.cross(touch.p_W - s.p_W) - vec(V.v) -
         vec(V.w).cross(touch.p_W - vec(world_->X_WB[other].p));
}

/// When its surface comes to the other's, from flight.at on; never within the step: infinite.
double Rebound::time_of_touch(const contact::ContactSet& contacts, uint32_t i,
                              const Flight& flight) const noexcept {
  const contact::Contact& c = contacts.contact[i];
  const bool a = flight.is_a(c);
  if (!(c.law.restitution > 0) || !(a || flight.is_b(c))) return kNever;
  if (!immovable(a ? c.body_b : c.body_a, a ? c.particle_b : c.particle_a)) return kNever;

  const contact::Touch now = touch(contacts, i, flight, flight.s, flight.at);
  if (now.gap <= tolerance_)
    return (a ? 1 : -1) * now.n_W.dot(approach(c, now, flight, flight.s)) < 0 ? flight.at : kNever;
  double low = flight.at, high = world_->dt, at_low = now.gap;
  double at_high = touch(contacts, i, flight, after(flight, high), high).gap;
  if (!(at_high < 0)) return kNever;

  // Illinois: regula falsi that halves what stands still
  for (uint32_t k = 0; k < kSecants; ++k) {
    const double t = low + (high - low) * at_low / (at_low - at_high);
    const double gap = touch(contacts, i, flight, after(flight, t), t).gap;
    if (std::abs(gap) <= tolerance_) return t;
    if (gap < 0) {
      high = t, at_high = gap;
      at_low *= 0.5;
    } else {
      low = t, at_low = gap;
      at_high *= 0.5;
    }
  }
  return low;
}

/// Newton's impulse where it touches; false, and none, where it comes to rest.
bool Rebound::push(contact::ContactSet& contacts, uint32_t i, Flight& flight) noexcept {
  const contact::Contact& c = contacts.contact[i];
  const double side = flight.is_a(c) ? 1 : -1;
  const contact::Touch at = touch(contacts, i, flight, flight.s, flight.at);
  const Vec3 n = side * at.n_W, r = at.p_W - flight.s.p_W, v = approach(c, at, flight, flight.s);
  const double coming = -n.dot(v), leaving = c.law.restitution * coming;
  if (2 * leaving < -world_->dt / flight.mass.mass * n.dot(flight.f_W)) return false;

  // what a unit impulse along e does to the touching point
  const auto turned = [&](const Vec3& j) -> Vec3 {
    const Quat& q = flight.s.q_WB;
    return q * flight.mass.inv_I.cwiseProduct(q.conjugate() * r.cross(j));
  };
  const auto given = [&](const Vec3& j) -> Vec3 { return j / flight.mass.mass + turned(j).cross(r); };
  Vec3 j = (coming + leaving) / n.dot(given(n)) * n;

  // friction, where it takes energy: against what would slide after j, up to mu j
  const Vec3 slides = v + given(j), across = slides - n.dot(slides) * n;
  const double speed = across.norm();
  if (speed > 0) {
    const Vec3 e = across / speed;
    const double stop = speed / e.dot(given(e)), most = c.law.friction * n.dot(j);
    const Vec3 with = j - std::min(stop, most) * e;
    // work of the impulse on the point: j . (v- + v+) / 2
    if (with.dot(2 * v + given(with)) <= j.dot(2 * v + given(j))) j = with;
  }
  flight.s.v_W += j / flight.mass.mass;
  flight.s.w_W += turned(j);
  if (impulse_.size() < impulse_.capacity()) impulse_.push_back({i, side * j});
  return true;
}

void Rebound::land(Motion& motion, contact::ContactSet& contacts, const Flight& flight) noexcept {
  const RigidState s = after(flight, world_->dt);
  if (flight.particle != kNone) {
    const uint32_t p = flight.particle;
    motion.p_free[p] = s.p_W, motion.v_free_p[p] = s.v_W;
    for (uint32_t k = 0; k < 3; ++k) {
      world_->particle_p_W[3 * p + k] = s.p_W[k];
      world_->particle_v_W[3 * p + k] = s.v_W[k];
    }
  } else {
    motion.X_free[flight.body] = {s.p_W, s.q_WB};
    motion.v_free[flight.body] = s.v_W, motion.w_free[flight.body] = s.w_W;
    world_->X_WB[flight.body] = motion.X_free[flight.body].abi();
    world_->V_WB[flight.body] = {raw(s.v_W), raw(s.w_W)};
  }
  for (uint32_t i = 0; i < contacts.contact.size(); ++i) {
    contact::Contact& c = contacts.contact[i];
    const bool a = flight.is_a(c);
    if (!(a || flight.is_b(c)) || !immovable(a ? c.body_b : c.body_a, a ? c.particle_b : c.particle_a))
      continue;
    const contact::Touch t = touch(contacts, i, flight, s, world_->dt);
    c.gap = t.gap, c.p_W = t.p_W, c.n_W = t.n_W;
  }
}

}  // namespace swage::dynamics
