// SPDX-License-Identifier: Apache-2.0
//
// The connection of this process to the OpenXR runtime. A process can have one; the devices of both hands share it.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "actions.hpp"
#include "toolkit/math.hpp"

namespace swage::openxr {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// State of one controller, in the runtime's local space: x right, y up, z towards the user, as in the device frame.
struct Controller {
  bool tracked = false;  // pose is measured, not estimated
  bool moving = false;   // v and w are measured
  Pose X_DA;             // A: the aim pose, pointing along its -z
  Vec3 v_D = Vec3::Zero(), w_D = Vec3::Zero();  // m/s, rad/s
  double trigger = 0;    // 0..1
  uint32_t buttons = 0;
  double time_s = 0;     // CLOCK_MONOTONIC
};

class Runtime {
 public:
  /// The existing connection or a new one; nullptr and the reason, a sentence with the remedy. It ends with its last owner. [main or io]
  static std::shared_ptr<Runtime> share(std::string& why);
  ~Runtime();
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;

  /// `side`: 0 left, 1 right. False: the runtime has ended, and a new connection is needed. [main or io]
  bool read(int side, Controller& out);
  const std::string& name() const { return name_; }

 private:
  Runtime() = default;
  bool connect(std::string& why);
  void hear_events();
  bool good(XrResult result);
  void read_controller(int side, Controller& out);
  uint32_t buttons(int side);

  std::mutex lock_;  // protects everything below
  Xr xr_{};
  XrInstance instance_ = XR_NULL_HANDLE;
  XrSession session_ = XR_NULL_HANDLE;
  XrSpace local_ = XR_NULL_HANDLE;
  Actions actions_;
  std::string name_;
  bool running_ = false, lost_ = false;
};

}  // namespace swage::openxr
