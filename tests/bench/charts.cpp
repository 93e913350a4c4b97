// SPDX-License-Identifier: Apache-2.0
#include "charts.hpp"

#include "queries.hpp"
#include "scenario.hpp"

namespace swage::bench {
namespace {

std::vector<Method> methods() {
  std::vector<Method> all;
  for (auto&& list : {swage_methods(), ode_methods(), mujoco_methods(), bullet_methods()})
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

Scatter chart_queries(bool quick) {
  Scatter c;
  c.title = "Needle against jaws: one query, 10,000 poses";
  c.x = {"worst error of a depth against the exact arc, um", 1e-6, 100, true, "exact", "misses contacts"};
  c.y = {"mean time of a query, ns", 10, 1e6, true, "", ""};
  for (const QueryFigures& f : measure_queries(Needle{}, quick ? 1 : 5))
    c.marks.push_back({f.family, f.name, std::max(f.worst_error * 1e6, 1e-6), f.all.mean});
  return c;
}

Scatter chart_free(bool quick) {
  Scatter c;
  c.title = "Free rigid body: asymmetric top at 30 rad/s for a minute";
  c.x = {"worst |E/E0 - 1|", 1e-14, 10, true, "", "diverged"};
  c.y = {"median time of a step of 1 ms, ns", 10, 1e4, true, "", ""};
  const Vec3 w0 = 30 * Vec3(0.01, 1, 0.01).normalized();
  for (const Method& m : methods()) {
    // settings that only matter for contacts give the same mark again
    const bool same = m.name.find("iterations") != m.name.npos || m.name.find("soft") != m.name.npos ||
                      m.name.find("chain") != m.name.npos || m.name.find("impulse") != m.name.npos ||
                      m.name.find("tuned") != m.name.npos || m.name == "ODE QuickStep";
    if (same) continue;
    const TopResult r = top(m, {}, {1e-12, 2e-12, 3e-12}, w0, quick ? 5 : 60);
    c.marks.push_back({m.family, m.name, std::max(r.energy, 1e-14), r.step.median});
  }
  return c;
}

Scatter chart_grasp(bool quick) {
  Scatter c;
  c.title = "Grasp: curved needle held under gravity, overlap 1 um";
  const double seconds = quick ? 2 : 60;
  c.x = {"slip after " + std::to_string(static_cast<int>(seconds)) + " s, um",
         1e-7,
         1e3,
         true,
         "none measurable",
         "lost"};
  c.y = {"median time of a step of 1 ms, ns", 100, 1e6, true, "", ""};
  for (const Method& m : methods()) {
    const bool free_only = m.name.find("Euler") != m.name.npos || m.name.find("RK4") != m.name.npos ||
                           m.name.find("splitting") != m.name.npos || m.name.find("implicit") != m.name.npos;
    if (free_only) continue;
    const HoldResult r = hold(m, {}, 1e-6, seconds);
    c.marks.push_back({m.family, m.name, r.lost_at < 0 ? std::max(r.worst * 1e6, 1e-7) : 1e9, r.step.median});
  }
  return c;
}

}  // namespace swage::bench
