// SPDX-License-Identifier: Apache-2.0
//
// @ID@: a hand that goes round in a circle and opens and closes.
#pragma once

#include <swage/device.hpp>

struct @NAME@Params {
  double radius = 5e-3;    // m
  double period = 2;       // s, of one turn
};

class @NAME@ final : public swage::Device<@NAME@Params> {
 public:
  static constexpr auto id = "@ID@";
  static constexpr auto version = "0.1.0";
  static constexpr auto name = "@TITLE@";
  static constexpr auto summary = "A hand that goes round in a circle and opens and closes.";
  static constexpr auto author = "Somebody";
  static constexpr auto licence = "Apache-2.0";

  // LOCKSTEP: exchange() is called in the step itself, so every run is the same to the bit. A driver of real hardware leaves the
  // flag out and is called on a thread of its own, where it may wait for its port; one that takes forces adds SWAGE_DEVICE_FORCE.
  static constexpr swage::DeviceCard card = {.flags = SWAGE_DEVICE_LOCKSTEP, .rate_hz = 1000};

  static constexpr std::array fields = {
      swage::real<&@NAME@Params::radius>("radius", "Radius", "m", "mm", 0, 0.2, "Of the circle."),
      swage::real<&@NAME@Params::period>("period", "Period", "s", "s", 0.05, 1000, "Of one turn."),
  };

  void open() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  uint64_t sequence_ = 0;
};
