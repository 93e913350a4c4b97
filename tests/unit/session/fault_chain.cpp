// SPDX-License-Identifier: Apache-2.0
//
// One fault after the other in the middle of a contact: whatever happens, no force above the limit leaves, none rises faster than the
// slew, and what falls below trust is let go. And how stiff a wall may be with how much delay: resources/charts/passivity.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "session/force_guard.hpp"

namespace swage::session {
namespace fault_chain_test {

constexpr double kDt = 1e-3, kNaN = std::numeric_limits<double>::quiet_NaN();

struct Fault {
  const char* name;
  std::function<void(int ms, ForceRequest&, HandMotion&)> what;  // ms since the fault began
  bool disarms = false;                                         // a person has to let it go on
};

const Fault kFaults[] = {
    {"the force is no number", [](int ms, ForceRequest& r, HandMotion&) { if (ms == 0) r.force.y = kNaN; }, true},
    {"the hand is nowhere", [](int ms, ForceRequest&, HandMotion& h) { if (ms == 0) h.p.z = kNaN; }, true},
    {"the step stalls for 50 ms", [](int ms, ForceRequest& r, HandMotion&) { if (ms < 50) r.age = kDt * ms; }, false},
    {"the step hangs", [](int ms, ForceRequest& r, HandMotion&) { r.age = kDt * ms; }, true},
    {"the arm is silent for 50 ms", [](int ms, ForceRequest&, HandMotion& h) { if (ms < 50) h.age = kDt * ms; }, false},
    {"the arm is pulled out", [](int ms, ForceRequest&, HandMotion& h) { h.age = kDt * ms; }, true},
    {"time steps back by 50 ms", [](int ms, ForceRequest& r, HandMotion& h) { if (ms < 50) r.age = h.age = -0.05; }, false},
    {"the scene explodes", [](int ms, ForceRequest& r, HandMotion&) { if (ms < 50) r.force = {50, -80, 20}; }, false},
    {"the contact flutters", [](int ms, ForceRequest& r, HandMotion&) { r.force.x = ms % 2 == 0 ? 3 : -3; }, false},
    {"the hand leaps by 5 mm", [](int ms, ForceRequest&, HandMotion& h) { if (ms > 0) h.p.x += 5e-3; }, false},
};

class FaultChain : public testing::TestWithParam<Fault> {};

TEST_P(FaultChain, NoForceAboveLimitOrSlewLeaves) {
  ForceGuard guard;
  const ForceLimits& limits = guard.limits();
  guard.arm();
  swage_vec3 last{};
  double before = 0, greatest = 0;
  for (int tick = 0; tick < 4000; ++tick) {
    ForceRequest request;
    request.force = {1, 0.2, 0};
    HandMotion hand;
    hand.p = {1e-3 * std::sin(2e-3 * tick), 0, 0};
    if (tick >= 2000 && tick < 2400) GetParam().what(tick - 2000, request, hand);
    const swage_command c = guard.tick(request, hand, kDt, kDt * tick);
    const double size = std::hypot(c.force.x, c.force.y, c.force.z);
    ASSERT_TRUE(std::isfinite(size)) << tick;
    ASSERT_LE(size, limits.max_force + 1e-9) << tick;
    // a force may fall to zero at once; it never rises faster than the slew, whatever it was
    const double change = std::hypot(c.force.x - last.x, c.force.y - last.y, c.force.z - last.z);
    if (size > 0) {
      ASSERT_LE(change, limits.slew * kDt + 1e-9) << tick;
    }
    if (tick == 1999) before = size;
    if (tick >= 2000) greatest = std::max(greatest, size);
    last = c.force;
  }
  EXPECT_NEAR(before, std::hypot(1, 0.2), 1e-3);
  EXPECT_EQ(guard.armed(), !GetParam().disarms);
  const double after = std::hypot(last.x, last.y, last.z);
  EXPECT_NEAR(after, GetParam().disarms ? 0 : before, 0.02) << "1.6 s later";
  EXPECT_LE(greatest, limits.max_force + 1e-9);
}

TEST_P(FaultChain, NothingLeavesAfterAnExitWhileArmed) {
  ForceGuard guard;
  guard.arm();
  for (int tick = 0; tick < 3000; ++tick) {
    ForceRequest request;
    request.force = {1, 0.2, 0};
    HandMotion hand;
    if (tick >= 1000) GetParam().what(tick - 1000, request, hand);
    if (tick == 1010) guard.disarm(ForceFault::kStopped);
    const swage_command c = guard.tick(request, hand, kDt, kDt * tick);
    if (tick >= 1010) {
      ASSERT_EQ(c.force.x, 0);
      ASSERT_EQ(c.stiffness, 0);
      ASSERT_EQ(c.gain, 0);
    }
  }
}

std::string fault_name(const testing::TestParamInfo<Fault>& one) {
  std::string name = one.param.name;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(OneAfterTheOther, FaultChain, testing::ValuesIn(kFaults), fault_name);

// Arm and hand in one degree of freedom, as in force_guard.cpp: 45 g, friction 0.06 N, encoder 23 um, a light grip (100 N/m, 0.5 N s/m)
// that presses 10 mm into a wall. The wall answers to where the hand was one period and `delay` ago. Ripple of the last second, m.
double ripple(double stiffness, double delay, double dissipation) {
  ForceLimits limits;
  limits.max_force = limits.continuous_force = limits.max_speed = 100;
  limits.slew = 1e6;
  limits.max_dissipation = dissipation;
  ForceGuard guard(limits);
  guard.arm();
  constexpr int kSub = 20;
  const auto late = static_cast<std::size_t>(std::lround(delay / kDt * kSub));
  std::vector<double> way(late + 1, -0.005);
  double x = -0.005, v = 0, wall = 0, low = 1, high = -1;
  for (int tick = 0; tick < 4000; ++tick) {
    const auto encoder = [](double p) { return std::floor(p / 23e-6) * 23e-6; };
    HandMotion hand;
    hand.p.x = encoder(x);
    ForceRequest request;
    request.force.x = wall;
    const double held = guard.tick(request, hand, kDt, tick * kDt).force.x;
    const double seen = encoder(way[way.size() - 1 - late]);
    wall = seen > 0 ? -stiffness * seen : 0;
    for (int sub = 0; sub < kSub; ++sub) {
      const double f = held + 100 * (0.01 - x) - 0.5 * v - 0.06 * std::tanh(v / 1e-4);
      v += f / 0.045 * kDt / kSub;
      x += v * kDt / kSub;
      way.push_back(x);
    }
    if (tick >= 3000) low = std::min(low, x), high = std::max(high, x);
  }
  return high - low;
}

/// The stiffest wall up to which every one is calm, N/m, to 5 %.
double stiffest(double delay, double dissipation) {
  double k = 50;
  while (k < 20000 && ripple(1.05 * k, delay, dissipation) < 100e-6) k *= 1.05;
  return k;
}

TEST(Passivity, DelayCostsStiffnessAndControlGivesSomeBack) {
  std::printf("| delay ms | bare N/m | with passivity control N/m |\n| --- | --- | --- |\n");
  double last_bare = 1e9;
  for (const double delay : {0.0, 0.5e-3, 1e-3, 1.5e-3, 2e-3}) {
    const double bare = stiffest(delay, 0), calmed = stiffest(delay, 8);
    std::printf("| %.1f | %.0f | %.0f |\n", 1e3 * delay, bare, calmed);
    EXPECT_LE(bare, last_bare * 1.001);
    EXPECT_GT(calmed, 1.2 * bare);
    EXPECT_GT(calmed, 500) << "the contact of 0.2 m/s on 500 N/m that the slew is made for";
    last_bare = bare;
  }
}

}  // namespace fault_chain_test
}  // namespace swage::session
