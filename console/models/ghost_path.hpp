// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The path of an expert's instruments through a lesson, and a ghost that follows it at the trainee's pace: it shows the next
// motion and waits there. No widgets.
#pragma once

#include <swage/abi/base.h>
#include <swage/abi/lesson.h>

#include <cstdint>
#include <span>
#include <vector>

namespace swage::console {

/// A point on a body, m, in the body's frame.
struct BodyPlace {
  uint32_t body = 0;
  swage_vec3 p_B{};
};

/// One sample of the path.
struct GhostFrame {
  double time_s = 0;
  uint32_t phase = SWAGE_NONE;
  std::vector<swage_pose> X_WB;    // of all bodies up to the last one of an instrument
  std::vector<swage_vec3> p_W{};   // m; the points by which instruments are compared
  double way_m = 0;                // mean path length of these points since the first frame
};

/// Grows while the expert is playing. The distance between two states of the instruments is the mean distance of their
/// points, tips and centres, so that rotation and closing of the jaws count as well as translation.
class GhostPath {
 public:
  explicit GhostPath(std::vector<BodyPlace> places) : places_(std::move(places)) {}
  void add(double time_s, uint32_t phase, std::span<const swage_pose> X_WB);
  bool empty() const { return frames_.empty(); }
  size_t size() const { return frames_.size(); }
  const GhostFrame& operator[](size_t i) const { return frames_[i]; }
  /// Distance of these instruments from frame i, m.
  double distance(size_t i, std::span<const swage_vec3> p_W) const;
  std::vector<swage_vec3> places_of(std::span<const swage_pose> X_WB) const;

 private:
  std::vector<BodyPlace> places_;
  std::vector<GhostFrame> frames_;
};

/// The position of the ghost. Progress is the nearest point of the path within the trainee's phase; from there the ghost advances
/// at the expert's pace, by at most kLead_m, and never beyond the phase.
class GhostPace {
 public:
  /// Lead in path length, m: a third of a needle, enough to show direction and technique; a longer lead would be a demonstration.
  static constexpr double kLead_m = 3e-3;

  explicit GhostPace(const GhostPath& path) : path_(path) {}
  /// `X_WB`: the trainee's instruments. `dt_s`: time since the last call.
  void follow(std::span<const swage_pose> X_WB, uint32_t phase, double dt_s);
  /// The frame that the trainee has reached.
  size_t progress() const { return progress_; }
  /// Time on the expert's path at which the ghost stands, s.
  double shown_s() const { return shown_s_; }
  double shown_way_m() const;
  /// Poses of the ghost's bodies; empty before the first frame.
  void pose(std::vector<swage_pose>& X_WB) const;

 private:
  void look_for_progress(std::span<const swage_vec3> p_W, uint32_t phase);
  std::pair<size_t, double> between() const;  // the frame before the ghost, and the fraction of the interval to the next

  const GhostPath& path_;
  uint32_t phase_ = SWAGE_NONE;
  bool begun_ = false, found_ = false;
  size_t progress_ = 0;
  double shown_s_ = 0;
};

}  // namespace swage::console
