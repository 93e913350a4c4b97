// SPDX-License-Identifier: Apache-2.0
#include "gamepad.hpp"

#include <time.h>

#include <algorithm>
#include <stdexcept>

#include "hand/hand.hpp"
#include "nodes/nodes.hpp"
#include "sentences.hpp"

namespace swage::gamepad {

using toolkit::Pose;
using toolkit::Vec3;

namespace {

constexpr double kRetry = 0.25;  // s between two searches for a pad that was unplugged
constexpr double kBatteryEach = 5;  // s between two reads of its battery level, which changes over hours
constexpr double kLow = 0.2;        // charge below which the person is warned

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Name of a pad that is plugged in but may not be read, "" when there is none.
std::string closed_pad() {
  constexpr uint16_t kSony = 0x054c, kNintendo = 0x057e;  // vendor ids of pads that SDL reads by hidraw
  for (const nodes::Tells kind : {nodes::Tells::kPad, nodes::Tells::kJoystick})
    if (std::string pad = nodes::closed_input(kind); !pad.empty()) return pad;
  const std::string pad = nodes::closed_of_maker(kSony);
  return pad.empty() ? nodes::closed_of_maker(kNintendo) : pad;
}

}  // namespace

void Gamepad::build(const P& params, DeviceBuilder& builder) {
  try {
    hand_ = rate::RateHand(
        Pose(toolkit::vec(params.start), hand::orientation(toolkit::vec(params.start_axis), toolkit::vec(params.start_closing))));
  } catch (const std::invalid_argument& problem) {
    builder.error("start_closing", problem.what());
  }
}

// opens the first pad with the wanted name
bool Gamepad::find() {
  const std::string& wanted = found_.empty() ? params().pad : found_;
  for (int i = 0; i < sdl_->NumJoysticks(); ++i) {
    const char* const called = sdl_->IsGameController(i) != 0 ? sdl_->GameControllerNameForIndex(i) : nullptr;
    if (called == nullptr || std::string(called).find(wanted) == std::string::npos) continue;
    pad_ = sdl_->GameControllerOpen(i);
    if (pad_ == nullptr) continue;
    found_ = called;
    return true;
  }
  return false;
}

void Gamepad::open() {
  std::string why;
  sdl_ = load_sdl(why);
  if (sdl_ == nullptr) return refuse(why);
  found_.clear();
  battery_told_ = false;
  sdl_->GameControllerUpdate();
  last_s_ = now_s();
  if (find()) return note(say::kPad(found_));
  std::string others;
  for (int i = 0; i < sdl_->NumJoysticks(); ++i)
    if (sdl_->IsGameController(i) != 0) others += std::string(others.empty() ? "" : ", ") + sdl_->GameControllerNameForIndex(i);
  if (!others.empty()) return refuse(say::kNoSuchPad(params().pad, others));
  if (const std::string pad = closed_pad(); !pad.empty()) return refuse(say::kMayNotRead(pad));
  refuse(say::kNoPad());
}

void Gamepad::close() {
  if (pad_ != nullptr) sdl_->GameControllerClose(pad_);
  pad_ = nullptr;
  battery_ = kNotKnown;
  battery_s_ = -kBatteryEach;
}

void Gamepad::look_at_battery(double now) {
  if (now - battery_s_ < kBatteryEach) return;
  battery_s_ = now;
  battery_ = battery_of(sdl_->JoystickCurrentPowerLevel(sdl_->GameControllerGetJoystick(pad_)));
  if (!(battery_ <= kLow) || battery_told_) return;
  battery_told_ = true;
  warn(say::kLowBattery(found_));
}

double Gamepad::axis(Axis a) const { return static_cast<double>(sdl_->GameControllerGetAxis(pad_, a)) / 32767; }

double Gamepad::key(Button plus, Button minus) const { return (down(plus) ? 1.0 : 0.0) - (down(minus) ? 1.0 : 0.0); }

// Sticks point down with +y; the device frame has +y up and +z towards the user.
void Gamepad::lead(double dt) {
  const P& p = params();
  const Half half = p.half;
  const bool right = half == Half::kRight;
  const double x = axis(right ? kRightX : kLeftX), y = -axis(right ? kRightY : kLeftY);
  Vec3 move, turn;
  if (half == Half::kBoth) {
    move = {x, y, key(kLeftShoulder, kRightShoulder)};
    turn = {axis(kRightY), axis(kRightX), key(kLeft, kRight)};
  } else {
    const bool deep = down(right ? kRightShoulder : kLeftShoulder);
    move = deep ? Vec3(0, 0, -y) : Vec3(x, y, 0);
    turn = right ? Vec3(key(kA, kY), key(kB, kX), 0) : Vec3(key(kDown, kUp), key(kRight, kLeft), 0);
    if (deep) turn.z() = -x;
  }
  const double scale = down(right ? kRightStick : kLeftStick) ? p.fine : 1;
  hand_.step(move, turn, {p.dead, p.exponent, scale * p.move, scale * p.turn, p.smoothing}, dt);
}

void Gamepad::squeeze(double dt) {
  const P& p = params();
  const bool left = p.half == Half::kLeft;
  const double trigger = std::clamp(axis(left ? kLeftTrigger : kRightTrigger), 0.0, 1.0);
  if (p.trigger == Trigger::kPosition) {
    closure_ = trigger;
    return;
  }
  const bool open = p.half == Half::kBoth ? axis(kLeftTrigger) > 0.5 : down(left ? kBack : kStart);
  closure_ = std::clamp(closure_ + dt / p.close_time * (rate::shaped(trigger, {.dead = p.dead, .exponent = 1}) - (open ? 1.0 : 0.0)), 0.0, 1.0);
}

void Gamepad::exchange(const swage_command&, swage_sample& sample) {
  const double now = now_s(), dt = std::clamp(now - last_s_, 0.0, 0.05);
  sdl_->GameControllerUpdate();
  if (pad_ != nullptr && sdl_->GameControllerGetAttached(pad_) == 0) {
    close();
    hand_.stand();
  }
  if (pad_ == nullptr) {
    if (now - tried_s_ < kRetry) return;
    tried_s_ = now;
    if (!find()) return;
  }
  last_s_ = now;
  look_at_battery(now);
  lead(dt);
  squeeze(dt);
  sample.sequence += 1;
  sample.time_s = now;
  sample.valid = SWAGE_VALID_CLOSURE | SWAGE_VALID_BUTTONS;
  hand_.write(sample);
  sample.closure = closure_;
  sample.buttons = 0;
  for (int b = 0; b < kButtons; ++b) sample.buttons |= down(static_cast<Button>(b)) ? 1u << b : 0u;
}

}  // namespace swage::gamepad

SWAGE_EXPORT(swage::gamepad::Gamepad)
