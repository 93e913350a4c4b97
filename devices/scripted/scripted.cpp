// SPDX-License-Identifier: Apache-2.0
#include "scripted.hpp"

#include <cmath>
#include <exception>
#include <numbers>

#include "hand/sentences.hpp"

namespace swage::scripted {

void Scripted::build(const ScriptedParams& params, DeviceBuilder& builder) {
  params_ = params;
  if (params.tremor_band.low >= params.tremor_band.high) {
    builder.error("tremor_band", hand::say::kTremorBand());
  }
  try {
    hand_ = hand::load_hand(params.file);
  } catch (const std::exception& problem) {
    builder.error("file", problem.what());
  }
}

void Scripted::draw() {
  const auto uniform = [this] { return random(); };
  tremor_.draw(params_.tremor, params_.tremor_band.low, params_.tremor_band.high, uniform);

  // three normally distributed numbers by Box and Muller; 1 - random() is never 0
  for (int k = 0; k < 3; ++k) {
    const double r = std::sqrt(-2 * std::log(1 - random()));
    spot_error_W_[k] = params_.spot_error / std::sqrt(3.0) * r * std::cos(2 * std::numbers::pi * random());
  }
  drawn_ = true;
}

void Scripted::exchange(const swage_command& command, swage_sample& sample) {
  if (!drawn_) draw();
  const double t = params_.speed * (command.time_s - params_.delay);
  const hand::Moment m = hand_.at(t, hand_.sampled ? hand::Between::kLinear : hand::Between::kMinimumJerk);

  Vec3 shake, shake_rate;
  tremor_.at(command.time_s, shake, shake_rate);
  sample.sequence += 1;
  sample.time_s = command.time_s;
  sample.pose.p = toolkit::raw(Vec3(m.X_WT.p + shake + spot_error_W_));
  sample.pose.q = toolkit::raw(m.X_WT.q);
  sample.twist.v = toolkit::raw(Vec3(params_.speed * m.v_W + shake_rate));
  sample.twist.w = toolkit::raw(Vec3(params_.speed * m.w_W));
  sample.closure = m.closure;
  sample.grip_force = m.grip;
  sample.buttons = 0;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_CLOSURE;
  if (hand_.has_grip) sample.valid |= SWAGE_VALID_GRIP;
  if (t >= hand_.duration()) sample.valid |= SWAGE_VALID_DONE;
}

}  // namespace swage::scripted

SWAGE_EXPORT(swage::scripted::Scripted)
