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
  const Eye eye = middle_eye(camera_, shape(size()));
  tool_at_left_ = !parts_.tips.empty() && eye.project(spot(parts_.tips), size()).x() < 0.5 * width();
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
      const QSizeF own = QSizeF(kSecondShape, 1) * (kSecond * all.height());
      // at the bottom, away from where the tool comes from
      const QPointF corner(tool_at_left_ ? all.width() - own.width() - kMargin_px : kMargin_px,
                           all.height() - own.height() - kMargin_px);
      const Eye eye = cross_eye(camera_, second_.centre(), second_.radius(), shape(own));
      out.push_back({QRectF(corner, own), own, {eye, {}}, true});
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

QVector3D SceneView::spot(const std::vector<Spot>& spots) const {
  QVector3D sum;
  for (const Spot& s : spots) {
    const swage_pose& X =
        have_snapshot_ && s.body < snapshot_->n_body ? snapshot_->X_WB[s.body] : card_.start[s.body];
    sum += to_mm(X.p) + to_qt(X.q).rotatedVector(s.p_B);
  }
  return spots.empty() ? sum : sum / static_cast<float>(spots.size());
}

// What is to be taken; once the tips are there, the mark that it is to be brought to.
QVector3D SceneView::aim_near(const QVector3D& tips) const {
  const QVector3D aim = parts_.aim.empty() ? tips : spot(parts_.aim);
  if ((aim - tips).length() > kAround_mm || !have_snapshot_) return aim;
  for (uint32_t m = 0; m < snapshot_->n_mark && m < card_.script.marks.size(); ++m) {
    if (card_.script.marks[m].mark.kind == SWAGE_MARK_POINT) return to_mm(snapshot_->mark_p_W[m]);
  }
  return aim;
}

// Shows the tips and what they are to take, the larger the nearer they come.
void SceneView::move_second(double dt_s) {
  if (stereo_ || !second_shown_ || dragging_ || parts_.tips.empty()) return;
  const QVector3D tips = spot(parts_.tips);
  QVector3D aim = aim_near(tips);
  if (const QVector3D way = aim - tips; way.length() > kFurthest_mm)
    aim = tips + way * (kFurthest_mm / way.length());
  const QVector3D centre = 0.5F * (tips + aim);
  const float radius = 0.5F * (aim - tips).length() + kAround_mm;
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
