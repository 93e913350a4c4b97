// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/camera.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swage::console {
namespace {

constexpr double kGlide_s = 0.09;  // time constant; longer feels sluggish, shorter jumps
constexpr float kStray = 0.5F;     // of half the picture's height: a followed point may move so far from the middle
constexpr float kInside = 0.8F;    // of half the picture: followed points stay within this share
constexpr float kLeastRoom = 0.3F; // of the room at the focus: lower limit for points nearer to the viewer
constexpr float kBack = 1.25F;     // factor of one step back; with smaller steps the picture changes all the time
constexpr float kMostBack = 2;     // further away the needle is too small to be worked on
constexpr float kSpare = 0.85F;    // of the room available: below this share the camera steps nearer again
constexpr float kNear = 0.7F;      // of the distance at which everything is framed
constexpr float kDeg = 0.017453292F;

int place_in_order(CameraPreset view) { return static_cast<int>(std::find(kViewOrder.begin(), kViewOrder.end(), view) - kViewOrder.begin()); }

}  // namespace

std::optional<CameraPreset> view_named(std::string_view name) {
  const auto* const found = std::find(std::begin(snapshot::kViews), std::end(snapshot::kViews), name);
  if (found == std::end(snapshot::kViews)) return std::nullopt;
  return kViewOrder[static_cast<size_t>(found - std::begin(snapshot::kViews))];
}

CameraPreset view_after(CameraPreset now, int steps) {
  return kViewOrder[static_cast<size_t>(place_in_order(now) + steps) % kViewOrder.size()];
}

int steps_between(CameraPreset from, CameraPreset to) {
  constexpr int n = static_cast<int>(kViewOrder.size());
  return (place_in_order(to) - place_in_order(from) + n) % n;
}

void OrbitCamera::frame(const QVector3D& centre, float radius) {
  home_centre_ = centre;
  home_radius_ = std::max(radius, 1e-3F);
  goal_.focus = centre;
  goal_.distance = room_ * home_radius_ / std::sin(0.5F * kFovDeg * kDeg);
  backed_ = 1;
  if (held_) goal_.yaw = held_yaw_, goal_.pitch = held_pitch_;
}

void OrbitCamera::set_room(float factor) { goal_.distance *= factor / std::exchange(room_, factor); }

void OrbitCamera::look(CameraPreset preset) {
  frame(home_centre_, home_radius_);
  follows_ = !held_;
  if (held_) return;
  switch (preset) {
    case CameraPreset::kOrbit:
      goal_.yaw = -60, goal_.pitch = 28;
      break;
    case CameraPreset::kSide:
      goal_.yaw = -90, goal_.pitch = 4;
      break;
    case CameraPreset::kTop:
      goal_.yaw = -90, goal_.pitch = 89.9F;
      break;
    case CameraPreset::kNear:
      goal_.yaw = -60, goal_.pitch = 32;
      goal_.distance *= kNear;
      break;
  }
}

void OrbitCamera::stay_at(const QVector3D& point) {
  if (held_) return;
  goal_.focus = point;
  follows_ = false;
}

bool OrbitCamera::from_behind() const {
  constexpr float kBehind = 0.5;  // of the way from the side to straight from behind
  return (eye() - now_.focus).normalized().y() > kBehind;
}

void OrbitCamera::hold(float yaw_deg, float pitch_deg) {
  held_ = true;
  held_yaw_ = yaw_deg, held_pitch_ = pitch_deg;
  look(CameraPreset::kOrbit);
}

OrbitCamera OrbitCamera::showing(float height_mm) const {
  OrbitCamera out = *this;
  out.now_.distance = 0.5F * height_mm / std::tan(0.5F * kFovDeg * kDeg);
  return out;
}

OrbitCamera OrbitCamera::nearer(float mm) const {
  OrbitCamera out = *this;
  out.now_.focus += mm * (eye() - now_.focus).normalized();
  return out;
}

void OrbitCamera::release() { held_ = false; }

// takes the shorter of the two rotations
void OrbitCamera::look_from(float yaw_deg) {
  if (held_) return;
  goal_.yaw = yaw_deg;
  now_.yaw = yaw_deg + std::remainder(now_.yaw - yaw_deg, 360.F);
}

void OrbitCamera::turn(float yaw_deg, float pitch_deg) {
  if (held_) return;
  goal_.yaw += yaw_deg;
  goal_.pitch = std::clamp(goal_.pitch + pitch_deg, 0.0F, 89.9F);
}

void OrbitCamera::pan(float dx, float dy) {
  if (held_) return;
  follows_ = false;
  const float height = 2 * goal_.distance * std::tan(0.5F * kFovDeg * kDeg);
  const QQuaternion q = q_WC();
  goal_.focus -= q.rotatedVector({dx * height, dy * height, 0});
  now_.focus = goal_.focus;
}

void OrbitCamera::follow(const QVector3D& point) {
  if (!follows_) return;
  const QVector3D forward = (now_.focus - eye()).normalized();
  QVector3D off = point - goal_.focus;
  off -= QVector3D::dotProduct(off, forward) * forward;
  const float allowed = kStray * goal_.distance * std::tan(0.5F * kFovDeg * kDeg);
  if (off.length() > allowed) goal_.focus += off * (1 - allowed / off.length());
}

void OrbitCamera::follow_both(const QVector3D& point, const QVector3D& other, float shape) {
  follow(point);
  if (!follows_) return;
  // Position across the picture at its focus, in units of its height; z: scale of the visible room at the point's depth, < 1 if nearer.
  const QQuaternion q = q_WC();
  const float distance = goal_.distance / backed_;
  const auto across = [&](const QVector3D& p) {
    const QVector3D c = q.conjugated().rotatedVector(p - goal_.focus);
    return QVector3D(c.x() / std::max(shape, 0.1F), c.y(), std::max(1 - c.z() / distance, kLeastRoom));
  };
  const QVector3D a = across(point), b = across(other);
  const float half = kInside * distance * std::tan(0.5F * kFovDeg * kDeg);
  const float apart = std::max(std::abs(a.x() - b.x()), std::abs(a.y() - b.y())) / (a.z() + b.z());
  float back = 1;
  while (back < kMostBack && apart > half * back) back *= kBack;
  if (back < backed_ && apart > kSpare * half * back) back = backed_;
  goal_.distance *= back / std::exchange(backed_, back);
  // the first point has priority: it always stays in the picture
  const float inside_a = half * back * a.z(), inside_b = half * back * b.z();
  const auto shift = [&](float first, float second) {
    const float wanted = second - std::clamp(second, -inside_b, inside_b);
    return std::clamp(wanted, std::min(0.F, first - inside_a), std::max(0.F, first + inside_a));
  };
  goal_.focus += q.rotatedVector({shift(a.x(), b.x()) * shape, shift(a.y(), b.y()), 0});
}

void OrbitCamera::zoom(float notches) {
  if (held_) return;
  goal_.distance =
      std::clamp(goal_.distance * std::pow(0.88F, notches), 0.3F * home_radius_, 40 * home_radius_);
}

bool OrbitCamera::advance(double dt_s) {
  const auto k = static_cast<float>(1 - std::exp(-std::max(dt_s, 0.0) / kGlide_s));
  const QVector3D df = goal_.focus - now_.focus;
  const float dy = goal_.yaw - now_.yaw, dp = goal_.pitch - now_.pitch, dd = goal_.distance - now_.distance;
  // below a tenth of a pixel the camera is at rest
  const float eps = 2e-4F;
  if (df.length() < eps * now_.distance && std::abs(dy) < 0.02F && std::abs(dp) < 0.02F &&
      std::abs(dd) < eps * now_.distance) {
    return false;
  }
  now_.focus += df * k;
  now_.yaw += dy * k;
  now_.pitch += dp * k;
  now_.distance += dd * k;
  return true;
}

void OrbitCamera::jump() { now_ = goal_; }

QVector3D OrbitCamera::eye() const {
  const float y = now_.yaw * kDeg, p = now_.pitch * kDeg;
  return now_.focus +
         now_.distance * QVector3D(std::cos(p) * std::cos(y), std::cos(p) * std::sin(y), std::sin(p));
}

QVector3D OrbitCamera::up() const {
  const float y = now_.yaw * kDeg, p = now_.pitch * kDeg;
  return {-std::sin(p) * std::cos(y), -std::sin(p) * std::sin(y), std::cos(p)};
}

QQuaternion OrbitCamera::q_WC() const {
  const QVector3D z = (eye() - now_.focus).normalized();
  return QQuaternion::fromAxes(QVector3D::crossProduct(up(), z), up(), z);
}

}  // namespace swage::console
