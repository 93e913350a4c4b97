// SPDX-License-Identifier: Apache-2.0
// expect: an id is a reverse domain
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr auto id = "ball";
};
SWAGE_EXPORT(Ball)
