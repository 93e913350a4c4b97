// SPDX-License-Identifier: Apache-2.0
#include "swage.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_swage {

using toolkit::raw;
using toolkit::vec;

namespace {

// In depths of the hole: the thread must start this near to it; from farther the first step would pull it there in a jerk.
constexpr double kMeets = 1;
// In depths of the hole: part of the thread beside the hole that does not touch the needle, as it leaves from within the needle's surface.
constexpr double kBeside = 3;

void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

void Swage::build(const SwageParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<SwageState>();
  tension_ = builder.signal("swage.tension", "N", "Pull of the thread on the needle; 0 when it is off.");
  angle_ = builder.signal("swage.angle", "rad", "Between that pull and the needle's hole: 0 straight out of it; 0 when it is off.");
  moment_ = builder.signal("swage.moment", "N*m", "Moment of the thread on the needle about the mouth of its hole.");
  attached_ = builder.signal("swage.attached", "1", "1: the thread is in the needle.");
  pulled_off_ = builder.event("swage.pulled_off", "The thread came out of the needle; value: the pull, N.");
}

void Swage::bind(const Peer& a, const Peer& b) {
  needle_ = a;
  thread_ = StrandPeer(b);
  if (!thread_.valid()) refuse("the thread has no table of " SWAGE_TRAIT_STRAND);
}

/// Before the first step: a thread that does not start at rest has moved by then.
void Swage::reset(const CouplingStep& step) {
  auto& state = step.state<SwageState>();
  state = {};
  state.off = meet(step, state) ? 0 : 1;
}

/// A part of the thread in the hole, or just outside of it, does not touch the needle.
void Swage::resolve(const CouplingStep& step) {
  const auto law = thread_.law(step.b());
  if (!law) return discard();
  const bool in = step.state<SwageState>().off == 0;
  for (swage_contact& contact : step.contacts()) {
    contact.friction = params_.friction, contact.stiffness = params_.touch, contact.restitution = 0;
    const auto place = in ? thread_.nearest(step.b(), contact.p_W) : std::nullopt;
    if (!place) continue;
    const double from_end = params_.end == End::kLast ? law->length - place->s : place->s;
    if (from_end < kBeside * params_.depth) contact.friction = contact.stiffness = 0;
  }
}

bool Swage::find(const CouplingStep& step, const SwageState& state, Joint& j) const {
  const auto law = thread_.law(step.b());
  const auto end = needle_.place(step.a(), 1);
  if (!law || !end) return false;
  const auto curve = needle_.locate(step.a(), end->p_W);
  const bool last = params_.end == End::kLast;
  const auto mouth = thread_.place(step.b(), last ? law->length - params_.depth : params_.depth);
  const auto bottom = thread_.place(step.b(), last ? law->length : 0);
  if (!curve || !mouth || !bottom) return false;
  j.mouth = vec(end->p_W), j.out = vec(end->tangent_W);
  const Vec3 n = vec(curve->normal_W), flat = (n - n.dot(j.out) * j.out).normalized();
  j.up = state.turn[0] * flat + state.turn[1] * j.out.cross(flat);
  j.thread_mouth = vec(mouth->p_W), j.thread_end = vec(bottom->p_W), j.thread_up = vec(mouth->normal_W);
  j.radius = law->radius;
  j.needle_body = end->body, j.thread_body = mouth->body;
  return true;
}

/// Stores the rotation of the thread in its hole at the start. False where the thread does not begin there.
bool Swage::meet(const CouplingStep& step, SwageState& state) const {
  Joint j;
  state.turn[0] = 1;
  if (!find(step, state, j) || (j.mouth - j.thread_mouth).norm() > kMeets * params_.depth) return false;
  const Vec3 d = (j.thread_up - j.thread_up.dot(j.out) * j.out).normalized();
  const double cosine = j.up.dot(d), sine = j.out.cross(j.up).dot(d);
  state.turn[0] = cosine, state.turn[1] = sine;
  return true;
}

/// Two ties at the ends of the hole hold position and direction, and the first alone bears the pull; a third, on the thread's surface,
/// holds its rotation.
uint32_t Swage::ties(const CouplingStep& step, std::span<swage_tie> out) {
  auto& state = step.state<SwageState>();
  if (state.off != 0 || out.size() < 3) return 0;
  Joint j;
  if (!find(step, state, j)) return 0;
  const auto tie = [&](const Vec3& p_needle, const Vec3& offset, const Vec3& axis, double across, double along) {
    swage_tie t{};
    t.body_a = j.needle_body, t.body_b = j.thread_body;
    t.p_W = raw(p_needle), t.axis_W = raw(axis), t.offset_W = raw(offset);
    t.stiffness_across = across, t.stiffness_along = along;
    t.strength = t.forward_limit = t.backward_limit = HUGE_VAL;
    return t;
  };
  const double k = params_.stiffness;
  const Vec3 bottom = j.mouth - params_.depth * j.out, side = j.out.cross(j.up);
  const Vec3 surface = j.mouth + j.radius * j.up, thread_surface = j.thread_mouth + j.radius * j.thread_up;
  out[0] = tie(j.mouth, j.mouth - j.thread_mouth, j.out, k, k);
  out[1] = tie(bottom, bottom - j.thread_end, j.out, k, 0);
  // an offset of the mouth is no rotation
  const double off = side.dot(surface - thread_surface - (j.mouth - j.thread_mouth));
  out[2] = tie(surface, off * side, side, 0, k);
  return 3;
}

void Swage::on_solved(const CouplingStep& step, std::span<const swage_tie> ties) {
  auto& state = step.state<SwageState>();
  if (ties.size() != 3) return;
  Vec3 f = Vec3::Zero(), m = Vec3::Zero();
  for (const swage_tie& tie : ties) {
    const Vec3 on_needle = vec(tie.f_a_W);
    f += on_needle;
    m += (vec(tie.p_W) - vec(ties[0].p_W)).cross(on_needle);
  }
  put(state.f, f), put(state.m, m);
}

void Swage::finish(const CouplingStep& step) {
  auto& state = step.state<SwageState>();
  const auto law = thread_.law(step.b());
  const auto end = needle_.place(step.a(), 1);
  if (!law || !end) return discard();
  if (state.off == 0) {
    const double pull = vec3(state.f).norm(), strength = params_.strength > 0 ? params_.strength : law->pull_off;
    step.signal(tension_, pull);
    step.signal(angle_, pull > 0 ? angle_between(vec3(state.f), vec(end->tangent_W)) : 0);
    step.signal(moment_, vec3(state.m).norm());
    // two steps in succession: a jerk on the thread stretches it too much for one step
    if (pull > strength && state.over != 0) {
      state.off = 1;
      step.event(pulled_off_, pull);
    }
    state.over = pull > strength ? 1 : 0;
  } else {
    step.signal(tension_, 0), step.signal(angle_, 0), step.signal(moment_, 0);
  }
  step.signal(attached_, state.off == 0 ? 1 : 0);
}

}  // namespace swage::coupling_swage

SWAGE_EXPORT(swage::coupling_swage::Swage)
