// SPDX-License-Identifier: Apache-2.0
#include "mouse.hpp"

#include <algorithm>
#include <stdexcept>

#include "hand/hand.hpp"

namespace swage::mouse {

using toolkit::vec;

namespace {

Speeds speeds_of(const MouseParams& p) {
  return {p.drag, p.wheel, p.turn, p.key_move, p.key_turn, 1 / p.close_time, p.tap, p.fine, p.smoothing, p.rest_force, p.give, p.give_turn, p.latch};
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
  if (params.hand > params.hands) builder.error("hand", "there are not so many hands (parameter hands)");
}

void Mouse::changed() {
  hand_.set_speeds(speeds_of(params()));
  hand_.set_circle({vec(params().circle_centre), vec(params().circle_axis)});
}

// the signals of one coupling stand together, "grasp.force" before those of the jaws
void Mouse::bind(const Scene& scene, std::span<const swage_scene_mark>) {
  grasps_.clear();
  for (uint32_t i = 0; i < scene->n_signal; ++i) {
    const swage_scene_signal& signal = scene->signal[i];
    if (!params().grasp.empty() && view(signal.owner) != params().grasp) continue;
    if (view(signal.id) == "grasp.force") grasps_.push_back({Signal(i), Signal(), Signal(), Signal()});
    if (!grasps_.empty() && view(signal.id) == "grasp.left") grasps_.back().left = Signal(i);
    if (!grasps_.empty() && view(signal.id) == "grasp.right") grasps_.back().right = Signal(i);
    if (!grasps_.empty() && view(signal.id) == "grasp.roll_moment") grasps_.back().roll_moment = Signal(i);
  }
  if (grasps_.empty() && !params().grasp.empty())
    refuse("there is no signal \"grasp.force\" of \"" + params().grasp + "\" (parameter grasp)");
}

void Mouse::look(const Sight& sight) {
  felt_ = {};
  // of several hands one without a grasp of its own, as of scissors, must not give way to what another one holds
  const bool own = params().hands < 2 || !params().grasp.empty();
  double left = 0, right = 0, moment = 0;
  for (const Grasp& grasp : grasps_) {
    felt_.grip = std::max(felt_.grip, sight.view().signal(grasp.force));
    if (!grasp.left.valid() || !grasp.right.valid()) continue;  // a coupling of others need not tell them
    left = std::max(left, sight.view().signal(grasp.left));
    right = std::max(right, sight.view().signal(grasp.right));
    if (grasp.roll_moment.valid()) moment += sight.view().signal(grasp.roll_moment);
  }
  if (!own) return;
  constexpr double kTouch = 1e-3;  // N, from which a hand feels a touch: noise of the contact must not turn it
  if (left + right >= kTouch) felt_.lever = moment / (left + right);
  constexpr double kFelt = 0.5;  // of the other jaw's force: below it one jaw is felt to push; at 1 a firm grip would wander
  if (std::min(left, right) < kFelt * std::max(left, right)) felt_.pushes = left > right ? 1 : -1;
}

void Mouse::open() {
  pointer_ = host_extension<swage_host_pointer>(SWAGE_HOST_POINTER);
  if (pointer_ == nullptr)
    refuse("this program does not pass on the pointer and the keys, so there is no mouse to use");
}

// Tab passes the control to the next hand. Keys that are down then belong to the other hand until they are released.
swage_pointer Mouse::taken_over(const swage_pointer& pointer) {
  const bool tab = (pointer.keys & kTab) != 0;
  if (tab && !tab_) {
    leads_ = leads_ % params().hands + 1;
    old_keys_ = pointer.keys;
    old_buttons_ = pointer.buttons;
  }
  tab_ = tab;
  old_keys_ &= pointer.keys;
  old_buttons_ &= pointer.buttons;
  swage_pointer out = pointer;
  out.keys &= ~old_keys_;
  out.buttons &= ~old_buttons_;
  return out;
}

void Mouse::exchange(const swage_command& command, swage_sample& sample) {
  // two calls at the same time, as after a pause, must not move the hand twice
  const double dt = std::clamp(command.time_s - last_s_, 0.0, 0.01);
  last_s_ = command.time_s;
  static constexpr swage_pointer kStill{0, 0, 0, 0, 0, 0, {1, 0, 0, 0}};
  const swage_pointer pointer = taken_over(pointer_ != nullptr ? *pointer_->read(&host()) : kStill);
  const bool shared = params().hands > 1, led = leads_ == params().hand;
  if (led)
    hand_.step(pointer, dt, felt_);
  else
    hand_.rest(dt);

  sample.sequence += 1;
  sample.time_s = command.time_s;
  sample.pose = hand_.pose().abi();
  sample.closure = hand_.closure();
  sample.grip_force = 0;
  sample.buttons = shared && led ? pointer.buttons : 0;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  // of hands that share a mouse only the controlled one has buttons: so a window knows which one it is
  if (shared && led) sample.valid |= SWAGE_VALID_BUTTONS;
}

}  // namespace swage::mouse

SWAGE_EXPORT(swage::mouse::Mouse)
