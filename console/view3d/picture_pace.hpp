// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Decides when a picture of the scene is drawn; measures the picture rate and the latency from movement to picture. Free of Qt. [main]
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "console/view3d/frame_times.hpp"

namespace swage::console {

class PicturePace {
 public:
  /// A change: at least so many pictures are to be drawn. Meshes load in the background, and the first pictures lack them.
  void want(int pictures) {
    to_draw_ = std::max(to_draw_, pictures);
    alike_ = 0;
  }
  /// No motion, and the last pictures were equal: the picture is complete, however slow the machine.
  bool resting() const { return to_draw_ == 0 && alike_ >= kAlike; }

  /// To be called at each tick of the display; true when a picture is drawn now. Software rendering takes processor time from the session:
  /// it draws every other picture.
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
  /// A person moved the instrument.
  void moved(int64_t now_ns) {
    if (moved_ns_ < 0) moved_ns_ = now_ns;
  }
  /// A new snapshot came: it may show the movement.
  void sampled() {
    if (moved_ns_ >= 0 && sampled_ns_ < 0) sampled_ns_ = moved_ns_;
  }
  /// A picture without content came.
  void empty() { alike_ = 0; }
  /// A picture came; `same`: equal to the last one.
  void arrived(int64_t now_ns, bool same) {
    alike_ = same ? alike_ + 1 : 0;
    frames_.add(now_ns);
    ++arrived_;
    if (drawn_ns_ < 0) return;
    shows_ns_ = drawn_ns_;
    moved_ns_ = sampled_ns_ = drawn_ns_ = -1;
  }
  /// The last picture was painted to the screen.
  void painted(int64_t now_ns) {
    if (shows_ns_ >= 0) latency_.add_time(1e-9 * static_cast<double>(now_ns - std::exchange(shows_ns_, -1)));
  }

  const FrameTimes& frames() const { return frames_; }
  /// Number of pictures received.
  uint64_t count() const { return arrived_; }
  /// From a movement to the first painted picture that can show it.
  const FrameTimes& latency() const { return latency_; }

 private:
  static constexpr int kAlike = 3;  // equal pictures in a row; with less, a mesh still being loaded is missed
  int to_draw_ = 0;                 // pictures still to draw
  int alike_ = 0;                   // equal pictures in a row
  bool skip_ = false;
  FrameTimes frames_, latency_;
  uint64_t arrived_ = 0;
  int64_t moved_ns_ = -1;    // the oldest movement that no picture shows yet
  int64_t sampled_ns_ = -1;  // of these, the movement that a snapshot since then may show
  int64_t drawn_ns_ = -1;    // of these, the movement that the picture being drawn shows
  int64_t shows_ns_ = -1;    // of these, the movement that the next paint shows
};

}  // namespace swage::console
