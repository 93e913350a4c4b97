// SPDX-License-Identifier: Apache-2.0
// expect: a version is three numbers
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr auto version = "1.0";
};
SWAGE_EXPORT(Ball)
