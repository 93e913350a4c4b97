// SPDX-License-Identifier: Apache-2.0
//
// Devices that are shown the scene: they look, and write nothing.
#include <gtest/gtest.h>

#include "fake_scene.hpp"

namespace swage::step {
namespace {

// a hand that sees is shown arrays of the whole scene; writing into them is undone and told, with its own name
TEST(Sight, IsForLookingOnly) {
  FakeScene s;
  swage_device_sight eyes{};
  uint64_t looks = 0;
  static uint64_t* counted = nullptr;
  counted = &looks;
  eyes.look = [](swage_instance*, const swage_sight* sight) {
    EXPECT_EQ(sight->view->X_WB[1].p.z, 5e-3);
    if (++*counted == 4) const_cast<swage_pose*>(sight->view->X_WB)[1].p.z += 1e-3;
    return swage_result{SWAGE_OK};
  };
  s.rig.devices[0].sight = &eyes;
  s.device_.exchange = [](const swage_command*, swage_sample* sample) {
    sample->pose = {{1e-4, 0, 0}, {1, 0, 0, 0}};
    sample->valid = SWAGE_VALID_POSE;
    ++sample->sequence;
    return swage_result{SWAGE_OK};
  };
  s.run(3);
  EXPECT_EQ(s.rig.devices[0].instance->quarantined.load(), 0u);
  s.run(3);
  EXPECT_EQ(looks, 4u);
  EXPECT_EQ(s.ball().p.z, 5e-3);
  EXPECT_EQ(s.rig.devices[0].instance->fault.load(), host::FaultKind::kMeddled);
  EXPECT_EQ(s.rig.devices[0].instance->quarantine_step.load(), 3u);
  EXPECT_EQ(s.rig.objects[1].instance->quarantined.load(), 0u);
}

// it remembers where the arrays are and writes while it is asked for its sample
TEST(Sight, RememberedArraysAreNoLicence) {
  FakeScene s;
  static const swage_pose* seen = nullptr;
  swage_device_sight eyes{};
  eyes.look = [](swage_instance*, const swage_sight* sight) {
    seen = sight->view->X_WB;
    return swage_result{SWAGE_OK};
  };
  s.rig.devices[0].sight = &eyes;
  s.device_.exchange = [](const swage_command*, swage_sample* out) {
    const_cast<swage_pose*>(seen)[1].p.z += 1e-3;
    ++out->sequence;
    return swage_result{SWAGE_OK};
  };
  s.run(2);
  EXPECT_EQ(s.ball().p.z, 5e-3);
  EXPECT_EQ(s.rig.devices[0].instance->fault.load(), host::FaultKind::kMeddled);
}

}  // namespace
}  // namespace swage::step
