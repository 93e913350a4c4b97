// SPDX-License-Identifier: Apache-2.0
//
// Where everything stands while the contact solve looks for the end of the step: trial poses, the movers that change them,
// and how far each has come since the start of the step.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/motion.hpp"
#include "dynamics/mover.hpp"
#include "dynamics/self_movers.hpp"
#include "scene/world.hpp"

namespace swage::dynamics {

/// One side of a contact: a body or a particle, and what moves it.
struct Side {
  uint32_t body = scene::kNone, particle = scene::kNone;
  uint32_t mover = scene::kNone;  // index into Placement, or kNone: cannot be moved
  uint32_t point = scene::kNone;  // SELF bodies: among the points of their mover
  bool shares = false;            // it is the nearest point of another contact: there is no room for its own
};

class Placement {
 public:
  explicit Placement(const scene::World& world);

  /// Forgets the last step; bodies are looked at when a contact first names them.
  void begin(scene::World& world, Motion& motion, std::span<SelfSolver* const> self) noexcept;
  /// The side of a contact, its mover ready at the predicted pose.
  Side side(uint32_t body, uint32_t particle) noexcept;

  SelfMovers& self() noexcept { return self_; }
  const SelfMovers& self() const noexcept { return self_; }
  /// Self movers know how they give once they have been asked.
  void take_answers() noexcept;

  Mover& mover(uint32_t i) noexcept { return mover_[i]; }
  const Mover& mover(uint32_t i) const noexcept { return mover_[i]; }
  uint32_t movers() const noexcept { return static_cast<uint32_t>(mover_.size()); }
  /// Numbers of all movers together.
  uint32_t unknowns() const noexcept;
  bool is_self(uint32_t mover) const noexcept { return mover != scene::kNone && mover >= first_self_; }
  /// False for a self mover that gives nowhere.
  bool moves(uint32_t mover) const noexcept {
    return mover != scene::kNone && (!is_self(mover) || self_.gives(mover - first_self_));
  }

  toolkit::Frame frame(const Side& side) const noexcept;
  /// Displacement over the step of the material point that is now at p_W [m].
  Vec3 displacement(const Side& side, const Vec3& p_W) const noexcept;
  /// A point of a SELF body is expected in the pose that its solver wrote.
  void expect(const Side& side, const Vec3& p_W) noexcept;
  /// How far a point of a SELF body is from where it stands in the pose that its solver wrote [m].
  Vec3 beyond(const Side& side, const Vec3& p_W) const noexcept;
  /// The same of where it goes without contacts [m].
  Vec3 beyond_free(const Side& side, const Vec3& p_W) const noexcept;
  /// Rotation vector over the step [rad]; `known`: false for what has none of its own.
  Vec3 rotation(const Side& side, bool& known) const noexcept;
  /// d(displacement . e) / d(unknowns), times `sign`, into `columns` numbers at J.
  void columns(const Side& side, const Vec3& p_W, const Vec3& e, double sign, double* J) const noexcept;

  /// Adds d to the unknowns of a mover.
  void move(uint32_t mover, const double* d) noexcept;
  /// It was predicted to go on as it went, but nothing holds it: to where it goes by itself. False when it is there.
  bool let_go(uint32_t mover) noexcept;
  /// Shortens its way over the step to at most `speed` [m/s]; what the fallback of the fallback is.
  void slow_down(uint32_t mover, double speed) noexcept;
  /// Speed that the loads on it give a body's centre, or a particle, in this step where nothing touches it [m/s].
  double gain(uint32_t mover) const noexcept;
  /// Speed of the material point at p_W over the step [m/s].
  double speed(const Side& side, const Vec3& p_W) const noexcept {
    return displacement(side, p_W).norm() / h_;
  }

  /// Poses and twists of everything into the world. `solved`: per mover, whether it was in an island.
  void write_back(std::span<const uint8_t> solved) noexcept;

 private:
  struct Trial {
    uint64_t step = 0;             // for which it was prepared
    Pose X0, X;                    // at the start of the step, now
    toolkit::Frame F;              // now
    Mat3 back = Mat3::Identity();  // turns a vector of now to what it was at the start
    Vec3 a = Vec3::Zero();         // rotation over the step
    bool stands = false;           // X0 = X
  };

  void prepare(uint32_t body) noexcept;
  void prepare_mover(uint32_t mover) noexcept;
  void turn_inertia(Mover& m) noexcept;
  static Vec3 carried(const Trial& trial, const Vec3& p_W) noexcept;
  void set_pose(Trial& trial, const Pose& X) noexcept;
  void write_body(const Mover& m, bool solved) noexcept;
  void write_hinge(const Mover& m, bool solved) noexcept;
  void write_particle(const Mover& m, bool solved) noexcept;

  scene::World* world_ = nullptr;
  Motion* motion_ = nullptr;
  double h_ = 1e-3;
  uint64_t step_ = 0;
  std::vector<Trial> trial_;  // per body
  std::vector<Vec3> p_;       // per particle
  std::vector<Mover> mover_;  // per dynamic body, hinge, particle, object with SELF bodies
  std::vector<uint64_t> mover_step_;
  std::vector<uint32_t> mover_of_body_, mover_of_particle_;
  uint32_t first_self_ = 0;
  SelfMovers self_;
};

}  // namespace swage::dynamics
