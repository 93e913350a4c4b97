// SPDX-License-Identifier: Apache-2.0
#include "inverse3.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "hand/hand.hpp"
#include "sentences.hpp"

namespace swage::inverse3 {
namespace {

constexpr double kLow = 0.2;      // charge below which the person is warned
constexpr double kPatience = 3;   // s, timeout for the service's answer at the start
constexpr double kRetry = 0.5;    // s between two attempts to reconnect
constexpr double kUnanswered = 0.1;  // s after which a message without an answer is sent again; usual are 0.1 to 1 ms

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void nap() {
  const timespec pause{0, 1'000'000};
  nanosleep(&pause, nullptr);
}

// The stylus G points along its y; the instrument T points along its x, and its closing direction z is to the left of the stylus.
const Quat& grip_to_tool() {
  static const Quat q = [] {
    toolkit::Mat3 R;
    R.col(0) = Vec3::UnitY();
    R.col(1) = -Vec3::UnitZ();
    R.col(2) = -Vec3::UnitX();
    return Quat(R);
  }();
  return q;
}

}  // namespace

void Inverse3::build(const P& params, DeviceBuilder& builder) {
  try {
    fixed_ = hand::orientation(toolkit::vec(params.axis), toolkit::vec(params.closing));
  } catch (const std::invalid_argument& problem) {
    builder.error("closing", problem.what());
  }
}

// waits until the service has reported an arm; returns "" or the reason
std::string Inverse3::reach() {
  const std::string where = params().host + ":" + std::to_string(params().port);
  std::string others, text;
  bool greeted = false;
  if (const std::string why = socket_.open(params().host, params().port, "/"); !why.empty()) return why;
  for (const double until = now_s() + kPatience; now_s() < until; nap()) {
    if (socket_.progress() == WebSocket::State::kClosed)
      return say::kNoService(where, socket_.trouble());
    while (socket_.receive(text)) {
      const Message m = read_message(text, params().arm, params().grip);
      greeted |= m.readable;
      others = m.others;
      hear(text, now_s());
    }
    if (fresh_) return "";
    if (greeted) answer({}, now_s());
  }
  if (!greeted) return say::kOtherService(where);
  if (!others.empty()) return say::kNoSuchArm(params().arm, others);
  return say::kNoArm();
}

void Inverse3::open() {
  arm_ = params().arm;
  battery_told_ = false;
  grip_known_ = grip_there_ = fresh_ = asked_ = false;
  now_ = {};
  closure_ = 0;
  last_s_ = tried_s_ = now_s();
  if (const std::string why = reach(); !why.empty()) {
    socket_.close();
    return refuse(why);
  }
  char percent[32] = "";
  if (grip_known_ && grip_.battery) std::snprintf(percent, sizeof percent, "%.0f", 1e2 * *grip_.battery);
  const std::string battery = *percent != '\0' ? say::kBattery(percent) : "";
  note(say::kArm(arm_, now_.handedness.empty() ? "" : say::kHanded(now_.handedness), grip_known_ ? say::kWithGrip(battery) : say::kWithoutGrip()));
}

// Ends with a zero force, and waits for the answer before closing the connection: unread data on either side would be lost with it.
void Inverse3::close() {
  std::string text;
  const auto wait = [&] {
    for (const double until = now_s() + kUnanswered; asked_ && now_s() < until; nap()) {
      if (socket_.progress() == WebSocket::State::kClosed) return;
      while (socket_.receive(text)) asked_ = false;
    }
    asked_ = false;
  };
  wait();
  answer({}, now_s());
  wait();
  socket_.close();
}

void Inverse3::hear(const std::string& text, double now) {
  const Message m = read_message(text, arm_, params().grip);
  asked_ = false;
  if (!m.arm) return;
  if (arm_.empty()) arm_ = m.arm->id;
  const std::string hand = now_.handedness;
  newer_ |= m.arm->newer;
  now_ = *m.arm;
  if (now_.handedness.empty()) now_.handedness = hand;
  grip_there_ = m.grip.has_value();
  if (m.grip) grip_ = *m.grip;
  if (m.grip && grip_.battery.value_or(1) <= kLow && !battery_told_) {
    battery_told_ = true;
    warn(say::kLowBattery());
  }
  grip_known_ |= grip_there_;
  heard_s_ = now;
  fresh_ = true;
}

Vec3 Inverse3::limited(const Vec3& force) const {
  if (!force.allFinite()) return Vec3::Zero();
  const double size = force.norm(), most = params().max_force;
  return size > most ? Vec3(force * (most / size)) : force;
}

// One message at a time is pending: the service answers each with one, and more would queue behind a slow one.
void Inverse3::answer(const swage_command& command, double now) {
  if (asked_ && now - asked_s_ < kUnanswered) return;
  const bool obeyed = now < command.deadline_s;
  const Vec3 force = obeyed ? limited(toolkit::vec(command.force)) : Vec3(Vec3::Zero());
  if (!socket_.send(arm_.empty() ? asking_message() : force_message(arm_, newer_, force))) return;
  asked_ = true;
  asked_s_ = now;
}

void Inverse3::exchange(const swage_command& command, swage_sample& sample) {
  const double now = now_s(), dt = std::clamp(now - last_s_, 0.0, 0.05);
  last_s_ = now;
  if (socket_.state() == WebSocket::State::kClosed) {
    if (now - tried_s_ < kRetry) return;
    tried_s_ = now;
    asked_ = false;
    if (!socket_.open(params().host, params().port, "/").empty()) return;
  }
  socket_.progress();
  std::string text;
  while (socket_.receive(text)) hear(text, now);
  answer(command, now);
  if (!fresh_) return;
  fresh_ = false;
  sample.sequence += 1;
  sample.time_s = heard_s_;
  sample.pose = Pose(now_.p_D, grip_known_ ? (grip_.q_DG * grip_to_tool()).normalized() : fixed_).abi();
  sample.twist = {toolkit::raw(now_.v_D), {}};
  // a stylus without messages has no valid orientation any more
  sample.valid = grip_there_ || !grip_known_ ? SWAGE_VALID_POSE | SWAGE_VALID_TWIST : 0u;
  if (!grip_there_) return;
  sample.buttons = grip_.buttons;
  sample.valid |= SWAGE_VALID_BUTTONS;
  if (!params().jaws) return;
  closure_ = std::clamp(closure_ + dt / params().close_time * (((grip_.buttons & 1) != 0 ? 1.0 : 0.0) - ((grip_.buttons & 2) != 0 ? 1.0 : 0.0)), 0.0, 1.0);
  sample.closure = closure_;
  sample.valid |= SWAGE_VALID_CLOSURE;
}

}  // namespace swage::inverse3

SWAGE_EXPORT(swage::inverse3::Inverse3)
