// SPDX-License-Identifier: Apache-2.0
//
// What a lesson puts between any device and the scene: filters of its poses, and the law by which forces come back to the hand.
#pragma once

#include <cstdint>
#include <vector>

namespace swage::host {

/// Filters of a device's poses, in the device's frame and before the motion scale, in this order. Zero: none.
struct HandFilters {
  double rate = 0;       // 1/s: the pose is a deflection and leads by so many times itself per second; 0: it is a place
  double low_pass = 0;   // Hz, cut-off of a first-order filter; normal 5 to 30. Lower lags by more than 30 ms
  double dead_band = 0;  // m at the hand: play within which the tool stays; of a deflection: what leads nowhere
  double dead_turn = 0;  // rad, likewise
  uint32_t clutch = 0;   // bits of buttons: while one is down the tool stays, and goes on without a leap afterwards
  uint32_t clutch_device = ~0u;  // whose buttons these are, of the lesson's devices: a pedal, say; ~0: its own

  bool shape() const { return rate > 0 || low_pass > 0 || dead_band > 0 || dead_turn > 0; }
};

/// From the size f of a force in the scene to that at the hand before the force scale; the direction stays.
enum class Law : int32_t {
  kProportional,  // f
  kNullZone,      // max(0, f - from): nothing is felt below `from`, and it begins softly
  kThreshold,     // f above `from`, else 0: the force begins with a step
  kQuadratic,     // f^2 / from: as it is at `from`, less below, more above
  kTable          // straight between points; beyond the last as in its last piece
};

struct Reaction {
  struct Point {
    double scene, hand;  // N
  };
  Law law = Law::kProportional;
  double from = 0;           // N
  std::vector<Point> table;  // at least two, both columns rising from 0
};

/// Spring and damper at the hand, between it and its tool: what is felt of a tool that does not follow, as a fixed solid stops it. Zero:
/// nothing. Normal 200 N/m and 1 N s/m; stiffer than twice the damping of arm and hand over the period of the loop, the wall rings.
struct HandCoupling {
  double stiffness = 0;  // N/m
  double damping = 0;    // N s/m
};

}  // namespace swage::host
