// SPDX-License-Identifier: Apache-2.0
//
// The list of primitives that an object or a coupling draws beside its shapes; bounded by the capacity of the host.
#pragma once

#include <swage/abi/visual.h>
#include <swage/common.hpp>

#include <span>

namespace swage {

/// Positions and directions are in W; after on(body) in the frame of that body. Lengths in m.
class Visuals {
 public:
  explicit Visuals(std::span<swage_visual> room) : room_(room) {}

  uint32_t size() const { return n_; }
  bool full() const { return n_ == room_.size(); }
  /// Adds a primitive; a full list takes no more: the host has a place more than it draws, and counts a list that fills it as cut. [rt]
  void add(const swage_visual& v) {
    if (!full()) room_[n_++] = v;
  }
  /// Sets the body in whose frame the following primitives are. [rt]
  void on(Body body) { body_ = body; }

  /// A dent: the surface at `a` is displaced to `b`, at a distance r from `a` by (b - a) / sqrt(1 + (r/radius)^2). [rt]
  void dent(swage_vec3 a, swage_vec3 b, double radius) { put(SWAGE_VISUAL_DENT, 0, 0, a, b, {}, radius, 1); }
  /// A flat capsule of a torn region. [rt]
  void tear(uint32_t group, swage_vec3 a, swage_vec3 b, swage_vec3 normal, double radius) {
    put(SWAGE_VISUAL_TEAR, group, 0, a, b, normal, radius, 1);
  }
  /// Opening `a`, depth `b` and direction of the torn region of a group; `radius`: of a disc with the area of the region. [rt]
  void wound(uint32_t group, swage_vec3 a, swage_vec3 b, swage_vec3 inward, double radius, bool filled) {
    put(SWAGE_VISUAL_WOUND, group, 0, a, b, inward, radius, filled ? 1 : 0);
  }
  void line(swage_vec3 a, swage_vec3 b, double radius, uint32_t tone = SWAGE_TONE_INK, double strength = 1) {
    put(SWAGE_VISUAL_LINE, 0, tone, a, b, {}, radius, strength);
  }
  void disc(swage_vec3 a, swage_vec3 normal, double radius, uint32_t tone = SWAGE_TONE_INK, double strength = 1) {
    put(SWAGE_VISUAL_DISC, 0, tone, a, a, normal, radius, strength);
  }
  void tube(swage_vec3 a, swage_vec3 b, double radius, uint32_t tone = SWAGE_TONE_FLESH, double strength = 1) {
    put(SWAGE_VISUAL_TUBE, 0, tone, a, b, {}, radius, strength);
  }

 private:
  void put(uint32_t kind, uint32_t group, uint32_t tone, swage_vec3 a, swage_vec3 b, swage_vec3 direction, double radius, double strength) {
    add({kind, body_, group, tone, a, b, direction, radius, strength});
  }

  std::span<swage_visual> room_;
  uint32_t n_ = 0, body_ = SWAGE_NONE;
};

}  // namespace swage
