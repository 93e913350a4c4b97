// SPDX-License-Identifier: Apache-2.0
//
// How pointer and keys move a hand. Pure arithmetic; the keys are listed in mouse.md.
#pragma once

#include <swage/abi/device.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::mouse {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// Bits of swage_pointer.keys.
constexpr uint64_t letter(char c) { return uint64_t{1} << (c - 'a'); }
inline constexpr uint64_t kLeft = uint64_t{1} << 36, kRight = uint64_t{1} << 37, kUp = uint64_t{1} << 38,
                          kDown = uint64_t{1} << 39, kSpace = uint64_t{1} << 40, kEnter = uint64_t{1} << 41,
                          kPlus = uint64_t{1} << 42, kMinus = uint64_t{1} << 43, kPageUp = uint64_t{1} << 44,
                          kPageDown = uint64_t{1} << 45, kTab = uint64_t{1} << 46;
inline constexpr uint32_t kLeftButton = 1, kMiddleButton = 2, kRightButton = 4;
inline constexpr uint32_t kShift = 1, kControl = 2, kAlt = 4;

/// The circle of a held needle's arc, about which the hand can rotate. Zero axis: no circle.
struct Circle {
  Vec3 centre_W = Vec3::Zero();  // m
  Vec3 axis_W = Vec3::Zero();    // unit, or zero; a right-handed rotation about it moves the needle's point ahead
};

struct Speeds {
  double drag = 10e-3;                        // m per span of the pointer: the tips stay under it
  double wheel = 0.2e-3;                      // m per notch
  double turn = 2 * std::numbers::pi / 3;     // rad per span of the pointer
  double key_move = 4e-3;                     // m/s
  double key_turn = 0.25 * std::numbers::pi;  // rad/s
  double squeeze = 0.6;                       // closure per second
  double tap = 0.025;                         // s, least time for which a key moves, turns or drives: a short stroke is 0.1 mm or 1.1 deg
  double fine = 0.2;                          // factor of all the above while shift is down
  double smoothing = 0.02;  // s, time constant: a mouse reports at 60 to 1000 Hz, a hand moves smoothly
  double rest_force = 0.6;  // N, grip force at which closing stops until the key is pressed again; 0: it never stops
  double give = 2e-3;       // m/s, at which the hand gives way while one jaw pushes: quicker than a jaw closes; 0: it never does
  double give_turn = 4 * std::numbers::pi;  // rad/s, at most, at which the hand rolls with the wire on which the jaws close obliquely; 0: it never does
  bool latch = true;        // the jaws keep their closure when the key is released; otherwise they open again
};

/// What the jaws feel.
struct Felt {
  double grip = 0;  // N, the grip force
  int pushes = 0;   // which jaw presses more than the other: 1 the left, -1 the right, 0 neither
  double lever = 0;  // m, half of the way along the jaws' width between the places where they press: the couple over the sum of the forces
};

/// Commanded pose of the hand, and its smoothed pose.
class MouseHand {
 public:
  MouseHand() = default;
  MouseHand(const Speeds& speeds, const Pose& start)
      : speeds_(speeds), target_(start), middle_(start), pose_(start) {}

  /// One step of dt [s]. [rt]
  void step(const swage_pointer& pointer, double dt, const Felt& felt = {}) noexcept {
    const bool shift = (pointer.modifiers & kShift) != 0;
    const double scale = shift ? speeds_.fine : 1.0;
    lead_all(pointer, shift, dt);
    lead_on(pointer, scale, dt);
    if (squeeze(pointer, scale, dt, felt.grip)) {
      yield(felt.pushes * scale * speeds_.give * dt);
      roll(std::clamp(felt.lever / kFullLever, -1.0, 1.0) * scale * speeds_.give_turn * dt);
    }
    smooth(dt);
  }

  /// A step in which another hand is controlled: this one comes to rest at its commanded pose, and holds. [rt]
  void rest(double dt) noexcept {
    goes_on_ = false;
    up_s_ = kLetGo_s;
    left_s_.fill(0);
    smooth(dt);
  }

  /// Applies from the next step on; the hand does not move. [rt]
  void set_speeds(const Speeds& speeds) noexcept { speeds_ = speeds; }

  /// Applies to the next rotations about the circle. [rt]
  void set_circle(const Circle& circle) noexcept {
    const double length = circle.axis_W.norm();
    circle_ = length > 0 ? Circle{circle.centre_W, circle.axis_W / length} : Circle{};
  }

  const Pose& pose() const { return pose_; }   // X_WT
  double closure() const { return closure_; }  // 0..1

 private:
  /// A key that was pressed with shift goes on at its fine speed until it is released: shift is often let go first, by a moment in which a
  /// fine stroke would become a coarse one.
  void lead_all(const swage_pointer& p, bool shift, double dt) noexcept {
    const uint64_t pressed = p.keys & ~keys_ & kLeading;
    fine_keys_ = (fine_keys_ & p.keys) | (shift ? pressed : 0);
    if (shift || fine_keys_ == 0) return lead(p, shift ? speeds_.fine : 1.0, dt);
    swage_pointer coarse = p, fine{};
    coarse.keys &= ~fine_keys_;
    fine.keys = fine_keys_;
    fine.camera = p.camera;
    lead(coarse, 1.0, dt);
    lead(fine, speeds_.fine, dt);
  }

  /// Moves, turns and drives the commanded pose as pointer and keys say.
  void lead(const swage_pointer& p, double scale, double dt) noexcept {
    const Quat q_WC = toolkit::quat(p.camera);
    if (const double angle = scale * along_circle(p, q_WC, dt); angle != 0) drive(angle);
    if (!drags_on_circle(p)) target_.p += scale * (q_WC * motion_C(p, dt));
    target_.q = (toolkit::exp_rotation(scale * (q_WC * turning_C(p, dt))) * target_.q).normalized();
  }

  /// A key that was released before its least time leads on until that is over, with the scale of its press. How long a stroke of a few
  /// ms appears depends on the host, its window and its load; without a least time it could be a single step, 4 um, that nobody sees.
  void lead_on(const swage_pointer& p, double scale, double dt) noexcept {
    const uint64_t pressed = p.keys & ~keys_ & kLeading;
    if (pressed != 0) press_scale_ = scale;
    keys_ = p.keys;
    swage_pointer late{};
    late.camera = p.camera;
    for (std::size_t i = 0; i < left_s_.size(); ++i) {
      const uint64_t key = uint64_t{1} << i;
      if ((pressed & key) != 0) left_s_[i] = speeds_.tap;
      constexpr double kRounding = 1e-9;  // s, far below a step: the sum of steps must not add one
      if (left_s_[i] <= kRounding) continue;
      if ((p.keys & key) == 0) late.keys |= key;
      left_s_[i] -= dt;
    }
    if (late.keys != 0) lead(late, press_scale_, dt);
  }

  static double axis(uint64_t keys, uint64_t plus, uint64_t minus) {
    return ((keys & plus) != 0 ? 1.0 : 0.0) - ((keys & minus) != 0 ? 1.0 : 0.0);
  }

  bool drags_on_circle(const swage_pointer& p) const {
    const bool wanted = (p.keys & letter('c')) != 0 || (p.modifiers & kAlt) != 0;
    return wanted && (p.buttons & kLeftButton) != 0 && !circle_.axis_W.isZero();
  }

  /// Rotation about the circle's axis [rad]: by keys, or by a drag, so that the tips follow the pointer's motion along the circle.
  double along_circle(const swage_pointer& p, const Quat& q_WC, double dt) const {
    if (circle_.axis_W.isZero()) return 0;
    double angle = speeds_.key_turn * dt * axis(p.keys, letter('t'), letter('g'));
    if (!drags_on_circle(p)) return angle;
    constexpr double kSeen =
        0.3;  // share of the motion that must lie in the view plane: a drag cannot follow motion along the line of sight
    const Vec3 way = circle_.axis_W.cross(target_.p - circle_.centre_W);  // m per rad
    const Vec3 way_C = q_WC.conjugate() * way;
    const double seen2 = way_C.x() * way_C.x() + way_C.y() * way_C.y();
    if (seen2 > kSeen * kSeen * way.squaredNorm() && seen2 > 0)
      angle += speeds_.drag * (p.dx * way_C.x() + p.dy * way_C.y()) / seen2;
    return angle;
  }

  /// Rotates the hand about the circle's axis.
  void drive(double angle) {
    const Quat turn = toolkit::exp_rotation(angle * circle_.axis_W);
    target_.p = circle_.centre_W + turn * (target_.p - circle_.centre_W);
    target_.q = (turn * target_.q).normalized();
  }

  /// Displacement [m] in the camera's frame: +x right, +y up, +z towards the viewer.
  Vec3 motion_C(const swage_pointer& p, double dt) const {
    Vec3 d = speeds_.key_move * dt *
             Vec3(axis(p.keys, letter('d'), letter('a')), axis(p.keys, letter('w'), letter('s')),
                  axis(p.keys, letter('e'), letter('q')));
    if ((p.buttons & kLeftButton) != 0) d += speeds_.drag * Vec3(p.dx, p.dy, 0);
    if ((p.modifiers & kControl) == 0) d.z() -= speeds_.wheel * p.wheel;
    return d;
  }

  /// Rotation vector [rad] in the camera's frame, right-handed.
  Vec3 turning_C(const swage_pointer& p, double dt) const {
    Vec3 a = speeds_.key_turn * dt *
             Vec3(axis(p.keys, kDown, kUp), axis(p.keys, kRight, kLeft),
                  axis(p.keys, letter('z') | kPageUp, letter('x') | kPageDown));
    // a drag moves the near side of the tool with the pointer; with control the tool rolls about the line of
    // sight
    if ((p.buttons & kRightButton) != 0) {
      const bool roll = (p.modifiers & kControl) != 0;
      a += speeds_.turn * (roll ? Vec3(0, 0, -p.dx) : Vec3(-p.dy, p.dx, 0));
    }
    return a;
  }

  /// A hand feels which jaw pushes and gives way, so that a needle is taken where it is and not pushed: moves by `way` [m] towards
  /// the left jaw, at once.
  void yield(double way) {
    const Vec3 d = way * (target_.q * Vec3::UnitZ());
    for (Pose* pose : {&target_, &middle_, &pose_}) pose->p += d;
  }

  /// Jaws that close obliquely on a wire touch it at one edge each, and turn it. A wrist gives way to that moment: the hand rolls about the
  /// jaw axis by `angle` [rad], at once, until the faces lie along the wire.
  void roll(double angle) {
    const Quat turn = toolkit::exp_rotation(angle * (target_.q * Vec3::UnitX()));
    for (Pose* pose : {&target_, &middle_, &pose_}) pose->q = (turn * pose->q).normalized();
  }

  /// A first press closes until the jaws hold with the resting force; a new press from there closes on. True while they close.
  bool squeeze(const swage_pointer& p, double scale, double dt, double grip) {
    constexpr double kNotch = 0.02;  // closure per notch of the wheel
    const bool control = (p.modifiers & kControl) != 0;
    const bool middle = (p.buttons & kMiddleButton) != 0;
    const bool close = (p.keys & (kSpace | kPlus)) != 0 || (middle && !control);
    const bool open = (p.keys & (letter('b') | kEnter | kMinus)) != 0 || (middle && control);
    constexpr double kRests = 0.9;  // share of the resting force from which a new press closes on
    if (close && up_s_ >= kLetGo_s) goes_on_ = grip >= kRests * speeds_.rest_force;
    up_s_ = close ? 0 : up_s_ + dt;
    const bool rests = speeds_.rest_force > 0 && grip >= speeds_.rest_force && !goes_on_;
    double rate = (close && !rests ? 1.0 : 0.0) - (open ? 1.0 : 0.0);
    if (!speeds_.latch && !close) rate = -2;
    closure_ += rate * scale * speeds_.squeeze * dt;
    if (control) closure_ += kNotch * scale * p.wheel;
    closure_ = std::clamp(closure_, 0.0, 1.0);
    return rate > 0;
  }

  /// Two equal first-order low-pass filters in series: continuous velocity, no overshoot.
  void smooth(double dt) {
    const double share = speeds_.smoothing > 0 ? 1 - std::exp(-dt / speeds_.smoothing) : 1.0;
    approach(middle_, target_, share);
    approach(pose_, middle_, share);
  }
  static void approach(Pose& pose, const Pose& goal, double share) {
    pose.p += share * (goal.p - pose.p);
    const Vec3 turn = toolkit::log_rotation(goal.q * pose.q.conjugate());
    pose.q = (toolkit::exp_rotation(share * turn) * pose.q).normalized();
  }

  // m, the lever from which the hand rolls with its full speed: a third of a jaw's half width. A larger one leaves the needle turned, a
  // smaller one lets the hand swing about the wire.
  static constexpr double kFullLever = 0.1e-3;

  // the keys that move, turn or drive
  static constexpr uint64_t kLeading = letter('a') | letter('d') | letter('w') | letter('s') | letter('q') | letter('e') | letter('z') | letter('x') |
                                       letter('t') | letter('g') | kLeft | kRight | kUp | kDown | kPageUp | kPageDown;

  Speeds speeds_;
  uint64_t keys_ = 0;                            // down in the last step
  uint64_t fine_keys_ = 0;                       // down, and pressed with shift
  std::array<double, SWAGE_KEY_COUNT> left_s_{};  // s of each key's least time that are left
  double press_scale_ = 1;                       // factor of the speeds at the last press
  Circle circle_;
  Pose target_, middle_, pose_;
  double closure_ = 0;
  // The repetition of a held key may arrive as a release and a press (X11 without detectable auto-repeat), a few ms apart.
  // Between two presses a finger is up for 80 ms or more. A larger value would merge a quick second press with the first.
  static constexpr double kLetGo_s = 0.04;
  double up_s_ = kLetGo_s;  // s, time since the closing key was released
  bool goes_on_ = false;    // this press began at the resting force
};

}  // namespace swage::mouse
