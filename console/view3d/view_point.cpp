// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/view_point.hpp"

#include <QtMath>
#include <algorithm>
#include <cmath>

#include "console/view3d/needle_circle.hpp"
#include "console/view3d/sight.hpp"

namespace swage::console {
namespace {

constexpr float kToTheKnot = 7;        // notches of the wheel: of a thread of 55 mm the 10 mm about its knot; with fewer the throws are not told apart
constexpr float kRoom = 1.2F;       // factor on the framed radius
constexpr float kLeast_mm = 0.3F;   // smallest framed radius
constexpr float kMoved_mm = 0.02F;  // smallest motion of a mark that the camera follows
constexpr float kAnywhere_mm = 1e6F;
constexpr float kStands = 0.7F;           // horizontal part of the needle plane's normal; below it the needle lies flat
constexpr float kBehindTool = 0.3F;       // cosine between view direction and tool: above it the tool stands in the way
constexpr float kAtViewer = 0.7F;             // the same of a shaft before other work, at 45 deg: below it one looks past it
constexpr float kRoundNeedle = 2;         // in radii of the needle's curve: needle and the marks beside it stay clear
constexpr float kJaws_mm = 4;             // depth before the needle: jaws within it are shown, the joint and the shaft behind are cut away
constexpr float kFromTheFront_deg = -90;  // a person at a station sits before the scene
constexpr float kFromBehind_deg = 90;

QVector3D middle_of(const Mesh& mesh) {
  Bounds own;
  for (const Vertex& v : mesh.vertex) own.add({v.p[0], v.p[1], v.p[2]});
  return own.empty() ? QVector3D() : own.centre();
}

}  // namespace

void ViewPoint::frame(CameraPreset preset) {
  const Bounds& focus = scene_.parts().focus;
  camera.frame(focus.centre(), kRoom * std::max(focus.radius(), kLeast_mm));
  near_ = {};
  focus_mm_ = 0;
  camera.look(preset_ = preset);
  look_aside();
  camera.jump();
}

void ViewPoint::look(CameraPreset preset) {
  camera.look(preset_ = preset);
  look_aside();
  near_ = {};
  look_near();
}

void ViewPoint::look_close() {
  look(CameraPreset::kNear);
  if (scene_.ties() || scene_.has_knot()) camera.zoom(kToTheKnot);
}

// Looks at what the lesson is about; where nothing tells it the present point stays. True when there is a point.
bool ViewPoint::look_near() {
  if (preset_ != CameraPreset::kNear) return near_.has_value();
  const std::optional<QVector3D> at = scene_.subject();
  if (!at) return near_.has_value();
  if (!near_ || (*near_ - *at).length() > kMoved_mm) camera.stay_at(*at);
  near_ = at;
  return true;
}

// From the side the camera looks perpendicular to the plane of an upright needle, past the tool: the needle is driven in this plane. Where
// something hides the needle, such as the flap to be pierced, the camera looks from the front; and where nothing can be pierced and a shaft
// lies along that line of sight, as it would hide the needle and its own tilt.
void ViewPoint::look_aside() {
  if (preset_ != CameraPreset::kSide || !scene_.have_card()) return;
  const auto circle = needle_circle(scene_.card(), scene_.parts(), scene_.X_WB(), scene_.middle_of_tips(), kAnywhere_mm);
  if (!circle) return look_past_tool();
  QVector3D level(circle->axis.x(), circle->axis.y(), 0);
  if (level.length() < kStands) return;
  if (!drives() && looks_along_a_shaft(level.normalized())) return look_past_tool();
  const float away = QVector3D::dotProduct(level.normalized(), handle());
  const bool other_side = std::abs(away) > kBehindTool ? away > 0 : level.y() > 0;
  if (other_side) level = -level;
  if (hidden(scene_.parts(), scene_.X_WB(), circle->centre, level.normalized())) return;
  camera.look_from(static_cast<float>(qRadiansToDegrees(std::atan2(level.y(), level.x()))));
}

// Direction from the tips to the handle of the active tool, as the other hand's stands aside; 0 0 0 without one.
QVector3D ViewPoint::handle() const {
  const QVector3D tips = scene_.middle_of_tips();
  const auto tool = scene_.active_tool();
  QVector3D sum;
  for (const ScenePart& part : scene_.parts().part)
    if (part.role == Role::kTool && part.chain < 0 && part.object == tool) sum += scene_.place_of({part.body, middle_of(part.mesh)}) - tips;
  return sum.normalized();
}

// Direction of a tool's shaft, from its tips.
QVector3D ViewPoint::shaft(uint32_t tool) const {
  QVector3D tips, sum;
  const std::vector<Spot>& spots = scene_.parts().tips_of.at(tool);
  for (const Spot& s : spots) tips += scene_.place_of(s) / static_cast<float>(spots.size());
  for (const ScenePart& part : scene_.parts().part)
    if (part.role == Role::kTool && part.chain < 0 && part.object == tool) sum += scene_.place_of({part.body, middle_of(part.mesh)}) - tips;
  return sum.normalized();
}

// Whether there is something to drive a needle through.
bool ViewPoint::drives() const {
  const auto& objects = scene_.card().objects;
  return std::any_of(objects.begin(), objects.end(), [](const snapshot::CardObject& o) {
    return std::find(o.traits.begin(), o.traits.end(), SWAGE_TRAIT_PIERCEABLE) != o.traits.end();
  });
}

bool ViewPoint::looks_along_a_shaft(const QVector3D& sight) const {
  const auto& tools = scene_.parts().tips_of;
  return std::any_of(tools.begin(), tools.end(), [&](const auto& t) { return std::abs(QVector3D::dotProduct(sight, shaft(t.first))) > kAtViewer; });
}

// Other work than a needle is seen from the front, or where a shaft points at the viewer there and hides what its tips hold, from behind.
void ViewPoint::look_past_tool() {
  const QVector3D front(0, -1, 0), work = scene_.watched().value_or(scene_.middle_of_tips());
  const auto& tools = scene_.parts().tips_of;
  const bool hides = std::any_of(tools.begin(), tools.end(), [&](const auto& t) { return QVector3D::dotProduct(front, shaft(t.first)) > kAtViewer; });
  if (hides && !hidden(scene_.parts(), scene_.X_WB(), work, -front)) camera.look_from(kFromBehind_deg);
}

ClearSight ViewPoint::clear_sight() const {
  if (preset_ != CameraPreset::kSide || stereo_ || !scene_.have_card()) return {};
  const auto circle = needle_circle(scene_.card(), scene_.parts(), scene_.X_WB(), scene_.middle_of_tips(), kAnywhere_mm);
  if (!circle) return {};
  return {circle->centre, kRoundNeedle * circle->radius, kJaws_mm};
}

void ViewPoint::set_stereo(const StereoLook& look) {
  stereo_ = look;
  const TrueSize& station = look.true_size;
  const bool hold = station.on && station.known() && station.held;
  if (hold) camera.hold(kFromTheFront_deg, look_down_deg(station, look.mirror != Mirror::kNone));
  if (!hold && camera.held()) {
    camera.release();
    camera.look(preset_);
  }
}

bool ViewPoint::zoom_microscope(int notches) {
  const float was = stereo_->microscope.zoom;
  stereo_->microscope.zoom = zoomed(was, notches);
  return stereo_->microscope.zoom != was;
}

bool ViewPoint::focus_microscope(int steps) {
  const float was = focus_mm_;
  focus_mm_ = std::clamp(was + kFocusStep_mm * static_cast<float>(steps), -kMostFocus_mm, kMostFocus_mm);
  return focus_mm_ != was;
}

Lens ViewPoint::lens(const QSize& panel_px, const Eye& eye) const {
  if (!microscope() || !stereo_->microscope.blur) return {};
  return {true, eye.distance, kPupil_mm / kWorkingDistance_mm, static_cast<float>(panel_px.height()) / eye.span};
}

QSizeF ViewPoint::screen_mm_per_pixel() const {
  constexpr double kUsual_mm = 25.4 / 96;  // pixel size of a screen without measurements
  if (!stereo_->true_size.known()) return {kUsual_mm, kUsual_mm};
  return console::mm_per_pixel(stereo_->true_size, screen_px_);
}

// Size on the screen over size in the scene, at the focus.
float ViewPoint::screen_scale() const {
  const TrueSize& station = stereo_->true_size;
  return stereo_->microscope.on ? scale_on_screen(stereo_->microscope, station.distance_mm) : station.scale;
}

std::array<Eye, 2> ViewPoint::eyes(const QSizeF& panel) const {
  const StereoLook& look = *stereo_;
  const bool middle = look.layout == StereoLayout::kOneEye;
  const auto seen_by = [&](const OrbitCamera& from) -> std::array<Eye, 2> {
    if (middle) return {middle_eye(from, shape_of(panel)), middle_eye(from, shape_of(panel))};
    return two_eyes(from, look.rig, shape_of(panel));
  };
  const QSizeF mm = screen_mm_per_pixel();
  if (look.microscope.on) return seen_by(camera.nearer(focus_mm_).showing(static_cast<float>(panel.height() * mm.height()) / screen_scale()));
  if (!look.true_size.on || !look.true_size.known()) return seen_by(camera);
  const QSizeF window(panel.width() * mm.width(), panel.height() * mm.height());
  if (middle) return {true_eye(camera, look.true_size, window), true_eye(camera, look.true_size, window)};
  return true_eyes(camera, look.true_size, window, look.rig.swapped);
}

record::Display ViewPoint::display() const {
  if (!stereo_) return {"mono"};
  const bool two = !flat(stereo_->layout) && stereo_->rig.eye_distance_mm > 0;
  const bool scaled = stereo_->true_size.known() && (stereo_->true_size.on || stereo_->microscope.on);
  return {layout_name(stereo_->layout).toStdString(), two, two && stereo_->rig.swapped, mirror_name(stereo_->mirror).toStdString(),
          scaled ? static_cast<double>(screen_scale()) : 0};
}

}  // namespace swage::console
