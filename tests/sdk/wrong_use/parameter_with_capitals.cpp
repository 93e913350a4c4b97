// SPDX-License-Identifier: Apache-2.0
// expect: the id of a parameter is snake_case
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr std::array fields{
      swage::real<&BallParams::radius>("ballRadius", "Radius", "m", "mm", 0, 1, "How wide.")};
};
SWAGE_EXPORT(Ball)
