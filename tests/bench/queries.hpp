// SPDX-License-Identifier: Apache-2.0
//
// The 10,000-pose trajectory and what every collision query makes of it.
#pragma once

#include "engine.hpp"
#include "timing.hpp"

namespace swage::bench {

enum class Phase { kFar, kNear, kTouching, kGrasped };
inline constexpr int kPhases = 4;

struct Frame {
  Pose needle, upper, lower;
  Phase phase = Phase::kFar;
  double arc_gap[2] = {0, 0};  // m, exact, by search (reference.hpp)
};

/// Far (tool 30 to 8 mm away), near (needle between open jaws), one jaw touching (gap +20 to -4 um), grasped (overlap 0.5 to
/// 3.4 um), 30/30/20/20 %, smooth wobble in all axes. Deterministic.
std::vector<Frame> trajectory(const Needle&, int poses);

struct QueryFigures {
  std::string family, name;
  Times all, phase[kPhases];       // ns, per-pose medians over the passes
  int missed = 0, invented = 0;    // contacts beyond 0.1 um against the exact arc
  int overlapping = 0, apart = 0;  // how many pairs there were of each
  double worst_error = 0;  // m, of a depth against the exact arc; a missed contact counts with its depth
};

/// All queries that are compiled in, interleaved pose by pose.
std::vector<QueryFigures> measure_queries(const Needle&, int passes, int poses = 10000);

}  // namespace swage::bench
