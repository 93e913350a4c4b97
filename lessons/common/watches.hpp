// SPDX-License-Identifier: Apache-2.0
//
// Observers for several lessons: path length and smoothness of the tips, and dropped objects. Each keeps its state in a struct of doubles
// that a lesson puts among its private numbers.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "common/low_pass.hpp"
#include "common/smoothness.hpp"
#include "toolkit/math.hpp"

namespace swage::lessons {

// Upper limit of a hand's voluntary movement, Hz: tremor (8-12 Hz) must not count as path length.
inline constexpr double kVoluntary = 6;

/// Path length of a point without tremor, and the time when it set off.
struct PathState {
  LowPass4State x, y, z;
  double last[3] = {0, 0, 0};  // m, filtered
  double length = 0;           // m
  double quick_s = 0;          // s, for which it has been quicker than 2 mm/s
  double set_off_s = -1;       // s, when the movement began; -1: not yet
  MovesState moves;
};

class PathWatch {
 public:
  PathWatch() = default;
  explicit PathWatch(double dt) : filter_(kVoluntary, dt), moves_(dt), dt_(dt) {}

  /// Observes the point in one step. [rt]
  void look(PathState& state, const Vec3& p_W, double time_s) const noexcept {
    const bool first = state.x.first.started == 0;
    const Vec3 now(filter_.next(state.x, p_W.x()), filter_.next(state.y, p_W.y()),
                   filter_.next(state.z, p_W.z()));
    Eigen::Map<Vec3> last(state.last);
    const double way = first ? 0 : (now - last).norm();
    last = now;
    state.length += way;
    moves_.look(state.moves, now);

    // the point has set off once it has been quicker than 2 mm/s for 0.1 s
    constexpr double kRest = 2e-3, kFor = 0.1;
    state.quick_s = way > kRest * dt_ ? state.quick_s + dt_ : 0;
    if (state.set_off_s < 0 && state.quick_s >= kFor) state.set_off_s = time_s - state.quick_s;
  }

 private:
  LowPass4 filter_;
  MovesWatch moves_;
  double dt_ = 1e-3;
};

/// Median over the movements of all hands: `which` is &MovesState::sparc or &MovesState::ldlj. Empty before the first movement. [rt]
inline std::optional<double> smoothness(std::span<const PathState> hands, MedianState MovesState::*which) noexcept {
  MedianState all;
  for (const PathState& hand : hands) {
    const MedianState& one = hand.moves.*which;
    for (size_t i = 0; i < static_cast<size_t>(one.n); ++i) add_value(all, one.value[i]);
  }
  if (all.n == 0) return std::nullopt;
  return median(all);
}

/// Time since the first of several hands set off, s; 0 before. [rt]
inline double time_since_set_off(std::span<const PathState> hands, double time_s) noexcept {
  double first = -1;
  for (const PathState& hand : hands)
    if (hand.set_off_s >= 0 && (first < 0 || hand.set_off_s < first)) first = hand.set_off_s;
  return first < 0 ? 0 : time_s - first;
}

/// An object that should be held or lie still, and the place from which a drop is measured.
struct DropState {
  double armed = 0;          // 0 or 1
  double at[3] = {0, 0, 0};  // m, place where it was last held or rested
};

class DropWatch {
 public:
  DropWatch() = default;
  /// `distance` [m]: an object further than this from its last place, and not held, has been dropped.
  explicit DropWatch(double distance) : distance_(distance) {}

  /// True in the step in which the object is found dropped. [rt]
  bool look(DropState& state, const Vec3& p_W, bool held) const noexcept {
    Eigen::Map<Vec3> at(state.at);
    if (held) {
      at = p_W;
      state.armed = 1;
      return false;
    }
    if (state.armed == 0) return false;
    if ((p_W - at).norm() <= distance_) return false;
    state.armed = 0;
    return true;
  }

  /// Sets the place of a resting object; leaving it without being held is a drop from now on. [rt]
  static void rest(DropState& state, const Vec3& p_W) noexcept {
    Eigen::Map<Vec3>(state.at) = p_W;
    state.armed = 1;
  }

 private:
  double distance_ = 2e-3;
};

}  // namespace swage::lessons
