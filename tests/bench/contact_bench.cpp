// SPDX-License-Identifier: Apache-2.0
//
// Time of one collision query, needle against both jaws, by phase of the trajectory; ODE (spheres against triangle
// meshes) beside it where it is installed.
#include <benchmark/benchmark.h>

#include "contact/detector.hpp"
#include "contact/sweep.hpp"
#include "engine.hpp"
#include "solids.hpp"
#include "timing.hpp"
#include "trajectory.hpp"

namespace {

using namespace swage;
using bench::Phase;
using bench::TrajectoryPose;

const std::vector<TrajectoryPose>& poses() {
  static const std::vector<TrajectoryPose> all = bench::trajectory({}, bench::jaw(1), bench::jaw(-1));
  return all;
}

/// The poses of one phase, or all.
std::vector<TrajectoryPose> of_phase(int phase) {
  std::vector<TrajectoryPose> out;
  for (const TrajectoryPose& p : poses())
    if (phase < 0 || static_cast<int>(p.phase) == phase) out.push_back(p);
  return out;
}

struct Both {
  contact::Solid needle = bench::contact_solid(bench::Needle());
  contact::Solid jaw[2] = {bench::contact_solid(bench::jaw(1)), bench::contact_solid(bench::jaw(-1))};
  contact::Separation memory[2];
  contact::Manifold found;
  contact::Query query;
};

void exact_arc(benchmark::State& state) {
  Both both;
  const auto phase = of_phase(static_cast<int>(state.range(0)));
  size_t i = 0;
  for (auto _ : state) {
    const TrajectoryPose& p = phase[i = i + 1 < phase.size() ? i + 1 : 0];
    const contact::Frame X_WN(p.X_WN);
    for (size_t k = 0; k < 2; ++k) {
      contact::collide(both.needle, X_WN, both.jaw[k], contact::Frame(p.X_WJ[k]), both.query, both.memory[k],
                       both.found);
      bench::keep(both.found.count);
    }
  }
}

void swept_arc(benchmark::State& state) {
  Both both;
  const auto phase = of_phase(static_cast<int>(state.range(0)));
  size_t i = 0;
  for (auto _ : state) {
    const TrajectoryPose& p = phase[i = i + 1 < phase.size() ? i + 1 : 0];
    const contact::Motion moving{p.X_WN, toolkit::Vec3(0, 0, 1e-4), toolkit::Vec3(0.01, 0, 0)};
    for (size_t k = 0; k < 2; ++k) {
      const contact::Motion still{p.X_WJ[k]};
      bench::keep(
          contact::first_touch(both.needle, moving, both.jaw[k], still, 1e-6, both.memory[k], both.found).t);
    }
  }
}

void ode_trimesh(benchmark::State& state) {
  const auto queries = bench::ode_queries({});
  if (queries.empty()) return state.SkipWithError("ODE is not installed");
  const auto phase = of_phase(static_cast<int>(state.range(0)));
  size_t i = 0;
  for (auto _ : state) {
    const TrajectoryPose& p = phase[i = i + 1 < phase.size() ? i + 1 : 0];
    bench::keep(queries[0].run(p.X_WN, p.X_WJ[0], p.X_WJ[1]).contacts);
  }
}

}  // namespace

// -1: all, then far, near, touching, grasped
BENCHMARK(exact_arc)->DenseRange(-1, 3);
BENCHMARK(swept_arc)->DenseRange(-1, 3);
BENCHMARK(ode_trimesh)->DenseRange(-1, 3);
