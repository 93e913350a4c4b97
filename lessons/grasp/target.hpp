// SPDX-License-Identifier: Apache-2.0
//
// The target to which the needle is carried and where it is held (thesis 6.2.4).
#pragma once

#include <cmath>

namespace swage::lesson_grasp {

/// Effect of leaving the target during the hold.
enum class Leave : int { kRestart, kPause, kFail };

struct TargetRules {
  bool carry = false;
  double radius = 0.5e-3;  // m
  Leave leave = Leave::kRestart;
};

struct TargetState {
  double drawn = 0;                  // 0 or 1
  double p_W[3] = {0, 0, 0};         // m
  double inside = 0;                 // 0 or 1
  double first_s = -1;               // s, when it was first reached; -1: not yet
  double hold_began_s = 0;           // s, start of the present hold
  double inside_s = 0, since_s = 0;  // s, time within the radius; s, time since it was first reached
  double square_s = 0, held_s = 0;   // m2 s, integral of the squared distance during holds; s, their time
  double breaks = 0;
};

class Target {
 public:
  Target() = default;
  explicit Target(const TargetRules& rules) : rules_(rules) {}

  /// Whether the needle, at this distance [m], is at the target; it leaves the target at 1.1 radii (hysteresis). [rt]
  bool look(TargetState& state, double distance, double time_s, double dt) const noexcept {
    constexpr double kLeaves = 1.1;
    if (state.first_s >= 0) state.since_s += dt;
    state.inside = distance <= (state.inside != 0 ? kLeaves : 1.0) * rules_.radius ? 1 : 0;
    if (state.inside == 0) return false;
    if (state.first_s < 0) {
      state.first_s = time_s;
      state.since_s = dt;
    }
    state.inside_s += dt;
    return true;
  }
  /// Adds one step of a hold. [rt]
  static void hold(TargetState& state, double distance, double dt) noexcept {
    state.square_s += distance * distance * dt;
    state.held_s += dt;
  }
  const TargetRules& rules() const { return rules_; }

 private:
  TargetRules rules_;
};

inline double hold_error(const TargetState& state) {
  return state.held_s > 0 ? std::sqrt(state.square_s / state.held_s) : 0;
}
/// Share of the time at the target since it was first reached; 0 before.
inline double in_target(const TargetState& state) {
  return state.since_s > 0 ? state.inside_s / state.since_s : 0;
}

}  // namespace swage::lesson_grasp
