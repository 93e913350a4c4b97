// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with a primitive that a plugin draws (abi/visual.h). The step leaves such a list out, the validator says why.
#pragma once

#include <swage/abi/visual.h>

#include <cmath>

namespace swage::host {

enum class VisualFault { kGood, kKind, kBody, kNumber, kSize, kStrength };

/// `bodies`: of the object on which it is drawn. [any]
inline VisualFault fault_of(const swage_visual& v, uint32_t bodies) noexcept {
  constexpr double kFar = 1e6;  // m: a thousand times what a scene holds (guide, limits); further away a place is a mistake
  const auto near = [](const swage_vec3& x) { return std::abs(x.x) < kFar && std::abs(x.y) < kFar && std::abs(x.z) < kFar; };
  if (v.kind == 0 || v.kind > SWAGE_VISUAL_KINDS || v.tone >= SWAGE_TONES) return VisualFault::kKind;
  if (v.body >= bodies && v.body != SWAGE_NONE) return VisualFault::kBody;
  if (!near(v.a) || !near(v.b) || !near(v.direction) || !std::isfinite(v.radius)) return VisualFault::kNumber;
  if (v.radius < 0 || (v.kind == SWAGE_VISUAL_DENT && v.radius == 0)) return VisualFault::kSize;
  return v.strength >= 0 && v.strength <= 1 ? VisualFault::kGood : VisualFault::kStrength;
}

}  // namespace swage::host
