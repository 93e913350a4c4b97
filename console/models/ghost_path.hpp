// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An expert's instruments on their way through a lesson, and a ghost that goes this way at the pace of somebody else: it shows what
// comes next and waits there. No widgets.
#pragma once

#include <swage/abi/base.h>
#include <swage/abi/lesson.h>

#include <cstdint>
#include <span>
#include <vector>

namespace swage::console {

/// A place on a body, m, in the body's frame.
struct BodyPlace {
  uint32_t body = 0;
  swage_vec3 p_B{};
};

/// One moment of the way.
struct GhostFrame {
  double time_s = 0;
  uint32_t phase = SWAGE_NONE;
  std::vector<swage_pose> X_WB;    // of the bodies up to the last one of an instrument
  std::vector<swage_vec3> p_W{};   // m; the places by which instruments are compared
  double way_m = 0;                // of these places in the mean, since the first frame
};

/// Grows while the expert is still on the way. How far two positions of the instruments are apart is the mean distance of places on
/// them, tips and middles: so a turn and jaws that close count as well as a move.
class GhostPath {
 public:
  explicit GhostPath(std::vector<BodyPlace> places) : places_(std::move(places)) {}
  void add(double time_s, uint32_t phase, std::span<const swage_pose> X_WB);
  bool empty() const { return frames_.empty(); }
  size_t size() const { return frames_.size(); }
  const GhostFrame& operator[](size_t i) const { return frames_[i]; }
  /// m, of these instruments from frame i.
  double distance(size_t i, std::span<const swage_vec3> p_W) const;
  std::vector<swage_vec3> places_of(std::span<const swage_pose> X_WB) const;

 private:
  std::vector<BodyPlace> places_;
  std::vector<GhostFrame> frames_;
};

/// Where the ghost is. Progress is the nearest point of the way within the phase that the trainee is in; the ghost goes on from there
/// at the expert's pace, at most by kLead, and never out of the phase.
class GhostPace {
 public:
  /// m of way. A third of a needle: enough to see whereto and how; further ahead it would be a demonstration.
  static constexpr double kLead_m = 3e-3;

  explicit GhostPace(const GhostPath& path) : path_(path) {}
  /// The trainee's instruments, and the seconds since the last call.
  void follow(std::span<const swage_pose> X_WB, uint32_t phase, double dt_s);
  /// The frame that the trainee has come to.
  size_t progress() const { return progress_; }
  /// Seconds into the expert's way: where the ghost stands.
  double shown_s() const { return shown_s_; }
  double shown_way_m() const;
  /// Poses of the ghost's bodies; empty before the first frame.
  void pose(std::vector<swage_pose>& X_WB) const;

 private:
  void look_for_progress(std::span<const swage_vec3> p_W, uint32_t phase);
  std::pair<size_t, double> between() const;  // the frame before the ghost, and the share of the way to the next

  const GhostPath& path_;
  uint32_t phase_ = SWAGE_NONE;
  bool begun_ = false, found_ = false;
  size_t progress_ = 0;
  double shown_s_ = 0;
};

}  // namespace swage::console
