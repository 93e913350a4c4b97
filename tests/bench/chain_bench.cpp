// SPDX-License-Identifier: Apache-2.0
//
// What finding the contacts of a chain costs in a step: a thread that touches nothing, one that lies in a tangle, and one that is
// pinched; and what all pairs of pieces cost. The number is that of the pieces.
#include <benchmark/benchmark.h>

#include "../unit/contact/chain_scene.hpp"
#include "toolkit/segment.hpp"

namespace {

using namespace swage;
using contact::Vec3;

constexpr double kRadius = 11e-6;  // m, of a 10-0 thread

/// Loops of 2 mm radius, 0.5 mm apart, pieces of 0.2 mm.
std::vector<Vec3> helix(int64_t n) {
  std::vector<Vec3> p;
  for (int64_t i = 0; i <= n; ++i) {
    const double a = 0.1 * static_cast<double>(i);
    p.emplace_back(2e-3 * std::cos(a), 2e-3 * std::sin(a), 0.5e-3 / (2 * M_PI) * a);
  }
  return p;
}

/// Detects over and over, the chain creeping as a held one does.
void detect(benchmark::State& state, const std::vector<Vec3>& p, bool itself, bool pinched) {
  scene::World w;
  contact::add_chain(w, p, kRadius, 3 * kRadius, 0);
  std::vector<contact::Pair> pairs;
  if (itself) pairs.push_back({0, 0, {}});
  if (pinched) {
    const Vec3 middle = 0.5 * (p[p.size() / 2] + p[p.size() / 2 + 1]);
    for (const double side : {1.0, -1.0})
      contact::add_shape(w, contact::ball(0.2e-3), 1,
                         {middle + Vec3(0, 0, side * (0.2e-3 + kRadius)), toolkit::Quat::Identity()});
    pairs.push_back({0, 1, {}});
  }
  for (size_t i = 0; i < p.size(); ++i) w.plugin_state[w.chain[0].state + 3 * (p.size() + i)] = 1e-4;
  contact::Detector detector(w, pairs, {});
  contact::ContactSet set;
  detector.reserve(set);
  for (auto _ : state) {
    detector.detect(w, set);
    benchmark::DoNotOptimize(set.contact.data());
  }
  state.counters["contacts"] = static_cast<double>(set.contact.size());
}

void touching_nothing(benchmark::State& state) { detect(state, helix(state.range(0)), true, false); }
void pinched(benchmark::State& state) { detect(state, helix(state.range(0)), true, true); }
void tangled(benchmark::State& state) {
  const auto n = static_cast<uint32_t>(state.range(0));
  detect(state, contact::wander(n, 0.1e-3, 0.4, 0.5e-3, 1), true, false);
}

/// Distances of all pairs of pieces: what a detector without boxes looks at.
void all_pairs(benchmark::State& state) {
  const std::vector<Vec3> p = helix(state.range(0));
  for (auto _ : state) {
    double least = 1;
    for (size_t i = 0; i + 1 < p.size(); ++i)
      for (size_t j = i + 2; j + 1 < p.size(); ++j) {
        const toolkit::Segment a{p[i], p[i + 1]}, b{p[j], p[j + 1]};
        const toolkit::SegmentPair at = closest(a, b);
        least = std::min(least, (a.point(at.s) - b.point(at.t)).squaredNorm());
      }
    benchmark::DoNotOptimize(least);
  }
}

}  // namespace

BENCHMARK(touching_nothing)->Arg(50)->Arg(100)->Arg(200)->Arg(400);
BENCHMARK(pinched)->Arg(100)->Arg(200);
BENCHMARK(tangled)->Arg(100)->Arg(200);
BENCHMARK(all_pairs)->Arg(100)->Arg(200)->Arg(400);
