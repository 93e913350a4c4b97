// SPDX-License-Identifier: Apache-2.0
//
// The stability catalogue: for each way in which such simulations are known to fail, a scene file that sweeps
// the dangerous parameter through the failure. tests/stability/*.json hold the scenes; README there explains
// the keys.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "chart.hpp"
#include "scenario.hpp"

namespace swage::bench {

/// One scene file, in SI.
struct StabilityScene {
  std::string file, id, title, scenario;
  double seconds = 1;
  bool straight = false;
  int poses = 10000;  // of a trajectory
  int shots = 24;     // at each value
  double jaw_mass = 5e-3, approach = 0, restitution = 0, radius = 50e-6, wire = 0.1e-3;
  std::vector<double> values;          // of the swept parameter, SI; a pinch sweeps by itself
  double value_scale = 1;              // display units per SI unit, of the sweep
  double measure_scale = 1;            // the same of the measure
  double pass = 0;                     // in display units
  double range = 1e300;                // the default method must pass for values up to here, SI
  std::vector<std::string> must_fail;  // methods that break or exceed the pass mark somewhere in the sweep
  std::string open;                    // why our default does not hold yet; empty: it must
  std::vector<std::string> also;       // further methods of ours that must hold
  std::string also_open;               // why they do not yet; empty: they must
  std::map<std::string, double> also_reach;  // how far those that do not yet may come instead, in display units, by name
  Sweep chart;
};

/// Throws std::runtime_error naming file and key.
StabilityScene read_scene(const std::string& file, bool quick);

struct StabilityResult {
  Sweep chart;
  bool ours_passed = false;
  bool someone_failed = false;       // the test is known to be able to fail
  std::vector<std::string> remarks;  // one per broken expectation
};

/// Runs one scene over all methods that are compiled in.
StabilityResult run_scene(const StabilityScene&);

}  // namespace swage::bench
