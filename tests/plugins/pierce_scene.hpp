// SPDX-License-Identifier: Apache-2.0
//
// pierce_rig.hpp for tests: what is wrong with the scene, or missing in it, fails the test.
#pragma once

#include <gtest/gtest.h>

#include "pierce_rig.hpp"
#include "test_places.hpp"

namespace swage::test {

struct PierceScene : PierceRig {
  void make(const Path& path) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const std::string wrong = build(path, std::string(SWAGE_BINARY_DIR "/pierce_") + info->name() + ".json");
    EXPECT_EQ(wrong, "");
    ASSERT_NE(engine, nullptr);
  }

  /// Steps until t [s]; `look` after each.
  void run_until(double t, const std::function<void()>& look = {}) {
    while (time() < t - 1e-9) {
      step();
      if (look) look();
    }
    EXPECT_EQ(engine->quarantined(), 0u);
  }

  double signal(const std::string& id, const std::string& owner = "") const {
    const double value = PierceRig::signal(id, owner);
    EXPECT_FALSE(std::isnan(value)) << "no signal " << id;
    return value;
  }
  double value(const std::string& id) const {
    const double value = PierceRig::value(id);
    EXPECT_FALSE(std::isnan(value)) << id << " was not heard";
    return value;
  }
};

/// Primitives of one kind that a snapshot shows.
inline std::vector<swage_visual> drawn(const snapshot::Snapshot& shot, uint32_t kind) {
  std::vector<swage_visual> out;
  for (uint32_t i = 0; i < shot.n_visual; ++i)
    if (shot.visual[i].visual.kind == kind) out.push_back(shot.visual[i].visual);
  return out;
}

/// m, how far a wound leads.
inline double depth_of(const swage_visual& wound) { return (toolkit::vec(wound.b) - toolkit::vec(wound.a)).norm(); }

}  // namespace swage::test
