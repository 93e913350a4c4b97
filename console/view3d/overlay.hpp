// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Paints over the 3D picture: scale bar, cue at the grasp, contact forces, clock and banner.
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

/// Separator of the parts of a hint.
inline constexpr char16_t kHintGap[] = u"   ·   ";

/// Smallest radius of a mark: its middle must stay visible.
inline constexpr double kLeastMark_px = 9;

class Overlay {
 public:
  Overlay(QPainter& painter, const QRectF& area, const UiTheme& ui) : p_(painter), area_(area), ui_(ui), font_(painter.font()) {}
  /// Of two eyes both must see a label at one place: none moves to another corner for what is behind it.
  void set_two_eyes(bool two) { two_eyes_ = two; }
  bool two_eyes() const { return two_eyes_; }
  /// Longest scale bar over the width of the picture.
  static constexpr double kScaleShare = 0.22;
  /// `left`: px that are covered at the left of the picture. `ground`: over what may be dark; a small close-up has no room for one.
  void scale_bar(double mm_per_pixel, double left = 0, bool ground = true);
  /// `slot` 0 above right of the place, 1 above left, 2 below right: cues at one grasp do not cover each other.
  /// `clear_px`: radius of a ring drawn instead of a dot, so that the place itself stays visible.
  void cue(const QPointF& at, const CueStyle& style, int slot, double clear_px = 0);
  /// A ring that fills clockwise during a hold, by `share`.
  void ring(const QPointF& at, double share, double radius_px = 17);
  /// The circle of a target; dashed where something is to come out.
  void target(const QPointF& at, double radius_px, const CueStyle& style);
  /// The sign and the text of a target, beside its circle with a short line to it, where they cover nothing that is kept clear.
  void target_word(const QPointF& at, double radius_px, const CueStyle& style);
  /// Marks the active tool, of several: a triangle below its tips, and its name.
  void led(const QPointF& at, const QString& name);
  /// The owner's name of a translucent instrument, with a thin line to it.
  void ghost(const QPointF& at, const QString& name);
  /// The line along which the jaws' faces lie, through their tips: whole where they stand across the wire, else dashed.
  void jaw_line(const QPointF& from, const QPointF& to, bool across);
  /// A sign and words about the jaws, beside their tips with a short line to them.
  void jaw_word(const QPointF& at, double radius_px, QChar sign, const QString& text);
  void force(const QPointF& from, const QPointF& to);
  /// Keeps later labels off this area.
  void keep_clear(const QRectF& place) { taken_.push_back(place); }
  void clock(const QString& text);
  /// Keeps later labels off a clock in one line, which is painted after them.
  void keep_clock_clear(const QString& text);
  /// A fact of the scene in the upper left corner; nothing for "".
  void corner(const QString& text);
  /// The title of an inset, at its top left.
  void caption(const QString& text);
  void banner(const QString& text);
  /// Parts joined by kHintGap, in as many lines as needed between `left` and `right`, px of the picture; the last line is the lowest.
  void hint(const QString& text, double left, double right);
  /// The height of a hint at the lower edge, px: labels of the picture are placed above it.
  static double hint_height(const QString& text, const QFont& font, double left, double right);
  /// An instructor's message: in the upper left corner, in as many lines as needed, clear of the middle of the picture.
  void message(const QString& text);

 private:
  QFont clock_font() const;
  QSizeF size_of(const QString& text, const QFont& font, double extra_left) const;
  QRectF cue_place(const QPointF& at, int slot, const QString& text, double extra_left);
  QRectF beside(const QPointF& at, double radius_px, const QString& text, double extra_left);
  QRectF room(const QPointF& centre, const QString& text, const QFont& font, double extra_left);
  void paint_label(const QRectF& at, double round_px);
  void several(const QStringList& lines, const QFont& font, double most_px);
  void pill(const QRectF& at, const QString& text, const QFont& font, double extra_left);
  void pill(const QPointF& centre, const QString& text, const QFont& font);
  QPainter& p_;
  QRectF area_;
  const UiTheme& ui_;
  QFont font_;                 // of transient texts
  bool two_eyes_ = false;
  std::vector<QRectF> taken_;  // areas of labels
};

}  // namespace swage::console
