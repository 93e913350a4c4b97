// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with a primitive that a plugin draws (abi/visual.h). The step leaves such a list out and counts it, the validator says why.
#pragma once

#include <swage/abi/visual.h>

#include <cmath>

#include "base/drawing_health.hpp"

namespace swage::host {

enum class VisualFault { kGood, kKind, kTone, kBody, kNumber, kSize, kStrength, kNormal };

/// The first fault of a primitive, and the member that has it.
struct VisualFlaw {
  VisualFault fault = VisualFault::kGood;
  base::VisualMember member = base::VisualMember::kNone;
  bool good() const { return fault == VisualFault::kGood; }
};

/// The first of nine coordinates, or the radius, that is not finite or too far away to be a place; kNone: none is. [any]
inline base::VisualMember not_a_place(const swage_visual& v) noexcept {
  constexpr double kFar = 1e6;  // m: a thousand times what a scene holds (guide, limits); further away a place is a mistake
  const double number[] = {v.a.x, v.a.y, v.a.z, v.b.x, v.b.y, v.b.z, v.direction.x, v.direction.y, v.direction.z};
  for (uint32_t k = 0; k < 9; ++k)
    if (!(std::abs(number[k]) < kFar)) return static_cast<base::VisualMember>(static_cast<uint32_t>(base::VisualMember::kAx) + k);
  return std::isfinite(v.radius) ? base::VisualMember::kNone : base::VisualMember::kRadius;
}

/// `bodies`: of the object on which it is drawn. [any]
inline VisualFlaw flaw_of(const swage_visual& v, uint32_t bodies) noexcept {
  using base::VisualMember;
  constexpr double kUnit = 1e-6;  // tolerance of a direction's length of 1, as of a tie's axis
  if (v.kind == 0 || v.kind > SWAGE_VISUAL_KINDS) return {VisualFault::kKind, VisualMember::kKind};
  if (v.tone >= SWAGE_TONES) return {VisualFault::kTone, VisualMember::kTone};
  if (v.body >= bodies && v.body != SWAGE_NONE) return {VisualFault::kBody, VisualMember::kBody};
  if (const VisualMember where = not_a_place(v); where != VisualMember::kNone) return {VisualFault::kNumber, where};
  if (v.radius < 0 || (v.kind == SWAGE_VISUAL_DENT && v.radius == 0)) return {VisualFault::kSize, VisualMember::kRadius};
  if (!(v.strength >= 0 && v.strength <= 1)) return {VisualFault::kStrength, VisualMember::kStrength};
  // a disc without a normal has no plane
  const double length = std::sqrt(v.direction.x * v.direction.x + v.direction.y * v.direction.y + v.direction.z * v.direction.z);
  if (v.kind == SWAGE_VISUAL_DISC && !(std::abs(length - 1) < kUnit)) return {VisualFault::kNormal, VisualMember::kDirection};
  return {};
}

}  // namespace swage::host
