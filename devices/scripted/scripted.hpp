// SPDX-License-Identifier: Apache-2.0
//
// swage.device.scripted: a hand that follows a file, with or without human errors. See scripted.md.
#pragma once

#include <swage/device.hpp>

#include <string>

#include "hand/hand.hpp"
#include "hand/tremor.hpp"

namespace swage::scripted {

using toolkit::Vec3;

struct ScriptedParams {
  std::string file;
  double speed = 1;
  double delay = 0;                // s
  double tremor = 0;               // m
  Interval tremor_band = {8, 12};  // Hz
  double spot_error = 0;           // m
};

class Scripted final : public Device<ScriptedParams> {
 public:
  static constexpr auto id = "swage.device.scripted";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Scripted hand";
  static constexpr auto summary =
      "Follows key poses from a file with minimum-jerk motion; tremor and misplacement can be added, drawn "
      "from the seed.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD | SWAGE_DEVICE_SCRIPTED};

  static constexpr std::array fields = {
      file<&ScriptedParams::file>("file", "Hand file", "File of key poses, format swage-hand/1.").required(),
      real<&ScriptedParams::speed>("speed", "Speed", "1", "1", 0.05, 20,
                                   "1 plays the file as written, 2 twice as fast."),
      real<&ScriptedParams::delay>("delay", "Delay", "s", "s", 0, 60, "Rests at the first pose for so long."),
      real<&ScriptedParams::tremor>(
          "tremor", "Tremor", "m", "um", 0, 2e-3,
          "Root mean square of the shaking, as a length in the scene. Eye surgeons at work: "
          "about 38 um.")
          .group("Flaws"),
      interval<&ScriptedParams::tremor_band>("tremor_band", "Tremor band", "Hz", "Hz", 0.1, 100,
                                             "Lowest and highest frequency of the shaking.")
          .group("Flaws"),
      real<&ScriptedParams::spot_error>("spot_error", "Spot error", "m", "um", 0, 5e-3,
                                        "Root mean square of a displacement that is drawn once and stays.")
          .group("Flaws"),
  };

  void build(const ScriptedParams& params, DeviceBuilder& builder) override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  void draw();

  ScriptedParams params_;
  hand::Hand hand_;
  hand::Tremor tremor_;
  Vec3 spot_error_W_ = Vec3::Zero();
  bool drawn_ = false;
};

}  // namespace swage::scripted
