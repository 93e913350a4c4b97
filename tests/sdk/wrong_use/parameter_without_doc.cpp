// SPDX-License-Identifier: Apache-2.0
// expect: a parameter needs one or two sentences
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr std::array fields{
      swage::real<&BallParams::radius>("radius", "Radius", "m", "mm", 0, 1, "")};
};
SWAGE_EXPORT(Ball)
