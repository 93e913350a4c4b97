// SPDX-License-Identifier: Apache-2.0
// expect: max_force is above zero exactly when the device takes forces
#include "plugins.hpp"

class Pen final : public swage::Device<>, public Said {
 public:
  static constexpr swage::DeviceCard card{.flags = SWAGE_DEVICE_FORCE, .rate_hz = 1000};
  void exchange(const swage_command&, swage_sample&) override {}
};
SWAGE_EXPORT(Pen)
