// SPDX-License-Identifier: Apache-2.0
//
// Time of one collision query, needle against both jaws, by phase of the trajectory; ODE (spheres against triangle
// meshes) beside it where it is installed.
#include <benchmark/benchmark.h>

#include "both_jaws.hpp"
#include "engine.hpp"

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

/// Calls query(pose) for the poses of the phase asked for, one an iteration.
template <class Query>
void over_phase(benchmark::State& state, Query&& query) {
  const auto phase = of_phase(static_cast<int>(state.range(0)));
  size_t i = 0;
  for (auto _ : state) query(phase[i = i + 1 < phase.size() ? i + 1 : 0]);
}

void exact_arc(benchmark::State& state) {
  bench::BothJaws both;
  over_phase(state, [&](const TrajectoryPose& p) {
    for (size_t k = 0; k < 2; ++k) bench::keep(both.collide(p, k));
  });
}

void swept_arc(benchmark::State& state) {
  bench::BothJaws both;
  over_phase(state, [&](const TrajectoryPose& p) {
    for (size_t k = 0; k < 2; ++k)
      bench::keep(both.first_touch(p, toolkit::Vec3(0, 0, 1e-4), toolkit::Vec3(0.01, 0, 0), k));
  });
}

void ode_trimesh(benchmark::State& state) {
  const auto queries = bench::ode_queries({});
  if (queries.empty()) return state.SkipWithError("ODE is not installed");
  over_phase(state, [&](const TrajectoryPose& p) {
    bench::keep(queries[0].run(p.X_WN, p.X_WJ[0], p.X_WJ[1]).contacts);
  });
}

}  // namespace

// -1: all, then far, near, touching, grasped
BENCHMARK(exact_arc)->DenseRange(-1, 3);
BENCHMARK(swept_arc)->DenseRange(-1, 3);
BENCHMARK(ode_trimesh)->DenseRange(-1, 3);
