// SPDX-License-Identifier: Apache-2.0
//
// Threads of the tests: a rod with its state, straight to begin with.
#pragma once

#include <vector>

#include "toolkit/rod.hpp"

namespace swage::toolkit {

constexpr double kGravity = 9.81;  // m/s2

/// 10-0 nylon of the reference: 22 um, 2.5 GPa.
inline RodSection nylon() { return RodSection::round(22e-6, 2.5e9, 0.39, 1140); }

struct TestRod {
  /// n equal edges from `start` along `along`.
  TestRod(const RodSection& section, int n, double length, const Vec3& start = Vec3::Zero(),
          const Vec3& along = Vec3::UnitX(), double memory = 0)
      : TestRod(section, std::vector<double>(static_cast<size_t>(n), length / n), start, along, memory) {}
  TestRod(const RodSection& section, const std::vector<double>& rest, const Vec3& start, const Vec3& along,
          double memory)
      : rod(section, rest, memory), numbers(RodState::size(rod.nodes())), s(rod.nodes(), numbers.data()) {
    Vec3 x = start;
    for (int i = 0; i < rod.nodes(); ++i) {
      put(i, x);
      if (i < rod.edges()) x += rod.rest_length(i) * along;
    }
    rod.start(s);
  }
  TestRod(const TestRod&) = delete;
  TestRod& operator=(const TestRod&) = delete;

  void put(int i, const Vec3& x) { Eigen::Map<Vec3>(s.x + 3 * i) = x; }
  /// Held at node 0, with its direction.
  void clamp_start(const Vec3& tangent, const Vec3& director) {
    rod.hold(0);
    rod.clamp(0) = {true, tangent, director};
    rod.start(s);
  }
  /// To rest, by long steps in time that grow. True: it is.
  bool settle(RodLoad load, double tolerance = 1e-12) {
    for (double h = 1e-3; h < 1e6; h *= 3) {
      load.h = h;
      rod.step(s, load, 40, tolerance);
    }
    load.h = 0;
    return rod.step(s, load, 40, tolerance).settled;
  }
  Vec3 tip() const { return s.node(rod.edges()); }

  Rod rod;
  std::vector<double> numbers;
  RodState s;
};

}  // namespace swage::toolkit
