// SPDX-License-Identifier: Apache-2.0
//
// From devices to tools: samples, the hand in the scene, and bodies that follow it, limited in speed and swept.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/contact_set.hpp"
#include "host/rig.hpp"
#include "scene/state_image.hpp"
#include "step/device_port.hpp"
#include "step/hand_filter.hpp"
#include "step/tool_proxy.hpp"
#include "step/write_guard.hpp"
#include "toolkit/math.hpp"

namespace swage::step {

class Hands {
 public:
  /// `ports`: as in Engine. [main]
  Hands(host::Rig& rig, std::vector<DevicePort*> ports);

  void reset() noexcept;                                    // [rt]
  /// Sets the pointer and keys that devices read from now on, as given in the displayed picture. [rt]
  void point(const swage_pointer& pointer) noexcept;
  bool see() const noexcept;                                // whether a device sees the scene
  /// Shows the scene to the devices that take it; a device that writes into it is at fault. `writes` has just been taken. [rt]
  void look(const swage_sight& sight, WriteGuard& writes) noexcept;
  void read(WriteGuard& writes) noexcept;  // [rt] newest sample of every device
  void follow() noexcept;                                   // [rt] moves tools towards their hands
  void send(const contact::ContactSet& contacts) noexcept;  // [rt] forces on the tools

  const swage_input* input(uint32_t object) const noexcept;  // nullptr when no device is bound
  std::span<const swage_sample> samples() const noexcept { return sample_; }
  std::span<const swage_pose> hands() const noexcept { return X_WD_; }
  std::size_t image_size() const;                // [main]
  void save(scene::Writer& out) const noexcept;  // [main or rt] last samples and hands
  bool restore(scene::Reader& in) noexcept;
  /// True when every hand has ended its script or is in quarantine: of two that work together one may end first.
  bool gone() const noexcept;

 private:
  /// Values held while a device gives nothing valid, and how its hand is matched again afterwards. Plain words, saved with the state.
  struct Hold {
    uint64_t known = 0;                       // SWAGE_VALID_* that it has ever given, of pose, closure and grip
    uint64_t pose_gone = 0, closure_gone = 0; // steps since each was last given
    uint64_t clutched = 0;                    // 1: p and q below are the offset between device and hand
    uint64_t meeting = 0;                     // 1: the closure is held until the person's meets it, coming from below; 2: from above
    swage_vec3 p{};                           // m, added to the device's place
    swage_quat q{1, 0, 0, 0};                 // after the device's rotation
    double closure = 0, grip = 0;             // as used
  };
  bool usable(uint32_t device) const noexcept;
  void place(uint32_t device) noexcept;
  bool clutched(uint32_t device) const noexcept;
  bool returns(uint32_t device) const noexcept;
  void meet_pose(uint32_t device, swage_pose& X_WD) noexcept;
  void hold_closure(uint32_t device) noexcept;
  void map_input(uint32_t object) noexcept;
  void lead(uint32_t object) noexcept;
  struct Felt {
    toolkit::Pose X_WT;  // the tool
    toolkit::Vec3 behind_W = toolkit::Vec3::Zero();  // m, from the hand to the tool
    swage_twist V_WT{};
    toolkit::Vec3 f_W = toolkit::Vec3::Zero(), t_W = toolkit::Vec3::Zero();  // N, N m about the tool's origin
  };
  Felt felt(uint32_t device, const contact::ContactSet& contacts) const noexcept;
  static Felt mirrored(const Felt& tool) noexcept;
  ToolForce to_hand(uint32_t device, const Felt& tool) const noexcept;

  host::Rig& rig_;
  ToolProxy stops_;
  std::vector<std::unique_ptr<DevicePort>> own_;
  std::vector<DevicePort*> port_;
  std::vector<swage_sample> sample_;  // of each device, as used in this step
  std::vector<swage_pose> X_WD_;      // of each device: the hand in the scene, last valid one
  std::vector<uint8_t> seen_;         // of each device: it has given a valid pose
  std::vector<Hold> hold_;            // of each device
  std::vector<FilterMemory> filter_;  // of each device; empty where no device is filtered, and then not in the saved state
  std::vector<swage_input> input_;    // of each object
  std::vector<swage_pose> X_OB_;      // of each body: as declared in its object
};

}  // namespace swage::step
