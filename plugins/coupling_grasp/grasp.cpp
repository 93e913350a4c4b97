// SPDX-License-Identifier: Apache-2.0
#include "grasp.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_grasp {

using toolkit::raw;
using toolkit::vec;

namespace {

// s: a new contact counts as a new touch only after this pause, as closing jaws bounce on a needle of 0.4 mg.
constexpr double kTouchPause = 0.15;
// Hysteresis: a force has fallen below a limit when it is below this share of it; else a force near the limit would give repeated events.
constexpr double kLeaves = 0.9;
// Thesis only: particles between the outermost contacts. A jaw of 1.5 mm then has one every 50 um, half overlapping.
constexpr int kParticles = 33;
// A held object is lost when a jaw falls below this share of touch_force.
constexpr double kLost = 0.5;

double lean(const Vec3& a, const Vec3& b) { return std::asin(std::clamp(a.dot(b), -1.0, 1.0)); }

}  // namespace

double Pinch::imbalance() const {
  const double harder = std::max(left, right);
  return harder > 0 ? std::abs(left - right) / harder : 0;
}

// Of unequal jaws the weaker one's force counts: the rest is no couple, and a hand gives way to it by moving aside.
double Pinch::couple() const {
  const double weaker = std::min(left, right);
  return weaker > 0 ? weaker * (roll_left / left + roll_right / right) : 0;
}

void Grasp::build(const GraspParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<GraspState>();
  held_ = builder.signal("grasp.held", "1", "1 while both jaws press evenly on the thing, else 0.");
  force_ =
      builder.signal("grasp.force", "N", "Grip: mean of the two jaws' forces along the closing direction.");
  left_ = builder.signal("grasp.left", "N", "Force of the left jaw.");
  right_ = builder.signal("grasp.right", "N", "Force of the right jaw.");
  s_ = builder.signal("grasp.s", "1",
                      "Where it is touched, 0 at the point and 1 at the swage; stays when let go.");
  tip_reach_ =
      builder.signal("grasp.tip_reach", "m", "How far the tips reach past the place where it is touched.");
  tilt_axis_ =
      builder.signal("grasp.tilt_axis", "rad", "How far the needle leans from perpendicular to the jaw axis.");
  tilt_plane_ =
      builder.signal("grasp.tilt_plane", "rad", "How far its plane leans from perpendicular to the jaw faces.");
  balance_ = builder.signal("grasp.balance", "1",
                            "Difference of the jaws over the harder one: 0 even, 1 one-sided.");
  slip_ = builder.signal("grasp.slip", "m/s", "Speed at which the thing slides in the jaws.");
  roll_moment_ = builder.signal("grasp.roll_moment", "N*m",
                                "Couple about the jaw axis of both jaws that press obliquely on a wire; right-handed: it would turn them along it.");
  touched_ = builder.event("grasp.touched",
                           "A jaw has touched it, after at least 0.15 s without; value: the force.");
  taken_ =
      builder.event("grasp.taken", "Both jaws hold it; value: where, 0 at the point and 1 at the swage.");
  released_ = builder.event("grasp.released", "It is no longer held; value: for how long it was.");
  too_hard_ = builder.event("grasp.too_hard", "The grip force has risen above the limit; value: the force.");
  collapsed_ = builder.event("grasp.collapsed",
                             "The wire gave way, its whole section flows; value: where, 0 at the point and 1 at the swage.");
  broke_ = builder.event("grasp.broke", "The wire broke; value: where, 0 at the point and 1 at the swage.");
}

void Grasp::bind(const Peer& a, const Peer& b) {
  gripper_ = a;
  thing_ = b;
  wire_ = WirePeer(b);
}

bool Grasp::gather(const CouplingStep& step, const swage_gripper_state& jaws, Pinch& pinch) const {
  const Vec3 closing = vec(jaws.closing_W), across = closing.cross(vec(jaws.axis_W)), tip_W = vec(jaws.tip_W);
  for (const swage_contact& contact : step.contacts()) {
    // the force of the object on a jaw pushes the left jaw to the left, the right one to the right
    const Vec3 f = vec(contact.f_a_W);
    const double normal = f.dot(vec(contact.n_W));
    const double along = f.dot(closing), roll = (vec(contact.p_W) - tip_W).dot(across) * along;
    if (contact.body_a == jaws.left_body)
      pinch.left += along, pinch.roll_left += roll;
    else if (contact.body_a == jaws.right_body)
      pinch.right -= along, pinch.roll_right += roll;
    else
      continue;
    if (!(normal > 0)) continue;

    const auto place = thing_.locate(step.b(), contact.p_W);
    if (!place) return false;
    pinch.weight += normal;
    pinch.s += normal * place->s;
    pinch.slip += normal * contact.slip;
    pinch.p_W += normal * vec(place->p_W);
    pinch.tangent_W += normal * vec(place->tangent_W);
    pinch.normal_W += normal * vec(place->normal_W);
  }
  pinch.left = std::max(0.0, pinch.left);
  pinch.right = std::max(0.0, pinch.right);
  pinch.uneven = pinch.imbalance();
  if (!(pinch.weight > 0)) return true;
  pinch.s /= pinch.weight;
  pinch.slip /= pinch.weight;
  pinch.p_W /= pinch.weight;
  pinch.tangent_W.normalize();
  pinch.normal_W.normalize();
  return true;
}

bool Grasp::choose_particle(const CouplingStep& step, const swage_gripper_state& jaws, Pinch& pinch) const {
  Face left, right;
  double radius = 0, first_s = 2, last_s = -1;
  Vec3 first_W = Vec3::Zero(), last_W = Vec3::Zero();
  for (const swage_contact& contact : step.contacts()) {
    const bool on_left = contact.body_a == jaws.left_body;
    if (!on_left && contact.body_a != jaws.right_body) continue;
    const auto place = thing_.locate(step.b(), contact.p_W);
    if (!place) return false;
    const Vec3 p = vec(contact.p_W), n = vec(contact.n_W);
    (on_left ? left : right).add(p + 0.5 * contact.gap * n, n, -contact.gap);
    radius = (p - 0.5 * contact.gap * n - vec(place->p_W)).norm();
    if (place->s < first_s) first_s = place->s, first_W = p;
    if (place->s > last_s) last_s = place->s, last_W = p;
  }
  left.finish();
  right.finish();
  pinch.uneven = 1;
  if (!(left.weight > 0 && right.weight > 0)) return true;

  Choice chosen;
  for (int i = 0; i < kParticles; ++i) {
    const Vec3 near_W = first_W + i / (kParticles - 1.0) * (last_W - first_W);
    const auto place = thing_.locate(step.b(), raw(near_W));
    if (!place) return false;
    const auto entered = particle(left, right, vec(place->p_W), radius, params_.skin);
    if (!entered) continue;
    chosen.offer(*entered, i, params_.balance);
    if (chosen.index != i) continue;
    pinch.s = place->s;
    pinch.p_W = vec(place->p_W);
    pinch.tangent_W = vec(place->tangent_W);
    pinch.normal_W = vec(place->normal_W);
  }
  if (chosen.index >= 0) pinch.uneven = chosen.best.imbalance();
  return true;
}

void Grasp::follow_touch(const CouplingStep& step, GraspState& state, const Pinch& pinch) const {
  const bool touching = std::max(pinch.left, pinch.right) >= params_.touch_force;
  if (!touching) {
    state.untouched_s += step.dt();
    if (state.untouched_s >= kTouchPause) state.touching = 0;
    return;
  }
  if (state.touching == 0) step.event(touched_, pinch.force());
  state.touching = 1;
  state.untouched_s = 0;
}

void Grasp::follow_hold(const CouplingStep& step, GraspState& state, const Pinch& pinch) const {
  const bool was = state.held != 0;
  const double least = std::min(pinch.left, pinch.right);

  // a hold ends when its force falls or becomes clearly one-sided; it begins only when it is even
  const double floor = was ? kLost * params_.touch_force : params_.touch_force;
  const double widest = was ? std::min(1.0, 2 * params_.balance) : params_.balance;
  const bool holds = least >= floor && pinch.uneven <= widest;
  state.pending_s = holds == was ? 0 : state.pending_s + step.dt();
  if (holds == was || state.pending_s < params_.settle_time) return;

  state.held = holds ? 1 : 0;
  state.pending_s = 0;
  if (holds) {
    state.held_since_s = step.time();
    step.event(taken_, state.s);
  } else {
    step.event(released_, step.time() - state.held_since_s);
  }
}

void Grasp::follow_force(const CouplingStep& step, GraspState& state, const Pinch& pinch) const {
  const double force = pinch.force();
  if (state.hard == 0 && force > params_.hard_force) {
    state.hard = 1;
    step.event(too_hard_, force);
  } else if (state.hard != 0 && force < kLeaves * params_.hard_force) {
    state.hard = 0;
  }
}

/// Reports that the wire collapsed or broke, at any place along it.
void Grasp::follow_wire(const CouplingStep& step) const {
  const auto end = wire_.end(step.b());
  if (!end) return;
  if (end->collapsed >= 0) step.event(collapsed_, end->collapsed);
  if (end->broke >= 0) step.event(broke_, end->broke);
}

void Grasp::finish(const CouplingStep& step) {
  const auto jaws = gripper_.describe(step.a());
  Pinch pinch;
  if (!jaws || !gather(step, *jaws, pinch)) return discard();
  if (params_.level == Level::kThesis && !choose_particle(step, *jaws, pinch)) return discard();

  // place and posture of the last touch are kept: between two touches there is no better estimate
  auto& state = step.state<GraspState>();
  if (pinch.weight > 0) {
    const Vec3 axis = vec(jaws->axis_W);
    state.s = pinch.s;
    state.tip_reach = (vec(jaws->tip_W) - pinch.p_W).dot(axis);
    state.tilt_axis = lean(pinch.tangent_W, axis);
    state.tilt_plane = lean(pinch.normal_W, vec(jaws->closing_W));
  }
  follow_touch(step, state, pinch);
  follow_hold(step, state, pinch);
  follow_force(step, state, pinch);
  follow_wire(step);

  step.signal(held_, state.held);
  step.signal(force_, pinch.force());
  step.signal(left_, pinch.left);
  step.signal(right_, pinch.right);
  step.signal(s_, state.s);
  step.signal(tip_reach_, state.tip_reach);
  step.signal(tilt_axis_, state.tilt_axis);
  step.signal(tilt_plane_, state.tilt_plane);
  step.signal(balance_, pinch.uneven);
  step.signal(slip_, pinch.slip);
  step.signal(roll_moment_, pinch.couple());
}

void Grasp::reset(const CouplingStep& step) { step.state<GraspState>() = {}; }

}  // namespace swage::coupling_grasp

SWAGE_EXPORT(swage::coupling_grasp::Grasp)
