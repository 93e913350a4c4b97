// SPDX-License-Identifier: Apache-2.0
// expect: swage::integer needs an integer
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr std::array fields{
      swage::integer<&BallParams::radius>("radius", "Radius", 0, 1, "How wide.")};
};
SWAGE_EXPORT(Ball)
