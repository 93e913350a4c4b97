// SPDX-License-Identifier: Apache-2.0
// expect: min must not be above max|not a constant expression|not a constant
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr std::array fields{
      swage::real<&BallParams::radius>("radius", "Radius", "m", "mm", 2, 1, "How wide.")};
};
SWAGE_EXPORT(Ball)
