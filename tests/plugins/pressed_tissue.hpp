// SPDX-License-Identifier: Apache-2.0
//
// What the tests of the tissue's levels press it with.
#pragma once

#include <gtest/gtest.h>
#include <swage/testbed.hpp>

#include "plugins/tissue/tissue.hpp"

namespace swage::tissue {

/// A tissue pressed at one place, step by step as the host's solve does it.
struct Pressed {
  testbed::ObjectBench<Tissue> bench;
  swage_contact_point point{0, 0, {0.5e-3, 0, 0}, {0, 0, -1}};

  explicit Pressed(double relaxed = 0.6, Level level = Level::kCompliant) {
    bench.set("level", static_cast<double>(level));
    bench.set("relaxed", relaxed);
    bench.set("cells", 8);  // of a mesh: the fewest, the quickest built
    EXPECT_TRUE(bench.start());
  }
  /// Displacement at the end of a step under f [N].
  Vec3 step(const Vec3& f) {
    const auto* s = bench.get<swage_solver>(SWAGE_EXT_SOLVER);
    const auto* surface = bench.get<swage_surface>(SWAGE_EXT_SURFACE);
    double v_free[3], W[9], u[3] = {0, 0, 0};
    EXPECT_EQ(s->advance(bench.raw, &bench.step), SWAGE_OK);
    EXPECT_EQ(s->mobility(bench.raw, &bench.step, 1, &point, v_free, W), SWAGE_OK);
    EXPECT_EQ(surface->displacement(bench.raw, &bench.step, 1, &point, u), SWAGE_OK);
    const double h = bench.step.dt_s;
    Vec3 out;
    for (int i = 0; i < 3; ++i) {
      out[i] = u[i];
      for (int k = 0; k < 3; ++k) out[i] += h * h * W[3 * i + k] * f[k];
      moved[i] = h * v_free[i] + out[i] - u[i];
    }
    const Vec3 j = h * f;
    EXPECT_EQ(s->apply_impulses(bench.raw, &bench.step, 1, &point, j.data()), SWAGE_OK);
    EXPECT_EQ(bench.finish(), SWAGE_OK);
    return out;
  }
  Vec3 moved = Vec3::Zero();  // over the step
};

}  // namespace swage::tissue
