// SPDX-License-Identifier: Apache-2.0
//
// What it costs on [rt] to look after plugins: WriteGuard after a call and before a phase, for scenes of so many bodies and
// particles, and a guarded call of a function that does nothing, with and without clocks.
#include <benchmark/benchmark.h>

#include "host/guard.hpp"
#include "step/write_guard.hpp"

namespace {

using namespace swage;

scene::World scene_of(int64_t bodies, int64_t particles) {
  scene::World world;
  world.X_WB.assign(static_cast<std::size_t>(bodies), {{0, 0, 0}, {1, 0, 0, 0}});
  world.V_WB.resize(static_cast<std::size_t>(bodies));
  world.particle_p_W.resize(3 * static_cast<std::size_t>(particles));
  world.particle_v_W.resize(3 * static_cast<std::size_t>(particles));
  return world;
}

void write_guard_check(benchmark::State& state) {
  scene::World world = scene_of(state.range(0), state.range(1));
  step::WriteGuard guard(world);
  host::Instance instance;
  for (auto _ : state) {
    guard.check(instance, host::Call::kForces);
    benchmark::ClobberMemory();
  }
}

void write_guard_take(benchmark::State& state) {
  scene::World world = scene_of(state.range(0), state.range(1));
  step::WriteGuard guard(world);
  for (auto _ : state) {
    guard.take();
    benchmark::ClobberMemory();
  }
}

void guarded_call(benchmark::State& state) {
  host::Instance instance;
  instance.watch.budget_ns = state.range(0);
  uint64_t step = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(host::guarded(instance, host::Call::kForces, ++step, [] { return swage_result{SWAGE_OK}; }));
}

// a needle and jaws; a bending needle in tissue; a thread of 400 points
BENCHMARK(write_guard_check)->Args({4, 0})->Args({20, 0})->Args({20, 400})->ArgNames({"bodies", "particles"});
BENCHMARK(write_guard_take)->Args({4, 0})->Args({20, 0})->Args({20, 400})->ArgNames({"bodies", "particles"});
BENCHMARK(guarded_call)->Arg(0)->Arg(1'000'000)->ArgName("budget_ns");

}  // namespace
