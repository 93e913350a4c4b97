// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Position, direction and frustum of a view of the scene: one eye in the middle, the two eyes of a
// stereo microscope, or a view from the side at right angles. World frame; lengths in mm. Free of Qt3D.
#pragma once

#include <QMatrix4x4>
#include <QPointF>
#include <QQuaternion>
#include <QSizeF>
#include <QVector3D>
#include <array>

#include "console/view3d/camera.hpp"

namespace swage::console {

struct Eye {
  QVector3D position, up{0, 0, 1}, ahead;  // `ahead`: any point straight ahead
  QMatrix4x4 projection;
  float distance = 1;  // distance at which `span` is measured
  float span = 1;      // height of the view at that distance

  QMatrix4x4 view() const;
  QQuaternion q_WC() const;  // C: +x right, +y up, +z towards the viewer
  QPointF project(const QVector3D& p_W, const QSizeF& size) const;
  /// mm per pixel in the plane of the focus, or in that of a point.
  double mm_per_pixel(double height_px) const;
  double mm_per_pixel(double height_px, const QVector3D& p_W) const;
};

/// The two eyes of a microscope as its maker specifies them, at a working distance of 250 mm. They are scaled with the picture,
/// so that the angle between the lines of sight, which conveys depth, stays the same at every magnification.
struct StereoRig {
  float eye_distance_mm = 24;  // stereo base of a usual operating microscope; 0: no stereo
  float convergence_mm =
      250;  // distance shown in the plane of the screen; with less, everything moves behind it
  bool swapped = false;  // left and right exchanged, for displays with reversed eyes
};
inline constexpr float kWorkingDistance_mm = 250;

Eye middle_eye(const OrbitCamera& camera, float aspect);

/// Left and right as shown. Both look in the same direction, not toed in, each through a window of its own in the plane of
/// convergence (off-axis frusta): a point at the distance z is b f (1/z - 1/z0) further right for the left eye.
std::array<Eye, 2> two_eyes(const OrbitCamera& camera, const StereoRig& rig, float aspect);

/// Perpendicular to a camera, with the same right: from above, or from the front where the camera looks down.
/// Shows a sphere.
Eye cross_eye(const OrbitCamera& camera, const QVector3D& centre, float radius, float aspect);

/// A steep view of a place on a surface, from the camera's side. Shows a sphere; anything nearer is clipped, so that
/// nothing hides the place.
Eye wound_eye(const OrbitCamera& camera, const QVector3D& middle, const QVector3D& normal, float radius,
              float aspect);

}  // namespace swage::console
