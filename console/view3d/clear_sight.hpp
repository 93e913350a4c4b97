// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A clear sight of the needle: instruments are cut away where they stand between the viewer and the needle. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <algorithm>

namespace swage::console {

/// The disc that is kept visible. Lengths in mm, world frame.
struct ClearSight {
  QVector3D centre;
  float radius = 0;  // of the disc, in the plane through the centre facing the viewer; 0: instruments are drawn whole
  float kept = 0;    // depth before that plane within which instruments are drawn whole: jaws and what they hold

  bool operator==(const ClearSight&) const = default;
};

/// Share of radius and depth over which an instrument fades out. Smaller: a hard edge; larger: half of the picture fades.
inline constexpr float kClearFade = 0.3F;

/// How much a surface at `p` hides the disc about `at`, seen from `eye`: 0 not at all, 1 fully. The text is valid C++ and
/// GLSL: cleared() below and the fragment shader of solid parts (qt3d_material.cpp) are compiled from it.
#define SWAGE_CLEAR_SIGHT_FORMULA                                                \
  float hides(vec3 eye, vec3 at, vec3 p, float radius, float kept, float fade) { \
    float distance = length(at - eye);                                           \
    float along = dot(at - eye, p - eye) / distance;                             \
    if (along <= 0.0F) return 0.0F;                                              \
    float aside = length(eye + (p - eye) * (distance / along) - at);             \
    return smoothstep(kept, kept * (1.0F + fade), distance - along) *            \
           (1.0F - smoothstep(radius, radius * (1.0F + fade), aside));           \
  }

/// The GLSL functions used by the formula.
namespace clear_sight_formula {
using vec3 = QVector3D;
inline float length(const vec3& v) { return v.length(); }
inline float dot(const vec3& a, const vec3& b) { return QVector3D::dotProduct(a, b); }
inline float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.F, 1.F);
  return t * t * (3 - 2 * t);
}
inline SWAGE_CLEAR_SIGHT_FORMULA
}  // namespace clear_sight_formula

/// Share of an instrument's surface at `p` that is left out of this eye's picture: 0 none, 1 all.
inline float cleared(const ClearSight& sight, const QVector3D& eye, const QVector3D& p) {
  return sight.radius <= 0 ? 0.F : clear_sight_formula::hides(eye, sight.centre, p, sight.radius, sight.kept, kClearFade);
}

}  // namespace swage::console
