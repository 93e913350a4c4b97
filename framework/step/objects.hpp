// SPDX-License-Identifier: Apache-2.0
//
// The objects of a scene: their views, and their calls in each phase; an object in quarantine keeps its last pose.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "host/rig.hpp"
#include "step/flexible_body_adapter.hpp"
#include "step/hands.hpp"
#include "step/write_guard.hpp"

namespace swage::step {

class Objects {
 public:
  /// [main]
  Objects(host::Rig& rig, const Hands& hands, WriteGuard& writes);

  void reset() noexcept;                 // [rt] all of them, and the world
  void reset(uint32_t object) noexcept;  // [rt] one of them
  void begin() noexcept;                 // [rt] views of this step; stores where everything was
  void forces() noexcept;                // [rt]
  void advance() noexcept;               // [rt] flexible bodies by their own mechanics
  void finish() noexcept;                // [rt]
  void freeze() noexcept;                // [rt] objects in quarantine keep their last pose
  void guard() noexcept;                 // [rt] checks the state after the solve

  std::span<const swage_object_step> views() const noexcept { return view_; }
  const swage_object_step& view(uint32_t object) const noexcept { return view_[object]; }
  std::span<dynamics::FlexibleBody* const> self() noexcept;  // flexible bodies that are not frozen
  /// True in quarantine, or out of the room (scene/room.hpp): the object keeps its last pose.
  bool frozen(uint32_t object) const noexcept {
    return gone_[object] != 0 ||
           rig_.objects[object].instance->quarantined.load(std::memory_order_relaxed) != 0;
  }

 private:
  bool left_room(uint32_t object) const noexcept;
  void put_back(uint32_t object) noexcept;
  void freeze(uint32_t object) noexcept;
  bool sound(uint32_t object, host::Call call) noexcept;
  template <class F>
  void for_chains(const host::ObjectSlot& slot, const F& each) noexcept;
  template <class Accept>
  bool sound_chains(uint32_t object, const Accept& accept) noexcept;
  void keep_chains() noexcept;
  void put_back_chains(const host::ObjectSlot& slot) noexcept;

  host::Rig& rig_;
  const double dt_ = rig_.world.dt;  // s, of a whole step
  const Hands& hands_;
  WriteGuard& writes_;
  std::vector<swage_object_step> view_;
  std::vector<uint8_t> gone_;  // out of the room at the beginning of the step
  std::vector<std::unique_ptr<FlexibleBodyAdapter>> self_;
  std::vector<dynamics::FlexibleBody*> self_now_;

  // where everything was before this step
  std::vector<swage_pose> X_WB_before_;
  std::vector<double> particle_before_, hinge_before_;
  std::vector<std::vector<double>> chain_before_;  // per chain of the world
  // at the start
  std::vector<double> particle_start_;
  std::vector<uint64_t> random_start_;
};

}  // namespace swage::step
