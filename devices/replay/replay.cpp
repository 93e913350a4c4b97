// SPDX-License-Identifier: Apache-2.0
#include "replay.hpp"

#include <exception>

namespace swage::replay {

void Replay::build(const ReplayParams& params, DeviceBuilder& builder) {
  params_ = params;
  try {
    hand_ = hand::load_hand(params.file);
    if (!hand_.sampled)
      builder.error("file", "this file has key poses, not samples; swage.device.scripted plays it");
  } catch (const std::exception& problem) {
    builder.error("file", problem.what());
  }
}

void Replay::exchange(const swage_command& command, swage_sample& sample) {
  const double t = params_.start + command.time_s;
  const bool linear = params_.between == Steps::kLinear;
  const hand::Moment m = hand_.at(t, linear ? hand::Between::kLinear : hand::Between::kHold);

  sample.sequence += 1;
  sample.time_s = command.time_s;
  sample.pose = m.X_WT.abi();
  sample.twist = {toolkit::raw(m.v_W), toolkit::raw(m.w_W)};
  sample.closure = m.closure;
  sample.grip_force = m.grip;
  sample.buttons = 0;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  if (linear) sample.valid |= SWAGE_VALID_TWIST;
  if (hand_.has_grip) sample.valid |= SWAGE_VALID_GRIP;
  if (t >= hand_.duration()) sample.valid |= SWAGE_VALID_DONE;
}

}  // namespace swage::replay

SWAGE_EXPORT(swage::replay::Replay)
