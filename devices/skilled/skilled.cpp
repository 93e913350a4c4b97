// SPDX-License-Identifier: Apache-2.0
#include "skilled.hpp"

#include <cmath>
#include <exception>
#include <numbers>

#include "hand/sentences.hpp"
#include "sentences.hpp"

namespace swage::skilled {

using toolkit::Mat3;
using toolkit::vec;

namespace {

constexpr double kAside = 0.2;  // of the needle's length: distance between the two places from which its arc is computed

/// Share of the path at the time share x on the minimum-jerk path.
double least_jerk(double x) { return x * x * x * (10 + x * (-15 + 6 * x)); }

Pose between(const Pose& a, const Pose& b, double u) {
  const Vec3 turn = toolkit::log_rotation(a.q.conjugate() * b.q);
  return {a.p + u * (b.p - a.p), a.q * toolkit::exp_rotation(u * turn)};
}

Place place(const swage_graspable_place& raw) {
  return {raw.s, raw.length, vec(raw.p_W), vec(raw.tangent_W), vec(raw.normal_W)};
}

Mat3 frame(const Vec3& x, const Vec3& z) {
  Mat3 R;
  R.col(0) = x;
  R.col(2) = z;
  R.col(1) = z.cross(x);
  return R;
}

}  // namespace

void Skilled::build(const SkilledParams& params, DeviceBuilder& builder) {
  params_ = params;
  if (params.tremor_band.low >= params.tremor_band.high) builder.error("tremor_band", hand::say::kTremorBand());
  try {
    plan_ = load_plan(params.file);
  } catch (const std::exception& problem) {
    builder.error("file", problem.what());
  }
  seeks_.assign(plan_.acts.size(), {});
  for (const Act& act : plan_.acts) seen_.among_W.resize(std::max(seen_.among_W.size(), act.among.size()));
  build_wrist(builder);
}

void Skilled::build_wrist(DeviceBuilder& builder) {
  const SkilledParams& p = params_;
  const Vec3 forearm(p.forearm[0], p.forearm[1], 0);
  if (!(forearm.norm() > 0)) builder.error("forearm", say::kForearm());
  for (const auto& [key, range] : {std::pair{"rotation", &p.rotation}, {"flexion", &p.flexion}, {"deviation", &p.deviation}})
    if (!(range->low < 0 && range->high > 0)) builder.error(key, say::kRange());
  const auto side = [](const Interval& i) { return Wrist::Range{i.low, i.high}; };
  wrist_ = Wrist({.left = p.wrist == WhoseWrist::kLeft,
                  .forearm_W = forearm,
                  .swing = p.swing,
                  .hold = p.hold,
                  .ease = p.ease,
                  .range = {side(p.rotation), side(p.flexion), side(p.deviation)}});
}

/// Computes the needle's arc from two places on it. A hand that reaches observes the needle beside its jaws; else it observes the point,
/// as the arc at the jaws would be wrong there for a bent needle.
void Skilled::look_at_needle(const View& scene) {
  const Step needle = scene.object(needle_);
  seen_.wire_good = false;
  auto a = needle_peer_.locate(needle, toolkit::raw(now_.p));
  if (!a) return;
  const bool reaches = act_ >= plan_.acts.size() || plan_.acts[act_].verb == Verb::kReach;
  if (const auto point = needle_peer_.place(needle, 0); point && !reaches)
    a = needle_peer_.locate(needle, point->p_W);
  if (!a) return;
  const double aside = (a->s < 0.5 ? kAside : -kAside) * a->length;
  const Vec3 further = vec(a->p_W) + aside * vec(a->tangent_W);
  if (const auto b = needle_peer_.locate(needle, toolkit::raw(further))) {
    seen_.wire = Wire::through(place(*a), place(*b));
    seen_.wire_good = true;
  }
}

/// Computes how far the needle's crossing has moved from its place of entry.
void Skilled::look_at_hole(const View& scene) {
  seen_.aside_W.setZero();
  if (!hole_.valid()) return;
  // a needle whose blunt end is inside no longer crosses there
  const double s = scene.signal(hole_.s);
  if (!(s > 0 && s < 1)) return;
  for (int i = 0; i < 3; ++i) seen_.aside_W[i] = scene.signal(hole_.at[i]) - scene.signal(hole_.entry[i]);
}

void Skilled::look(const Sight& sight) {
  const View scene = sight.view();
  // during an act the needle is observed only by a hand that reaches for it or waits for it
  const bool under_way = act_ < plan_.acts.size() && !fresh_;
  const bool follows = under_way && (plan_.acts[act_].verb == Verb::kReach || plan_.acts[act_].verb == Verb::kAwait);
  if (!under_way || follows) look_at_needle(scene);
  look_at_hole(scene);
  seen_.force = force_.valid() ? scene.signal(force_) : 0;
  if (act_ >= plan_.acts.size()) return;
  const Seeks& seeks = seeks_[act_];
  if (seeks.signal.valid()) seen_.signal = scene.signal(seeks.signal);
  if (plan_.acts[act_].keep) look_at_strand(scene, plan_.acts[act_]);
  if (seeks.mark != kNone) seen_.mark_W = vec(sight.mark(seeks.mark));
  if (seeks.other != kNone) seen_.other_W = vec(sight.mark(seeks.other));
  for (size_t i = 0; i < seeks.among.size(); ++i) seen_.among_W[i] = vec(sight.mark(seeks.among[i]));
  if (seen_.wire_good) seen_.up_W = seen_.wire.place(0).tangent_W;
  if (const auto jaws =
          seeks.thing_peer.describe(scene.object(seeks.thing == kNone ? gripper_ : seeks.thing)))
    seen_.up_W = -vec(jaws->axis_W), seen_.axis_W = vec(jaws->axis_W), seen_.tip_W = vec(jaws->tip_W);
  seen_.into_W = plan_.acts[act_].into;
  if (seeks.tissue == kNone) return;
  if (const auto p = seeks.tissue_peer.inside(scene.object(seeks.tissue), toolkit::raw(seen_.mark_W)))
    seen_.into_W = -vec(p->normal_W);
}

// a new attempt begins at time 0
void Skilled::restart() {
  act_ = 0;
  act_began_s_ = 0;
  from_ = goal_ = now_ = plan_.start;
  asked_ = now_.q;
  turn_W_.setZero();
  from_closure_ = closure_ = plan_.closure;
  fresh_ = true;
  shown_W_.setZero();
  lift_W_.setZero();
  if (drawn_) return;
  tremor_.draw(params_.tremor, params_.tremor_band.low, params_.tremor_band.high,
               [this] { return random(); });
  drawn_ = true;
}

/// Normally distributed number by Box and Muller; 1 - random() is never 0.
double Skilled::normal() {
  const double r = std::sqrt(-2 * std::log(1 - random()));
  return r * std::cos(2 * std::numbers::pi * random());
}

void Skilled::begin_act(double time_s) {
  if (act_ == 0 || plan_.acts[act_ - 1].verb != Verb::kAim) lift_W_.setZero();
  from_ = goal_ = now_;
  from_closure_ = closure_;
  act_began_s_ = time_s;
  // the attitude asked of the wrist is kept while the tool has the one that the wrist gave for it
  constexpr double kSame = 1e-6;  // rad
  asked_ = toolkit::exp_rotation(turn_W_) * asked_;
  if (has_wrist() && wrist_.given(asked_).angularDistance(now_.q) > kSame) asked_ = now_.q;
  turn_W_.setZero();
  brought_W_.setZero();
  fresh_ = true;
}

/// Place of the thread to reach for, for tips past or before it along the present direction of the jaws.
void Skilled::look_at_strand(const View& scene, const Act& act) {
  const Step thread = scene.object(needle_);
  seen_.strand_good = false;
  const auto law = strand_.law(thread);
  if (!law) return;
  const auto place = strand_.place(thread, act.s * law->length + missed_m_);
  if (!place) return;
  seen_.strand_W = vec(place->p_W), seen_.strand_good = true;
}

/// Pose with the jaws perpendicular around the wire: their axis along the normal of its plane, closing along its radius.
Pose Skilled::reach_goal(const Act& act) const {
  const Place p = seen_.wire.place(act.s + missed_m_ / seen_.wire.at.length);
  const Vec3 x = p.normal_W.dot(act.from) > 0 ? Vec3(-p.normal_W) : p.normal_W;
  Vec3 z = x.cross(p.tangent_W);
  // the assignment of the two jaws that needs the smaller turn
  if (z.dot(from_.q * Vec3::UnitZ()) < 0) z = -z;
  const Quat lean = toolkit::exp_rotation(act.tilt * p.tangent_W);
  const Mat3 R = frame(lean * x, lean * z);
  return {p.p_W + (act.past - act.back) * R.col(0), Quat(R).normalized()};
}

/// Rotation of the held needle that directs its point along `into`, the normal of its plane along `across`, plus the lean errors.
Quat Skilled::turned_to(const Vec3& into, const Vec3& across) const {
  const Vec3 forward = -seen_.wire.place(0).tangent_W;
  const Mat3 R = frame(into, across) * frame(forward, seen_.wire.axis_W).transpose();
  const Quat leaning = toolkit::exp_rotation(params_.lean * across) * Quat(R);
  if (params_.side_lean == 0) return leaning;
  return toolkit::exp_rotation(params_.side_lean * across.cross(into)) * leaning;
}

/// The normal of the needle's plane: on the side of the smaller turn, or with less strain of the wrist.
Vec3 Skilled::side(const Act& act, const Vec3& into) const {
  const Vec3 flat = act.across - act.across.dot(into) * into;
  Vec3 across = flat.normalized();
  if (across.dot(seen_.wire.axis_W) < 0) across = -across;
  if (!has_wrist()) return across;
  const auto strain = [&](const Vec3& n) { return wrist_.strain(wrist_.asked(turned_to(into, n) * from_.q)); };
  return strain(-across) < strain(across) ? Vec3(-across) : across;
}

/// Tool pose in which the held needle has its point at the target, directed along `into`, turned back along the arc by the hover. A wrist
/// that cannot turn so far tilts the needle about its point.
Pose Skilled::lead(const Act& act, const Vec3& target, const Vec3& into) {
  const Wire& wire = seen_.wire;
  const Place point = wire.place(0);
  Quat q = turned_to(into, side(act, into));
  if (has_wrist()) {
    asked_ = q * from_.q;
    q = wrist_.given(asked_) * from_.q.conjugate();
  }
  const Vec3 to_centre = q * (wire.centre_W - point.p_W);
  // along the surface only: a leaning needle that is moved along its radius would have its centre too high, and lean more
  const Vec3 inwards = wire.curvature * (to_centre - to_centre.dot(into) * into);
  const Vec3 at = target + act.inside * inwards;
  const Pose held{at + q * (from_.p - point.p_W), (q * from_.q).normalized()};
  const Vec3 centre = at + to_centre;
  Pose goal = turned(held, centre, act.hover * wire.curvature * (q * wire.axis_W));
  goal.p -= act.above * into;
  return goal;
}

/// The held needle, or the own jaws, held up and pointing to the mark.
Pose Skilled::show_goal(const Act& act) {
  const Vec3 way = (seen_.mark_W - act.at).normalized();
  if (!act.jaws) return lead(act, act.at, way);
  const Vec3 closing = act.across - act.across.dot(way) * way;
  return {act.at, Quat(frame(way, closing.normalized())).normalized()};
}

/// True while the event to which the act reacts has not happened.
bool Skilled::waits(const Act& act) const {
  constexpr double kSame = 1e-9;  // m
  if (act.verb == Verb::kChoose) return (seen_.mark_W - shown_W_).norm() < kSame;
  if (act.verb == Verb::kShow)
    return (seen_.mark_W - shown_W_).norm() < kSame || (!act.jaws && !seen_.wire_good);
  return act.verb == Verb::kAnswer && (seen_.other_W - seen_.mark_W).norm() < kSame;
}

/// True while the awaited condition holds.
bool Skilled::has_come(const Act& act) const {
  if (!act.signal.empty()) return seen_.signal > act.more && seen_.signal < act.less;
  return seen_.wire_good && (seen_.wire.place(act.s).p_W - seen_.mark_W).norm() < act.near;
}

/// The mark on the side to which the object appears to lean.
Vec3 Skilled::answer() {
  const Vec3 to_other = (seen_.other_W - seen_.mark_W).normalized();
  const double lean = std::asin(std::clamp(seen_.up_W.dot(to_other), -1.0, 1.0));
  const double seen = lean + params_.angle_bias + params_.angle_noise * normal();
  return seen > 0 ? seen_.other_W : seen_.mark_W;
}

/// The mark whose number is the signal, or a random one.
Vec3 Skilled::choose() {
  const double n = static_cast<double>(plan_.acts[act_].among.size());
  const double which = random() < params_.guesses ? 1 + std::floor(n * random()) : seen_.signal;
  return seen_.among_W[static_cast<size_t>(std::clamp(std::round(which), 1.0, n)) - 1];
}

void Skilled::set_goal(const Act& act) {
  const Wire& wire = seen_.wire;
  switch (act.verb) {
    case Verb::kReach:
      if (fresh_) missed_m_ = params_.spot_error * normal();
      if (act.keep && seen_.strand_good) goal_.p = seen_.strand_W + (act.past - act.back) * (from_.q * Vec3::UnitX());
      if (!act.keep && seen_.wire_good) goal_ = reach_goal(act);
      return;  // set again in every step: the object may move
    case Verb::kBack:
      goal_.p = from_.p - act.by * (from_.q * Vec3::UnitX());
      break;
    case Verb::kMove:
      goal_.p = act.to_place ? act.at : from_.p + act.way;
      if (act.turns_to) goal_.q = act.attitude;
      if (act.roll != 0) goal_.q = (from_.q * toolkit::exp_rotation(act.roll * Vec3::UnitX())).normalized();
      break;
    case Verb::kDraw:
      goal_.p = from_.p + act.way;
      drawn_share_ = 0;
      break;
    case Verb::kBring:
      if (seen_.wire_good) goal_.p = from_.p + seen_.mark_W - wire.place(act.s).p_W;
      break;
    case Verb::kAim:
      for (int k = 0; k < 3; ++k) missed_W_[k] = params_.aim_error / std::numbers::sqrt2 * normal();
      if (seen_.wire_good)
        goal_ =
            lead(act, seen_.mark_W + missed_W_ - missed_W_.dot(seen_.into_W) * seen_.into_W, seen_.into_W);
      lift_W_ = -act.above * seen_.into_W;
      break;
    case Verb::kShow:
      shown_W_ = seen_.mark_W;
      goal_ = show_goal(act);
      break;
    case Verb::kAnswer:
      goal_.p = answer();
      break;
    case Verb::kChoose:
      shown_W_ = seen_.mark_W;
      goal_.p = choose();
      break;
    case Verb::kDrive: {
      if (!seen_.wire_good) break;
      const Vec3 out = (wire.place(0).p_W - wire.centre_W).normalized();
      turn_centre_W_ = wire.centre_W - params_.pivot_error * out;
      turn_W_ = -act.angle * wire.axis_W;  // the axis is for turns towards the swage, the point moves the other way
      // about a lifted centre the point would enter at an angle: the lift is reduced by the path length of the point, so that the other end
      // of half a circle stays at its height
      const double arc = std::abs(act.angle) / wire.curvature;  // m, path length of the point
      lowered_ = arc > 0 ? std::min(1.0, lift_W_.norm() / arc) : 0;
      break;
    }
    case Verb::kWind: {
      const Vec3 d = from_.p - seen_.tip_W;
      about_W_ = seen_.tip_W, about_axis_W_ = seen_.axis_W;
      radius_ = (d - d.dot(about_axis_W_) * about_axis_W_).norm();
      outwards_ = way_ = 0, pace_ = 1;
      break;
    }
    case Verb::kWait:
    case Verb::kAwait:
    case Verb::kClose:
    case Verb::kOpen:
    case Verb::kAgain:
      break;
  }
}

/// Pose after a share of a drive: along the arc, and down by the lift of the aim. The arm brings the tool to its place, but the
/// wrist may be unable to turn it so far.
Pose Skilled::driven(double u) const {
  Pose X = turned(from_, turn_centre_W_, u * turn_W_);
  if (has_wrist()) {
    const Quat from_given = wrist_.given(asked_).conjugate() * from_.q;
    X.q = (wrist_.given(toolkit::exp_rotation(u * turn_W_) * asked_) * from_given).normalized();
  }
  X.p -= (u < lowered_ ? u / lowered_ : 1) * lift_W_;
  return X;
}

void Skilled::follow_act(const Act& act, double share, double rate, double dt) {
  if (fresh_ || act.verb == Verb::kReach) set_goal(act);
  fresh_ = false;
  const double u = least_jerk(share);
  if (act.verb == Verb::kWind && !act.signal.empty()) feel(act, dt);
  if (act.verb == Verb::kDraw) draw(act, rate * dt);
  now_ = act.verb == Verb::kDrive  ? driven(u)
         : act.verb == Verb::kWind ? wound(act, u)
                                   : between(from_, goal_, act.verb == Verb::kDraw ? drawn_share_ : u);
  if (act.verb == Verb::kDrive && hole_.valid()) {
    brought_W_ -= std::min(1.0, dt / params_.steady) * seen_.aside_W;
    now_.p += brought_W_;
  }
  if (act.verb == Verb::kOpen || (act.verb == Verb::kClose && act.force <= 0))
    closure_ = from_closure_ + u * (act.closure - from_closure_);
  if (act.verb == Verb::kClose && act.force > 0 && seen_.force < act.force)
    closure_ = std::min(1.0, closure_ + rate * dt * (1 - from_closure_));
}

void Skilled::exchange(const swage_command& command, swage_sample& sample) {
  const double t = command.time_s;
  if (t <= last_s_ || last_s_ < 0) restart();
  const double dt = last_s_ < 0 ? 0 : std::max(0.0, t - last_s_);
  last_s_ = t;
  if (act_ < plan_.acts.size()) {
    const Act& act = plan_.acts[act_];
    const double time = act.time / params_.speed;
    if ((fresh_ && waits(act)) || (act.verb == Verb::kAwait && !has_come(act))) act_began_s_ = t;
    const double share = std::min(1.0, (t - act_began_s_) / time);
    if (!fresh_ || !waits(act)) follow_act(act, share, 1 / time, dt);
    // closing to a force ends at that force, or with closed jaws
    const bool closing = act.verb == Verb::kClose && act.force > 0 && seen_.force < act.force && closure_ < 1;
    if (share >= 1 && !closing) {
      act_ = act.verb == Verb::kAgain && has_come(act) ? act.from_act : act_ + 1;
      if (act_ < plan_.acts.size() && plan_.acts[act_].is_loop()) act_ = plan_.acts[act_].from_act;
      begin_act(t);
    }
  }

  Vec3 shake, shake_rate;
  tremor_.at(t, shake, shake_rate);
  sample.sequence += 1;
  sample.time_s = t;
  sample.pose.p = toolkit::raw(Vec3(now_.p + shake));
  sample.pose.q = toolkit::raw(now_.q);
  sample.closure = closure_;
  sample.buttons = 0;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  if (act_ >= plan_.acts.size()) sample.valid |= SWAGE_VALID_DONE;
}

}  // namespace swage::skilled

SWAGE_EXPORT(swage::skilled::Skilled)
