// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From where SceneView looks: at marks, square onto a needle's plane, with the eyes of a person or of a microscope.
#include <swage/abi/lesson.h>

#include <QScreen>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "console/view3d/scene_view.hpp"

namespace swage::console {
namespace {

constexpr float kMoved_mm = 0.02F;  // a mark that moves less stays where it is looked at
constexpr float kAnywhere_mm = 1e6F;
constexpr float kStands =
    0.7F;  // level part of its plane's normal: a needle that lies is looked at as everything is
constexpr float kBehindTool = 0.3F;  // of the way to the viewer: from here on the tool is in the way
constexpr float kFromTheFront_deg = -90;  // a person at a station sits before the scene

float shape(const QSizeF& size) { return static_cast<float>(size.width() / std::max(size.height(), 1.0)); }

QVector3D middle_of(const Mesh& mesh) {
  Bounds own;
  for (const Vertex& v : mesh.vertex) own.add({v.p[0], v.p[1], v.p[2]});
  return own.empty() ? QVector3D() : own.centre();
}

}  // namespace

// At the mark that is in the world, else at what is watched.
void SceneView::look_near() {
  if (preset_ != CameraPreset::kNear || !judged()) return;
  for (uint32_t m = 0; m < card_.script.marks.size() && m < snapshot_->n_mark; ++m) {
    if (card_.script.marks[m].mark.kind != SWAGE_MARK_POINT) continue;
    const QVector3D at = to_mm(snapshot_->mark_p_W[m]);
    if (!near_ || (*near_ - at).length() > kMoved_mm) camera_.stay_at(at);
    near_ = at;
    return;
  }
}

// From the side one looks square onto the plane of a needle that stands, past the tool: so it is driven along its curve.
void SceneView::look_aside() {
  if (preset_ != CameraPreset::kSide || !have_card_) return;
  const std::span<const swage_pose> X_WB =
      have_snapshot_ ? std::span<const swage_pose>(snapshot_->X_WB, snapshot_->n_body)
                     : std::span<const swage_pose>(card_.start);
  const auto circle = needle_circle(card_, parts_, X_WB, middle_of_tips(), kAnywhere_mm);
  if (!circle) return;
  QVector3D level(circle->axis.x(), circle->axis.y(), 0);
  if (level.length() < kStands) return;
  QVector3D handle;  // from the tips
  for (const ScenePart& part : parts_.part)
    if (part.role == Role::kTool && part.chain < 0)
      handle += place_of({part.body, middle_of(part.mesh)}) - middle_of_tips();
  const float away = QVector3D::dotProduct(level.normalized(), handle.normalized());
  const bool other_side = std::abs(away) > kBehindTool ? away > 0 : level.y() > 0;
  if (other_side) level = -level;
  camera_.look_from(static_cast<float>(qRadiansToDegrees(std::atan2(level.y(), level.x()))));
}

void SceneView::look(CameraPreset preset) {
  camera_.look(preset_ = preset);
  look_aside();
  near_ = {};
  look_near();
  touch();
}

void SceneView::set_stereo(const StereoLook& look) {
  stereo_ = look;
  const TrueSize& station = look.true_size;
  const bool hold = station.on && station.known() && station.held;
  if (hold) camera_.hold(kFromTheFront_deg, look_down_deg(station, look.mirror != Mirror::kNone));
  if (!hold && camera_.held()) {
    camera_.release();
    camera_.look(preset_);
  }
  lay_out();
}

QSizeF SceneView::screen_mm_per_pixel() const {
  constexpr double kUsual_mm = 25.4 / 96;  // of a screen that nobody has measured
  const QScreen* on = screen();
  if (!stereo_->true_size.known()) return {kUsual_mm, kUsual_mm};
  return console::mm_per_pixel(stereo_->true_size, on != nullptr ? on->size() : size());
}

// Size on the screen over size in the scene, at the focus.
float SceneView::screen_scale() const {
  const TrueSize& station = stereo_->true_size;
  return stereo_->microscope.on ? scale_on_screen(stereo_->microscope, station.distance_mm) : station.scale;
}

void SceneView::zoom_microscope(int notches) {
  const float was = std::exchange(stereo_->microscope.zoom, zoomed(stereo_->microscope.zoom, notches));
  if (was == stereo_->microscope.zoom) return;
  touch();
  Q_EMIT microscope_zoomed(stereo_->microscope.zoom);
}

void SceneView::set_station_mark(const std::optional<QPointF>& at_mm) {
  station_mark_ = at_mm;
  update();
}

// The eyes of a panel of this size in pixels: left and right, or the middle one twice.
std::array<Eye, 2> SceneView::eyes(const QSizeF& own) const {
  const StereoLook& look = *stereo_;
  const bool middle = look.layout == StereoLayout::kOneEye;
  if (look.microscope.on) {
    const auto height_mm = static_cast<float>(own.height() * screen_mm_per_pixel().height()) / screen_scale();
    const OrbitCamera scope = camera_.showing(height_mm);
    if (middle) return {middle_eye(scope, shape(own)), middle_eye(scope, shape(own))};
    return two_eyes(scope, look.rig, shape(own));
  }
  if (!look.true_size.on || !look.true_size.known()) {
    if (middle) return {middle_eye(camera_, shape(own)), middle_eye(camera_, shape(own))};
    return two_eyes(camera_, look.rig, shape(own));
  }
  const QSizeF mm = screen_mm_per_pixel();
  const QSizeF window(own.width() * mm.width(), own.height() * mm.height());
  if (middle) return {true_eye(camera_, look.true_size, window), true_eye(camera_, look.true_size, window)};
  return true_eyes(camera_, look.true_size, window, look.rig.swapped);
}

record::Display SceneView::display() const {
  if (!stereo_) return {"mono"};
  const bool two = !flat(stereo_->layout) && stereo_->rig.eye_distance_mm > 0;
  return {layout_name(stereo_->layout).toStdString(), two, two && stereo_->rig.swapped, mirror_name(stereo_->mirror).toStdString(),
          stereo_->true_size.known() && (stereo_->true_size.on || stereo_->microscope.on) ? static_cast<double>(screen_scale()) : 0};
}

}  // namespace swage::console
