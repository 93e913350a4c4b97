// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/eye.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swage::console {
namespace {

constexpr float kEyeDeg = 0.017453292F;
constexpr float kDown_deg = 45;  // for a camera that looks down more steeply the second view is from the front

constexpr float kClear = 2;  // radii before a wound that are drawn: jaws nearer to the viewer would hide it
constexpr float kSteep_deg =
    55;  // elevation from which a wound is seen: its lips stand out, its shape is not foreshortened

// half the height of the view at a distance of 1
float half_height() { return std::tan(0.5F * OrbitCamera::kFovDeg * kEyeDeg); }

// near and far planes scale with the distance, for depth resolution near the scene
float near_of(float distance) { return 0.05F * distance; }
float far_of(float distance) { return 20 * distance; }

Eye aside(const OrbitCamera& camera, float offset, float convergence, float aspect) {
  const float d = camera.distance(), n = near_of(d), h = n * half_height();
  const float shift = offset * n / convergence;  // of the frustum's window, back towards the middle
  const QVector3D right = camera.q_WC().rotatedVector({1, 0, 0});
  Eye eye;
  eye.position = camera.eye() + offset * right;
  eye.up = camera.up();
  eye.ahead = camera.focus() + offset * right;
  eye.projection.frustum(-h * aspect - shift, h * aspect - shift, -h, h, n, far_of(d));
  eye.distance = d;
  eye.span = 2 * d * half_height();
  return eye;
}

}  // namespace

QMatrix4x4 Eye::view() const {
  QMatrix4x4 m;
  m.lookAt(position, ahead, up);
  return m;
}

QQuaternion Eye::q_WC() const {
  const QVector3D z = (position - ahead).normalized();
  return QQuaternion::fromAxes(QVector3D::crossProduct(up, z), up, z);
}

QPointF Eye::project(const QVector3D& p, const QSizeF& size) const {
  const QVector3D c = (projection * view()).map(p);
  return {(0.5 + 0.5 * static_cast<double>(c.x())) * size.width(),
          (0.5 - 0.5 * static_cast<double>(c.y())) * size.height()};
}

double Eye::mm_per_pixel(double height_px) const {
  return static_cast<double>(span) / std::max(height_px, 1.0);
}

double Eye::mm_per_pixel(double height_px, const QVector3D& p) const {
  const float depth = QVector3D::dotProduct(p - position, (ahead - position).normalized());
  return mm_per_pixel(height_px) * static_cast<double>(std::max(depth / distance, 0.1F));
}

Eye middle_eye(const OrbitCamera& camera, float aspect) {
  return aside(camera, 0, camera.distance(), aspect);
}

std::array<Eye, 2> two_eyes(const OrbitCamera& camera, const StereoRig& rig, float aspect) {
  const float scale = camera.distance() / kWorkingDistance_mm;
  const float half = 0.5F * scale * rig.eye_distance_mm, z0 = scale * std::max(rig.convergence_mm, 1.0F);
  std::array<Eye, 2> eyes = {aside(camera, -half, z0, aspect), aside(camera, half, z0, aspect)};
  if (rig.swapped) std::swap(eyes[0], eyes[1]);
  return eyes;
}

Eye cross_eye(const OrbitCamera& camera, const QVector3D& centre, float radius, float aspect) {
  const QVector3D right = camera.q_WC().rotatedVector({1, 0, 0});
  const QVector3D forwards = QVector3D::crossProduct({0, 0, 1}, right).normalized();  // level
  const float climb = QVector3D::dotProduct(camera.up(), {0, 0, 1});  // cosine of the camera's pitch
  const bool from_above = climb > std::cos(kDown_deg * kEyeDeg);
  Eye eye;
  eye.distance = radius / std::sin(0.5F * OrbitCamera::kFovDeg * kEyeDeg);
  eye.span = 2 * eye.distance * half_height();
  eye.ahead = centre;
  eye.position = centre + eye.distance * (from_above ? QVector3D(0, 0, 1) : -forwards);
  eye.up = from_above ? forwards : QVector3D(0, 0, 1);
  eye.projection.perspective(OrbitCamera::kFovDeg, aspect, near_of(eye.distance), far_of(eye.distance));
  return eye;
}

Eye wound_eye(const OrbitCamera& camera, const QVector3D& middle, const QVector3D& normal, float radius,
              float aspect) {
  const auto in_plane = [&](const QVector3D& v) { return v - QVector3D::dotProduct(v, normal) * normal; };
  QVector3D aside = in_plane(camera.eye() - camera.focus());
  if (aside.length() < 0.1F * camera.distance()) aside = in_plane(-camera.up());
  const QVector3D to_eye =
      std::cos(kSteep_deg * kEyeDeg) * aside.normalized() + std::sin(kSteep_deg * kEyeDeg) * normal;
  Eye eye;
  eye.distance = radius / std::sin(0.5F * OrbitCamera::kFovDeg * kEyeDeg);
  eye.span = 2 * eye.distance * half_height();
  eye.ahead = middle;
  eye.position = middle + eye.distance * to_eye;
  eye.up = (normal - QVector3D::dotProduct(normal, to_eye) * to_eye).normalized();
  eye.projection.perspective(OrbitCamera::kFovDeg, aspect, eye.distance - kClear * radius,
                             far_of(eye.distance));
  return eye;
}

}  // namespace swage::console
