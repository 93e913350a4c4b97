// SPDX-License-Identifier: Apache-2.0
//
// Objects made of nothing but their traits, for couplings and lessons to look at.
#pragma once

#include <swage/abi/object.h>

#include <cstring>

namespace swage::stage {

/// Says what `state` says.
struct FakeGripper {
  FakeGripper() {
    raw.self = this;
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_gripper table{
          [](swage_instance* i, const swage_object_step*, swage_gripper_state* out) {
            *out = static_cast<FakeGripper*>(i->self)->state;
            return static_cast<swage_result>(SWAGE_OK);
          }};
      return std::strcmp(id, SWAGE_TRAIT_GRIPPER) == 0 ? &table : nullptr;
    };
    state.left_body = 1;
    state.right_body = 2;
    state.axis_W = {1, 0, 0};
    state.closing_W = {0, 0, 1};
  }
  swage_instance raw{};
  swage_gripper_state state{};
};

/// A straight wire along +y through the origin: s = 0.5 + y / length.
struct FakeWire {
  FakeWire() {
    raw.self = this;
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_graspable table{locate};
      return std::strcmp(id, SWAGE_TRAIT_GRASPABLE) == 0 ? &table : nullptr;
    };
  }
  static swage_result locate(swage_instance* i, const swage_object_step*, swage_vec3 p,
                             swage_graspable_place* out) {
    const auto& self = *static_cast<FakeWire*>(i->self);
    *out = {0.5 + p.y / self.length, self.length, {0, p.y, 0}, self.tangent_W, self.normal_W};
    return SWAGE_OK;
  }
  swage_instance raw{};
  double length = 10e-3;
  swage_vec3 tangent_W{0, 1, 0}, normal_W{1, 0, 0};
};

}  // namespace swage::stage
