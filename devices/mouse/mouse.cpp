// SPDX-License-Identifier: Apache-2.0
#include "mouse.hpp"

#include <algorithm>
#include <stdexcept>

#include "hand/hand.hpp"

namespace swage::mouse {

using toolkit::vec;

namespace {

Speeds speeds_of(const MouseParams& p) {
  return {p.drag, p.wheel, p.turn, p.key_move, p.key_turn, 1 / p.close_time, p.fine, p.smoothing, p.rest_force, p.latch};
}

}  // namespace

void Mouse::build(const MouseParams& params, DeviceBuilder& builder) {
  try {
    const Quat q = hand::orientation(vec(params.start_axis), vec(params.start_closing));
    hand_ = MouseHand(speeds_of(params), Pose(vec(params.start), q));
    hand_.set_circle({vec(params.circle_centre), vec(params.circle_axis)});
  } catch (const std::invalid_argument& problem) {
    builder.error("start_closing", problem.what());
  }
}

void Mouse::changed() {
  hand_.set_speeds(speeds_of(params()));
  hand_.set_circle({vec(params().circle_centre), vec(params().circle_axis)});
}

void Mouse::bind(const Scene& scene, std::span<const swage_scene_mark>) {
  for (uint32_t i = 0; i < scene->n_signal; ++i)
    if (view(scene->signal[i].id) == "grasp.force") grip_.emplace_back(i);
}

// the hardest of all grips: there is one instrument
void Mouse::look(const Sight& sight) {
  grip_N_ = 0;
  for (const Signal force : grip_) grip_N_ = std::max(grip_N_, sight.view().signal(force));
}

void Mouse::open() {
  pointer_ = host_extension<swage_host_pointer>(SWAGE_HOST_POINTER);
  if (pointer_ == nullptr)
    refuse("this program does not pass on the pointer and the keys, so there is no mouse to use");
}

void Mouse::exchange(const swage_command& command, swage_sample& sample) {
  // two calls at the same moment, as after a pause, must not move the hand twice
  const double dt = std::clamp(command.time_s - last_s_, 0.0, 0.01);
  last_s_ = command.time_s;
  static constexpr swage_pointer kStill{0, 0, 0, 0, 0, 0, {1, 0, 0, 0}};
  hand_.step(pointer_ != nullptr ? *pointer_->read(&host()) : kStill, dt, grip_N_);

  sample.sequence += 1;
  sample.time_s = command.time_s;
  sample.pose = hand_.pose().abi();
  sample.closure = hand_.closure();
  sample.grip_force = 0;
  sample.buttons = 0;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
}

}  // namespace swage::mouse

SWAGE_EXPORT(swage::mouse::Mouse)
