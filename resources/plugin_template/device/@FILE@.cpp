// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <cmath>
#include <numbers>

// [main] The place to open hardware; refuse("...") reports why that failed.
void @NAME@::open() { sequence_ = 0; }

// [rt] with LOCKSTEP, otherwise [io]. Device frame: +x right, +y up, +z towards the user, metres.
void @NAME@::exchange(const swage_command& command, swage_sample& sample) {
  const double turn = 2 * std::numbers::pi / params().period;  // rad/s
  const double angle = turn * command.time_s, r = params().radius;
  sample.sequence = ++sequence_;
  sample.time_s = command.time_s;
  sample.pose = swage::at(r * std::cos(angle), r * std::sin(angle), 0);
  sample.twist = {{-turn * r * std::sin(angle), turn * r * std::cos(angle), 0}, {0, 0, 0}};
  sample.closure = 0.5 - 0.5 * std::cos(angle);
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_CLOSURE;
}

SWAGE_EXPORT(@NAME@)
