// SPDX-License-Identifier: Apache-2.0
//
// A pen on a tablet, from the kernel's input events to places, angles and pressure. Pure arithmetic. [any]
#pragma once

#include <cstddef>
#include <cstdint>

namespace swage::tablet {

/// One axis as the kernel describes it; present when it has a range.
struct AxisRange {
  int32_t minimum = 0, maximum = 0;
  int32_t resolution = 0;  // units per mm, or per rad for tilts; 0: not said
  bool present() const { return maximum > minimum; }
};

struct PenRanges {
  AxisRange x, y, pressure, distance, tilt_x, tilt_y;
};

/// What a pen does now. SI; x to the right and y up from the middle of the surface, tilts towards +x and +y.
struct PenState {
  bool near = false, touches = false;
  double x = 0, y = 0;            // m
  double pressure = 0;            // 0..1
  double height = 0;              // 0 on the surface .. 1 where it is lost
  double tilt_x = 0, tilt_y = 0;  // rad from upright
  uint32_t buttons = 0;           // bit 0: the first on the pen, 1: the second
  double time_s = 0;              // of the last whole report, on the clock of the events
};

/// Puts events together to reports. What comes between a loss of events and the next whole report is not believed.
class PenDecoder {
 public:
  /// `width`, `height`: m, of the surface where the kernel says no resolution.
  void begin(const PenRanges& ranges, double width, double height);
  /// Bytes of `struct input_event`, cut anywhere. True when a whole report has ended in them: state() is new.
  bool take(const char* bytes, std::size_t size);
  const PenState& state() const { return state_; }
  uint32_t lost() const { return lost_; }  // times that the kernel had to drop events

 private:
  void event(uint16_t type, uint16_t code, int32_t value);
  bool report(double time_s);
  PenRanges ranges_;
  double width_ = 0.2, height_ = 0.12;
  PenState state_, next_;
  char part_[32]{};  // of an event that has begun
  std::size_t have_ = 0;
  uint32_t lost_ = 0;
  bool dropping_ = false;
};

}  // namespace swage::tablet
