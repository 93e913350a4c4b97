// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_painter.hpp"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <algorithm>
#include <utility>

#include "console/view3d/medium_look.hpp"

namespace swage::console {

void ScenePainter::paint(QPainter& painter, const Canvas& canvas, const std::vector<Panel>& panels, const Picture& picture, const ViewWords& words,
                         bool leads) {
  const Job job{canvas, panels, picture, words, leads};
  const std::optional<StereoLook>& look = point_.stereo();
  if (look && (overlaid(look->layout) || look->mirror != Mirror::kNone)) return paint_eyes(painter, job);
  for (size_t i = 0; i < panels.size(); ++i) {
    if (panels[i].inset != Inset::kNone && !drawn(job, i)) continue;  // its first picture is not there yet
    paint_panel(painter, job, panels[i], i);
    if (panels[i].inset != Inset::kNone) paint_frame(painter, panels[i]);
  }
  if (!look) paint_words(painter, job);
}

void ScenePainter::paint_placeholder(QPainter& painter, const Canvas& canvas, const QString& why) {
  const QRect all(QPoint(), canvas.size);
  paint_background(painter, canvas, all);
  painter.setPen(shown_.ui["view_text"]);
  painter.drawText(all.adjusted(40, 0, -40, 0), Qt::AlignCenter | Qt::TextWordWrap,
                   tr("The 3D view needs OpenGL 3.3 (%1).\nEverything else works: lessons run and are recorded.").arg(why));
}

void ScenePainter::paint_background(QPainter& painter, const Canvas& canvas, const QRectF& at) {
  const QSize pixels = (QSizeF(canvas.size) * canvas.ratio).toSize();
  if (background_.size() != pixels) {
    background_ = QPixmap(pixels);
    QPainter p(&background_);
    QLinearGradient gradient(0, 0, 0, pixels.height());
    const MediumLook look = medium_look(scene_.have_card() ? scene_.card().medium : 0, 1);
    gradient.setColorAt(0, veiled(shown_.ui["view_top"], look));
    gradient.setColorAt(1, veiled(shown_.ui["view_bottom"], look));
    p.fillRect(background_.rect(), gradient);
  }
  painter.drawPixmap(at, background_, background_.rect());
}

// the panel's rectangle in the last picture, which may have other panels
const Panel* ScenePainter::drawn(const Job& job, size_t index) const {
  const std::vector<Panel>& last = job.picture.panels;
  if (point_.stereo()) return index < last.size() ? &last[index] : nullptr;
  const auto same = std::find_if(last.begin(), last.end(), [&](const Panel& p) { return p.inset == job.panels[index].inset; });
  return same == last.end() ? nullptr : &*same;
}

// Paints the scene for one eye, and the marks at positions in it.
void ScenePainter::paint_panel(QPainter& painter, const Job& job, const Panel& panel, size_t index) {
  painter.save();
  painter.setClipRect(panel.at);
  paint_background(painter, job.canvas, panel.at);
  Panel seen = panel;  // with the eye of the picture, so that marks stay on what they mark while the view moves
  if (const Panel* last = drawn(job, index)) {
    // until the next picture comes, one of another size is stretched
    const QRect& part = last->view.part;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, part.size() != panel.view.part.size());
    painter.drawImage(panel.at, job.picture.image, part);
    if (part.size() == panel.view.part.size()) seen.view.eye = last->view.eye;
  }
  painter.translate(panel.at.topLeft());
  painter.scale(panel.at.width() / panel.size.width(), panel.at.height() / panel.size.height());
  if (point_.microscope()) paint_field(painter, panel.size);
  const bool whole = panel.inset == Inset::kNone && !point_.stereo();
  // labels are placed above the hint, which is painted over the picture
  const auto [hint_left, hint_right] = beside_scale(job);
  const double below = whole ? Overlay::hint_height(job.words.hint, painter.font(), hint_left, hint_right) : 0;
  Overlay overlay(painter, QRectF(QPointF(), panel.size - QSizeF(0, below)), shown_.ui);
  overlay.set_two_eyes(point_.stereo().has_value());
  if (whole) {
    for (const Panel& other : job.panels)
      if (other.inset != Inset::kNone) overlay.keep_clear(other.at);
    overlay.keep_clear(scale_place(job));
    overlay.keep_clock_clear(job.words.clock);
    if (scene_.have_card()) overlay.corner(corner_words());
  }
  // marks of a scene that is not drawn yet would lie in the void
  if (drawn(job, index)) marks_.paint(overlay, seen, job.leads);
  if (point_.stereo()) paint_eye_words(painter, overlay, job, panel);
  painter.restore();
}

// the medium, and a side that was changed without being asked for
QString ScenePainter::corner_words() const {
  QStringList all = {medium_words(scene_.card().medium, scene_.card().viscosity)};
  if (point_.behind()) all += tr("Seen from behind: left and right are exchanged");
  all.removeAll(QString());
  return all.join(QString::fromUtf16(kHintGap));
}

// clock, verdict and task appear to each eye at the depth of the screen
void ScenePainter::paint_eye_words(QPainter& painter, Overlay& overlay, const Job& job, const Panel& panel) const {
  const ViewWords& words = job.words;
  if (!words.clock.isEmpty()) overlay.clock(words.clock);
  if (!words.banner.isEmpty()) overlay.banner(words.banner);
  if (!words.task.isEmpty()) overlay.hint(words.task, 0, panel.size.width());
  if (!words.message.isEmpty())
    overlay.message(words.message);
  else if (scene_.have_card())
    overlay.corner(corner_words());
  if (station_mark_) paint_station_mark(painter, panel);
}

// The mark lies in the plane of the screen: both eyes see it at the same place.
void ScenePainter::paint_station_mark(QPainter& painter, const Panel& panel) const {
  constexpr double kArm_mm = 8;
  const QSizeF mm = point_.screen_mm_per_pixel();
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

std::vector<QImage> ScenePainter::eyes(const Canvas& canvas, const std::vector<Panel>& panels, const Picture& picture, const ViewWords& words,
                                       bool leads) {
  return eyes(Job{canvas, panels, picture, words, leads});
}

// The picture of each eye with its texts, reflected for a mirror.
std::vector<QImage> ScenePainter::eyes(const Job& job) {
  const double ratio = job.canvas.ratio;
  const StereoLook& look = *point_.stereo();
  std::vector<QImage> eye;
  for (size_t i = 0; i < job.panels.size(); ++i) {
    QImage picture((job.panels[i].at.size() * ratio).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    Panel own = job.panels[i];
    own.at.moveTopLeft({});
    QPainter onto(&picture);
    onto.setFont(job.canvas.font);
    paint_panel(onto, job, own, i);
    onto.end();
    eye.push_back(picture.mirrored(look.mirror == Mirror::kLeftRight, look.mirror == Mirror::kUpDown));
    eye.back().setDevicePixelRatio(ratio);
  }
  return eye;
}

// The two pictures overlaid or side by side.
void ScenePainter::paint_eyes(QPainter& painter, const Job& job) {
  const std::vector<QImage> eye = eyes(job);
  const StereoLook& look = *point_.stereo();
  if (overlaid(look.layout) && eye.size() == 2) {
    // interleaved lines and pixels are counted on the screen, wherever the window lies
    QImage together = overlay_eyes(look.layout, eye[0], eye[1], job.canvas.origin);
    together.setDevicePixelRatio(job.canvas.ratio);
    return painter.drawImage(QPointF(), together);
  }
  for (size_t i = 0; i < job.panels.size(); ++i) painter.drawImage(job.panels[i].at.topLeft(), eye[i]);
}

// The largest of several wounds. The corner is narrow, so the text is short.
QString ScenePainter::wound_words() const {
  const WoundPlace& wound = marks_.wound();
  const QString size = QString::number(100 * wound.ratio, 'f', 0);
  if (wound.kind == WoundKind::kEntry) return tr("Entry %1 %").arg(size);
  if (wound.kind == WoundKind::kExit) return tr("Exit %1 %").arg(size);
  return wound.of > 1 ? tr("Largest %1 %").arg(size) : tr("Wound %1 %").arg(size);
}

// the frame of an inset, its title and its scale
void ScenePainter::paint_frame(QPainter& painter, const Panel& inset) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(shown_.ui["border"], 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(inset.at);
  painter.setPen(shown_.ui["view_text"]);
  if (inset.inset == Inset::kDepth) {
    const bool from_above = inset.view.eye.up.z() < 0.5F;
    painter.drawText(inset.at.adjusted(8, 5, -8, -5), Qt::AlignLeft | Qt::AlignTop, from_above ? tr("From above") : tr("From the front"));
    return;
  }
  // the size of a wound is a cue, hidden in a Test; the wound itself is always visible
  Overlay overlay(painter, inset.at, shown_.ui);
  constexpr double kAround_px = 32;
  const bool narrow = QFontMetricsF(painter.font()).horizontalAdvance(wound_words()) + kAround_px > inset.at.width();
  const QString size = QStringLiteral("%1 %").arg(100 * marks_.wound().ratio, 0, 'f', 0);
  overlay.caption(!shown_.cues_shown ? tr("Wound") : narrow ? size : wound_words());
  overlay.scale_bar(inset.view.eye.mm_per_pixel(inset.at.height()), 0, false);
}

// left and right end of the lower edge that the insets leave free, px
std::pair<double, double> ScenePainter::lower_edge(const Job& job) {
  const QSizeF all = job.canvas.size;
  double left = 0, right = all.width();
  for (const Panel& panel : job.panels) {
    if (panel.inset == Inset::kNone || panel.at.bottom() < all.height() / 2.0) continue;
    panel.at.center().x() < all.width() / 2.0 ? left = std::max(left, panel.at.right()) : right = std::min(right, panel.at.left());
  }
  return {left, right};
}

// where the scale bar is drawn, px
QRectF ScenePainter::scale_place(const Job& job) {
  constexpr double kHigh_px = 46, kAround_px = 30;
  const QSizeF all = job.canvas.size;
  return {lower_edge(job).first, all.height() - kHigh_px, Overlay::kScaleShare * all.width() + kAround_px, kHigh_px};
}

// What of the lower edge is left for a hint: beside the scale bar, where there is room for some words.
std::pair<double, double> ScenePainter::beside_scale(const Job& job) {
  constexpr double kLeast_px = 240;
  const auto [left, right] = lower_edge(job);
  const double beside = scale_place(job).right();
  return {right - beside < kLeast_px ? left : beside, right};
}

void ScenePainter::paint_words(QPainter& painter, const Job& job) const {
  const QRect all(QPoint(), job.canvas.size);
  Overlay overlay(painter, all, shown_.ui);
  const double left = lower_edge(job).first;
  const auto [hint_left, hint_right] = beside_scale(job);
  if (scene_.have_card()) overlay.scale_bar(job.panels.front().view.eye.mm_per_pixel(all.height()), left);
  if (!job.words.clock.isEmpty()) overlay.clock(job.words.clock);
  if (!job.words.hint.isEmpty()) overlay.hint(job.words.hint, hint_left, hint_right);
  if (!job.words.banner.isEmpty()) overlay.banner(job.words.banner);
  if (!job.canvas.focus) return;
  painter.setPen(QPen(shown_.ui["accent"], 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(all.adjusted(1, 1, -1, -1));
}

}  // namespace swage::console
