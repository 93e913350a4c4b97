// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is painted over the 3D picture: scale bar, cue at the grasp, contact forces, clock and banner.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <vector>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"

namespace swage::console {

/// The longest bar of 1, 2 or 5 times a power of ten that is no longer than `most_px`. Length in mm.
double nice_scale_mm(double mm_per_pixel, double most_px);
QString length_text(double mm);

/// Between the parts of a hint.
inline constexpr char16_t kHintGap[] = u"   ·   ";

/// A mark is at least so large: what happens in its middle is to be seen.
inline constexpr double kLeastMark_px = 9;

class Overlay {
 public:
  Overlay(QPainter& painter, const QRectF& area, const UiTheme& ui) : p_(painter), area_(area), ui_(ui), font_(painter.font()) {}
  /// `left`: what is taken at the left of the picture, px.
  void scale_bar(double mm_per_pixel, double left = 0);
  /// `slot` 0 above right of the place, 1 above left, 2 below right: cues at one grasp do not cover each other.
  /// `clear_px`: a ring of this radius instead of a dot, so that what is there stays to be seen.
  void cue(const QPointF& at, const CueStyle& style, int slot, double clear_px = 0);
  /// A ring that fills clockwise while something is held.
  void ring(const QPointF& at, double share, double radius_px = 17);
  /// A place to go to: its circle.
  void target(const QPointF& at, double radius_px, const CueStyle& style);
  /// Its sign and its word, below the circle.
  void target_word(const QPointF& at, double radius_px, const CueStyle& style);
  /// The tool that is led, of several: a triangle below its tips, and its name.
  void led(const QPointF& at, const QString& name);
  /// Whose instrument is seen through here: a thin line to a name.
  void ghost(const QPointF& at, const QString& name);
  void force(const QPointF& from, const QPointF& to);
  /// No label of those to come lies there.
  void keep_clear(const QRectF& place) { taken_.push_back(place); }
  void clock(const QString& text);
  /// What an inset shows, at its top left.
  void caption(const QString& text);
  void banner(const QString& text);
  /// Parts joined by kHintGap, in as many lines as they need between `left` and `right`, px of the picture; the last one lies lowest.
  void hint(const QString& text, double left, double right);
  /// The height that it takes at the lower edge, px: labels of the picture stand above it.
  static double hint_height(const QString& text, const QFont& font, double left, double right);
  /// What an instructor says: in the upper left corner, in as many lines as it takes, clear of what is worked on in the middle.
  void message(const QString& text);

 private:
  QRectF room(const QPointF& centre, const QString& text, const QFont& font, double extra_left);
  void pill(const QRectF& at, const QString& text, const QFont& font, double extra_left);
  void pill(const QPointF& centre, const QString& text, const QFont& font);
  QPainter& p_;
  QRectF area_;
  const UiTheme& ui_;
  QFont font_;                 // of what is said in passing
  std::vector<QRectF> taken_;  // by labels
};

}  // namespace swage::console
