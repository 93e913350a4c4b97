// SPDX-License-Identifier: Apache-2.0
//
// A driver whose hardware is always there and which tells of itself what FAULT says: a number, what is not known, what is infinite.
#include <swage/device_signals.hpp>

#include <time.h>

#include <array>
#include <cmath>
#include <limits>

namespace {

class Tells final : public swage::TellingDevice<swage::NoParams> {
 public:
  using P = swage::NoParams;
  static constexpr auto id = ID;
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Tells";
  static constexpr auto summary = "Tells of itself what it must not.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr swage::DeviceCard card{.rate_hz = 1000};

  void exchange(const swage_command&, swage_sample& sample) override {
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    sample.sequence += 1;
    sample.time_s = static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    sample.pose = swage::at(0, 0, 0);
    sample.valid = SWAGE_VALID_POSE;
  }
  static constexpr std::array told{swage::DeviceSignal{"tells.value", "1", "What it tells."}};
  void tell(std::span<double> out) override { out[0] = FAULT; }
};

}  // namespace

SWAGE_EXPORT(Tells)
