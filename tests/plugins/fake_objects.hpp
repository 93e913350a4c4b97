// SPDX-License-Identifier: Apache-2.0
//
// Objects made of nothing but their traits, for couplings and lessons to look at.
#pragma once

#include <swage/abi/object.h>

#include <algorithm>
#include <cmath>
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

/// A quarter circle of 2 mm radius in the plane y = 0 that pierces: its point in `at` leads down, its centre is at +x; then turned
/// about y at its point.
struct FakeNeedle {
  static constexpr double kRadius = 2e-3, kSweep = 1.5707963267948966;  // m, rad
  FakeNeedle() {
    raw.self = this;
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_piercing table{place, nearest};
      static const swage_graspable grasped{locate};
      if (std::strcmp(id, SWAGE_TRAIT_GRASPABLE) == 0) return &grasped;
      return std::strcmp(id, SWAGE_TRAIT_PIERCING) == 0 ? &table : nullptr;
    };
  }
  static swage_result place(swage_instance* i, const swage_object_step*, double s,
                            swage_piercing_place* out) {
    const auto& self = *static_cast<FakeNeedle*>(i->self);
    const double a = kSweep * s, lean = a + self.lean;
    *out = {};
    out->s = s;
    out->length = kRadius * kSweep;
    out->radius = 50e-6;
    out->p_W = turned({kRadius * (1 - std::cos(a)), 0, kRadius * std::sin(a)}, self.turn);
    out->p_W = {self.at.x + out->p_W.x, self.at.y, self.at.z + out->p_W.z};
    out->tangent_W = turned({std::sin(lean), 0, std::cos(lean)}, self.turn);
    return SWAGE_OK;
  }
  static swage_result locate(swage_instance* i, const swage_object_step* step, swage_vec3 p,
                             swage_graspable_place* out) {
    swage_piercing_place at{};
    nearest(i, step, p, &at);
    *out = {at.s, at.length, at.p_W, at.tangent_W, {0, 1, 0}};
    return SWAGE_OK;
  }
  static swage_result nearest(swage_instance* i, const swage_object_step* step, swage_vec3 p,
                              swage_piercing_place* out) {
    const auto& self = *static_cast<FakeNeedle*>(i->self);
    const swage_vec3 q = turned({p.x - self.at.x, 0, p.z - self.at.z}, -self.turn);
    const double a = std::atan2(q.z, kRadius - q.x);
    return place(i, step, std::min(1.0, std::max(0.0, a / kSweep)), out);
  }
  static swage_vec3 turned(swage_vec3 p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
  }
  double lean = 0;            // rad, of its tangents towards +x
  double turn = 0;            // rad, from +z towards +x
  swage_vec3 at = {0, 0, 0};  // m
  swage_instance raw{};
};

/// The half space below z = 0, 1 mm thick, with an edge at x = kEdge beyond which there is nothing.
struct FakeTissue {
  static constexpr double kEdge = 1e-3;  // m
  FakeTissue() {
    raw.self = this;
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_pierceable table{law, locate};
      return std::strcmp(id, SWAGE_TRAIT_PIERCEABLE) == 0 ? &table : nullptr;
    };
  }
  static swage_result law(swage_instance*, const swage_object_step*, swage_pierceable_law* out) {
    *out = {};
    return SWAGE_OK;
  }
  static swage_result locate(swage_instance*, const swage_object_step*, swage_vec3 p,
                             swage_pierceable_place* out) {
    *out = {};
    out->depth = -p.z;
    out->beyond = -1e-3 - p.z;
    out->edge = kEdge - p.x;
    out->p_W = {p.x, p.y, 0};
    out->normal_W = {0, 0, 1};
    return SWAGE_OK;
  }
  swage_instance raw{};
};

}  // namespace swage::stage
