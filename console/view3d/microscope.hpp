// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The look of an operating microscope: a round field, magnification by its usual measure, a working light that fades to the rim.
// Depth of field is a choice: where there is no graphics card it takes time of the processor for each picture.
#pragma once

#include <QPainter>
#include <QSizeF>

namespace swage::console {

struct Microscope {
  bool on = false;
  float zoom = 10;  // as makers say it: size seen over size seen with the bare eye at 250 mm
  bool blur = false;  // what lies before and behind the plane in focus is unsharp
};
inline constexpr float kLeastZoom = 4, kMostZoom = 25;  // of operating microscopes for vessels of a millimetre

/// A step of the zoom, in or out; ten of them lead from one end to the other.
float zoomed(float zoom, int notches);

/// Width of the lens before each eye at a working distance of 250 mm: an aperture of 0.024, of the 0.02 to 0.035 of operating microscopes. A
/// needle of 0.1 mm is twice as wide 2 mm from the plane in focus; a wider lens leaves less in focus.
inline constexpr float kPupil_mm = 12;
/// One step of the focus, along the line of sight; at most so far from where the scene is framed, mm.
inline constexpr float kFocusStep_mm = 0.25F, kMostFocus_mm = 15;

/// Size on a screen over size in the scene, for a person at this distance from it, mm.
float scale_on_screen(const Microscope& scope, float distance_mm);

/// Over a picture of this size: dark outside of the round field, dimmer towards its rim.
void paint_field(QPainter& painter, const QSizeF& size);
/// Radius of that field, of the smaller side of the picture.
inline constexpr double kFieldRadius = 0.49;

}  // namespace swage::console
