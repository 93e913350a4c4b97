// SPDX-License-Identifier: Apache-2.0
//
// What several lessons watch: the way of the tips and how smooth it is, and things that fall. Each keeps its memory in a struct of doubles that
// a lesson puts among its private numbers.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "common/low_pass.hpp"
#include "common/smoothness.hpp"
#include "toolkit/math.hpp"

namespace swage::lessons {

// Voluntary movement of a hand lies below this, Hz: tremor (8-12 Hz) must not count as way travelled.
inline constexpr double kVoluntary = 6;

/// Way of a point, its voluntary part only; and when it set off.
struct PathState {
  LowPass4State x, y, z;
  double last[3] = {0, 0, 0};  // m, filtered
  double length = 0;           // m
  double quick_s = 0;          // s, how long it has been quicker than a rest
  double set_off_s = -1;       // s, when the movement began; -1: not yet
  MovesState moves;
};

class PathWatch {
 public:
  PathWatch() = default;
  explicit PathWatch(double dt) : filter_(kVoluntary, dt), moves_(dt), dt_(dt) {}

  /// [rt]
  void look(PathState& state, const Vec3& p_W, double time_s) const noexcept {
    const bool first = state.x.first.started == 0;
    const Vec3 now(filter_.next(state.x, p_W.x()), filter_.next(state.y, p_W.y()),
                   filter_.next(state.z, p_W.z()));
    Eigen::Map<Vec3> last(state.last);
    const double way = first ? 0 : (now - last).norm();
    last = now;
    state.length += way;
    moves_.look(state.moves, now);

    // it has set off once it was quicker than 2 mm/s for 0.1 s
    constexpr double kRest = 2e-3, kFor = 0.1;
    state.quick_s = way > kRest * dt_ ? state.quick_s + dt_ : 0;
    if (state.set_off_s < 0 && state.quick_s >= kFor) state.set_off_s = time_s - state.quick_s;
  }

 private:
  LowPass4 filter_;
  MovesWatch moves_;
  double dt_ = 1e-3;
};

/// Median over the movements of all hands: `which` is &MovesState::sparc or &MovesState::ldlj. Nothing before there was one. [rt]
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

/// A thing that should be held or lie still, and whether it fell.
struct DropState {
  double armed = 0;          // 0 or 1
  double at[3] = {0, 0, 0};  // m, where it was left
};

class DropWatch {
 public:
  DropWatch() = default;
  /// It has dropped when it is further than this from where it was left [m].
  explicit DropWatch(double distance) : distance_(distance) {}

  /// True in the step in which the thing has dropped. [rt]
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

  /// The thing rests here; from now on leaving the place unheld is a drop. [rt]
  static void rest(DropState& state, const Vec3& p_W) noexcept {
    Eigen::Map<Vec3>(state.at) = p_W;
    state.armed = 1;
  }

 private:
  double distance_ = 2e-3;
};

}  // namespace swage::lessons
