// SPDX-License-Identifier: LGPL-3.0-or-later
//
// True size and place: measurements of screen, eyes and mirror, and the frusta through which two eyes see the
// scene at its true size and place. Lengths in mm. Free of Qt3D.
#pragma once

#include <array>

#include "console/view3d/eye.hpp"

namespace swage::console {

/// As measured at a station; kept with its settings.
struct TrueSize {
  bool on = false;
  QSizeF screen_mm{0, 0};      // of the lit area, across and down; empty: not measured
  float distance_mm = 500;     // from the eyes to the picture, along the light path: over the mirror where there is one
  float eye_distance_mm = 63;  // between the pupils
  float scale = 1;             // size in the picture over size in the scene
  bool held = false;           // the camera's direction is fixed: that in which the picture stands before the person
  float screen_tilt_deg = 90;  // of the screen from the table: 90 upright, 0 lying with its face up; negative: face down
  float mirror_tilt_deg = 0;   // of the mirror from the table; used where the picture is mirrored

  bool known() const { return screen_mm.width() > 0 && screen_mm.height() > 0 && distance_mm > 0 && scale > 0; }
};

/// mm of one pixel of a screen, across and down.
QSizeF mm_per_pixel(const TrueSize& station, const QSize& screen_px);

/// Angle at which a person looks down at the picture, degrees: perpendicular to the screen, or to its mirror image.
float look_down_deg(const TrueSize& station, bool by_mirror);

/// Left and right as shown, through a window of this size in mm whose middle shows the camera's focus. An object at the focus has
/// its size in the scene times the scale.
std::array<Eye, 2> true_eyes(const OrbitCamera& camera, const TrueSize& station, const QSizeF& window_mm, bool swapped);
/// The view of one eye in the middle, with the same window.
Eye true_eye(const OrbitCamera& camera, const TrueSize& station, const QSizeF& window_mm);

}  // namespace swage::console
