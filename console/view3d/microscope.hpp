// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The view of an operating microscope: a round field, magnification by its usual measure, a working light that falls off to the rim.
// Depth of field is optional: without a graphics card it costs processor time for each picture.
#pragma once

#include <QPainter>
#include <QSizeF>

namespace swage::console {

struct Microscope {
  bool on = false;
  float zoom = 10;  // as makers define it: apparent size over that seen with the bare eye at 250 mm
  bool blur = false;  // blurs points before and behind the focal plane
};
inline constexpr float kLeastZoom = 4, kMostZoom = 25;  // of operating microscopes for vessels of a millimetre

/// The zoom after some steps in or out; ten steps cover the whole range.
float zoomed(float zoom, int notches);

/// Width of the lens before each eye at a working distance of 250 mm: an aperture of 0.024, of operating microscopes' 0.02 to 0.035. A
/// needle of 0.1 mm looks twice as wide 2 mm from the focal plane; a wider lens leaves less in focus.
inline constexpr float kPupil_mm = 12;
/// One step of the focus along the line of sight, and its greatest distance from the framed centre, mm.
inline constexpr float kFocusStep_mm = 0.25F, kMostFocus_mm = 15;

/// Size on a screen over size in the scene, for a person at this distance from it, mm.
float scale_on_screen(const Microscope& scope, float distance_mm);

/// Darkens a picture of this size outside the round field and dims it towards the rim.
void paint_field(QPainter& painter, const QSizeF& size);
/// Radius of that field, as a share of the smaller side of the picture.
inline constexpr double kFieldRadius = 0.49;

}  // namespace swage::console
