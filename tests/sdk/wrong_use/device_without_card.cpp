// SPDX-License-Identifier: Apache-2.0
// expect: a device says what it can
#include "plugins.hpp"

class Pen final : public swage::Device<>, public Said {
 public:
  void exchange(const swage_command&, swage_sample&) override {}
};
SWAGE_EXPORT(Pen)
