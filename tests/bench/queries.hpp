// SPDX-License-Identifier: Apache-2.0
//
// What every collision query makes of the trajectory (trajectory.hpp).
#pragma once

#include "engine.hpp"
#include "timing.hpp"
#include "trajectory.hpp"

namespace swage::bench {

struct QueryFigures {
  std::string family, name;
  Times all, phase[kPhases];       // ns, per-pose medians over the passes
  int missed = 0, invented = 0;    // contacts beyond 0.1 um against the exact arc
  int overlapping = 0, apart = 0;  // how many pairs there were of each
  double worst_error = 0;  // m, of a depth against the exact arc; a missed contact counts with its depth
};

/// All queries that are compiled in, interleaved block by block.
std::vector<QueryFigures> measure_queries(const Needle&, int passes, int poses = 10000);

/// S03: the needle pressed by `overlap` [m] into the middle of each face, edge and corner of a jaw. Worst error of a depth for
/// each query, in the order of all_queries(); infinity where one saw nothing or read less depth for more overlap.
std::vector<double> overlap_errors(double overlap);

}  // namespace swage::bench
