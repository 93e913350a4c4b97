// SPDX-License-Identifier: Apache-2.0
#include "tablet.hpp"

#include <errno.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sentences.hpp"

namespace swage::tablet {

using toolkit::Vec3;

namespace {

// s for which a pen that was away counts as lost, even if it is back sooner: the host matches the offset only of a hand that was lost for
// more than 0.1 s, and a pen that is put down elsewhere must not move the tool there
constexpr double kAway = 0.15;
constexpr double kRetry = 0.25;  // s between two searches for a tablet that was unplugged

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void Tablet::open() {
  if (const std::string why = opener_(params().device, "", pen_); !why.empty()) return refuse(why);
  found_ = pen_.name;
  decoder_.begin(pen_.ranges, params().size[0], params().size[1]);
  was_near_ = false;
  last_s_ = now_s();
  left_s_ = 0;
  note(say::kTablet(found_, pen_.ranges.tilt_x.present() ? "" : say::kNoTilt()));
}

void Tablet::close() {
  if (pen_.file >= 0) ::close(pen_.file);
  pen_.file = -1;
}

// false when the tablet was unplugged
bool Tablet::hear() {
  char bytes[1024];
  for (;;) {
    const ssize_t n = ::read(pen_.file, bytes, sizeof bytes);
    if (n > 0) decoder_.take(bytes, static_cast<std::size_t>(n));
    if (n > 0 || (n < 0 && errno == EINTR)) continue;
    if (n < 0 && errno == EAGAIN) return true;
    close();
    return false;
  }
}

// The surface is the x-y plane of the device frame; an upright pen points along -z, and its tip is the tool's tips.
void Tablet::follow(double dt) {
  const P& p = params();
  const PenState& pen = decoder_.state();
  const double press = std::clamp((pen.pressure - p.soft) / (1 - p.soft), 0.0, 1.0);
  double z = pen.touches ? 0 : p.hover * pen.height;
  double closure = press;
  if (p.pressure == Pressure::kJaws) {
    height_ += dt * p.lift * (((pen.buttons & 2) != 0 ? 1.0 : 0.0) - ((pen.buttons & 1) != 0 ? 1.0 : 0.0));
    height_ = std::clamp(height_, -0.1, 0.1);
    z += height_;
  } else {
    z -= p.depth * press;
    closure = (pen.buttons & 1) != 0 ? 1 : 0;
  }
  // a pen tilted towards +x is rotated about +y, one tilted towards +y about -x
  const Vec3 place(pen.x, pen.y, z), tilt(-pen.tilt_y, pen.tilt_x, 0);
  const double share = was_near_ && p.smoothing > 0 ? 1 - std::exp(-dt / p.smoothing) : 1;
  p_ += share * (place - p_);
  tilt_ += share * (tilt - tilt_);
  closure_ += share * (closure - closure_);
  was_near_ = true;
}

void Tablet::exchange(const swage_command&, swage_sample& sample) {
  const double now = now_s(), dt = std::clamp(now - last_s_, 0.0, 0.05);
  last_s_ = now;
  if (pen_.file < 0) {
    if (now - tried_s_ < kRetry) return;
    tried_s_ = now;
    if (!opener_(params().device, found_, pen_).empty()) return;
    decoder_.begin(pen_.ranges, params().size[0], params().size[1]);
  }
  if (!hear()) {
    was_near_ = false;
    return;
  }
  sample.sequence += 1;
  sample.time_s = now;
  sample.valid = 0;
  if (!decoder_.state().near) left_s_ = now;
  if (now - left_s_ < kAway) {
    was_near_ = false;
    return;
  }
  follow(dt);
  sample.pose.p = toolkit::raw(p_);
  // for an upright pen the tool's x (hinge to tips) points down and its closing direction to the right
  static const toolkit::Quat upright = toolkit::exp_rotation({0, 0.5 * std::numbers::pi, 0});
  sample.pose.q = toolkit::raw(toolkit::Quat(toolkit::exp_rotation(tilt_) * toolkit::exp_rotation({0, 0, params().roll}) * upright));
  sample.closure = closure_;
  sample.buttons = decoder_.state().buttons;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE | SWAGE_VALID_BUTTONS;
}

}  // namespace swage::tablet

SWAGE_EXPORT(swage::tablet::Tablet)
