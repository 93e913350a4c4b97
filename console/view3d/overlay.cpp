// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/overlay.hpp"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace swage::console {

namespace {
constexpr double kBelowClock_px = 62;  // cues are drawn below the clock
constexpr double kApart_px = 3;        // gap between two labels
constexpr double kAboutText_px = 8;    // difference between the heights of a label and its text
constexpr double kHintUp_px = 24;      // from the lower edge to the middle of the lowest line of a hint
constexpr double kHintAround_px = 32;  // margin beside a line of a hint

// the words of a sentence in lines of at most this width
QStringList broken(const QString& sentence, const QFontMetricsF& metrics, double width) {
  if (metrics.horizontalAdvance(sentence) <= width) return {sentence};
  QStringList lines;
  for (const QString& word : sentence.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const QString longer = lines.isEmpty() ? word : lines.last() + QLatin1Char(' ') + word;
    if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      lines.last() = longer;
    else
      lines += word;
  }
  return lines;
}

QStringList hint_lines(const QString& text, const QFontMetricsF& metrics, double width) {
  const QString gap = QString::fromUtf16(kHintGap);
  QStringList parts, lines;
  for (const QString& part : text.split(gap)) parts += broken(part, metrics, width - kHintAround_px);
  for (const QString& part : parts) {
    const QString longer = lines.isEmpty() ? QString() : lines.last() + gap + part;
    if (!longer.isEmpty() && metrics.horizontalAdvance(longer) + kHintAround_px <= width)
      lines.last() = longer;
    else
      lines += part;
  }
  return lines;
}
}  // namespace

double nice_scale_mm(double mm_per_pixel, double most_px) {
  const double most = std::max(mm_per_pixel * most_px, 1e-9);
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= most) return step * power;
  }
  return power;
}

QString length_text(double mm) {
  return mm < 0.1 ? QStringLiteral("%L1 µm").arg(mm * 1000, 0, 'g', 3)
                  : QStringLiteral("%L1 mm").arg(mm, 0, 'g', 3);
}

QSizeF Overlay::size_of(const QString& text, const QFont& font, double extra_left) const {
  const QFontMetricsF metrics(font);
  return {metrics.horizontalAdvance(text) + extra_left + 20, metrics.height() + kAboutText_px};
}

// The first free place about a circle: right, left, then the corners, then further away; where none is free, below it.
QRectF Overlay::beside(const QPointF& at, double radius_px, const QString& text, double extra_left) {
  constexpr double kNear_px = 14, kFar_px = 46;
  const QSizeF size = size_of(text, p_.font(), extra_left);
  const QRectF inside = area_.adjusted(6, 6, -6, -6);
  for (const double gap : {kNear_px, kFar_px})
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, 1}, {0, -1}}) {
      QRectF r(QPointF(), size);
      r.moveCenter(at + QPointF(x * (radius_px + gap + 0.5 * size.width()), y * (radius_px + gap + 0.5 * size.height())));
      const bool free = std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return r.intersects(other); });
      if (!free || !inside.contains(r)) continue;
      taken_.push_back(r);
      return r;
    }
  return room(at + QPointF(0, radius_px + 26), text, p_.font(), extra_left);
}

// a label's place: inside the picture and clear of the labels already drawn
QRectF Overlay::room(const QPointF& centre, const QString& text, const QFont& font, double extra_left) {
  const QSizeF size = size_of(text, font, extra_left);
  const double h = size.height(), w = size.width();
  QRectF r(centre.x() - 0.5 * w, centre.y() - 0.5 * h, w, h);
  r.moveLeft(std::clamp(r.left(), area_.left() + 6, std::max(area_.left() + 6, area_.right() - 6 - w)));
  r.moveTop(std::clamp(r.top(), area_.top() + 6, std::max(area_.top() + 6, area_.bottom() - 6 - h)));
  for (const QRectF& other : taken_) {
    if (!r.intersects(other)) continue;
    const bool down =
        r.center().y() >= other.center().y() && other.bottom() + kApart_px + h < area_.bottom() - 6;
    r.moveTop(down ? other.bottom() + kApart_px : other.top() - kApart_px - h);
  }
  taken_.push_back(r);
  return r;
}

void Overlay::paint_label(const QRectF& at, double round_px) {
  QColor back = ui_["card"];
  back.setAlpha(225);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setPen(QPen(ui_["border"], 1));
  p_.setBrush(back);
  p_.drawRoundedRect(at, round_px, round_px);
}

// draws a rounded label, with room before its text for signs
void Overlay::pill(const QRectF& r, const QString& text, const QFont& font, double extra_left) {
  paint_label(r, 0.5 * r.height());
  p_.setFont(font);
  p_.setPen(ui_["text"]);
  p_.drawText(r.adjusted(10 + extra_left, 0, -10, 0), Qt::AlignVCenter | Qt::AlignLeft, text);
}

void Overlay::pill(const QPointF& centre, const QString& text, const QFont& font) {
  pill(room(centre, text, font, 0), text, font, 0);
}

void Overlay::scale_bar(double mm_per_pixel, double left, bool ground) {
  const double mm = nice_scale_mm(mm_per_pixel, kScaleShare * area_.width()), px = mm / mm_per_pixel;
  const double x = area_.left() + left + 18, y = area_.bottom() - 18;
  const QRectF words(x, y - 26, std::max(px, 60.0), 18);
  const QRectF all = words.united(QRectF(x, y - 5, px, 6));
  // an instrument or a dark wall may be behind it
  constexpr double kAround_px = 6;
  QColor back = ui_["card"];
  back.setAlpha(150);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setPen(Qt::NoPen);
  p_.setBrush(back);
  if (ground) p_.drawRoundedRect(all.adjusted(-kAround_px, -2, kAround_px, kAround_px), kAround_px, kAround_px);
  for (const auto& [colour, width] : {std::pair{ui_["view_bottom"], 4.5}, {ui_["view_text"], 2.0}}) {
    p_.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    p_.drawLine(QPointF(x, y), QPointF(x + px, y));
    p_.drawLine(QPointF(x, y - 5), QPointF(x, y + 1));
    p_.drawLine(QPointF(x + px, y - 5), QPointF(x + px, y + 1));
  }
  p_.drawText(words, Qt::AlignCenter, length_text(mm));
  keep_clear(all);
}

// The first free place of a cue's label about its grasp: its own corner, the same corner further out, the other corners; where none is
// free, above or below what is in its own.
QRectF Overlay::cue_place(const QPointF& at, int slot, const QString& text, double signs) {
  constexpr double kAside_px = 120, kUp_px = -84, kDown_px = 64, kOut = 1.6;
  const double x = slot == 1 ? -kAside_px : kAside_px, y = slot == 2 ? kDown_px : kUp_px, other_y = slot == 2 ? kUp_px : kDown_px;
  const QSizeF size = size_of(text, p_.font(), signs);
  const QRectF inside = area_.adjusted(6, 6, -6, -6);
  const auto below_clock = [&](QPointF centre) {
    centre.setY(std::max(centre.y(), area_.top() + kBelowClock_px));
    return centre;
  };
  if (two_eyes_) return room(below_clock(at + QPointF(x, y)), text, p_.font(), signs);
  for (const QPointF& way : {QPointF(x, y), QPointF(kOut * x, kOut * y), QPointF(-x, y), QPointF(x, other_y), QPointF(-x, other_y)}) {
    QRectF r(QPointF(), size);
    r.moveCenter(below_clock(at + way));
    const bool free = std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return r.intersects(other); });
    if (!free || !inside.contains(r)) continue;
    taken_.push_back(r);
    return r;
  }
  return room(below_clock(at + QPointF(x, y)), text, p_.font(), signs);
}

void Overlay::cue(const QPointF& at, const CueStyle& style, int slot, double clear_px) {
  // a line from the grasp to its label, which is clear of the tips
  const QFont font = p_.font();
  const double sign = 22, signs = sign * static_cast<double>(style.shape.size()) + 6;
  const QRectF r = cue_place(at, slot, style.text, signs);
  const QPointF label = r.center();
  p_.setRenderHint(QPainter::Antialiasing);
  const QPointF way = label - at;
  const QPointF from = at + way * (clear_px / std::max(std::hypot(way.x(), way.y()), 1.0));
  p_.setBrush(Qt::NoBrush);
  for (const auto& [colour, width] :
       {std::pair{QColor(0, 0, 0, 110), 3.0}, {QColor(255, 255, 255, 220), 1.4}}) {
    p_.setPen(QPen(colour, width));
    p_.drawLine(from, label);
    if (clear_px > 0) p_.drawEllipse(at, clear_px, clear_px);
  }
  p_.setBrush(style.colour);
  if (clear_px <= 0) p_.drawEllipse(at, 3.5, 3.5);
  pill(r, style.text, font, signs);
  paint_cue_shape(p_, {r.left() + 8, r.center().y() - 0.5 * sign}, sign, style);
}

void Overlay::ring(const QPointF& at, double share, double radius_px) {
  const QRectF r(at.x() - radius_px, at.y() - radius_px, 2 * radius_px, 2 * radius_px);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setBrush(Qt::NoBrush);
  p_.setPen(QPen(QColor(0, 0, 0, 90), 6));
  p_.drawEllipse(r);
  p_.setPen(QPen(QColor(255, 255, 255, 245), 4, Qt::SolidLine, Qt::FlatCap));
  p_.drawArc(r, 90 * 16, -static_cast<int>(360 * 16 * std::clamp(share, 0.0, 1.0)));
}

void Overlay::target(const QPointF& at, double radius_px, const CueStyle& style) {
  const double r = std::max(radius_px, kLeastMark_px);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setBrush(Qt::NoBrush);
  for (const auto& [colour, width] :
       {std::pair{QColor(0, 0, 0, 120), 5.0}, {QColor(255, 255, 255, 220), 3.6}, {style.colour, 2.2}}) {
    // the outlines of a dashed circle are whole, so that it is seen on any ground
    p_.setPen(QPen(colour, width, style.shape.startsWith(QLatin1Char('^')) && colour == style.colour ? Qt::DashLine : Qt::SolidLine));
    p_.drawEllipse(at, r, r);
  }
}

void Overlay::target_word(const QPointF& at, double radius_px, const CueStyle& style) {
  const double r = std::max(radius_px, kLeastMark_px), sign = 18;
  const QRectF label = beside(at, r, style.text, sign + 4);
  const QPointF end(std::clamp(at.x(), label.left(), label.right()), std::clamp(at.y(), label.top(), label.bottom()));
  const QPointF way = end - at;
  p_.setRenderHint(QPainter::Antialiasing);
  for (const auto& [colour, width] : {std::pair{QColor(0, 0, 0, 110), 3.0}, {QColor(255, 255, 255, 220), 1.4}}) {
    p_.setPen(QPen(colour, width));
    p_.drawLine(at + way * (r / std::max(std::hypot(way.x(), way.y()), r)), end);
  }
  pill(label, style.text, p_.font(), sign + 4);
  CueStyle one = style;
  one.shape = style.shape.left(1);
  paint_cue_shape(p_, {label.left() + 8, label.center().y() - 0.5 * sign}, sign, one);
}

void Overlay::jaw_line(const QPointF& from, const QPointF& to, bool across) {
  p_.setRenderHint(QPainter::Antialiasing);
  for (const auto& [colour, width] : {std::pair{QColor(0, 0, 0, 160), 4.5}, {QColor(255, 255, 255, 245), 2.2}}) {
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap);
    if (!across) pen.setDashPattern({7 / width, 5 / width});
    p_.setPen(pen);
    p_.drawLine(from, to);
  }
}

void Overlay::jaw_word(const QPointF& at, double radius_px, QChar sign, const QString& text) {
  const QString all = sign + QLatin1Char(' ') + text;
  const QRectF label = beside(at, radius_px, all, 0);
  const QPointF end(std::clamp(at.x(), label.left(), label.right()), std::clamp(at.y(), label.top(), label.bottom()));
  p_.setRenderHint(QPainter::Antialiasing);
  for (const auto& [colour, width] : {std::pair{QColor(0, 0, 0, 110), 3.0}, {QColor(255, 255, 255, 220), 1.4}}) {
    p_.setPen(QPen(colour, width));
    p_.drawLine(at + (end - at) * (radius_px / std::max(std::hypot(end.x() - at.x(), end.y() - at.y()), radius_px)), end);
  }
  pill(label, all, p_.font(), 0);
}

void Overlay::force(const QPointF& from, const QPointF& to) {
  const QPointF d = to - from;
  const double length = std::hypot(d.x(), d.y());
  if (length < 3) return;
  const QPointF u = d / length, n(-u.y(), u.x());
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setPen(QPen(ui_["warn"], 2));
  p_.drawLine(from, to - u * 6);
  p_.setPen(Qt::NoPen);
  p_.setBrush(ui_["warn"]);
  p_.drawPolygon(QPolygonF({to, to - u * 9 + n * 4, to - u * 9 - n * 4}));
}

void Overlay::led(const QPointF& at, const QString& name) {
  constexpr double kBelow_px = 26, kHalf_px = 8;  // clear of cue and ring
  const QPointF top = at + QPointF(0, kBelow_px);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setPen(QPen(ui_["view_text"], 1.5));
  p_.setBrush(ui_["accent"]);
  p_.drawPolygon(QPolygonF({top, top + QPointF(-kHalf_px, 1.6 * kHalf_px), top + QPointF(kHalf_px, 1.6 * kHalf_px)}));
  pill(top + QPointF(0, 1.6 * kHalf_px + 14), name, p_.font());
}

void Overlay::ghost(const QPointF& at, const QString& name) {
  const QFont font = p_.font();
  const QRectF r = room(at + QPointF(-70, -46), name, font, 0);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setPen(QPen(ui_["ghost"], 1.4, Qt::DashLine));
  p_.drawLine(at, r.center());
  pill(r, name, font, 0);
}

QFont Overlay::clock_font() const {
  QFont font = p_.font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setBold(true);
  return font;
}

void Overlay::keep_clock_clear(const QString& text) {
  constexpr double kEdge_px = 6;
  if (text.isEmpty()) return;
  const QSizeF size = size_of(text, clock_font(), 0);
  keep_clear({area_.right() - kEdge_px - size.width(), area_.top(), size.width() + kEdge_px, kEdge_px + size.height()});
}

void Overlay::clock(const QString& text) {
  QFont font = clock_font();
  // in a narrow picture, such as one of two that are compared, the text is smaller, then in several lines
  constexpr double kSmallest = 0.72, kAround_px = 32;
  const double room = std::max(0.0, area_.width() - kAround_px), needed = QFontMetricsF(font).horizontalAdvance(text);
  if (needed > room) font.setPointSizeF(font.pointSizeF() * std::max(kSmallest, room / needed));
  const QStringList lines = broken(text, QFontMetricsF(font), room);
  lines.size() < 2 ? pill({area_.right(), area_.top()}, text, font) : several(lines, font, room);
}

// lines in one label in the upper right corner
void Overlay::several(const QStringList& lines, const QFont& font, double most_px) {
  constexpr double kEdge_px = 6, kBeside_px = 10, kRound_px = 12;
  const QFontMetricsF metrics(font);
  double wide = 0;
  for (const QString& line : lines) wide = std::max(wide, std::min(most_px, metrics.horizontalAdvance(line)));
  const double high = static_cast<double>(lines.size()) * metrics.height();
  QRectF box(0, area_.top() + kEdge_px, wide + 2 * kBeside_px, high + kAboutText_px);
  box.moveRight(area_.right() - kEdge_px);
  paint_label(box, kRound_px);
  p_.setFont(font);
  p_.setPen(ui_["text"]);
  QRectF row(box.left() + kBeside_px, box.top() + 0.5 * kAboutText_px, wide, metrics.height());
  for (const QString& line : lines) {
    p_.drawText(row, Qt::AlignRight | Qt::AlignVCenter, metrics.elidedText(line, Qt::ElideRight, wide + 1));
    row.translate(0, metrics.height());
  }
  keep_clear(box);
}

void Overlay::banner(const QString& text) {
  QFont font = p_.font();
  font.setPointSizeF(font.pointSizeF() * 1.5);
  font.setBold(true);
  // above the scale bar; the cues are drawn above the grasp
  pill({area_.center().x(), area_.bottom() - 68}, text, font);
}

void Overlay::caption(const QString& text) {
  const double w = QFontMetricsF(p_.font()).horizontalAdvance(text) + 20;
  pill(QPointF(area_.left() + 0.5 * w, area_.top()), text, p_.font());
}

void Overlay::corner(const QString& text) {
  if (!text.isEmpty()) caption(text);
}

void Overlay::message(const QString& text) {
  constexpr double kEdge_px = 12, kInside_px = 8, kShare = 0.45, kRound_px = 8;
  const QRectF most(area_.left() + kEdge_px + kInside_px, area_.top() + kEdge_px + kInside_px, kShare * area_.width(), 0.25 * area_.height());
  const QRectF words = QFontMetricsF(p_.font()).boundingRect(most, Qt::AlignLeft | Qt::TextWordWrap, text).intersected(most);
  const QRectF box = words.adjusted(-kInside_px, -kInside_px, kInside_px, kInside_px);
  QColor back = ui_["card"];
  back.setAlpha(225);
  p_.setRenderHint(QPainter::Antialiasing);
  p_.setPen(QPen(ui_["accent"], 2));
  p_.setBrush(back);
  p_.drawRoundedRect(box, kRound_px, kRound_px);
  p_.setPen(ui_["text"]);
  p_.drawText(words, Qt::AlignLeft | Qt::TextWordWrap, text);
  keep_clear(box);
}

double Overlay::hint_height(const QString& text, const QFont& font, double left, double right) {
  if (text.isEmpty()) return 0;
  const QFontMetricsF metrics(font);
  const double line = metrics.height() + kAboutText_px;
  const auto n = static_cast<double>(hint_lines(text, metrics, right - left).size());
  return kHintUp_px + (n - 0.5) * line + (n - 1) * kApart_px;
}

void Overlay::hint(const QString& text, double left, double right) {
  const QFontMetricsF metrics(font_);
  const QStringList lines = hint_lines(text, metrics, right - left);
  double y = area_.bottom() - kHintUp_px;
  for (auto line = lines.crbegin(); line != lines.crend(); ++line, y = taken_.back().top() - kApart_px - 0.5 * taken_.back().height())
    pill({0.5 * (left + right), y}, metrics.elidedText(*line, Qt::ElideRight, right - left - kHintAround_px), font_);
}

}  // namespace swage::console
