// SPDX-License-Identifier: LGPL-3.0-or-later
//
// When a picture of the scene is drawn, how often pictures come, and how long a movement takes to its picture. Free of Qt. [main]
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "console/view3d/frame_times.hpp"

namespace swage::console {

class PicturePace {
 public:
  /// Something changed: at least so many pictures are to come. Meshes load in the background, and the first are without them.
  void want(int pictures) {
    to_draw_ = std::max(to_draw_, pictures);
    alike_ = 0;
  }
  /// Nothing moves, and the last pictures were alike: what is seen is what there is, however slow the machine.
  bool resting() const { return to_draw_ == 0 && alike_ >= kAlike; }

  /// Asked at each tick of the display; whether a picture is drawn now. A processor that draws has less left for the session: every other
  /// picture is enough for it.
  bool due(bool by_processor) {
    if (resting()) {
      moved_ns_ = sampled_ns_ = drawn_ns_ = -1;
      frames_.rest();
      return false;
    }
    skip_ = by_processor && !skip_;
    if (skip_) return false;
    to_draw_ = std::max(0, to_draw_ - 1);
    if (sampled_ns_ >= 0 && drawn_ns_ < 0) drawn_ns_ = sampled_ns_;
    return true;
  }
  /// A hand moved the instrument.
  void moved(int64_t now_ns) {
    if (moved_ns_ < 0) moved_ns_ = now_ns;
  }
  /// A snapshot came that is another than the last: it may show the movement.
  void sampled() {
    if (moved_ns_ >= 0 && sampled_ns_ < 0) sampled_ns_ = moved_ns_;
  }
  /// A picture came that is still empty.
  void empty() { alike_ = 0; }
  /// A picture came; `same` as the last.
  void arrived(int64_t now_ns, bool same) {
    alike_ = same ? alike_ + 1 : 0;
    frames_.add(now_ns);
    ++arrived_;
    if (drawn_ns_ < 0) return;
    shows_ns_ = drawn_ns_;
    moved_ns_ = sampled_ns_ = drawn_ns_ = -1;
  }
  /// The last picture that came is on its way to the screen.
  void painted(int64_t now_ns) {
    if (shows_ns_ >= 0) latency_.add_time(1e-9 * static_cast<double>(now_ns - std::exchange(shows_ns_, -1)));
  }

  const FrameTimes& frames() const { return frames_; }
  /// Pictures that came.
  uint64_t count() const { return arrived_; }
  /// From a movement to the first picture painted that can show it.
  const FrameTimes& latency() const { return latency_; }

 private:
  static constexpr int kAlike = 3;  // pictures in a row; less, and a mesh that is still being loaded is missed
  int to_draw_ = 0;                 // pictures still wanted
  int alike_ = 0;                   // pictures in a row that were the same
  bool skip_ = false;
  FrameTimes frames_, latency_;
  uint64_t arrived_ = 0;
  int64_t moved_ns_ = -1;    // the oldest movement that no picture shows yet
  int64_t sampled_ns_ = -1;  // and that a snapshot since then may show
  int64_t drawn_ns_ = -1;    // and that the picture under way shows
  int64_t shows_ns_ = -1;    // and that the next paint brings to the screen
};

}  // namespace swage::console
