// SPDX-License-Identifier: Apache-2.0
//
// From touch to touch within the step: the prediction, the time at which a touch needs an impulse, and Newton's impulse there.
#include <algorithm>
#include <cmath>

#include "contact/candidate.hpp"
#include "dynamics/rebound.hpp"
#include "dynamics/rotation.hpp"

namespace swage::dynamics {

using contact::Detector;
using scene::kNone;
using toolkit::Frame;

namespace {

constexpr uint32_t kPushes = 64;  // impulses at one time; normal: one for each point of a line contact
constexpr uint32_t kSecants = 40;
constexpr double kNever = HUGE_VAL;
constexpr double kSlow = 2.5e-3;  // of the scene's length, per step: slower approaches are left to the contact solve
constexpr double kAtOnce = 1e-4;  // of the scene's length: smaller gaps close at one time, 0.1 um for a 1 mm scene

}  // namespace

/// Flies to the next touch and applies its impulses. False at the end of the step.
bool Rebound::fly_to_next() noexcept {
  look_ahead();
  gather();
  double first = kNever;
  const Touching* late = nullptr;
  for (const Touching& t : touching_) {
    bool sinks = false;
    const double time = time_of(t, sinks);
    if (time < first) first = time, late = sinks ? &t : nullptr;
  }
  if (first == kNever) {
    // no touch needs an impulse: nothing passes through anything up to ahead_
    if (hit_ == kNone && until_ == world_->dt) return false;
    if (hit_ != kNone) ++meeting_[hit_].touches;
    advance(ahead_);
    return true;
  }
  advance(first);
  push_all(late);
  return true;
}

/// Predicts the flight of every flyer and finds the time ahead_ up to which the swept paths are free.
void Rebound::look_ahead() noexcept {
  until_ = world_->dt;
  for (const Flyer& f : flyer_) until_ = std::min(until_, at_ + kTurn / f.s.w_W.norm());
  const double rest = until_ - at_;
  for (Flyer& f : flyer_) {
    f.end = f.s;
    move_free(method_, motion_->mass[f.body], f.f_W, f.t_W, rest, f.end);
    f.turn = rotation_vector(f.end.q_WB * f.s.q_WB.conjugate());
  }
  ahead_ = until_, hit_ = kNone;
  for (uint32_t i = 0; i < meeting_.size(); ++i) {
    const Meeting& m = meeting_[i];
    const contact::Motion a = path(m.body_a), b = path(m.body_b);
    if (detector_->reach(*world_, m.swept, a, b) == Detector::Reach::kFar) continue;
    const contact::FirstTouch touch = detector_->first_overlap(*world_, m.swept, a, b, m.sunk, m.touches);
    const double t = at_ + touch.t * rest;
    if (touch.hit && (hit_ == kNone || t < ahead_)) ahead_ = t, hit_ = i;
  }
}

/// Collects all touches at the time ahead_.
void Rebound::gather() noexcept {
  touching_.clear();
  for (uint32_t i = 0; i < meeting_.size(); ++i) {
    const Meeting& m = meeting_[i];
    const double margin = i == hit_ ? contact::kTouchGap * world_->length : 0.0;
    const auto& found = detector_->touches(*world_, m.swept, Frame(pose(m.body_a, ahead_)),
                                           Frame(pose(m.body_b, ahead_)), margin);
    for (int k = 0; k < found.count; ++k) touching_.add({i, found.candidate[static_cast<size_t>(k)]});
  }
}

/// Time at which a touch needs an impulse; infinite when it needs none before ahead_. `sinks` is set where a slow touch has reached
/// the largest overlap allowed to slow ones.
double Rebound::time_of(const Touching& touching, bool& sinks) noexcept {
  const Meeting& m = meeting_[touching.meeting];
  const double gap = touch(touching, at_).gap;
  if (gap > tolerance_) {
    const double t = time_of_gap(touching, gap, 0);
    if (t == kNever) return kNever;
    const Sides s = sides(touching, t);
    if (comes(s) && !slow(m, s)) return t;
  } else {
    const Sides s = sides(touching, at_);
    if (comes(s) && !slow(m, s)) return at_;
  }
  // a slow shape cannot pass through the other
  if (!fast(m)) return kNever;
  sinks = true;
  const double t = time_of_gap(touching, gap, std::min(gap, -m.sunk) - kSlow * world_->length);
  return t < kNever && comes(sides(touching, t)) ? t : kNever;
}

/// Time at which the gap, now larger than `least`, has shrunk to it; infinite when it does not before ahead_.
double Rebound::time_of_gap(const Touching& touching, double gap, double least) const noexcept {
  double low = at_, high = ahead_, at_low = gap - least, at_high = touch(touching, high).gap - least;
  if (!(at_high < 0)) return kNever;

  // Illinois: regula falsi that halves the value at an end that stays
  double t = low;
  for (uint32_t k = 0; k < kSecants; ++k) {
    t = low + (high - low) * at_low / (at_low - at_high);
    const double now = touch(touching, t).gap - least;
    if (std::abs(now) <= tolerance_) break;
    if (now < 0) {
      high = t, at_high = now;
      at_low *= 0.5;
    } else {
      low = t, at_low = now;
      at_high *= 0.5;
    }
  }
  return t;
}

/// Moves everything that flies to the time t.
void Rebound::advance(double t) noexcept {
  for (Flyer& f : flyer_) {
    f.s = state(f, t);
    if (waypoint_.size() < waypoint_.capacity()) waypoint_.push_back({f.body, t, {f.s.p_W, f.s.q_WB}});
  }
  at_ = t;
}

/// Applies impulses to the present touches, fastest approach first, until all approach slowly; always to `sunk`.
void Rebound::push_all(const Touching* sunk) noexcept {
  for (uint32_t k = 0; k < kPushes; ++k) {
    const Touching* fastest = nullptr;
    Sides of_fastest;
    for (const Touching& t : touching_) {
      const Sides s = sides(t, at_);
      if (!comes(s) || s.gap > kAtOnce * world_->length || (fastest && s.coming <= of_fastest.coming)) continue;
      if (&t != sunk && slow(meeting_[t.meeting], s)) continue;
      fastest = &t, of_fastest = s;
    }
    if (!fastest) return;
    // an overlapping shape stops, as it must not rebound from below the surface
    const Meeting& m = meeting_[fastest->meeting];
    const bool in = fastest == sunk || of_fastest.gap < -m.sunk - kResting * world_->length;
    push(*fastest, of_fastest, in ? 0 : m.law.restitution);
    if (in) lift(*fastest);
  }
}

bool Rebound::fast(const Meeting& m) const noexcept {
  const auto is = [&](uint32_t body) { return flyer_of_[body] != kNone && flyer_[flyer_of_[body]].fast; };
  return is(m.body_a) || is(m.body_b);
}

/// Moves overlapping shapes apart until they touch: a few um, without a change of velocity.
void Rebound::lift(const Touching& touching) noexcept {
  const Sides s = sides(touching, at_);
  const double deep = -s.gap - meeting_[touching.meeting].sunk;
  if (!(deep > 0)) return;
  const auto light = [&](const Flyer* f) { return f ? 1 / motion_->mass[f->body].mass : 0.0; };
  const double share = std::min(deep, 4 * kSlow * world_->length) / (light(s.a) + light(s.b));
  if (s.a) s.a->s.p_W += share * light(s.a) * s.n, s.a->end = s.a->s;
  if (s.b) s.b->s.p_W -= share * light(s.b) * s.n, s.b->end = s.b->s;
}

bool Rebound::comes(const Sides& s) const noexcept {
  return s.coming > kResting * world_->length / world_->dt;
}

/// True when the touch is left to the contact solve.
bool Rebound::slow(const Meeting& meeting, const Sides& s) const noexcept {
  const double h = world_->dt;
  double pressed = 0;
  if (s.a) pressed -= s.n.dot(s.a->f_W) / motion_->mass[s.a->body].mass;
  if (s.b) pressed += s.n.dot(s.b->f_W) / motion_->mass[s.b->body].mass;
  if (fast(meeting) && h * s.coming >= kSlow * world_->length) return false;
  return 2 * meeting.law.restitution * s.coming <= std::max(h * pressed, kResting * world_->length / h);
}

/// Change of the velocity of a relative to b at the touch by the impulse j on a and -j on b.
Vec3 Rebound::added(const Sides& s, const Vec3& j) const noexcept {
  Vec3 v = Vec3::Zero();
  for (const Flyer* f : {s.a, s.b}) {
    if (!f) continue;
    const Vec3 r = s.p - f->s.p_W;
    const RigidMass& mass = motion_->mass[f->body];
    v += j / mass.mass + turned_by(mass, f->s.q_WB, r.cross(j)).cross(r);
  }
  return v;
}

/// Newton's impulse on a.
Vec3 Rebound::impulse(const Sides& s, double restitution, double friction) const noexcept {
  const Vec3 j = (1 + restitution) * s.coming / s.n.dot(added(s, s.n)) * s.n;
  // friction, where it takes energy: against the sliding that is left after j, up to mu j
  const Vec3 slides = s.v + added(s, j), across = slides - s.n.dot(slides) * s.n;
  const double speed = across.norm();
  if (!(speed > 0)) return j;
  const Vec3 e = across / speed;
  const double stop = speed / e.dot(added(s, e)), most = friction * s.n.dot(j);
  const Vec3 with = j - std::min(stop, most) * e;
  // work of the impulse on the point: j . (v- + v+) / 2
  return with.dot(2 * s.v + added(s, with)) <= j.dot(2 * s.v + added(s, j)) ? with : j;
}

/// Applies the impulse of a touch to both bodies.
void Rebound::push(const Touching& touching, const Sides& s, double restitution) noexcept {
  const Meeting& m = meeting_[touching.meeting];
  const Vec3 j = impulse(s, restitution, m.law.friction);
  for (Flyer* f : {s.a, s.b}) {
    if (!f) continue;
    const Vec3 on = f == s.a ? j : Vec3(-j);
    const RigidMass& mass = motion_->mass[f->body];
    f->s.v_W += on / mass.mass;
    f->s.w_W += turned_by(mass, f->s.q_WB, (s.p - f->s.p_W).cross(on));
    moved_[f->body] = 1;
  }
  meeting_[touching.meeting].pushed = true;
  const Detector::Shapes& shapes = detector_->swept(m.swept);
  if (impulse_.size() < impulse_.capacity())
    impulse_.push_back({shapes.shape_a, shapes.shape_b, touching.candidate.feature, j});
  const auto known = [&](const Detector::Struck& k) { return k.swept == m.swept; };
  if (struck_.size() < struck_.capacity() && std::none_of(struck_.begin(), struck_.end(), known))
    struck_.push_back({m.swept, touching.candidate});
}

}  // namespace swage::dynamics
