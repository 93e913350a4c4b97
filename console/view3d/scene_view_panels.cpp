// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The panels of SceneView: one, with or without a second view in its corner, or the two eyes of a trainee.
#include <swage/abi/lesson.h>

#include <algorithm>
#include <cmath>

#include "console/view3d/corner.hpp"
#include "console/view3d/led_tool.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {
namespace {

constexpr double kSecond = 0.36;       // height of the second view, of that of the first
constexpr double kSecondShape = 1.25;  // width over height
constexpr double kMargin_px = 10;
constexpr double kLoupeShape = 1;
constexpr float kLeastLoupe_mm =
    0.3F;                           // half of what is shown of a clean prick: the wire fills a third of it
constexpr float kLoupeRoom = 1.5F;  // around the wound
constexpr float kLoupeStep = 1.5F;
constexpr int kGap_px = 2;          // between panels in the picture: the renderer rounds to whole pixels
constexpr double kClear_px = 24;    // between it and what it must not cover
constexpr float kAround_mm = 0.9F;  // shown around the tips and what they are to take
constexpr float kFurthest_mm = 6;   // from the tips: what is further off is not shown, the tips are
constexpr double kGlide_s = 0.15;   // time constant with which the second view follows
constexpr float kStill = 0.01F;     // of its size: a smaller move is none

float shape(const QSizeF& size) { return static_cast<float>(size.width() / std::max(size.height(), 1.0)); }

}  // namespace

void SceneView::set_second_shown(bool shown) {
  if (second_shown_ == shown) return;
  second_shown_ = shown;
  second_ = {};
  corner_ = 0;
  lay_out();
}

void SceneView::set_loupe_shown(bool shown) {
  if (loupe_shown_ == shown) return;
  loupe_shown_ = shown;
  show_loupe();
}

// The more there is to see the less it is magnified, in steps: a picture that breathes tells nothing. Under a drag it stays.
void SceneView::show_loupe() {
  float wanted = 0;
  if (loupe_shown_ && !stereo_ && wound_.there())
    for (wanted = kLeastLoupe_mm; wanted < kLoupeRoom * wound_.radius; wanted *= kLoupeStep) {
    }
  if (wanted == loupe_mm_ || (dragging_ && wanted > 0 && loupe_mm_ > 0)) return;
  loupe_mm_ = wanted;
  lay_out();
}

SceneView::Panel SceneView::loupe() const {
  const QRectF at = corner_at(loupe_corner_, kLoupeShape);
  const Eye eye = wound_eye(camera_, wound_.middle, wound_.normal, loupe_mm_, shape(at.size()));
  return {at, at.size(), {eye, {}}, Inset::kWound};
}

void SceneView::lay_out() {
  if (renderer_) renderer_->resize(canvas());
  touch(4);
  update();
}

std::vector<SceneView::Panel> SceneView::panels() const {
  const QSizeF all(size());
  std::vector<Panel> out;
  if (stereo_) {
    const auto two = places(stereo_->layout, all);
    for (size_t i = 0; i < two.size(); ++i) {
      if (two[i].isEmpty()) continue;
      const QSizeF own = stereo_->squeezed ? all : two[i].size();
      out.push_back({two[i], own, {eyes(own)[i], {}}});
    }
  } else {
    out.push_back({QRectF(QPointF(), all), all, {middle_eye(camera_, shape(all)), {}}});
    if (second_shown_ && !second_.empty()) {
      const QRectF at = corner_at(corner_, kSecondShape);
      const Eye eye = cross_eye(camera_, second_.centre(), second_.radius(), shape(at.size()));
      out.push_back({at, at.size(), {eye, {}}, Inset::kDepth});
    }
    if (loupe_mm_ > 0) out.push_back(loupe());
  }
  int x = 0;
  for (Panel& panel : out) {
    const QSize pixels = (panel.at.size() * devicePixelRatioF()).toSize();
    panel.view.part = QRect(QPoint(x, 0), pixels);
    x += pixels.width() + kGap_px;
  }
  return out;
}

// the corners in the order in which they are liked: bottom left, bottom right, top left; clock and cues are at the top right
QRectF SceneView::corner_at(int corner, double shape) const {
  const double h = kSecond * height(), w = shape * h;
  const double x = corner == 1 ? width() - w - kMargin_px : kMargin_px;
  return {x, corner == 2 ? kMargin_px : height() - h - kMargin_px, w, h};
}

// never over the tips, nor over what they go for; nor over other things that can be taken, where another corner is free of them
void SceneView::choose_corner(const QVector3D& tips, const QVector3D& aim) {
  const Eye eye = middle_eye(camera_, shape(size()));
  std::array<QRectF, 3> corners;
  for (int i = 0; i < 3; ++i)
    corners[static_cast<size_t>(i)] = corner_at(i, kSecondShape).adjusted(-kClear_px, -kClear_px, kClear_px, kClear_px);
  std::vector<QPointF> rather;
  for (const Spot& s : parts_.aim) rather.push_back(eye.project(place_of(s), size()));
  const int best = least_covered(corners, second_.empty() ? -1 : corner_, {eye.project(tips, size()), eye.project(aim, size())}, rather);
  if (best == corner_) return;
  corner_ = best;
  touch();
}

// nor the loupe over the tips, the wound or the second view
void SceneView::choose_loupe_corner() {
  if (loupe_mm_ <= 0 || dragging_) return;
  const Eye eye = middle_eye(camera_, shape(size()));
  const bool second = second_shown_ && !second_.empty();
  const auto free = [&](int corner) {
    if (second && corner == corner_) return false;
    const QRectF at = corner_at(corner, kLoupeShape).adjusted(-kClear_px, -kClear_px, kClear_px, kClear_px);
    return !at.contains(eye.project(middle_of_tips(), size())) &&
           !at.contains(eye.project(wound_.middle, size()));
  };
  if (free(loupe_corner_)) return;
  for (const int corner : {1, 0, 2}) {
    if (!free(corner)) continue;
    loupe_corner_ = corner;
    return touch();
  }
}

QSize SceneView::canvas() const {
  QSize out(1, 1);
  for (const Panel& panel : panels())
    out = {panel.view.part.right() + 1, std::max(out.height(), panel.view.part.height())};
  return out;
}

QImage SceneView::image() const {
  return image_parts_.size() < 2 ? image_ : image_.copy(image_parts_.front().view.part);
}

SceneView::Panel SceneView::panel_at(const QPointF& position) const {
  const std::vector<Panel> all = panels();
  for (const Panel& panel : all) {
    if (panel.inset == Inset::kNone) continue;
    if (dragging_ ? panel.inset == drags_in_ : panel.at.contains(position)) return panel;
  }
  return all.front();
}

QVector3D SceneView::place_of(const Spot& spot) const {
  const swage_pose& X =
      have_snapshot_ && spot.body < snapshot_->n_body ? snapshot_->X_WB[spot.body] : card_.start[spot.body];
  return to_mm(X.p) + to_qt(X.q).rotatedVector(spot.p_B);
}

// the middle between them
QVector3D SceneView::middle_of_tips() const {
  QVector3D sum;
  for (const Spot& s : parts_.tips) sum += place_of(s);
  return parts_.tips.empty() ? sum : sum / static_cast<float>(parts_.tips.size());
}

// What is near the tips, is dragged with them or driven about them are those of the tool that is led.
void SceneView::follow_led_tool() {
  const uint32_t now = led_tool(card_, *snapshot_);
  if (now == led_) return;
  led_ = now;
  if (const auto tips = parts_.tips_of.find(now); tips != parts_.tips_of.end()) parts_.tips = tips->second;
  update();
}

// The nearest thing that may be taken; once the tips are there, the mark that it is to be brought to.
QVector3D SceneView::aim_near(const QVector3D& tips) const {
  QVector3D aim = tips;
  float least = 1e30F;
  for (const Spot& s : parts_.aim) {
    const QVector3D p = place_of(s);
    if ((p - tips).length() >= least) continue;
    least = (p - tips).length();
    aim = p;
  }
  if ((aim - tips).length() > kAround_mm || !judged()) return aim;
  for (uint32_t m = 0; m < snapshot_->n_mark && m < card_.script.marks.size(); ++m) {
    if (card_.script.marks[m].mark.kind == SWAGE_MARK_POINT) return to_mm(snapshot_->mark_p_W[m]);
  }
  return aim;
}

// Shows the tips and what they are to take, the larger the nearer they come.
void SceneView::move_second(double dt_s) {
  choose_loupe_corner();
  if (stereo_ || !second_shown_ || dragging_ || parts_.tips.empty()) return;
  const QVector3D tips = middle_of_tips();
  QVector3D aim = aim_near(tips);
  if (const QVector3D way = aim - tips; way.length() > kFurthest_mm)
    aim = tips + way * (kFurthest_mm / way.length());
  choose_corner(tips, aim);
  const QVector3D centre = 0.5F * (tips + aim);
  float spread = 0.5F * (aim - tips).length();
  for (const Spot& s : parts_.tips) spread = std::max(spread, (place_of(s) - centre).length());
  const float radius = spread + kAround_mm;
  const bool fresh = second_.empty();
  const QVector3D half = QVector3D(1, 1, 1) * (radius / std::sqrt(3.0F));
  const auto k = fresh ? 1.0F : static_cast<float>(1 - std::exp(-dt_s / kGlide_s));
  if (!fresh && (centre - second_.centre()).length() + std::abs(radius - second_.radius()) < kStill * radius)
    return;
  second_.low = fresh ? centre - half : second_.low + k * (centre - half - second_.low);
  second_.high = fresh ? centre + half : second_.high + k * (centre + half - second_.high);
  fresh ? lay_out() : touch();
}

}  // namespace swage::console
