// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/panels.hpp"

#include <QVector4D>
#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

constexpr double kSecond = 0.36;       // height of the second view over that of the first
constexpr double kWidest = 0.42;       // largest width of an inset over that of the first view, which stays visible in a narrow picture
constexpr double kSmall = 0.7;         // size of the second view over its full one, where that covers the work in every corner
constexpr double kSecondShape = 1.25;  // width over height
constexpr int kTipsBeforeEnds = 3;     // weight of a place at the tips against the ends of an object that can be grasped
constexpr double kMargin_px = 10;
constexpr double kLoupeShape = 1;
constexpr float kLeastLoupe_mm = 0.3F;  // smallest radius of the loupe's view, for a clean puncture: the wire fills a third of it
constexpr float kLoupeRoom = 1.5F;      // radius of the view over that of the wound
constexpr float kLoupeStep = 1.5F;
constexpr int kGap_px = 2;          // between panels in the picture, as the renderer rounds to whole pixels
constexpr double kClear_px = 24;    // between an inset and places that it must not cover
constexpr float kAround_mm = 0.9F;  // margin around the tips and their target
constexpr float kFurthest_mm = 6;   // from the tips: a target further away is left out of the second view
constexpr double kGlide_s = 0.15;   // time constant of the second view's motion
constexpr float kStays = 0.75F;     // of the second view's radius: tips within it need no new picture
constexpr float kStill = 0.01F;     // of its size: a smaller motion is ignored

QRectF with_room(const QRectF& at, double room_px = kClear_px) { return at.adjusted(-room_px, -room_px, room_px, room_px); }

}  // namespace

void PanelLayout::clear() {
  second_ = {};
  loupe_mm_ = 0;
  wound_ = {};
}

PanelLayout::Change PanelLayout::show_second(bool shown) {
  if (second_shown_ == shown) return Change::kNone;
  second_shown_ = shown;
  second_ = {};
  corner_ = {};
  return Change::kLaidOut;
}

PanelLayout::Change PanelLayout::show_loupe(bool shown) {
  if (loupe_shown_ == shown) return Change::kNone;
  loupe_shown_ = shown;
  return fit_loupe();
}

PanelLayout::Change PanelLayout::set_wound(const WoundPlace& wound) {
  wound_ = wound;
  return fit_loupe();
}

// The magnification of the loupe changes in steps with the size of the wound, as a picture that changes all the time is hard to read.
PanelLayout::Change PanelLayout::fit_loupe() {
  float wanted = 0;
  if (loupe_shown_ && !point_.stereo() && wound_.there())
    for (wanted = kLeastLoupe_mm; wanted < kLoupeRoom * wound_.radius; wanted *= kLoupeStep) {
    }
  if (wanted == loupe_mm_ || (held() && wanted > 0 && loupe_mm_ > 0)) return Change::kNone;
  loupe_mm_ = wanted;
  return Change::kLaidOut;
}

Panel PanelLayout::loupe() const {
  const QRectF at = corner_at(loupe_corner_, kLoupeShape);
  const Eye eye = wound_eye(point_.camera, wound_.middle, wound_.normal, loupe_mm_, shape_of(at.size()));
  return {at, at.size(), {eye, {}}, Inset::kWound};
}

std::vector<Panel> PanelLayout::panels() const {
  const QSizeF all(size_);
  std::vector<Panel> out;
  if (const std::optional<StereoLook>& look = point_.stereo()) {
    const auto two = places(look->layout, all);
    for (size_t i = 0; i < two.size(); ++i) {
      if (two[i].isEmpty()) continue;
      const QSizeF own = look->squeezed ? all : two[i].size();
      out.push_back({two[i], own, {point_.eyes(own)[i], {}}});
    }
  } else {
    out.push_back({QRectF(QPointF(), all), all, {middle_eye(point_.camera, shape_of(all)), {}}});
    if (second_there()) {
      const QRectF at = second_at();
      const Eye eye = cross_eye(point_.camera, second_.centre(), second_.radius(), shape_of(at.size()));
      out.push_back({at, at.size(), {eye, {}}, Inset::kDepth});
    }
    if (loupe_mm_ > 0) out.push_back(loupe());
  }
  int x = 0;
  for (Panel& panel : out) {
    const QSize pixels = (panel.at.size() * ratio_).toSize();
    panel.view.part = QRect(QPoint(x, 0), pixels);
    x += pixels.width() + kGap_px;
  }
  return out;
}

// the corners in order of preference: bottom left, bottom right, top left; clock and cues are at the top right
QRectF PanelLayout::corner_at(int corner, double shape, double share) const {
  const double h = share * std::min(kSecond * size_.height(), kWidest * size_.width() / kSecondShape), w = shape * h;
  const double x = corner == 1 ? size_.width() - w - kMargin_px : kMargin_px;
  return {x, corner == 2 ? kMargin_px : size_.height() - h - kMargin_px, w, h};
}

QRectF PanelLayout::second_at() const { return corner_at(corner_.corner, kSecondShape, corner_.small ? kSmall : 1); }

// never over the tips, their target, a mark of the lesson, an end or the middle of the object; other graspable objects are avoided where
// possible. In a small window, where the full size covers one of them in every corner, the inset is smaller.
PanelLayout::Change PanelLayout::choose_corner(const QVector3D& tips, const QVector3D& aim) {
  const Eye eye = middle_eye(point_.camera, shape_of(size_));
  std::array<QRectF, 3> full, small, wide;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<size_t>(i);
    full[k] = with_room(corner_at(i, kSecondShape));
    small[k] = with_room(corner_at(i, kSecondShape, kSmall));
    wide[k] = with_room(full[k]);
  }
  std::vector<QPointF> rather;
  for (const Spot& s : scene_.parts().aim) rather.push_back(eye.project(scene_.place_of(s), size_));
  std::vector<QPointF> must;
  for (int i = 0; i < kTipsBeforeEnds; ++i) {
    must.insert(must.end(), {eye.project(tips, size_), eye.project(aim, size_)});
    for (const QVector3D& mark : scene_.points()) must.push_back(eye.project(mark, size_));
  }
  const SceneParts& parts = scene_.parts();
  for (const Spot& end : parts.ends) must.push_back(eye.project(scene_.place_of(end), size_));
  if (parts.watched >= 0) must.push_back(eye.project(scene_.place_of({static_cast<uint32_t>(parts.watched), parts.watched_on}), size_));
  const CornerPlace best = least_covered(full, small, wide, corner_, second_.empty(), must, rather);
  if (best == corner_) return Change::kNone;
  const bool resized = best.small != corner_.small;
  corner_ = best;
  return resized ? Change::kLaidOut : Change::kMoved;
}

// the loupe avoids the tips, the wound and the second view
PanelLayout::Change PanelLayout::choose_loupe_corner() {
  if (loupe_mm_ <= 0 || held()) return Change::kNone;
  const Eye eye = middle_eye(point_.camera, shape_of(size_));
  const auto free = [&](int corner) {
    if (second_there() && corner == corner_.corner) return false;
    const QRectF at = with_room(corner_at(corner, kLoupeShape));
    return !at.contains(eye.project(scene_.middle_of_tips(), size_)) && !at.contains(eye.project(wound_.middle, size_));
  };
  if (free(loupe_corner_)) return Change::kNone;
  for (const int corner : {1, 0, 2}) {
    if (!free(corner)) continue;
    loupe_corner_ = corner;
    return Change::kMoved;
  }
  return Change::kNone;
}

PanelLayout::Change PanelLayout::advance(double dt_s) {
  const Change loupe = choose_loupe_corner();
  return std::max(loupe, follow_tips(dt_s));
}

// Shows the tips and their target, magnified more the nearer they are to each other.
PanelLayout::Change PanelLayout::follow_tips(double dt_s) {
  if (point_.stereo() || !second_shown_ || held() || scene_.parts().tips.empty()) return Change::kNone;
  const QVector3D tips = scene_.middle_of_tips();
  if (keys_down_ && !second_.empty() && (tips - second_.centre()).length() < kStays * second_.radius()) return Change::kNone;
  QVector3D aim = scene_.aim_near(tips, kAround_mm);
  if (const QVector3D way = aim - tips; way.length() > kFurthest_mm) aim = tips + way * (kFurthest_mm / way.length());
  const Change corner = choose_corner(tips, aim);
  const QVector3D centre = 0.5F * (tips + aim);
  float spread = 0.5F * (aim - tips).length();
  for (const Spot& s : scene_.parts().tips) spread = std::max(spread, (scene_.place_of(s) - centre).length());
  const float radius = spread + kAround_mm;
  const bool fresh = second_.empty();
  const QVector3D half = QVector3D(1, 1, 1) * (radius / std::sqrt(3.0F));
  const auto k = fresh ? 1.0F : static_cast<float>(1 - std::exp(-dt_s / kGlide_s));
  if (!fresh && (centre - second_.centre()).length() + std::abs(radius - second_.radius()) < kStill * radius) return corner;
  second_.low = fresh ? centre - half : second_.low + k * (centre - half - second_.low);
  second_.high = fresh ? centre + half : second_.high + k * (centre + half - second_.high);
  return std::max(corner, fresh ? Change::kLaidOut : Change::kMoved);
}

QSize PanelLayout::canvas() const {
  QSize out(1, 1);
  for (const Panel& panel : panels()) out = {panel.view.part.right() + 1, std::max(out.height(), panel.view.part.height())};
  return out;
}

double PanelLayout::mm_per_pixel() const {
  const Panel first = panels().front();
  return first.view.eye.mm_per_pixel(first.size.height());
}

bool PanelLayout::shows_tips(const Panel& panel) const {
  if (scene_.parts().tips.empty()) return false;
  const QVector4D p = panel.view.eye.projection * panel.view.eye.view() * QVector4D(scene_.middle_of_tips(), 1);
  return std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) <= p.w();
}

Panel PanelLayout::moved_in(const QPointF& position) const {
  const Panel panel = at(position);
  return held() || panel.inset == Inset::kNone || shows_tips(panel) ? panel : panels().front();
}

Panel PanelLayout::at(const QPointF& position) const {
  const std::vector<Panel> all = panels();
  for (const Panel& panel : all) {
    if (panel.inset == Inset::kNone) continue;
    if (dragged_in_ ? panel.inset == *dragged_in_ : panel.at.contains(position)) return panel;
  }
  return all.front();
}

}  // namespace swage::console
