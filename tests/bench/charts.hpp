// SPDX-License-Identifier: Apache-2.0
//
// Work-precision charts: error against cost for every method of ours and every peer, in one run.
#pragma once

#include "chart.hpp"

namespace swage::bench {

Scatter chart_queries(bool quick);  // depth against the exact arc, per query
Scatter chart_free(bool quick);     // energy of a free top after a minute, per step
Scatter chart_grasp(bool quick);    // slip of a held needle, per step

}  // namespace swage::bench
