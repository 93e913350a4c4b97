// SPDX-License-Identifier: Apache-2.0
//
// swage.device.openxr: the controller of a VR headset as a hand, without images in the headset. See openxr.md.
#pragma once

#include <swage/device.hpp>

#include <memory>
#include <optional>

#include "runtime.hpp"

namespace swage::openxr {

enum class Side : int32_t { kLeft, kRight };

struct OpenxrParams {
  Side side = Side::kRight;
  swage_vec3 start = {0, 0, 0};  // m
  bool jaws = true;
};

inline constexpr const char* kSideNames[] = {"left", "right", nullptr};

class Openxr final : public Device<OpenxrParams> {
 public:
  using P = OpenxrParams;
  static constexpr auto id = "swage.device.openxr";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "VR controller (OpenXR)";
  static constexpr auto summary = "The controller of a VR headset leads the instrument, its trigger closes the jaws.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.rate_hz = 250};

  static constexpr std::array fields = {
      choice<&P::side>("side", "Hand", kSideNames, "Whose controller leads this instrument; both make two instruments."),
      vector<&P::start>("start", "Start at", "m", "mm", -1, 1, "Where the place at which the controller is first seen lies in the device's frame."),
      boolean<&P::jaws>("jaws", "Jaws", "The trigger closes the jaws; otherwise the jaws are another device's."),
  };

  void open() override;
  void close() override { runtime_.reset(); }
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  std::shared_ptr<Runtime> runtime_;
  std::optional<Vec3> first_;  // m, first known position of the controller
  double tried_s_ = 0;
};

}  // namespace swage::openxr
