// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A clear sight of the work: an instrument is cut off where it stands between a viewer and the needle. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <algorithm>

namespace swage::console {

/// The round place that is kept clear. Lengths in mm, world frame.
struct ClearSight {
  QVector3D centre;
  float radius = 0;  // of what is kept clear, in the plane through the centre; 0: instruments are drawn whole
  float kept = 0;    // an instrument nearer to that plane than this is drawn whole: its jaws and what they hold

  bool operator==(const ClearSight&) const = default;
};

/// Over so much of the radius, and of the depth that is kept, an instrument fades. Smaller: a hard edge; larger: half of the picture fades.
inline constexpr float kClearFade = 0.3F;

/// How much of an instrument's surface at `p` is left out of the picture for this eye: 0 none, 1 all. The fragment shader
/// of solid parts (qt3d_material.cpp) has the same formula.
inline float cleared(const ClearSight& sight, const QVector3D& eye, const QVector3D& p) {
  if (sight.radius <= 0) return 0;
  const auto step = [](float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.F, 1.F);
    return t * t * (3 - 2 * t);
  };
  const QVector3D ahead = (sight.centre - eye).normalized();
  const float distance = (sight.centre - eye).length(), along = QVector3D::dotProduct(ahead, p - eye);
  if (along <= 0) return 0;
  const float aside = (eye + (p - eye) * (distance / along) - sight.centre).length();
  return step(sight.kept, sight.kept * (1 + kClearFade), distance - along) *
         (1 - step(sight.radius, sight.radius * (1 + kClearFade), aside));
}

}  // namespace swage::console
