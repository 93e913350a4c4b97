// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/true_size.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swage::console {
namespace {

// Near and far plane over the distance to the picture: no eye comes nearer than a tenth, and nothing lies beyond three times.
constexpr float kNear = 0.1F, kFar = 3;

// An eye beside the middle looks straight ahead, through the same window as the other eye.
Eye beside(const OrbitCamera& camera, const TrueSize& station, const QSizeF& window_mm, float offset_mm) {
  const float scale = station.scale, d = station.distance_mm / scale, aside = offset_mm / scale;
  const float half_w = 0.5F * static_cast<float>(window_mm.width()) / scale, half_h = 0.5F * static_cast<float>(window_mm.height()) / scale;
  const QVector3D right = camera.q_WC().rotatedVector({1, 0, 0}), back = camera.q_WC().rotatedVector({0, 0, 1});
  const float near = kNear * d, share = near / d;
  Eye eye;
  eye.position = camera.focus() + d * back + aside * right;
  eye.ahead = camera.focus() + aside * right;
  eye.up = camera.up();
  eye.projection.frustum(share * (-half_w - aside), share * (half_w - aside), -share * half_h, share * half_h, near, kFar * d);
  eye.distance = d;
  eye.span = 2 * half_h;
  return eye;
}

}  // namespace

QSizeF mm_per_pixel(const TrueSize& station, const QSize& screen_px) {
  return {station.screen_mm.width() / std::max(screen_px.width(), 1), station.screen_mm.height() / std::max(screen_px.height(), 1)};
}

float look_down_deg(const TrueSize& station, bool by_mirror) {
  // a mirror at the angle m reflects a line at the angle a into one at 2 m - a
  const float picture = by_mirror ? 2 * station.mirror_tilt_deg - station.screen_tilt_deg : station.screen_tilt_deg;
  const float folded = std::abs(std::remainder(picture, 180.F));  // 0 lies flat, 90 stands
  return 90 - folded;
}

std::array<Eye, 2> true_eyes(const OrbitCamera& camera, const TrueSize& station, const QSizeF& window_mm, bool swapped) {
  const float half = 0.5F * station.eye_distance_mm;
  std::array<Eye, 2> eyes = {beside(camera, station, window_mm, -half), beside(camera, station, window_mm, half)};
  if (swapped) std::swap(eyes[0], eyes[1]);
  return eyes;
}

Eye true_eye(const OrbitCamera& camera, const TrueSize& station, const QSizeF& window_mm) {
  return beside(camera, station, window_mm, 0);
}

}  // namespace swage::console
