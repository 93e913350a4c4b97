// SPDX-License-Identifier: Apache-2.0
//
// swage.device.openhaptics: an arm with force feedback (Touch, Touch X, Omni, Phantom Desktop). See openhaptics.md.
#pragma once

#include <swage/device.hpp>

#include <string>

#include "servo.hpp"

namespace swage::openhaptics {

struct OpenhapticsParams {
  std::string device, library;
  bool jaws = true;
  double close_time = 1.5;  // s
};

class Openhaptics final : public Device<OpenhapticsParams> {
 public:
  using P = OpenhapticsParams;
  static constexpr auto id = "swage.device.openhaptics";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Haptic arm (OpenHaptics)";
  static constexpr auto summary = "The stylus of a Touch, Touch X, Omni or Phantom Desktop leads the instrument and gives forces back.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  // the strongest model; a Touch reports less
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_FORCE, .rate_hz = 1000, .max_force = 7.9};

  static constexpr std::array fields = {
      text<&P::device>("device", "Device", "Name of the arm in its maker's setup; empty: the default one."),
      text<&P::library>("library", "Library", "File of libHD.so; empty: where the system finds it.").hidden(),
      boolean<&P::jaws>("jaws", "Jaws", "The first button closes the jaws and the second opens them; otherwise the jaws are another device's."),
      real<&P::close_time>("close_time", "Closing time", "s", "s", 0.05, 60, "From open to closed while the button is down.").live(),
  };

  void open() override;
  void close() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  bool reach(std::string& why);
  unsigned init(std::string& why);
  void drain();

  const Hd* hd_ = nullptr;
  unsigned device_ = kBadHandle;
  unsigned long callback_ = 0;
  bool scheduled_ = false;
  Servo servo_;
  Measured last_;
  double closure_ = 0, last_s_ = 0, tried_s_ = 0;
};

}  // namespace swage::openhaptics
