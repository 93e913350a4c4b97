// SPDX-License-Identifier: Apache-2.0
#include "spacemouse.hpp"

#include <time.h>

#include <algorithm>
#include <stdexcept>

#include "hand/hand.hpp"

namespace swage::spacemouse {

using toolkit::Pose;
using toolkit::Vec3;

namespace {

constexpr double kRetry = 0.25;  // s between two attempts to reconnect to the daemon
// s without an event after which the cap counts as released. A held cap reports every 8 to 16 ms, as it is never quite still; a mouse
// unplugged while its cap is deflected would otherwise move the tool for ever
constexpr double kLetGo = 0.3;

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void Spacemouse::build(const P& params, DeviceBuilder& builder) {
  try {
    hand_ = rate::RateHand(
        Pose(toolkit::vec(params.start), hand::orientation(toolkit::vec(params.start_axis), toolkit::vec(params.start_closing))));
  } catch (const std::invalid_argument& problem) {
    builder.error("start_closing", problem.what());
  }
}

void Spacemouse::open() {
  move_ = turn_ = Vec3::Zero();
  buttons_ = 0;
  last_s_ = now_s();
  if (const std::string why = socket_.open(params().socket); !why.empty()) refuse(why);
}

// spacenavd has x to the right, y up and z away from the user; rotations likewise
void Spacemouse::hear(double now) {
  SpnavEvent e;
  while (socket_.next(e)) {
    heard_s_ = now;
    if (e.type == SpnavEvent::kMotion) {
      const double k = 1 / params().full;
      move_ = k * Vec3(e.data[0], e.data[1], -static_cast<double>(e.data[2]));
      turn_ = k * Vec3(e.data[3], e.data[4], -static_cast<double>(e.data[5]));
    } else if ((e.type == SpnavEvent::kPress || e.type == SpnavEvent::kRelease) && e.data[0] >= 0 && e.data[0] < 32) {
      const uint32_t bit = 1u << e.data[0];
      buttons_ = e.type == SpnavEvent::kPress ? buttons_ | bit : buttons_ & ~bit;
    }
  }
  if (now - heard_s_ > kLetGo || !socket_.is_open()) move_ = turn_ = Vec3::Zero();
}

void Spacemouse::exchange(const swage_command&, swage_sample& sample) {
  const double now = now_s(), dt = std::clamp(now - last_s_, 0.0, 0.05);
  last_s_ = now;
  if (!socket_.is_open() && now - tried_s_ >= kRetry) {
    tried_s_ = now;
    socket_.open(params().socket);
  }
  hear(now);
  if (!socket_.is_open()) {
    hand_.stand();
    buttons_ = 0;
    return;
  }
  const P& p = params();
  hand_.step(move_, turn_, {p.dead, p.exponent, p.move, p.turn, p.smoothing}, dt);
  closure_ = std::clamp(closure_ + dt / p.close_time * (((buttons_ & 1) != 0 ? 1.0 : 0.0) - ((buttons_ & 2) != 0 ? 1.0 : 0.0)), 0.0, 1.0);
  sample.sequence += 1;
  sample.time_s = now;
  sample.valid = SWAGE_VALID_BUTTONS;
  hand_.write(sample);
  sample.buttons = buttons_;
  if (!p.jaws) return;
  sample.closure = closure_;
  sample.valid |= SWAGE_VALID_CLOSURE;
}

}  // namespace swage::spacemouse

SWAGE_EXPORT(swage::spacemouse::Spacemouse)
