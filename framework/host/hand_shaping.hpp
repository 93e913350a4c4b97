// SPDX-License-Identifier: Apache-2.0
//
// Processing that a lesson puts between a device and the scene: filters of poses, and the law by which forces are sent to the hand.
#pragma once

#include <cstdint>
#include <vector>

namespace swage::host {

/// Filters of a device's poses, in the device's frame and before the motion scale, in this order. Zero: off.
struct HandFilters {
  double rate = 0;       // 1/s: the pose is a deflection and sets a velocity of this many times itself; 0: the pose is a position
  double low_pass = 0;   // Hz, cut-off of a first-order filter; usual 5 to 30. Lower lags by more than 30 ms
  double dead_band = 0;  // m at the hand: play within which the tool does not move; of a deflection: dead zone
  double dead_turn = 0;  // rad, likewise
  uint32_t clutch = 0;   // button bits: while one is down the tool rests, and continues without a jump afterwards
  uint32_t clutch_device = ~0u;  // the lesson's device whose buttons these are, such as a pedal; ~0: the device itself

  bool shape() const { return rate > 0 || low_pass > 0 || dead_band > 0 || dead_turn > 0; }
};

/// Maps the size f of a force in the scene to that at the hand, before the force scale; the direction is kept.
enum class Law : int32_t {
  kProportional,  // f
  kNullZone,      // max(0, f - from): zero below `from`, continuous
  kThreshold,     // f above `from`, else 0: the force begins with a step
  kQuadratic,     // f^2 / from: equal to f at `from`, less below, more above
  kTable          // linear between points; continued beyond the last with the slope of the last piece
};

struct Reaction {
  struct Point {
    double scene, hand;  // N
  };
  Law law = Law::kProportional;
  double from = 0;           // N
  std::vector<Point> table;  // at least two, both columns rising from 0
};

/// Spring and damper at the hand, between it and its tool: force of a tool that does not follow the hand, as at a fixed solid. Zero:
/// none. Usual 200 N/m and 1 N s/m; with a stiffness above twice the damping of arm and hand over the loop period the wall vibrates.
struct HandCoupling {
  double stiffness = 0;  // N/m
  double damping = 0;    // N s/m
};

}  // namespace swage::host
