// SPDX-License-Identifier: Apache-2.0
//
// Trial poses of the contact solve, the blocks that change them, and displacements since the start of the
// step.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "dynamics/dof_block.hpp"
#include "dynamics/flexible_bodies.hpp"
#include "dynamics/motion.hpp"
#include "scene/world.hpp"

namespace swage::dynamics {

/// One side of a contact or tie: a body or a particle, and the block that moves it.
struct Side {
  uint32_t body = scene::kNone, particle = scene::kNone;
  uint32_t block = scene::kNone;  // index into Placement, or kNone: cannot be moved
  uint32_t point = scene::kNone;  // flexible bodies: index among the points of their block
  uint32_t chain = scene::kNone;  // chain of the world, where the body's surface is that of a chain
  contact::ChainPlace place;      // place on that chain
  bool tied = false;              // side of a tie, not of a contact
  bool shares = false;            // shares the point of another contact: there was no room for its own
};

class Placement {
 public:
  explicit Placement(const scene::World& world);

  /// Forgets the last step. A body is prepared when a contact first names it.
  void begin(scene::World& world, Motion& motion, std::span<FlexibleBody* const> self) noexcept;
  /// Returns the side of a contact, its block prepared at the predicted pose.
  Side side(uint32_t body, uint32_t particle) noexcept;
  /// The same for a place on a chain.
  Side side(uint32_t body, uint32_t particle, uint32_t shape, const contact::ChainPlace& place) noexcept;

  /// Returns the side of a tie at p_W; on a body with a chain, at the nearest place of the chain.
  Side tied_side(uint32_t body, const Vec3& p_W) noexcept;

  FlexibleBodies& flexible() noexcept { return flexible_; }
  const FlexibleBodies& flexible() const noexcept { return flexible_; }
  /// Copies the mobilities that flexible bodies answered in this step to their blocks.
  void take_answers() noexcept;

  DofBlock& block(uint32_t i) noexcept { return block_[i]; }
  const DofBlock& block(uint32_t i) const noexcept { return block_[i]; }
  uint32_t blocks() const noexcept { return static_cast<uint32_t>(block_.size()); }
  /// Number of unknowns of all blocks together.
  uint32_t unknowns() const noexcept;
  bool is_flexible(uint32_t block) const noexcept {
    return block != scene::kNone && block >= first_flexible_;
  }
  /// A flexible body that is a band: it has unknowns.
  bool is_banded(uint32_t block) const noexcept {
    return is_flexible(block) && block_[block].kind == DofBlock::Kind::kBanded;
  }
  /// False for kNone and for a flexible block that cannot move.
  bool moves(uint32_t block) const noexcept {
    return block != scene::kNone && (!is_flexible(block) || flexible_.gives(block - first_flexible_));
  }

  toolkit::Frame frame(const Side& side) const noexcept;
  /// Displacement over the step of the material point at p_W [m].
  Vec3 displacement(const Side& side, const Vec3& p_W) const noexcept;
  /// Sets the expected displacement of a flexible body's point: to its place in the pose that the body's solver wrote.
  void expect(const Side& side, const Vec3& p_W) noexcept;
  /// Displacement of a flexible body's point from its place in the pose that the body's solver wrote [m].
  Vec3 prediction_error_at(const Side& side, const Vec3& p_W) const noexcept;
  /// The same for the displacement of the point without contacts [m].
  Vec3 free_prediction_error_at(const Side& side, const Vec3& p_W) const noexcept;
  const scene::World& world() const { return *world_; }
  /// Rotation vector over the step [rad]; `known`: false for particles, flexible bodies and the world, which have none.
  Vec3 rotation(const Side& side, bool& known) const noexcept;
  /// Displacement of a place of any side from where contacts were detected [m].
  Vec3 off_prediction(const Side& side, const Vec3& p_W) const noexcept;
  /// Radius of the chain at a side [m]; 0 where the chain is cut.
  double radius(const Side& side) const noexcept;
  /// Unknowns that move a side: `size` of them, from `offset` on among those of its block.
  struct Columns {
    uint32_t size = 0, offset = 0;
  };
  Columns columns(const Side& side) const noexcept;
  /// d(displacement . e) / d(unknowns), times `sign`, into as many numbers at J.
  void columns(const Side& side, const Vec3& p_W, const Vec3& e, double sign, double* J) const noexcept;

  /// Adds d to the unknowns of a block.
  void move(uint32_t block, const double* d) noexcept;
  /// Moves a block that was predicted as held, but is not, to its free pose. False when it is there.
  bool release(uint32_t block) noexcept;
  /// Limits the velocity of a block over the step to `speed` [m/s]: the last fallback.
  void slow_down(uint32_t block, double speed) noexcept;
  /// Speed that its loads would give a body's centre, or a particle, in this step without contacts [m/s].
  double gain(uint32_t block) const noexcept;
  /// Speed of the material point at p_W over the step [m/s].
  double speed(const Side& side, const Vec3& p_W) const noexcept {
    return displacement(side, p_W).norm() / h_;
  }

  /// Writes poses and twists of all blocks to the world. `solved`: per block, whether it was in an island.
  void write_back(std::span<const uint8_t> solved) noexcept;

 private:
  struct Trial {
    uint64_t step = 0;             // step for which it was prepared
    Pose X0, X;                    // at the start of the step, now
    toolkit::Frame F;              // now
    Mat3 back = Mat3::Identity();  // rotates a vector from the present attitude to that at the start
    Vec3 a = Vec3::Zero();         // rotation over the step
    bool stands = false;           // X0 = X
  };

  void prepare(uint32_t body) noexcept;
  void prepare_block(uint32_t block) noexcept;
  void turn_inertia(DofBlock& m) noexcept;
  Vec3 advanced(const Side& side) const noexcept;
  Vec3 turn_about_itself(const Side& side, const Vec3& p_W) const noexcept;
  static Vec3 carried(const Trial& trial, const Vec3& p_W) noexcept;
  Vec3 carried(const Side& side, const Vec3& p_W) const noexcept;
  void set_pose(Trial& trial, const Pose& X) noexcept;
  void write_body(const DofBlock& m, bool solved) noexcept;
  void write_hinge(const DofBlock& m, bool solved) noexcept;
  void write_particle(const DofBlock& m, bool solved) noexcept;

  scene::World* world_ = nullptr;
  Motion* motion_ = nullptr;
  double h_ = 1e-3;
  uint64_t step_ = 0;
  std::vector<Trial> trial_;     // per body
  std::vector<Vec3> p_;          // per particle
  std::vector<DofBlock> block_;  // per dynamic body, hinge, particle, object with flexible bodies
  std::vector<uint64_t> block_step_;
  std::vector<uint32_t> block_of_body_, block_of_particle_;
  std::vector<uint32_t> chain_of_body_;  // of the world, or kNone
  uint32_t first_flexible_ = 0;
  FlexibleBodies flexible_;
};

}  // namespace swage::dynamics
