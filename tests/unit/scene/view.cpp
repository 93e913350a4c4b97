// SPDX-License-Identifier: Apache-2.0
#include "scene/view.hpp"

#include <gtest/gtest.h>

#include "scene/kinematics.hpp"

namespace swage::scene {
namespace {

TEST(View, ShowsTheObjectsOwnSlices) {
  World w;
  w.body.resize(4);
  w.particle_mass.assign(3, 1e-9);
  w.hinge.resize(2);
  for (auto& hinge : w.hinge) hinge.parent = 0, hinge.child = 1;
  w.plugin_state.assign(5, 0);
  w.signal.assign(3, 0);
  reset(w);
  const Slices slices{{1, 2}, {2, 1}, {0, 0}, {1, 1}, {3, 2}, {0, 3}};
  swage_object_step step = view(w, slices, nullptr);
  EXPECT_EQ(step.struct_size, sizeof(step));
  EXPECT_EQ(step.n_body, 2u);
  EXPECT_EQ(step.X_WB, &w.X_WB[1]);
  EXPECT_EQ(step.particle_f_W, &w.particle_f_W[6]);
  EXPECT_EQ(step.drive, &w.drive[1]);
  step.state[1] = 9;
  EXPECT_EQ(w.plugin_state[4], 9);
}

TEST(View, LocalIndices) {
  const Range range{3, 2};
  EXPECT_EQ(local(range, 4), 1u);
  EXPECT_EQ(local(range, 2), kNone);
  EXPECT_EQ(local(range, 5), kNone);
}

}  // namespace
}  // namespace swage::scene
