// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The panels of SceneView: one, with or without a second view in its corner, or the two eyes of a trainee.
#include <swage/abi/lesson.h>

#include <algorithm>
#include <cmath>

#include "console/view3d/scene_view.hpp"

namespace swage::console {
namespace {

constexpr double kSecond = 0.36;       // height of the second view, of that of the first
constexpr double kSecondShape = 1.25;  // width over height
constexpr double kMargin_px = 10;
constexpr double kClear_px = 16;    // between it and what it must not cover
constexpr float kAround_mm = 0.9F;  // shown around the tips and what they are to take
constexpr float kFurthest_mm = 6;   // from the tips: what is further off is not shown, the tips are
constexpr double kGlide_s = 0.15;   // time constant with which the second view follows
constexpr float kStill = 0.01F;     // of its size: a smaller move is none

float shape(const QSizeF& size) { return static_cast<float>(size.width() / std::max(size.height(), 1.0)); }

}  // namespace

void SceneView::set_stereo(const StereoLook& look) {
  stereo_ = look;
  lay_out();
}

void SceneView::set_second_shown(bool shown) {
  if (second_shown_ == shown) return;
  second_shown_ = shown;
  second_ = {};
  corner_ = 0;
  lay_out();
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
      out.push_back({two[i], own, {two_eyes(camera_, stereo_->rig, shape(own))[i], {}}});
    }
    if (out.size() == 1) out[0].view.eye = middle_eye(camera_, shape(out[0].size));
  } else {
    out.push_back({QRectF(QPointF(), all), all, {middle_eye(camera_, shape(all)), {}}});
    if (second_shown_ && !second_.empty()) {
      const QRectF at = second_at(corner_);
      const Eye eye = cross_eye(camera_, second_.centre(), second_.radius(), shape(at.size()));
      out.push_back({at, at.size(), {eye, {}}, true});
    }
  }
  int x = 0;
  for (Panel& panel : out) {
    const QSize pixels = (panel.at.size() * devicePixelRatioF()).toSize();
    panel.view.part = QRect(QPoint(x, 0), pixels);
    x += pixels.width();
  }
  return out;
}

// the corners in the order in which they are liked: bottom left, bottom right, top left; clock and cues are at the top right
QRectF SceneView::second_at(int corner) const {
  const double h = kSecond * height(), w = kSecondShape * h;
  const double x = corner == 1 ? width() - w - kMargin_px : kMargin_px;
  return {x, corner == 2 ? kMargin_px : height() - h - kMargin_px, w, h};
}

// never over the tips, nor over what they go for
void SceneView::choose_corner(const QVector3D& tips, const QVector3D& aim) {
  const Eye eye = middle_eye(camera_, shape(size()));
  const auto covers = [&](int corner) {
    const QRectF at = second_at(corner).adjusted(-kClear_px, -kClear_px, kClear_px, kClear_px);
    return at.contains(eye.project(tips, size())) || at.contains(eye.project(aim, size()));
  };
  if (!covers(corner_)) return;
  for (int corner = 0; corner < 3; ++corner) {
    if (covers(corner)) continue;
    corner_ = corner;
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
  return image_parts_.size() < 2 ? image_ : image_.copy(image_parts_.front());
}

SceneView::Panel SceneView::panel_at(const QPointF& position) const {
  const std::vector<Panel> all = panels();
  const bool second = all.size() > 1 && (dragging_ ? drags_second_ : all[1].at.contains(position));
  return all[second ? 1 : 0];
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
  if ((aim - tips).length() > kAround_mm || !have_snapshot_) return aim;
  for (uint32_t m = 0; m < snapshot_->n_mark && m < card_.script.marks.size(); ++m) {
    if (card_.script.marks[m].mark.kind == SWAGE_MARK_POINT) return to_mm(snapshot_->mark_p_W[m]);
  }
  return aim;
}

// Shows the tips and what they are to take, the larger the nearer they come.
void SceneView::move_second(double dt_s) {
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
