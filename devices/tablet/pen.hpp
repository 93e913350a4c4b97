// SPDX-License-Identifier: Apache-2.0
//
// A pen on a tablet: converts the kernel's input events to positions, angles and pressure. Pure arithmetic. [any]
#pragma once

#include <cstddef>
#include <cstdint>

namespace swage::tablet {

/// One axis as the kernel describes it; present when its range is not empty.
struct AxisRange {
  int32_t minimum = 0, maximum = 0;
  int32_t resolution = 0;  // units per mm, or per rad for tilts; 0: unknown
  bool present() const { return maximum > minimum; }
};

struct PenRanges {
  AxisRange x, y, pressure, distance, tilt_x, tilt_y;
};

/// State of a pen. SI; x to the right and y up from the middle of the surface, tilts towards +x and +y.
struct PenState {
  bool near = false, touches = false;
  double x = 0, y = 0;            // m
  double pressure = 0;            // 0..1
  double height = 0;              // 0 on the surface .. 1 at the limit of detection
  double tilt_x = 0, tilt_y = 0;  // rad from upright
  uint32_t buttons = 0;           // bit 0: the first on the pen, 1: the second
  double time_s = 0;              // of the last complete report, on the clock of the events
};

/// Assembles events to reports. Events between a loss and the next complete report are discarded.
class PenDecoder {
 public:
  /// `width`, `height`: m, size of the surface where the kernel gives no resolution.
  void begin(const PenRanges& ranges, double width, double height);
  /// Bytes of `struct input_event`, split anywhere. True when they complete a report: state() is new.
  bool take(const char* bytes, std::size_t size);
  const PenState& state() const { return state_; }
  uint32_t lost() const { return lost_; }  // number of times that the kernel dropped events

 private:
  void event(uint16_t type, uint16_t code, int32_t value);
  bool report(double time_s);
  PenRanges ranges_;
  double width_ = 0.2, height_ = 0.12;
  PenState state_, next_;
  char part_[32]{};  // bytes of an incomplete event
  std::size_t have_ = 0;
  uint32_t lost_ = 0;
  bool dropping_ = false;
};

}  // namespace swage::tablet
