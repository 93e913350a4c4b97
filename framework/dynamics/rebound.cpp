// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rebound.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/rotation.hpp"

namespace swage::dynamics {

using contact::Detector;
using scene::kNone;
using toolkit::Frame;
using toolkit::raw;
using toolkit::vec;

namespace {

constexpr uint32_t kLooks = 64;        // ahead in one step; normal: two for each touch. A step that needs more is counted over budget
constexpr size_t kMeetings = 1 << 14;  // pairs of shapes with something that flies
constexpr int kRounds = 4;             // of lifting at the end of the step

}  // namespace

Rebound::Rebound(const scene::World& world, uint32_t max_contacts)
    : path_(world.body.size()), flyer_of_(world.body.size(), kNone), moved_(world.body.size(), 0) {
  flyer_.reserve(world.body.size());
  meeting_.reserve(std::min(world.shape.size() * world.shape.size(), kMeetings));
  impulse_.reserve(size_t{max_contacts} * 2);
  struck_.reserve(max_contacts);
  waypoint_.reserve(size_t{kLooks} * world.body.size());
}

bool Rebound::fly(scene::World& world, Motion& motion, contact::ContactSet& contacts, Detector& detector,
                  FreeMotion method, double tolerance) noexcept {
  impulse_.clear(), struck_.clear(), waypoint_.clear();
  std::fill(motion.flown.begin(), motion.flown.end(), uint8_t{0});
  if (detector.swept_pairs() == 0) return true;
  world_ = &world, motion_ = &motion, detector_ = &detector;
  method_ = method, tolerance_ = tolerance;
  find_paths();
  if (!find_flyers(contacts)) return true;
  find_meetings(contacts);
  at_ = 0;
  uint32_t looks = 0;
  while (looks < kLooks && fly_to_next()) ++looks;
  const bool ended = looks < kLooks;
  // what flies fast has met all that it meets, also where that needed no push: contacts of the whole way mean nothing any more
  bool fast = false;
  for (const Flyer& f : flyer_)
    if (f.fast && !motion.held_body[f.body]) moved_[f.body] = 1, fast = true;
  if (impulse_.empty() && ended && !fast) return true;
  if (ended)
    settle();
  else
    carry_along();
  land(contacts);
  return ended;
}

void Rebound::report(contact::ContactSet& contacts, double h) const noexcept {
  for (const Impulse& j : impulse_) {
    contact::Contact* best = nullptr;
    for (contact::Contact& c : contacts.contact) {
      if (c.shape_a != j.shape_a || c.shape_b != j.shape_b) continue;
      if (!best || c.feature == j.feature) best = &c;
      if (c.feature == j.feature) break;
    }
    if (best) best->f_a_W += j.on_a_W / h;
  }
}

// --- who flies

/// How every body moves as it is predicted: from its pose at the start of the step to that of now.
void Rebound::find_paths() noexcept {
  const double h = world_->dt;
  for (uint32_t b = 0; b < path_.size(); ++b) {
    flyer_of_[b] = kNone, moved_[b] = 0;
    const int32_t kind = world_->body[b].motion;
    const Pose X(world_->X_WB[b]);
    contact::Motion& path = path_[b];
    if (kind == SWAGE_MOTION_DYNAMIC || kind == SWAGE_MOTION_HINGED) {
      path.X0 = motion_->X0[b];
      path.d = X.p - path.X0.p;
      path.turn = rotation_vector(X.q * path.X0.q.conjugate());
    } else {
      path.d = h * vec(world_->V_WB[b].v), path.turn = h * vec(world_->V_WB[b].w);
      path.X0 = Pose(X.p - path.d, dynamics::turn(-path.turn) * X.q);
    }
  }
  flyer_.clear(), meeting_.clear();
}

contact::Law Rebound::law_of(const contact::ContactSet& contacts, uint32_t swept) const noexcept {
  const Detector::Shapes& s = detector_->swept(swept);
  const contact::Law* law = &detector_->pairs()[s.pair].law;
  if (s.pair >= contacts.of_pair.size()) return *law;
  const scene::Range range = contacts.of_pair[s.pair];
  for (uint32_t i = range.first; i < range.first + range.count; ++i) {
    const contact::Contact& c = contacts.contact[i];
    law = &c.law;
    if (c.shape_a == s.shape_a && c.shape_b == s.shape_b) break;
  }
  return *law;
}

/// True when there are some.
bool Rebound::find_flyers(const contact::ContactSet& contacts) noexcept {
  find_rebounding(contacts);
  find_fast(contacts);
  join_met();
  return !flyer_.empty();
}

/// What is free and overlaps something with a restitution above 0.
void Rebound::find_rebounding(const contact::ContactSet& contacts) noexcept {
  for (const contact::Contact& c : contacts.contact) {
    if (!(c.law.restitution > 0) || !(c.gap < 0) || !(c.law.stiffness > 0)) continue;
    if (c.particle_a != kNone || c.particle_b != kNone) continue;
    const auto held = [&](uint32_t body) {
      return world_->body[body].motion == SWAGE_MOTION_FLEXIBLE ||
             (world_->body[body].motion == SWAGE_MOTION_DYNAMIC && motion_->held_body[body]);
    };
    if (!held(c.body_a) && !held(c.body_b)) join(c.body_a), join(c.body_b);
  }
}

/// What may come out on the far side of something.
void Rebound::find_fast(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < detector_->swept_pairs(); ++i) {
    const Detector::Shapes& s = detector_->swept(i);
    const contact::Motion &a = path_[s.body_a], &b = path_[s.body_b];
    if (detector_->reach(*world_, i, a, b) != Detector::Reach::kFast) continue;
    if (!(law_of(contacts, i).stiffness > 0)) continue;
    // what spins fast goes on another path than that of a constant twist
    const bool spins = std::max(a.turn.squaredNorm(), b.turn.squaredNorm()) > kTurn * kTurn;
    if (!spins && !detector_->first_overlap(*world_, i, a, b, 0, 0).hit) continue;
    for (const uint32_t body : {s.body_a, s.body_b}) {
      join(body);
      if (Flyer* f = flyer(body)) f->fast = true;
    }
  }
}

/// What a flyer may meet, and can move, flies too.
void Rebound::join_met() noexcept {
  for (bool more = !flyer_.empty(); more;) {
    more = false;
    for (uint32_t i = 0; i < detector_->swept_pairs(); ++i) {
      const Detector::Shapes& s = detector_->swept(i);
      if ((flyer_of_[s.body_a] == kNone) == (flyer_of_[s.body_b] == kNone)) continue;
      if (detector_->reach(*world_, i, path_[s.body_a], path_[s.body_b]) == Detector::Reach::kFar) continue;
      const size_t before = flyer_.size();
      join(s.body_a), join(s.body_b);
      more = more || flyer_.size() > before;
    }
  }
}

/// Makes a body a flyer from the start of the step on, if it is one that can fly.
void Rebound::join(uint32_t body) noexcept {
  if (world_->body[body].motion != SWAGE_MOTION_DYNAMIC || flyer_of_[body] != kNone) return;
  flyer_of_[body] = static_cast<uint32_t>(flyer_.size());
  Flyer f;
  f.body = body;
  const double mass = motion_->mass[body].mass;
  f.f_W = vec(world_->F_B_W[body].f) + mass * vec(world_->gravity);
  f.t_W = vec(world_->F_B_W[body].t);
  f.s = {motion_->X0[body].p, motion_->X0[body].q, motion_->v_free[body] - world_->dt / mass * f.f_W,
         motion_->w0[body]};
  f.end = f.s;
  flyer_.push_back(f);
}

void Rebound::find_meetings(const contact::ContactSet& contacts) noexcept {
  const auto pairs = static_cast<uint32_t>(detector_->swept_pairs());
  for (uint32_t i = 0; i < pairs && meeting_.size() < meeting_.capacity(); ++i) {
    const Detector::Shapes& s = detector_->swept(i);
    if (flyer_of_[s.body_a] == kNone && flyer_of_[s.body_b] == kNone) continue;
    Meeting m;
    m.swept = i, m.body_a = s.body_a, m.body_b = s.body_b;
    m.law = law_of(contacts, i);
    if (!(m.law.stiffness > 0)) continue;
    const auto& found =
        detector_->touches(*world_, i, Frame(path_[s.body_a].X0), Frame(path_[s.body_b].X0), 0);
    for (int k = 0; k < found.count; ++k)
      m.sunk = std::max(m.sunk, -found.candidate[static_cast<size_t>(k)].touch.gap);
    meeting_.push_back(m);
  }
}

// --- the end of the step

/// The end of the step, without what slow touches sank in by: where nothing overlaps the contact solve has nothing to add.
void Rebound::settle() noexcept {
  advance(world_->dt);
  for (int round = 0; round < kRounds; ++round) {
    ahead_ = at_, hit_ = kNone;
    gather();
    for (const Touching& t : touching_) {
      const Meeting& m = meeting_[t.meeting];
      if (!moved_[m.body_a] && !moved_[m.body_b]) continue;
      const Sides s = sides(t, at_);
      // what leaves comes out by itself: lifted, it would gain height
      if (s.coming < -kResting * world_->length / world_->dt) continue;
      if (comes(s)) push(t, s, 0);
      lift(t);
    }
  }
}

/// The end of a step whose touches do not end: what flies goes on with what it touched last, as if it stuck to it.
void Rebound::carry_along() noexcept {
  const double now = at_;
  for (Flyer& f : flyer_) {
    moved_[f.body] = 1;
    for (const Meeting& m : meeting_) {
      if (!m.pushed || (m.body_a != f.body && m.body_b != f.body)) continue;
      const uint32_t other = m.body_a == f.body ? m.body_b : m.body_a;
      if (flyer_of_[other] != kNone) continue;
      const Pose X = pose(other, world_->dt) * pose(other, now).inverse() * Pose(f.s.p_W, f.s.q_WB);
      f.s.p_W = X.p, f.s.q_WB = X.q;
      break;
    }
    f.end = f.s;
  }
}

/// Hands over what flew to the contact solve: at its end of the step, as if it had come there by the motion that it now has.
void Rebound::land(contact::ContactSet& contacts) noexcept {
  const double h = world_->dt;
  for (Flyer& f : flyer_) {
    if (!moved_[f.body]) continue;
    const RigidState& s = f.s;
    const RigidMass& mass = motion_->mass[f.body];
    motion_->X_free[f.body] = {s.p_W, s.q_WB};
    motion_->v_free[f.body] = s.v_W, motion_->w_free[f.body] = s.w_W;
    // a start of the step from which that motion, with its angular momentum, leads there
    const Quat q0 = dynamics::turn(-h * s.w_W) * s.q_WB;
    const Vec3 L = s.q_WB * mass.I.cwiseProduct(s.q_WB.conjugate() * s.w_W);
    motion_->X0[f.body] = Pose(s.p_W - h * s.v_W, q0);
    motion_->w0[f.body] = turned_by(mass, q0, L - h * f.t_W);
    motion_->flown[f.body] = 1;
    world_->X_WB[f.body] = motion_->X_free[f.body].abi();
    world_->V_WB[f.body] = {raw(s.v_W), raw(s.w_W)};
    if (waypoint_.size() < waypoint_.capacity()) waypoint_.push_back({f.body, h, motion_->X_free[f.body]});
  }
  detector_->look_again(*world_, contacts, moved_, struck_);
}

// --- poses and speeds within the step

Rebound::Flyer* Rebound::flyer(uint32_t body) noexcept {
  return flyer_of_[body] == kNone ? nullptr : &flyer_[flyer_of_[body]];
}

/// How a body moves from now to the end of the look.
contact::Motion Rebound::path(uint32_t body) const noexcept {
  contact::Motion m;
  m.X0 = pose(body, at_);
  if (flyer_of_[body] != kNone) {
    const Flyer& f = flyer_[flyer_of_[body]];
    m.d = f.end.p_W - f.s.p_W, m.turn = f.turn;
  } else {
    const double rest = (until_ - at_) / world_->dt;
    m.d = rest * path_[body].d, m.turn = rest * path_[body].turn;
  }
  return m;
}

/// A flyer at the time t, from now on.
RigidState Rebound::state(const Flyer& f, double t) const noexcept {
  if (!(t > at_)) return f.s;
  if (t == until_) return f.end;
  RigidState s = f.s;
  move_free(method_, motion_->mass[f.body], f.f_W, f.t_W, t - at_, s);
  return s;
}

Pose Rebound::pose(uint32_t body, double t) const noexcept {
  if (flyer_of_[body] == kNone) return path_[body].at(t / world_->dt);
  const RigidState s = state(flyer_[flyer_of_[body]], t);
  return {s.p_W, s.q_WB};
}

contact::Touch Rebound::touch(const Touching& touching, double t) const noexcept {
  const Meeting& m = meeting_[touching.meeting];
  return reevaluate(touching.candidate, Frame(pose(m.body_a, t)), Frame(pose(m.body_b, t)));
}

Rebound::Sides Rebound::sides(const Touching& touching, double t) noexcept {
  const Meeting& m = meeting_[touching.meeting];
  const contact::Touch at = touch(touching, t);
  Sides s;
  s.gap = at.gap, s.n = at.n_W, s.p = at.p_W;
  s.a = flyer(m.body_a), s.b = flyer(m.body_b);
  const auto velocity = [&](uint32_t body, const Flyer* f) -> Vec3 {
    if (f) {
      const RigidState now = state(*f, t);
      return now.v_W + now.w_W.cross(s.p - now.p_W);
    }
    const contact::Motion& path = path_[body];
    return (path.d + path.turn.cross(s.p - path.at(t / world_->dt).p)) / world_->dt;
  };
  s.v = velocity(m.body_a, s.a) - velocity(m.body_b, s.b);
  s.coming = -s.n.dot(s.v);
  return s;
}

}  // namespace swage::dynamics
