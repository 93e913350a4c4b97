// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The look of an operating microscope: a round field, magnification by its usual measure, a working light that fades to the rim.
// Everything is sharp: blur by depth, nine taps a pixel, costs 38 ms of processor time a picture of 1280 x 720 where there is no graphics
// card, twice the rest of the picture.
#pragma once

#include <QPainter>
#include <QSizeF>

namespace swage::console {

struct Microscope {
  bool on = false;
  float zoom = 10;  // as makers say it: size seen over size seen with the bare eye at 250 mm
};
inline constexpr float kLeastZoom = 4, kMostZoom = 25;  // of operating microscopes for vessels of a millimetre

/// A step of the zoom, in or out; ten of them lead from one end to the other.
float zoomed(float zoom, int notches);

/// Size on a screen over size in the scene, for a person at this distance from it, mm.
float scale_on_screen(const Microscope& scope, float distance_mm);

/// Over a picture of this size: dark outside of the round field, dimmer towards its rim.
void paint_field(QPainter& painter, const QSizeF& size);
/// Radius of that field, of the smaller side of the picture.
inline constexpr double kFieldRadius = 0.49;

}  // namespace swage::console
