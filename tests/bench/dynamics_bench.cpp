// SPDX-License-Identifier: Apache-2.0
//
// Time of one step of each free motion, and of one island of 1 to 10 contacts that holds a needle; an empty loop beside them.
#include <benchmark/benchmark.h>

#include <vector>

#include "dynamics/free_motion.hpp"
#include "dynamics/island.hpp"

namespace {

using namespace swage;
using namespace swage::dynamics;

void empty_loop(benchmark::State& state) {
  double x = 1;
  for (auto _ : state) benchmark::DoNotOptimize(x);
}

/// An asymmetric top at 30 rad/s.
void free_motion(benchmark::State& state, FreeMotion method) {
  const RigidMass m(4e-7, Vec3(1e-12, 2e-12, 3e-12));
  RigidState s{Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3(0.3, 30, 0.3)};
  for (auto _ : state) {
    move_free(method, m, Vec3::Zero(), Vec3::Zero(), 1e-3, s);
    benchmark::DoNotOptimize(s);
  }
}

/// A needle of 0.4 mg on `state.range(0)` contacts in a row, each carrying 0.1 N against as much from above.
void island(benchmark::State& state) {
  constexpr double kHh = 1e6;  // 1/s2, 1 / h^2
  const auto n = static_cast<size_t>(state.range(0));
  DofBlock needle;
  needle.m_hh = 4e-7 * kHh;
  needle.I_hh = Vec3(1.3e-12, 5e-16, 1.3e-12).asDiagonal();
  needle.I_hh *= kHh;
  needle.inv_I_hh = needle.I_hh.inverse();
  std::vector<double> J(18 * n);
  std::vector<Constraint> row(n);
  for (size_t i = 0; i < n; ++i) {
    const double side = i % 2 ? -1 : 1;
    const Vec3 arm(0, 5e-5 * static_cast<double>(i / 2), -5e-5 * side);
    const Vec3 axis[3] = {Vec3(0, 0, side), Vec3(side, 0, 0), Vec3(0, 1, 0)};
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 moment = arm.cross(axis[k]);
      for (int c = 0; c < 3; ++c) {
        J[18 * i + 6 * k + static_cast<size_t>(c)] = axis[k][c];
        J[18 * i + 6 * k + 3 + static_cast<size_t>(c)] = moment[c];
      }
    }
    row[i].size_a = 6;
    row[i].surface = {1e6, 0.82e6, 0.3};
    row[i].at = {-1e-7, 1e-9, 0};
    row[i].J = &J[18 * i];
  }
  DofBlock* const movers[] = {&needle};
  IslandSolver solver(12);
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve({movers, row, 6}, Scales{}, Limits::kCoulomb));
}

}  // namespace

BENCHMARK(empty_loop);
BENCHMARK_CAPTURE(free_motion, thesis, FreeMotion::kThesis);
BENCHMARK_CAPTURE(free_motion, symplectic_euler, FreeMotion::kSymplecticEuler);
BENCHMARK_CAPTURE(free_motion, runge_kutta_4, FreeMotion::kRungeKutta4);
BENCHMARK_CAPTURE(free_motion, splitting_2, FreeMotion::kSplitting2);
BENCHMARK_CAPTURE(free_motion, splitting_4, FreeMotion::kSplitting4);
BENCHMARK_CAPTURE(free_motion, taylor, FreeMotion::kTaylor);
BENCHMARK_CAPTURE(free_motion, elliptic, FreeMotion::kElliptic);
BENCHMARK(island)->DenseRange(1, 10);
