// SPDX-License-Identifier: Apache-2.0
//
// Work-precision charts: error against cost for every method of ours and every peer, in one run.
#pragma once

#include "chart.hpp"

namespace swage::bench {

Scatter chart_queries(bool quick);  // depth against the exact arc, per query
Scatter chart_free(bool quick);     // attitude of a free top after a minute, per simulated millisecond
Scatter chart_grasp(bool quick);    // slip of a held needle, per step
Scatter chart_slip(bool quick);     // where a pulled wire begins to slip, per step
Scatter chart_bend(bool quick);     // how far a needle bends under a force, per step of a grasp with it
Scatter chart_keep(bool quick);     // the angle that it keeps, per step
Scatter chart_thread(bool quick);   // how far a thread held by one end hangs from the exact elastica, per simulated millisecond
Sweep chart_directions(bool quick);  // what Newton's direction of a thread costs over its contacts, beside ODE's exact grasp step
Scatter chart_dent(bool quick);     // how deep tissue is dented, per step of an insertion into it

struct ChartOf {
  const char* name;  // of its files, work_precision_<name>
  Scatter (*draw)(bool quick);
};
inline constexpr ChartOf kCharts[] = {{"query", chart_queries}, {"free", chart_free}, {"grasp", chart_grasp},
                                      {"slip", chart_slip},     {"bend", chart_bend}, {"keep", chart_keep},
                                      {"dent", chart_dent},     {"thread", chart_thread}};

}  // namespace swage::bench
