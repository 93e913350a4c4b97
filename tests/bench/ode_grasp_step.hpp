// SPDX-License-Identifier: Apache-2.0
//
// The yardstick of what a thread costs.
#pragma once

#include <cmath>

#include "grip.hpp"
#include "timing.hpp"

namespace swage::bench {

/// Step of ODE's exact solver with soft contacts that holds a needle between two jaws [ns]; NaN where it is not installed.
inline double ode_grasp_step() {
  constexpr int kSteps = 2000;
  for (const Method& m : ode_methods()) {
    if (m.name != "ODE exact, soft contacts") continue;
    const Setup setup;
    const auto engine = m.make(setup);
    const Openings openings(m, setup.needle, 1e-6);
    engine->set_gravity(Vec3::Zero());
    openings.apply(*engine, Pose{}, true);
    engine->set_needle(grip_pose(setup.needle), Vec3::Zero(), Vec3::Zero());
    std::vector<double> ns;
    for (int i = 0; i < kSteps; ++i) {
      const double begin = cpu_ns();
      openings.apply(*engine, Pose{}, false);
      engine->step();
      ns.push_back(cpu_ns() - begin);
    }
    return times(ns).median;
  }
  return std::nan("");
}

}  // namespace swage::bench
