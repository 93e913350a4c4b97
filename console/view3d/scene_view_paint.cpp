// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What SceneView paints around and over the 3D picture.
#include <swage/abi/lesson.h>

#include <QLinearGradient>
#include <QPainter>
#include <algorithm>

#include "console/view3d/overlay.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {
namespace {

constexpr double kForceScale_px = 60;  // arrow of 1 N

}  // namespace

QVector3D SceneView::grasp_point(uint32_t object) const {
  // a wound; else where the forces of contact act, which are greatest in the jaws; else the object itself
  for (uint32_t i = 0; i < snapshot_->n_tear; ++i) {
    if (snapshot_->tear[i].object == object) return to_mm(snapshot_->tear[i].tear.b_W);
  }
  QVector3D sum;
  double weight = 0;
  for (uint32_t i = 0; i < snapshot_->n_contact; ++i) {
    const swage_vec3& f = snapshot_->contact[i].f_W;
    const double w = f.x * f.x + f.y * f.y + f.z * f.z;
    sum += static_cast<float>(w) * to_mm(snapshot_->contact[i].p_W);
    weight += w;
  }
  if (weight > 0) return sum / static_cast<float>(weight);
  if (parts_.watched >= 0 && static_cast<uint32_t>(parts_.watched) < snapshot_->n_body) {
    const swage_pose& X = snapshot_->X_WB[parts_.watched];
    if (role_of(card_, object) == Role::kWork)
      return to_mm(X.p) + to_qt(X.q).rotatedVector(parts_.watched_on);
  }
  const uint32_t body = card_.objects[object].first_body;
  return to_mm(body < snapshot_->n_body ? snapshot_->X_WB[body].p : swage_vec3{});
}

void SceneView::paint_placeholder(QPainter& painter) {
  painter.setPen(ui_["view_text"]);
  painter.drawText(
      rect().adjusted(40, 0, -40, 0), Qt::AlignCenter | Qt::TextWordWrap,
      tr("The 3D view needs OpenGL 3.3 (%1).\nEverything else works: lessons run and are recorded.")
          .arg(gl_.why));
}

void SceneView::paint_background(QPainter& painter, const QRectF& at) {
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  if (background_.size() != pixels) {
    background_ = QPixmap(pixels);
    QPainter p(&background_);
    QLinearGradient gradient(0, 0, 0, pixels.height());
    gradient.setColorAt(0, ui_["view_top"]);
    gradient.setColorAt(1, ui_["view_bottom"]);
    p.fillRect(background_.rect(), gradient);
  }
  painter.drawPixmap(at, background_, background_.rect());
}

bool SceneView::has_target() const {
  return std::any_of(card_.script.marks.begin(), card_.script.marks.end(),
                     [](const judge::Script::Mark& m) { return m.mark.kind == SWAGE_MARK_POINT; });
}

// Points that a lesson shows in the world. Where to go is the task and is seen in a test, too; that one is near is a cue.
void SceneView::paint_marks(Overlay& overlay, const Panel& panel) const {
  const Eye& eye = panel.view.eye;
  const double h = panel.size.height();
  for (uint32_t m = 0; m < snapshot_->n_mark && m < card_.script.marks.size(); ++m) {
    const auto& mark = card_.script.marks[m];
    if (mark.mark.kind != SWAGE_MARK_POINT) continue;
    const uint32_t cue = cues_shown_ ? snapshot_->mark_cue[m] : SWAGE_NONE;
    if (cue == SWAGE_NONE && pierced_) continue;  // the wound is there now, and is to be seen
    const std::string meaning = cue < card_.script.cues.size() ? card_.script.cues[cue].id : mark.meaning;
    const QPointF at = eye.project(to_mm(snapshot_->mark_p_W[m]), panel.size);
    const double radius = mark.mark.number[0] * kMmPerM / eye.mm_per_pixel(h);
    overlay.target(at, radius, cues_.style(QString::fromStdString(meaning)), !panel.second);
    if (cues_shown_ && hold_ > 0) overlay.ring(at, hold_, std::max(radius, kLeastMark_px) + 7);
  }
}

void SceneView::paint_forces(Overlay& overlay, const Panel& panel) const {
  const Eye& eye = panel.view.eye;
  for (uint32_t c = 0; forces_shown_ && c < snapshot_->n_contact; ++c) {
    const QVector3D p = to_mm(snapshot_->contact[c].p_W);
    const swage_vec3& f = snapshot_->contact[c].f_W;
    const auto mm = static_cast<float>(kForceScale_px * eye.mm_per_pixel(panel.size.height()));
    const QVector3D arrow(static_cast<float>(f.x), static_cast<float>(f.y), static_cast<float>(f.z));
    overlay.force(eye.project(p, panel.size), eye.project(p + mm * arrow, panel.size));
  }
}

void SceneView::paint_cues(Overlay& overlay, const Panel& panel) const {
  int slot = 0;
  bool ringed = false;
  for (uint32_t o = 0; o < card_.objects.size(); ++o) {
    const QString cue = cue_of(o);
    if (cue.isEmpty()) continue;
    const QPointF at = panel.view.eye.project(grasp_point(o), panel.size);
    if (!ringed && hold_ > 0 && !has_target()) overlay.ring(at, hold_), ringed = true;
    // the tool's own cue (too much force) goes to the left, that of the work to the right
    const bool tool = role_of(card_, o) == Role::kTool;
    overlay.cue(at, cues_.style(cue), tool ? 1 : slot++ == 0 ? 0 : 2);
  }
}

// The scene as one eye sees it, and over it what belongs to places in it.
void SceneView::paint_panel(QPainter& painter, const Panel& panel, size_t index) {
  painter.save();
  painter.setClipRect(panel.at);
  paint_background(painter, panel.at);
  if (index < image_parts_.size()) {
    // until the next one comes a picture of another size is stretched
    const QRect& part = image_parts_[index];
    painter.setRenderHint(QPainter::SmoothPixmapTransform, part.size() != panel.view.part.size());
    painter.drawImage(panel.at, image_, part);
  }
  painter.translate(panel.at.topLeft());
  painter.scale(panel.at.width() / panel.size.width(), panel.at.height() / panel.size.height());
  Overlay overlay(painter, QRectF(QPointF(), panel.size), ui_);
  if (have_snapshot_) {
    paint_marks(overlay, panel);
    paint_forces(overlay, panel);
    if (!panel.second) paint_cues(overlay, panel);
  }
  painter.restore();
}

void SceneView::paint_anaglyph(QPainter& painter, const std::vector<Panel>& two) {
  QImage eye[2];
  for (size_t i = 0; i < 2; ++i) {
    eye[i] = QImage((two[i].at.size() * devicePixelRatioF()).toSize(), QImage::Format_RGB32);
    eye[i].setDevicePixelRatio(devicePixelRatioF());
    QPainter own(&eye[i]);
    own.setFont(font());
    paint_panel(own, two[i], i);
  }
  painter.drawImage(rect(), red_cyan(eye[0], eye[1]));
}

// the corner that shows the depth: what it is, and how large
void SceneView::paint_frame(QPainter& painter, const Panel& second) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(ui_["border"], 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(second.at);
  const bool from_above = second.view.eye.up.z() < 0.5F;
  painter.setPen(ui_["view_text"]);
  painter.drawText(second.at.adjusted(8, 5, -8, -5), Qt::AlignLeft | Qt::AlignTop,
                   from_above ? tr("From above") : tr("From the front"));
}

void SceneView::paint_words(QPainter& painter) {
  Overlay overlay(painter, rect(), ui_);
  const std::vector<Panel> all = panels();
  const bool beside = all.size() > 1 && corner_ == 0;
  if (have_card_)
    overlay.scale_bar(all.front().view.eye.mm_per_pixel(height()), beside ? all[1].at.right() : 0);
  if (!clock_text_.isEmpty()) overlay.clock(clock_text_);
  if (!banner_.isEmpty()) overlay.banner(banner_);
  if (instrument_ && !hasFocus()) overlay.hint(tr("Click here: then mouse and keys move the instrument"));
  if (!hasFocus()) return;
  painter.setPen(QPen(ui_["accent"], 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SceneView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!renderer_) {
    paint_background(painter, rect());
    return paint_placeholder(painter);
  }
  const std::vector<Panel> all = panels();
  if (stereo_ && all.size() == 2 && stereo_->layout == StereoLayout::kAnaglyph)
    return paint_anaglyph(painter, all);
  for (size_t i = 0; i < all.size(); ++i) {
    paint_panel(painter, all[i], i);
    if (all[i].second) paint_frame(painter, all[i]);
  }
  if (!stereo_) paint_words(painter);
}

}  // namespace swage::console
