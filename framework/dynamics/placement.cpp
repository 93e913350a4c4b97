// SPDX-License-Identifier: Apache-2.0
#include "dynamics/placement.hpp"

#include <algorithm>
#include <cmath>

#include "scene/chain.hpp"
#include "scene/kinematics.hpp"

namespace swage::dynamics {

using scene::kNone;
using toolkit::Frame;
using toolkit::raw;
using toolkit::vec;

Placement::Placement(const scene::World& world) : flexible_(world) {
  const size_t bodies = world.body.size(), hinges = world.hinge.size(),
               particles = world.particle_mass.size();
  trial_.resize(bodies);
  p_.assign(particles, Vec3::Zero());
  block_of_body_.assign(bodies, kNone), block_of_particle_.assign(particles, kNone);

  chain_of_body_.assign(bodies, kNone);
  for (const scene::Shape& shape : world.shape)
    if (shape.kind == SWAGE_SHAPE_CHAIN) chain_of_body_[shape.body] = shape.chain;

  auto add = [this](DofBlock::Kind kind, size_t index, uint32_t size) {
    DofBlock m;
    m.kind = kind, m.index = static_cast<uint32_t>(index), m.size = size;
    block_.push_back(m);
    return static_cast<uint32_t>(block_.size() - 1);
  };
  for (size_t i = 0; i < bodies; ++i)
    if (world.body[i].motion == SWAGE_MOTION_DYNAMIC) block_of_body_[i] = add(DofBlock::Kind::kRigid, i, 6);
  for (size_t i = 0; i < hinges; ++i)
    block_of_body_[world.hinge[i].child] = add(DofBlock::Kind::kHinge, i, 1);
  for (size_t i = 0; i < particles; ++i) block_of_particle_[i] = add(DofBlock::Kind::kParticle, i, 3);
  first_flexible_ = blocks();
  for (size_t i = 0; i < flexible_.capacity(); ++i) add(DofBlock::Kind::kFlexible, i, 0);
  block_step_.assign(block_.size(), 0);
}

uint32_t Placement::unknowns() const noexcept {
  uint32_t sum = 0;
  for (const DofBlock& m : block_) sum += m.size;
  return sum;
}

void Placement::begin(scene::World& world, Motion& motion, std::span<FlexibleBody* const> self) noexcept {
  world_ = &world, motion_ = &motion;
  h_ = world.dt;
  ++step_;
  flexible_.begin(self, motion.stiffer);
  for (uint32_t slot = 0; slot < flexible_.capacity(); ++slot) {
    DofBlock& m = block_[first_flexible_ + slot];
    m.band = flexible_.band(slot);
    m.kind = m.band ? DofBlock::Kind::kBanded : DofBlock::Kind::kFlexible;
    m.size = m.band ? m.band->unknowns() : 0;
  }
}

Side Placement::side(uint32_t body, uint32_t particle) noexcept {
  Side s;
  if (particle != kNone) {
    s.particle = particle;
    s.block = block_of_particle_[particle];
    if (block_step_[s.block] != step_) {
      const double* p = &world_->particle_p_W[3 * particle];
      p_[particle] = Vec3(p[0], p[1], p[2]);
    }
  } else {
    s.body = body;
    if (trial_[body].step != step_) prepare(body);
    s.block = block_of_body_[body];
    if (world_->body[body].motion == SWAGE_MOTION_FLEXIBLE) {
      const uint32_t slot = flexible_.slot(world_->body[body].object);
      s.block = slot == kNone ? kNone : first_flexible_ + slot;
    }
  }
  if (s.block != kNone && block_step_[s.block] != step_) prepare_block(s.block);
  return s;
}

Side Placement::side(uint32_t body, uint32_t particle, uint32_t shape,
                     const contact::ChainPlace& place) noexcept {
  Side s = side(body, particle);
  if (place.segment != kNone) s.chain = world_->shape[shape].chain, s.place = place;
  if (s.chain == kNone && is_banded(s.block)) s.block = kNone;
  return s;
}

Side Placement::tied_side(uint32_t body, const Vec3& p_W) noexcept {
  Side s = side(body, kNone);
  s.tied = true;
  s.chain = chain_of_body_[body];
  if (s.chain == kNone) {
    if (is_banded(s.block)) s.block = kNone;
    return s;
  }
  s.place = scene::nearest_place(scene::ChainView(*world_, world_->chain[s.chain]), p_W);
  if (s.place.segment == kNone) s.chain = kNone;
  if (s.chain == kNone && is_banded(s.block)) s.block = kNone;
  return s;
}

void Placement::take_answers() noexcept {
  for (uint32_t slot = 0; slot < flexible_.count(); ++slot)
    if (!block_[first_flexible_ + slot].band) block_[first_flexible_ + slot].own = flexible_.answer(slot);
}

/// Prepares the trial of a body at its pose in the world.
void Placement::prepare(uint32_t body) noexcept {
  Trial& t = trial_[body];
  const int32_t kind = world_->body[body].motion;
  const Vec3 v = vec(world_->V_WB[body].v), w = vec(world_->V_WB[body].w);
  t.step = step_;
  t.stands = false;
  const Pose X(world_->X_WB[body]);
  if (kind == SWAGE_MOTION_DYNAMIC || kind == SWAGE_MOTION_HINGED) {
    t.X0 = motion_->X0[body];
    set_pose(t, X);
    return;
  }
  // the twist of a kinematic body gives its pose at the start
  t.X = t.X0 = X;
  t.F = Frame(X);
  t.a = h_ * w;
  t.stands = v.isZero(0) && w.isZero(0);
  if (t.stands) return;
  const Quat undo = turn(-t.a);
  t.X0 = Pose(X.p - h_ * v, undo * X.q);
  t.back = undo.toRotationMatrix();
}

void Placement::prepare_block(uint32_t block) noexcept {
  DofBlock& m = block_[block];
  block_step_[block] = step_;
  const double per_hh = 1 / (h_ * h_);
  switch (m.kind) {
    case DofBlock::Kind::kRigid: {
      const RigidMass& mass = motion_->mass[m.index];
      const Trial& t = trial_[m.index];
      m.m_hh = mass.mass * per_hh;
      m.x = t.X.p - t.X0.p - h_ * motion_->v_free[m.index];
      const Quat& q0 = t.X0.q;
      const Vec3 L0 = q0 * mass.I.cwiseProduct(q0.conjugate() * motion_->w0[m.index]);
      m.b = L0 / h_ + vec(world_->F_B_W[m.index].t);
      turn_inertia(m);
      break;
    }
    case DofBlock::Kind::kHinge: {
      const scene::HingeInfo& info = world_->hinge[m.index];
      const Pose X_WP(world_->X_WB[info.parent]);
      m.axis = X_WP.q * vec(info.axis), m.anchor = X_WP * vec(info.anchor);
      m.drive = motion_->drive[m.index];
      m.m_hh = m.drive.inertia_hh;
      m.angle = world_->hinge_angle[m.index] - motion_->q0[m.index];
      break;
    }
    case DofBlock::Kind::kParticle:
      m.m_hh = world_->particle_mass[m.index] * per_hh;
      m.x = p_[m.index] - motion_->p0[m.index] - h_ * motion_->v_free_p[m.index];
      break;
    case DofBlock::Kind::kBanded:
    case DofBlock::Kind::kFlexible:
      break;
  }
}

/// Updates the inertia in W to the present attitude.
void Placement::turn_inertia(DofBlock& m) noexcept {
  const RigidMass& mass = motion_->mass[m.index];
  const Trial& t = trial_[m.index];
  const double hh = h_ * h_;
  m.a = t.a;
  m.I_hh = t.F.R * (mass.I / hh).asDiagonal() * t.F.R.transpose();
  m.inv_I_hh = t.F.R * (hh * mass.inv_I).asDiagonal() * t.F.R.transpose();
}

void Placement::set_pose(Trial& t, const Pose& X) noexcept {
  t.X = X;
  t.F = Frame(X);
  const Quat turned = X.q * t.X0.q.conjugate();
  t.a = rotation_vector(turned);
  t.back = turned.conjugate().toRotationMatrix();
}

Frame Placement::frame(const Side& side) const noexcept {
  return side.particle != kNone ? Frame(p_[side.particle], Mat3::Identity()) : trial_[side.body].F;
}

Vec3 Placement::displacement(const Side& side, const Vec3& p_W) const noexcept {
  if (side.particle != kNone) return p_[side.particle] - motion_->p0[side.particle];
  if (is_banded(side.block))
    return advanced(side) + block_[side.block].band->moved(side.place, turn_about_itself(side, p_W));
  if (is_flexible(side.block) && side.point != kNone)
    return flexible_.displacement(side.block - first_flexible_, side.point);
  return carried(side, p_W);
}

/// Displacement of a point of a body from the start of the step to its pose.
Vec3 Placement::carried(const Trial& t, const Vec3& p_W) noexcept {
  if (t.stands) return Vec3::Zero();
  const Vec3 r = p_W - t.X.p;
  return (t.X.p - t.X0.p) + (r - t.back * r);
}

/// The same for a place on a body's surface; a chain moves with its vertices, and a segment tilts with its two ends.
Vec3 Placement::carried(const Side& side, const Vec3& p_W) const noexcept {
  if (side.chain == kNone) return carried(trial_[side.body], p_W);
  const scene::ChainView chain(*world_, world_->chain[side.chain]);
  const uint32_t i = side.place.segment;
  const double t = side.place.share;
  const Vec3 p0 = chain.p(i), p1 = chain.p(i + 1), v0 = chain.v(i), v1 = chain.v(i + 1);
  const Vec3 u = p1 - p0, turn = u.cross(v1 - v0) / u.squaredNorm();
  return h_ * ((1 - t) * v0 + t * v1 + turn.cross(p_W - (p0 + t * u)));
}

void Placement::expect(const Side& side, const Vec3& p_W) noexcept {
  flexible_.expect(side.block - first_flexible_, side.point, carried(side, p_W));
}

/// Displacement of the centre line over the step, to where it advanced. The surface displacement by the tilt of a segment is left out, as
/// in the unknowns: with it, but without its derivative, segments that slide over an edge would rock on it.
Vec3 Placement::advanced(const Side& side) const noexcept {
  const scene::ChainView chain(*world_, world_->chain[side.chain]);
  const double t = side.place.share;
  return h_ * ((1 - t) * chain.v(side.place.segment) + t * chain.v(side.place.segment + 1));
}

/// Displacement of a band's point per rotation of its segment about its axis [m/rad]. A tie uses the place at which its point was added:
/// its present place may be far from where the band advanced to, as its other side has moved.
Vec3 Placement::turn_about_itself(const Side& side, const Vec3& p_W) const noexcept {
  const scene::ChainView chain(*world_, world_->chain[side.chain]);
  const Vec3 p0 = chain.p(side.place.segment), u = chain.p(side.place.segment + 1) - p0;
  const Vec3 p = side.tied && side.point != kNone ? flexible_.place(block_[side.block].index, side.point) : p_W;
  return u.normalized().cross(p - (p0 + side.place.share * u));
}

Vec3 Placement::prediction_error_at(const Side& side, const Vec3& p_W) const noexcept {
  if (is_banded(side.block)) return block_[side.block].band->moved(side.place, turn_about_itself(side, p_W));
  return flexible_.displacement(side.block - first_flexible_, side.point) - carried(side, p_W);
}

Vec3 Placement::free_prediction_error_at(const Side& side, const Vec3& p_W) const noexcept {
  if (is_banded(side.block))
    return block_[side.block].band->moved_free(side.place, turn_about_itself(side, p_W));
  return flexible_.u_free(side.block - first_flexible_, side.point) - carried(side, p_W);
}

Vec3 Placement::off_prediction(const Side& side, const Vec3& p_W) const noexcept {
  if (is_flexible(side.block)) return side.point != kNone ? prediction_error_at(side, p_W) : Vec3::Zero();
  if (side.body == kNone || side.block == kNone) return Vec3::Zero();
  return p_W - Frame(world_->X_WB[side.body]) * trial_[side.body].F.inverse_times(p_W);
}

double Placement::radius(const Side& side) const noexcept {
  return scene::ChainView(*world_, world_->chain[side.chain]).radius(side.place.segment);
}

Vec3 Placement::rotation(const Side& side, bool& known) const noexcept {
  known = side.body != kNone && !is_flexible(side.block);
  return known ? trial_[side.body].a : Vec3::Zero();
}

Placement::Columns Placement::columns(const Side& side) const noexcept {
  if (!moves(side.block)) return {};
  if (is_banded(side.block)) return {BandedBody::kOfPoint, BandedBody::kUnknowns * side.place.segment};
  return {block_[side.block].size, 0};
}

void Placement::columns(const Side& side, const Vec3& p_W, const Vec3& e, double sign,
                        double* J) const noexcept {
  const DofBlock& m = block_[side.block];
  switch (m.kind) {
    case DofBlock::Kind::kRigid: {
      // u = d + w x r: e . u = e . d + (r x e) . w
      const Vec3 moment = (p_W - trial_[side.body].X.p).cross(e);
      for (int i = 0; i < 3; ++i) J[i] = sign * e[i], J[3 + i] = sign * moment[i];
      break;
    }
    case DofBlock::Kind::kHinge:
      J[0] = sign * m.axis.cross(p_W - m.anchor).dot(e);
      break;
    case DofBlock::Kind::kParticle:
      for (int i = 0; i < 3; ++i) J[i] = sign * e[i];
      break;
    case DofBlock::Kind::kBanded: {
      const double s = side.place.share;
      for (int i = 0; i < 3; ++i) J[i] = sign * (1 - s) * e[i], J[4 + i] = sign * s * e[i];
      J[3] = sign * turn_about_itself(side, p_W).dot(e);
      J[7] = 0;
      break;
    }
    case DofBlock::Kind::kFlexible:  // contact_space.hpp
      break;
  }
}

void Placement::move(uint32_t block, const double* d) noexcept {
  DofBlock& m = block_[block];
  switch (m.kind) {
    case DofBlock::Kind::kRigid: {
      Trial& t = trial_[m.index];
      const Vec3 dp(d[0], d[1], d[2]);
      Quat q = turn(Vec3(d[3], d[4], d[5])) * t.X.q;
      renormalise(q);
      set_pose(t, Pose(t.X.p + dp, q));
      m.x += dp;
      turn_inertia(m);
      break;
    }
    case DofBlock::Kind::kHinge: {
      m.angle += d[0];
      const scene::HingeInfo& info = world_->hinge[m.index];
      const Pose X_WP(world_->X_WB[info.parent]);
      set_pose(trial_[info.child], scene::hinged(info, X_WP, motion_->q0[m.index] + m.angle));
      break;
    }
    case DofBlock::Kind::kParticle: {
      const Vec3 dp(d[0], d[1], d[2]);
      p_[m.index] += dp;
      m.x += dp;
      break;
    }
    case DofBlock::Kind::kBanded:
      m.band->go(d);
      break;
    case DofBlock::Kind::kFlexible:
      break;
  }
}

bool Placement::release(uint32_t block) noexcept {
  DofBlock& m = block_[block];
  switch (m.kind) {
    case DofBlock::Kind::kRigid:
      if (!motion_->held_body[m.index]) return false;
      set_pose(trial_[m.index], motion_->X_free[m.index]);
      break;
    case DofBlock::Kind::kHinge: {
      if (!motion_->held_hinge[m.index]) return false;
      const scene::HingeInfo& info = world_->hinge[m.index];
      m.angle = motion_->q_free[m.index] - motion_->q0[m.index];
      set_pose(trial_[info.child],
               scene::hinged(info, Pose(world_->X_WB[info.parent]), motion_->q_free[m.index]));
      return true;
    }
    case DofBlock::Kind::kParticle:
      if (!motion_->held_particle[m.index]) return false;
      p_[m.index] = motion_->p_free[m.index];
      break;
    case DofBlock::Kind::kBanded:
    case DofBlock::Kind::kFlexible:
      return flexible_.release(m.index);
  }
  prepare_block(block);
  return true;
}

}  // namespace swage::dynamics
