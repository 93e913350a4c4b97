// SPDX-License-Identifier: Apache-2.0
//
// Nothing allocates once a scene stands: steps with rebounds and contacts, and islands of many contacts that slip, stick and open.
#include <cstdlib>
#include <memory>
#include <new>

#include "base/rng.hpp"
#include "dynamics/island.hpp"
#include "scene.hpp"

namespace {
uint64_t allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace swage::physics {
namespace {

using namespace swage::dynamics;

TEST(NoAllocation, TheCounterCounts) {
  const uint64_t before = allocations;
  EXPECT_NE(std::make_unique<std::vector<double>>(8), nullptr);
  EXPECT_GT(allocations, before);
}

TEST(NoAllocation, InSteps) {
  for (const double e : {0.0, 0.9}) {
    BallOverPlate s(50e-6, {0.3, 1e6, e});
    s.world.X_WB[0].p.z = 0.3e-3;
    s.world.V_WB[0] = {{0.05, 0, 0}, {10, -400, 30}};
    const uint64_t before = allocations;
    for (int i = 0; i < 400; ++i) s.step();
    EXPECT_EQ(allocations, before) << e;
  }
}

TEST(NoAllocation, InIslandsOfManyContacts) {
  constexpr size_t kRows = 40;
  base::Xoshiro256 rng(12);
  const auto draw = [&] { return rng.uniform(-1, 1); };
  DofBlock needle;
  needle.m_hh = 0.4;
  needle.I_hh = Vec3(1.3e-6, 5e-10, 1.3e-6).asDiagonal();
  needle.inv_I_hh = needle.I_hh.inverse();
  DofBlock* const movers[] = {&needle};
  std::vector<double> J(18 * kRows);
  std::vector<Constraint> row(kRows);
  IslandSolver solver(12);
  uint32_t fell_back = 0;
  for (int trial = 0; trial < 200; ++trial) {
    for (size_t i = 0; i < kRows; ++i) {
      const Vec3 n = Vec3{0.05 * draw(), 0.05 * draw(), draw() > 0 ? 1.0 : -1.0}
                         .normalized();  // braces: drawn in this order
      const Vec3 t1 = n.cross(Vec3::UnitY()).normalized(), t2 = n.cross(t1),
                 arm(0, 2e-3 * draw(), -5e-5 * n.z());
      const Vec3* axis[3] = {&n, &t1, &t2};
      for (size_t k = 0; k < 3; ++k) {
        const Vec3 moment = arm.cross(*axis[k]);
        for (size_t c = 0; c < 3; ++c) {
          J[18 * i + 6 * k + c] = (*axis[k])[static_cast<Eigen::Index>(c)];
          J[18 * i + 6 * k + 3 + c] = moment[static_cast<Eigen::Index>(c)];
        }
      }
      row[i].size_a = 6;
      row[i].surface = {1e6, 0.82e6, 0.3};
      row[i].at = {-1e-6 * rng.uniform(0, 1), 1e-6 * draw(), 1e-6 * draw()};
      row[i].J = &J[18 * i];
    }
    const uint64_t before = allocations;
    const Outcome outcome = solver.solve({movers, row, 6}, Scales{}, Limits::kCoulomb);
    ASSERT_EQ(allocations, before);
    EXPECT_TRUE(outcome.converged) << trial;
    fell_back += outcome.fell_back;
  }
  EXPECT_GT(fell_back, 0u);  // the path was gone, too
}

}  // namespace
}  // namespace swage::physics
