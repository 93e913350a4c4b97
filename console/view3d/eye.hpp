// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From where, which way and through which window the scene is looked at: by one eye in the middle, by the two of a
// stereo microscope, or from the side at right angles. World frame; lengths in mm. Free of Qt3D.
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
  float distance = 1;  // from which `span` is seen
  float span = 1;      // height of what is seen at that distance

  QMatrix4x4 view() const;
  QQuaternion q_WC() const;  // C: +x right, +y up, +z towards the viewer
  QPointF project(const QVector3D& p_W, const QSizeF& size) const;
  /// mm per pixel in the plane of the focus, or in that of a point.
  double mm_per_pixel(double height_px) const;
  double mm_per_pixel(double height_px, const QVector3D& p_W) const;
};

/// How the two eyes of a microscope stand, as its maker says it: at a working distance of 250 mm. The picture scales them,
/// so that the angle between the lines of sight, which the depth is judged by, stays the same at every magnification.
struct StereoRig {
  float eye_distance_mm = 24;  // stereo base of a usual operating microscope; 0: flat
  float convergence_mm =
      250;  // what is so far away lies in the plane of the screen; less: everything moves behind it
  bool swapped = false;  // for a display that shows them the other way round
};
inline constexpr float kWorkingDistance_mm = 250;

Eye middle_eye(const OrbitCamera& camera, float aspect);

/// Left and right as shown. Both look the same way, never toed in, each through a window of its own in the plane of
/// convergence (off-axis frusta): a point at the distance z is b f (1/z - 1/z0) further right for the left eye.
std::array<Eye, 2> two_eyes(const OrbitCamera& camera, const StereoRig& rig, float aspect);

/// At right angles to a camera, with right still at the right: from above, or from the front where the camera looks down.
/// Shows a sphere.
Eye cross_eye(const OrbitCamera& camera, const QVector3D& centre, float radius, float aspect);

/// Onto a place of a surface, steeply, from the camera's side. Shows a sphere; what is nearer than that is cut away, so that
/// nothing stands before it.
Eye wound_eye(const OrbitCamera& camera, const QVector3D& middle, const QVector3D& normal, float radius,
              float aspect);

}  // namespace swage::console
