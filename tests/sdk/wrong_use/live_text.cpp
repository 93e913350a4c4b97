// SPDX-License-Identifier: Apache-2.0
// expect: a text cannot be live
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  static constexpr std::array fields{
      swage::text<&BallParams::words>("words", "Words", "What it says.").live()};
};
SWAGE_EXPORT(Ball)
