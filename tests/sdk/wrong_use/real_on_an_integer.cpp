// SPDX-License-Identifier: Apache-2.0
// expect: swage::real needs a double
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr std::array fields{
      swage::real<&BallParams::count>("count", "Count", "1", "1", 0, 1, "How many.")};
};
SWAGE_EXPORT(Ball)
