// SPDX-License-Identifier: Apache-2.0
//
// The yardstick of what a thread costs: ODE's exact solver with soft contacts, which holds a needle between two jaws.
#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include "grip.hpp"
#include "timing.hpp"

namespace swage::bench {

/// The grasp, held from the first step on.
class OdeGrasp {
 public:
  /// Nothing where ODE is not installed.
  static std::optional<OdeGrasp> make() {
    for (const Method& m : ode_methods())
      if (m.name == "ODE exact, soft contacts") return OdeGrasp(m);
    return {};
  }
  void step() {
    openings_.apply(*engine_, Pose{}, false);
    engine_->step();
  }

 private:
  explicit OdeGrasp(const Method& m) : engine_(m.make(Setup{})), openings_(m, Setup{}.needle, 1e-6) {
    engine_->set_gravity(Vec3::Zero());
    openings_.apply(*engine_, Pose{}, true);
    engine_->set_needle(grip_pose(Setup{}.needle), Vec3::Zero(), Vec3::Zero());
  }
  std::unique_ptr<Engine> engine_;
  Openings openings_;
};

/// Processor time of its step [ns], the median of 2000; NaN where ODE is not installed.
inline double ode_grasp_step() {
  constexpr int kSteps = 2000;
  std::optional<OdeGrasp> grasp = OdeGrasp::make();
  if (!grasp) return std::nan("");
  std::vector<double> ns;
  for (int i = 0; i < kSteps; ++i) {
    const double begin = cpu_ns();
    grasp->step();
    ns.push_back(cpu_ns() - begin);
  }
  return times(ns).median;
}

}  // namespace swage::bench
