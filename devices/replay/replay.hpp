// SPDX-License-Identifier: Apache-2.0
//
// swage.device.replay: plays recorded samples of a hand. See replay.md.
#pragma once

#include <swage/device.hpp>

#include <string>

#include "hand/hand.hpp"

namespace swage::replay {

enum class Steps : int { kHold, kLinear };

struct ReplayParams {
  std::string file;
  Steps between = Steps::kHold;
  double start = 0;  // s
};

class Replay final : public Device<ReplayParams> {
 public:
  static constexpr auto id = "swage.device.replay";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Replayed hand";
  static constexpr auto summary =
      "Plays recorded samples of a hand; held between samples, the same numbers come out again.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD | SWAGE_DEVICE_SCRIPTED};

  static constexpr const char* kSteps[] = {"hold", "linear", nullptr};
  static constexpr std::array fields = {
      file<&ReplayParams::file>("file", "Hand file", "File of samples, format swage-hand/1.").required(),
      choice<&ReplayParams::between>(
          "between", "Between samples", kSteps,
          "Hold: the last sample, exactly. Linear: straight to the next, for samples that are "
          "rarer than steps."),
      real<&ReplayParams::start>("start", "Start at", "s", "s", 0, 36000, "Skips the beginning of the file."),
  };

  void build(const ReplayParams& params, DeviceBuilder& builder) override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  ReplayParams params_;
  hand::Hand hand_;
};

}  // namespace swage::replay
