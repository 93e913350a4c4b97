// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What SceneView paints around and over the 3D picture.
#include <swage/abi/lesson.h>

#include <QLinearGradient>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "console/view3d/overlay.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {
namespace {

constexpr double kBesideWound_px = 9;  // from its edge to the ring of its cue
constexpr double kForceScale_px = 60;  // arrow of 1 N

}  // namespace

QVector3D SceneView::grasp_point(uint32_t object) const {
  if (wound_.there() && object == wounded_object_) return wound_.middle;
  // where the forces of contact act, which are greatest in the jaws; else the object itself
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
  for (uint32_t m = 0; judged() && m < snapshot_->n_mark && m < card_.script.marks.size(); ++m) {
    const auto& mark = card_.script.marks[m];
    if (mark.mark.kind != SWAGE_MARK_POINT) continue;
    const uint32_t cue = cues_shown_ ? snapshot_->mark_cue[m] : SWAGE_NONE;
    if (cue == SWAGE_NONE && pierced_) continue;  // the wound is there now, and is to be seen
    const std::string meaning = cue < card_.script.cues.size() ? card_.script.cues[cue].id : mark.meaning;
    const QPointF at = eye.project(to_mm(snapshot_->mark_p_W[m]), panel.size);
    const double radius = mark.mark.number[0] * kMmPerM / eye.mm_per_pixel(h);
    overlay.target(at, radius, cues_.style(QString::fromStdString(meaning)), panel.inset == Inset::kNone);
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

// a cue stands beside a wound, never on it
double SceneView::clear_px(uint32_t object, const Panel& panel) const {
  if (!wound_.there() || object != wounded_object_) return 0;
  const double mm = panel.view.eye.mm_per_pixel(panel.size.height(), wound_.middle);
  return static_cast<double>(wound_.radius) / mm + kBesideWound_px;
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
    overlay.cue(at, cues_.style(cue), tool ? 1 : slot++ == 0 ? 0 : 2, clear_px(o, panel));
  }
}

// where a panel lies in the last picture, which may be of other panels
const SceneView::Panel* SceneView::drawn(const Panel& panel, size_t index) const {
  if (stereo_) return index < image_parts_.size() ? &image_parts_[index] : nullptr;
  const auto same = std::find_if(image_parts_.begin(), image_parts_.end(),
                                 [&](const Panel& p) { return p.inset == panel.inset; });
  return same == image_parts_.end() ? nullptr : &*same;
}

// In the plane of the screen: either eye has it at the same place.
void SceneView::paint_station_mark(QPainter& painter, const Panel& panel) const {
  constexpr double kArm_mm = 8;
  const QSizeF mm = screen_mm_per_pixel();
  if (mm.width() <= 0 || mm.height() <= 0) return;
  const QPointF at(0.5 * panel.size.width() + station_mark_->x() / mm.width(), 0.5 * panel.size.height() - station_mark_->y() / mm.height());
  const QPointF x(kArm_mm / mm.width(), 0), y(0, kArm_mm / mm.height());
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [colour, width] : {std::pair{Qt::black, 5}, {Qt::white, 2}}) {
    painter.setPen(QPen(colour, width));
    painter.drawLine(at - x, at + x);
    painter.drawLine(at - y, at + y);
  }
}

// The scene as one eye sees it, and over it what belongs to places in it.
void SceneView::paint_panel(QPainter& painter, const Panel& panel, size_t index) {
  painter.save();
  painter.setClipRect(panel.at);
  paint_background(painter, panel.at);
  if (const Panel* last = drawn(panel, index)) {
    // until the next one comes a picture of another size is stretched
    const QRect& part = last->view.part;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, part.size() != panel.view.part.size());
    painter.drawImage(panel.at, image_, part);
  }
  painter.translate(panel.at.topLeft());
  painter.scale(panel.at.width() / panel.size.width(), panel.at.height() / panel.size.height());
  if (stereo_ && stereo_->microscope.on) paint_field(painter, panel.size);
  Overlay overlay(painter, QRectF(QPointF(), panel.size), ui_);
  if (panel.inset == Inset::kNone && !stereo_)
    for (const Panel& other : panels())
      if (other.inset != Inset::kNone) overlay.keep_clear(other.at);
  if (have_snapshot_) {
    if (panel.inset != Inset::kWound) paint_marks(overlay, panel);
    paint_forces(overlay, panel);
    if (panel.inset == Inset::kNone) paint_cues(overlay, panel), paint_led(overlay, panel), paint_ghost(overlay, panel);
  }
  // each eye sees clock, verdict and task at the depth of the screen
  if (stereo_) {
    if (!clock_text_.isEmpty()) overlay.clock(clock_text_);
    if (!banner_.isEmpty()) overlay.banner(banner_);
    if (!task_.isEmpty()) overlay.hint(task_);
    if (!message_.isEmpty()) overlay.message(message_);
    if (station_mark_) paint_station_mark(painter, panel);
  }
  painter.restore();
}

// Each eye's picture by itself, words and all, then reflected and laid on the other or beside it.
void SceneView::paint_eyes(QPainter& painter, const std::vector<Panel>& all) {
  const double ratio = devicePixelRatioF();
  std::vector<QImage> eye;
  for (size_t i = 0; i < all.size(); ++i) {
    QImage picture((all[i].at.size() * ratio).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    Panel own = all[i];
    own.at.moveTopLeft({});
    QPainter onto(&picture);
    onto.setFont(font());
    paint_panel(onto, own, i);
    onto.end();
    eye.push_back(picture.mirrored(stereo_->mirror == Mirror::kLeftRight, stereo_->mirror == Mirror::kUpDown));
    eye.back().setDevicePixelRatio(ratio);
  }
  if (overlaid(stereo_->layout) && eye.size() == 2) {
    // lines and chess boards are those of the screen, wherever the window lies
    const QPoint origin = (QPointF(mapToGlobal(QPoint())) * ratio).toPoint();
    QImage together = overlay_eyes(stereo_->layout, eye[0], eye[1], origin);
    together.setDevicePixelRatio(ratio);
    return painter.drawImage(QPointF(), together);
  }
  for (size_t i = 0; i < all.size(); ++i) painter.drawImage(all[i].at.topLeft(), eye[i]);
}

// a corner that shows the depth or a wound: what it is, and how large
void SceneView::paint_frame(QPainter& painter, const Panel& inset) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(ui_["border"], 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(inset.at);
  painter.setPen(ui_["view_text"]);
  if (inset.inset == Inset::kDepth) {
    const bool from_above = inset.view.eye.up.z() < 0.5F;
    painter.drawText(inset.at.adjusted(8, 5, -8, -5), Qt::AlignLeft | Qt::AlignTop,
                     from_above ? tr("From above") : tr("From the front"));
    return;
  }
  // how large it is is a cue; that it is there is plain to see
  Overlay overlay(painter, inset.at, ui_);
  overlay.caption(cues_shown_ ? tr("Wound %1 %").arg(100 * wound_.ratio, 0, 'f', 0) : tr("Wound"));
  overlay.scale_bar(inset.view.eye.mm_per_pixel(inset.at.height()));
}

// Of two tools the one that the mouse leads has a sign at its tips.
void SceneView::paint_led(Overlay& overlay, const Panel& panel) const {
  if (led_ == SWAGE_NONE || !instrument_) return;
  overlay.led(panel.view.eye.project(middle_of_tips(), panel.size), QString::fromStdString(card_.objects[led_].name));
}

// What the mouse does here now.
QString SceneView::hint() const {
  if (!instrument_)
    return turned_view_ && !banner_.isEmpty() ? tr("The instrument waits: a drag turns the view") : QString();
  if (!hasFocus()) return tr("Click here: then mouse and keys move the instrument");
  QStringList all;
  if (led_ != SWAGE_NONE) all += tr("Tab: the other instrument");
  if (hint_drag_) all += tr("Drag: move the instrument");
  if (hint_close_) all += tr("Space: close the jaws");
  if (hint_drive_) all += tr("T: drive the needle");
  return all.join(QStringLiteral("   ·   "));
}

void SceneView::paint_words(QPainter& painter) {
  Overlay overlay(painter, rect(), ui_);
  const std::vector<Panel> all = panels();
  double left = 0;  // what insets take of the lower left
  for (const Panel& panel : all)
    if (panel.inset != Inset::kNone && panel.at.left() < width() / 4.0 && panel.at.bottom() > height() / 2.0)
      left = panel.at.right();
  if (have_card_) overlay.scale_bar(all.front().view.eye.mm_per_pixel(height()), left);
  if (!clock_text_.isEmpty()) overlay.clock(clock_text_);
  if (!banner_.isEmpty()) overlay.banner(banner_);
  if (const QString words = hint(); !words.isEmpty()) overlay.hint(words);
  if (!hasFocus()) return;
  painter.setPen(QPen(ui_["accent"], 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SceneView::paintEvent(QPaintEvent*) {
  if (shows_ns_ >= 0) latency_.add_time(1e-9 * static_cast<double>(clock_.nsecsElapsed() - std::exchange(shows_ns_, -1)));
  QPainter painter(this);
  if (!renderer_) {
    paint_background(painter, rect());
    return paint_placeholder(painter);
  }
  const std::vector<Panel> all = panels();
  if (stereo_ && (overlaid(stereo_->layout) || stereo_->mirror != Mirror::kNone)) return paint_eyes(painter, all);
  for (size_t i = 0; i < all.size(); ++i) {
    paint_panel(painter, all[i], i);
    if (all[i].inset != Inset::kNone) paint_frame(painter, all[i]);
  }
  if (!stereo_) paint_words(painter);
}

}  // namespace swage::console
