// SPDX-License-Identifier: Apache-2.0
//
// A thread thrown about for 0.3 s; prints the hash of the bits of its state. Compiled twice, without and with optimisation
// (rod_bits_test.cmake compares).
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "rod.hpp"

using namespace swage::toolkit;

int main() {
  TestRod t(nylon(), 40, 20e-3, Vec3::Zero(), Vec3::UnitX(), 60);
  t.rod.hold(0);
  t.rod.clamp(0) = {true, Vec3::UnitX(), Vec3::UnitY()};
  t.rod.start(t.s);
  RodLoad load;
  load.h = 1e-3, load.gravity = {0, 0, -kGravity}, load.fluid = {1.2, 1.8e-5};
  uint64_t hash = 1469598103934665603u;  // FNV-1a
  for (int k = 0; k < 300; ++k) {
    load.second_order = k > 150;
    t.rod.clamp(0).tangent = Vec3(std::cos(0.01 * k), std::sin(0.01 * k), 0);
    t.rod.clamp(0).director = Vec3(0, 0, 1).cross(t.rod.clamp(0).tangent);
    t.rod.follow_clamps(t.s);
    t.rod.step(t.s, load, 8, 1e-12);
    for (const double x : t.numbers) {
      uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 1099511628211u;
    }
  }
  std::printf("%016llx %.17g\n", static_cast<unsigned long long>(hash), t.tip().z());
  return 0;
}
