// SPDX-License-Identifier: Apache-2.0
//
// Placement: the end of a solve. Slows blocks that did not converge, writes poses and twists.
#include <algorithm>

#include "dynamics/placement.hpp"

namespace swage::dynamics {

using toolkit::raw;
using toolkit::vec;

double Placement::gain(uint32_t block) const noexcept {
  const DofBlock& m = block_[block];
  const uint32_t i = m.index;
  if (m.kind == DofBlock::Kind::kRigid)
    return h_ * (vec(world_->F_B_W[i].f) / motion_->mass[i].mass + vec(world_->gravity)).norm();
  return m.kind == DofBlock::Kind::kParticle
             ? 2 * (motion_->v_free_p[i] - (motion_->p_free[i] - motion_->p0[i]) / h_).norm()
             : 0.0;
}

void Placement::slow_down(uint32_t block, double speed) noexcept {
  DofBlock& m = block_[block];
  if (m.kind == DofBlock::Kind::kRigid) {
    Trial& t = trial_[m.index];
    // a body that flew has had its impulses: it stays where it landed
    if (motion_->flown[m.index]) return set_pose(t, motion_->X_free[m.index]);
    const Vec3 way = t.X.p - t.X0.p;
    const double far = way.norm();
    if (far <= h_ * speed) return;
    const double keep = h_ * speed / far;
    // a torque may turn it as far as without contacts: a body wrung out of a grip is not held back
    const double given = (m.inv_I_hh * vec(world_->F_B_W[m.index].t)).norm(), angle = t.a.norm();
    const double keep_turn = given >= angle ? 1 : std::max(keep, given / angle);
    set_pose(t, Pose(t.X0.p + keep * way, turn(keep_turn * t.a) * t.X0.q));
  } else if (m.kind == DofBlock::Kind::kParticle) {
    const Vec3 way = p_[m.index] - motion_->p0[m.index];
    const double far = way.norm();
    if (far > h_ * speed) p_[m.index] = motion_->p0[m.index] + h_ * speed / far * way;
  }
}

void Placement::write_back(std::span<const uint8_t> solved) noexcept {
  for (uint32_t i = 0; i < first_flexible_; ++i) {
    const DofBlock& m = block_[i];
    switch (m.kind) {
      case DofBlock::Kind::kRigid:
        write_body(m, solved[i]);
        break;
      case DofBlock::Kind::kHinge:
        write_hinge(m, solved[i]);
        break;
      case DofBlock::Kind::kParticle:
        write_particle(m, solved[i]);
        break;
      case DofBlock::Kind::kBanded:
      case DofBlock::Kind::kFlexible:
        break;
    }
  }
}

void Placement::write_body(const DofBlock& m, bool solved) noexcept {
  const uint32_t i = m.index;
  if (solved) {
    const Trial& t = trial_[i];
    world_->X_WB[i] = t.X.abi();
    world_->V_WB[i] = {raw(Vec3((t.X.p - t.X0.p) / h_)), raw(Vec3(t.a / h_))};
  } else {
    world_->X_WB[i] = motion_->X_free[i].abi();
    world_->V_WB[i] = {raw(motion_->v_free[i]), raw(motion_->w_free[i])};
  }
}

void Placement::write_hinge(const DofBlock& m, bool solved) noexcept {
  const double q = solved ? motion_->q0[m.index] + m.angle : motion_->q_free[m.index];
  place_hinge(*world_, *motion_, m.index, q);
}

void Placement::write_particle(const DofBlock& m, bool solved) noexcept {
  const uint32_t i = m.index;
  const Vec3 p = solved ? p_[i] : motion_->p_free[i];
  const Vec3 v = solved ? Vec3((p_[i] - motion_->p0[i]) / h_) : motion_->v_free_p[i];
  for (int k = 0; k < 3; ++k) {
    world_->particle_p_W[3 * i + static_cast<uint32_t>(k)] = p[k];
    world_->particle_v_W[3 * i + static_cast<uint32_t>(k)] = v[k];
  }
}

}  // namespace swage::dynamics
