// SPDX-License-Identifier: Apache-2.0
#include "pen.hpp"

#include <linux/input.h>

#include <algorithm>
#include <cstring>
#include <numbers>

namespace swage::tablet {

namespace {

double share(const AxisRange& r, int32_t value) {
  if (!r.present()) return 0;
  const double range = static_cast<double>(r.maximum) - r.minimum;
  return std::clamp((static_cast<double>(value) - r.minimum) / range, 0.0, 1.0);
}

// m from the middle of the surface
double place(const AxisRange& r, int32_t value, double size) {
  if (r.resolution > 0) size = 1e-3 * (static_cast<double>(r.maximum) - r.minimum) / r.resolution;
  return (share(r, value) - 0.5) * size;
}

// rad from upright; one unit is a degree where the kernel gives no resolution, as most pens have 64 steps
double tilt(const AxisRange& r, int32_t value) {
  if (!r.present()) return 0;
  const double per_unit = r.resolution > 0 ? 1.0 / r.resolution : std::numbers::pi / 180;
  const double middle = 0.5 * (static_cast<double>(r.minimum) + r.maximum);
  return std::clamp(per_unit * (static_cast<double>(value) - middle), -1.4, 1.4);
}

}  // namespace

void PenDecoder::begin(const PenRanges& ranges, double width, double height) {
  *this = PenDecoder();
  ranges_ = ranges;
  width_ = width;
  height_ = height;
  if (!ranges.distance.present()) next_.height = 0;
}

bool PenDecoder::take(const char* bytes, std::size_t size) {
  static_assert(sizeof(input_event) <= sizeof part_);
  bool whole = false;
  for (std::size_t at = 0; at < size;) {
    const std::size_t n = std::min(sizeof(input_event) - have_, size - at);
    std::memcpy(part_ + have_, bytes + at, n);
    have_ += n;
    at += n;
    if (have_ < sizeof(input_event)) break;
    have_ = 0;
    input_event e;
    std::memcpy(&e, part_, sizeof e);
    if (e.type == EV_SYN && e.code == SYN_REPORT)
      whole |= report(static_cast<double>(e.input_event_sec) + 1e-6 * static_cast<double>(e.input_event_usec));
    else
      event(e.type, e.code, e.value);
  }
  return whole;
}

void PenDecoder::event(uint16_t type, uint16_t code, int32_t value) {
  if (type == EV_SYN && code == SYN_DROPPED) {
    dropping_ = true;
    ++lost_;
    return;
  }
  const auto button = [&](uint32_t bit) { next_.buttons = value != 0 ? next_.buttons | bit : next_.buttons & ~bit; };
  if (type == EV_KEY) {
    if (code == BTN_TOOL_PEN || code == BTN_TOOL_RUBBER) next_.near = value != 0;
    if (code == BTN_TOUCH) next_.touches = value != 0;
    if (code == BTN_STYLUS) button(1);
    if (code == BTN_STYLUS2) button(2);
  } else if (type == EV_ABS) {
    // the kernel's y points down, towards the user
    if (code == ABS_X) next_.x = place(ranges_.x, value, width_);
    if (code == ABS_Y) next_.y = -place(ranges_.y, value, height_);
    if (code == ABS_PRESSURE) next_.pressure = share(ranges_.pressure, value);
    if (code == ABS_DISTANCE) next_.height = share(ranges_.distance, value);
    if (code == ABS_TILT_X) next_.tilt_x = tilt(ranges_.tilt_x, value);
    if (code == ABS_TILT_Y) next_.tilt_y = -tilt(ranges_.tilt_y, value);
  }
}

// After a loss the first report may be incomplete: the next one counts. Axes that did not change meanwhile are not sent again; those
// that did change are sent with the next motion.
bool PenDecoder::report(double time_s) {
  if (dropping_) {
    dropping_ = false;
    return false;
  }
  state_ = next_;
  state_.time_s = time_s;
  return true;
}

}  // namespace swage::tablet
