// SPDX-License-Identifier: Apache-2.0
// expect: override
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  void forces(swage::Step& step) override { step.add_force(swage::Body(0), {0, 0, 1}); }
};
SWAGE_EXPORT(Ball)
