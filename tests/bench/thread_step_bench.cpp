// SPDX-License-Identifier: Apache-2.0
//
// What the host does with a thread of 100 nodes, beside ODE's exact grasp step:
//
//   direction   Newton's direction of an island (dynamics/sparse_space.hpp) with a needle and so many contacts, a third each with what
//               stands, with the needle and with the thread itself; begin() finds the sides of its contacts, once an island
//   held        a step of a thread that two round jaws hold, still or moved at 3 mm/s: its own mechanics, contacts found, solved
//   lying       a step of one that lies flat on a plate, with two contacts a segment
#include <benchmark/benchmark.h>

#include <memory>

#include "dynamics/axes.hpp"
#include "dynamics/sparse_space.hpp"
#include "ode_grasp_step.hpp"
#include "held_thread.hpp"

namespace {

using namespace swage;
using namespace swage::dynamics;
using toolkit::Vec3;

constexpr uint32_t kNodes = 100;

void direction(benchmark::State& state) {
  const auto n = static_cast<uint32_t>(state.range(0));
  scene::World world = bench::with_thread(kNodes);
  scene::reset(world);
  RodBody rod(world, 0, 0, bench::nylon(), true);
  rod.advance();
  BandedBody band(0, kNodes);
  band.begin();
  uint64_t stiffer = 0;
  if (!band.linearise(rod, false, stiffer)) return state.SkipWithError("no step");
  DofBlock thread, needle;
  thread.kind = DofBlock::Kind::kBanded, thread.band = &band, thread.size = band.unknowns();
  needle.m_hh = 0.4, needle.offset = thread.size;
  needle.I_hh = Vec3(1.3e-6, 1e-7, 1.3e-6).asDiagonal(), needle.inv_I_hh = needle.I_hh.inverse();
  DofBlock* const blocks[] = {&thread, &needle};
  std::vector<Constraint> all(n);
  std::vector<std::array<double, 48>> J(n);
  for (uint32_t i = 0; i < n; ++i) {
    Constraint& c = all[i];
    const uint32_t node = 10 + i * 38 / n;
    c.n = Vec3::UnitZ();
    axes_across(c.n, c.t1, c.t2);
    c.block_a = 0, c.size_a = 8, c.offset_a = 4 * node;
    if (i % 3 == 1) c.block_b = 1, c.size_b = 6, c.offset_b = needle.offset;
    if (i % 3 == 2) c.block_b = 0, c.size_b = 8, c.offset_b = 4 * (kNodes - 2 - node);
    const uint32_t columns = c.size_a + c.size_b;
    J[i].fill(0);
    const Vec3* axis[] = {&c.n, &c.t1, &c.t2};
    for (uint32_t r = 0; r < 3; ++r)
      for (uint32_t k = 0; k < 3; ++k) {
        const double e = (*axis[r])[static_cast<int>(k)];
        J[i][r * columns + k] = 0.6 * e, J[i][r * columns + 4 + k] = 0.4 * e;
        if (c.size_b == 6) J[i][r * columns + 8 + k] = -e;
        if (c.size_b == 8) J[i][r * columns + 8 + k] = -0.4 * e, J[i][r * columns + 12 + k] = -0.6 * e;
      }
    c.J = J[i].data();
    c.surface = {1e4, 8e3, 0.2};
    c.at = {-1e-7, 0, 0};
    c.D.nn = 1e4, c.D.t11 = c.D.t22 = 8e3;
    // every other one slides: the system is not symmetric
    if (state.range(1) != 0 && i % 2 == 0) c.D.t11 = 0, c.D.n1 = 2e3;
  }
  const Island island{blocks, all, needle.offset + 6, false, true};
  SparseSpace space(6, {kNodes, n});
  std::vector<double> d(island.size), step(island.size);
  space.begin(island);
  space.start(d.data());
  space.displace(d.data());
  space.residual(d.data());
  for (auto _ : state) {
    if (!space.search_direction(d.data(), false, step.data())) return state.SkipWithError("no direction");
    benchmark::DoNotOptimize(step.data());
  }
}

void steps(benchmark::State& state, bench::Held how, double speed) {
  bench::HeldThread s(how, speed, static_cast<uint32_t>(state.range(0)) + 1);
  for (int i = 0; i < 300; ++i) s.step();
  for (auto _ : state) s.step();
  const Stats& stats = s.solve->stats();
  state.counters["contacts"] = static_cast<double>(s.contacts.contact.size());
  state.counters["newton"] = static_cast<double>(stats.newton) / static_cast<double>(stats.steps);
  state.counters["not_converged"] = static_cast<double>(stats.health.not_converged);
}

void ode_grasp_step(benchmark::State& state) {
  std::optional<swage::bench::OdeGrasp> grasp = swage::bench::OdeGrasp::make();
  if (!grasp) return state.SkipWithError("ODE is not installed");
  for (auto _ : state) grasp->step();
}

BENCHMARK(ode_grasp_step)->Unit(benchmark::kMicrosecond);
BENCHMARK(direction)->ArgNames({"contacts", "slide"})->Args({20, 0})->Args({60, 0})->Args({60, 1})->Args({100, 0})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(steps, held_still, bench::Held::kJaws, 0.0)->ArgName("segments")->Arg(60)->Arg(80)->Arg(99)->Arg(140)->Arg(200)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(steps, held_moved, bench::Held::kJaws, 3e-3)->ArgName("segments")->Arg(99)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(steps, lying, bench::Held::kLying, 0.0)->ArgName("segments")->Arg(60)->Arg(80)->Arg(99)->Arg(140)->Arg(200)->Unit(benchmark::kMicrosecond);

}  // namespace
