// SPDX-License-Identifier: Apache-2.0
//
// A thread on a bench of its own: what its tests ask of it as a host does.
#pragma once

#include <gtest/gtest.h>
#include <swage/testbed.hpp>

#include <string>
#include <vector>

#include "plugins/thread/thread.hpp"

namespace swage::thread {

using toolkit::Vec3;

struct Bench {
  testbed::ObjectBench<Thread> bench;
  std::vector<swage_contact_point> point;
  std::vector<swage_chain_place> place;
  std::vector<double> v_free, W;
  double h = 1e-3;

  void start() {
    ASSERT_TRUE(bench.start(h));
    bench.step.gravity = {0, 0, -9.81};
    solver = bench.get<swage_solver_2>(SWAGE_EXT_SOLVER_2);
    n = bench.declared.shapes.size() == 1 ? bench.declared.n_state / 12 : 0;
  }
  void advance() { ASSERT_EQ(solver->advance(bench.raw, bench.fill()), SWAGE_OK); }
  /// A point on the middle of a segment, `up` from its centre line.
  void touch(uint32_t segment, double up = 0) {
    const Vec3 p = middle(segment) + up * Vec3::UnitZ();
    point.push_back({0, 0, toolkit::raw(p), {0, 0, 1}});
    place.push_back({segment, 0, 0.5, 0});
  }
  void clear() { point.clear(), place.clear(); }
  Vec3 node(uint32_t i) const { return Eigen::Map<const Vec3>(bench.state.data() + 3 * i); }
  Vec3 velocity(uint32_t i) const { return Eigen::Map<const Vec3>(bench.state.data() + 3 * (n + i)); }
  void ask() {
    v_free.assign(3 * point.size(), 0.0), W.assign(9 * point.size() * point.size(), 0.0);
    ASSERT_EQ(solver->mobility(bench.raw, bench.fill(), static_cast<uint32_t>(point.size()), point.data(),
                                 place.data(), v_free.data(), W.data()),
              SWAGE_OK);
  }
  void apply_impulses(const Eigen::VectorXd& impulse) {
    ASSERT_EQ(solver->apply_impulses(bench.raw, bench.fill(), static_cast<uint32_t>(point.size()), point.data(),
                            place.data(), impulse.data()),
              SWAGE_OK);
  }
  Vec3 middle(uint32_t segment) const { return 0.5 * (node(segment) + node(segment + 1)); }
  double signal(const char* id) {
    EXPECT_EQ(bench.finish(), SWAGE_OK);
    const char* const names[] = {"thread.tension_first", "thread.tension_last", "thread.tension_grip",
                                 "thread.tension",       "thread.bend_radius",  "thread.parted"};
    for (size_t i = 0; i < 6; ++i)
      if (std::string(id) == names[i]) return bench.signal[i];
    ADD_FAILURE() << id;
    return 0;
  }
  const swage_solver_2* solver = nullptr;
  uint32_t n = 0;  // vertices
};

}  // namespace swage::thread
