// SPDX-License-Identifier: Apache-2.0
//
// What Newton's direction of a thread costs in each of three ways (thread_direction.hpp), beside ODE's exact grasp step.
//
//   dense      the dense factor of 3 m rows alone: less than that no way over W can cost, how ever W is found (a chain's Green's
//              function finds it in O(n + m^2))
//   assembly   gradient and Hessian of the rod, for the whole: a direction is assembly + one of the ways
#include "thread_direction.hpp"

#include <benchmark/benchmark.h>

#include "ode_grasp_step.hpp"

namespace {

using namespace swage;
using namespace swage::bench::direction;

void direction(benchmark::State& state, Way way) {
  Scene k(static_cast<uint32_t>(state.range(0)));
  // all ways lead to the same place
  const Eigen::VectorXd known = by_woodbury(k), found = way(k);
  const double off = (known - found).norm() / known.norm();
  if (!k.ok || !(off < 1e-5)) {
    state.SkipWithError("not the same direction");
    return;
  }
  for (auto _ : state) {
    Eigen::VectorXd x = way(k);
    benchmark::DoNotOptimize(x.data());
  }
  state.counters["apart"] = off;
  state.counters["products"] = static_cast<double>(k.H.work());
}

void analysis(benchmark::State& state) {
  Scene k(static_cast<uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(k.H.analyse(kNodes + 2, k.coupled));
}

void dense_alone(benchmark::State& state) {
  const auto n = static_cast<size_t>(3 * state.range(0));
  std::vector<double> W(n * n, 0.1), a;
  for (size_t i = 0; i < n; ++i) W[i * n + i] = static_cast<double>(n);
  for (auto _ : state) {
    a = W;
    benchmark::DoNotOptimize(dynamics::ldl_factor(n, a.data()));
  }
}

void assembly(benchmark::State& state) {
  Scene k(20);
  for (auto _ : state) {
    k.assemble();
    benchmark::DoNotOptimize(k.A.column(0));
  }
}

void ode_grasp_step(benchmark::State& state) {
  std::optional<swage::bench::OdeGrasp> grasp = swage::bench::OdeGrasp::make();
  if (!grasp) return state.SkipWithError("ODE is not installed");
  for (auto _ : state) grasp->step();
}

BENCHMARK(ode_grasp_step)->Unit(benchmark::kMicrosecond);
BENCHMARK(assembly)->Unit(benchmark::kMicrosecond);
BENCHMARK(analysis)->Arg(20)->Arg(60)->Arg(100)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(direction, blocks, by_blocks)->Arg(20)->Arg(60)->Arg(100)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(direction, woodbury, by_woodbury)
    ->Arg(20)
    ->Arg(60)
    ->Arg(100)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(direction, delassus, by_delassus)
    ->Arg(20)
    ->Arg(60)
    ->Arg(100)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(dense_alone)->Arg(20)->Arg(60)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
