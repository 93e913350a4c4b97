// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/cue_legend.hpp"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "console/cues/theme_words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kSign_px = 18, kCueRow_px = 26;
constexpr int kMostTall = 4;  // largest number of rows with two lines; more rows have one line each, elided if too long
constexpr int kLow_px = 19;
constexpr int kColumns = 2;
// smallest size of the texts, in units of the usual one, still legible at arm's length; all rows use one size, so that the longest fits.
constexpr double kSmallest = 0.75;
constexpr double kStep = 0.025;  // step between the tried sizes: less than a pixel in the height of the letters

}  // namespace

/// One meaning: its signs in its colour, its text.
class CueLegend::Row : public QWidget {
 public:
  /// `wide`: a sign of this column has two parts, and all texts of the column begin behind it. `low`: a single line.
  Row(const CueStyle& style, bool wide, bool low, const UiTheme& ui, CueLegend* legend)
      : QWidget(legend), legend_(legend), style_(style), ui_(ui), wide_(wide), low_(low) {
    setFixedHeight(low ? kLow_px : kCueRow_px);
    setMinimumWidth(60);
    QStringList tip = {style.text};
    if (!style.sound.isEmpty()) tip += CueLegend::tr("Sound: %1").arg(theme_word(style.sound));
    setToolTip(tip.join(QLatin1Char('\n')));
    setAccessibleName(style.text);
  }
  void set_active(bool on) {
    if (on == active_) return;
    active_ = on;
    setAccessibleDescription(on ? CueLegend::tr("on now") : QString());
    update();
  }
  /// Whether the text fits one line at this size. It is measured at that size: letter widths are rounded to whole pixels, so
  /// that text at nine tenths of the size may be as wide as before.
  bool fits(double scale) const { return QFontMetricsF(words_font(scale)).horizontalAdvance(style_.text) <= room().width(); }
  /// px, width of the whole row without elision
  int natural_px() const { return static_cast<int>(room().left() + words_px()) + 4; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (active_) {
      p.setPen(QPen(ui_["accent"], 1.5));
      p.setBrush(ui_["raised"]);
      p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
    }
    const int sign = sign_px();
    paint_cue_shape(p, {5, 0.5 * (height() - sign)}, sign, style_);
    QFont text = words_font(legend_->scale());
    QFont bold = text;
    bold.setBold(true);
    // bold text is wider; where it would be elided only the frame marks the row
    if (active_ && QFontMetricsF(bold).horizontalAdvance(style_.text) <= room().width()) text = bold;
    p.setFont(text);
    p.setPen(ui_["text"]);
    if (low_)
      p.drawText(room(), Qt::AlignLeft | Qt::AlignVCenter,
                 QFontMetricsF(text).elidedText(style_.text, Qt::ElideRight, room().width()));
    else
      p.drawText(room(), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, style_.text);
  }

  void resizeEvent(QResizeEvent* event) override {
    legend_->scale_ = 0;
    QWidget::resizeEvent(event);
  }
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::FontChange) legend_->scale_ = 0;
    QWidget::changeEvent(event);
  }

 private:
  double words_px() const { return QFontMetricsF(font()).horizontalAdvance(style_.text); }
  QFont words_font(double scale) const {
    QFont out = font();
    out.setPointSizeF(out.pointSizeF() * scale);
    return out;
  }
  int sign_px() const { return low_ ? kLow_px - 3 : kSign_px; }
  QRectF room() const {
    const double left = 5 + (wide_ ? 2 : 1) * sign_px() + 6;
    return {left, 0, width() - left - 2, double(height())};
  }
  CueLegend* legend_;
  CueStyle style_;
  UiTheme ui_;
  bool wide_, low_, active_ = false;
};

CueLegend::CueLegend(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("legend"));
  setAccessibleName(tr("What the cues mean"));
  setProperty("card", true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 5, 10, 4);
  column->setSpacing(2);
  heading_ = make_heading(tr("Cues"), this);
  column->addWidget(heading_);
  grid_ = new QGridLayout;
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(6);
  grid_->setVerticalSpacing(0);
  column->addLayout(grid_);
  empty_ = make_muted(tr("This lesson shows no cues."), this);
  column->addWidget(empty_);
  column->addStretch(1);
}

void CueLegend::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_ = ui;
  cues_ = cues;
  fill();
}

void CueLegend::set_meanings(const QStringList& meanings) {
  if (has_lesson_ && meanings == meanings_) return;
  has_lesson_ = true;
  meanings_ = meanings;
  fill();
}

// Column widths follow their texts, as those of the grasp are twice as long as the others.
void CueLegend::add_column(const QStringList& meanings, int column, bool low) {
  const bool wide = std::any_of(meanings.begin(), meanings.end(), [this](const QString& m) { return cues_.style(m).shape.size() > 1; });
  int widest_px = 1, line = 0;
  for (const QString& meaning : meanings) {
    auto* row = new Row(cues_.style(meaning), wide, low, ui_, this);
    grid_->addWidget(row, line++, column);
    widest_px = std::max(widest_px, row->natural_px());
    rows_ += row;
  }
  grid_->setColumnStretch(column, widest_px);
}

void CueLegend::fill() {
  for (Row* row : rows_) delete row;
  rows_.clear();
  scale_ = 0;
  const auto lines = static_cast<int>((meanings_.size() + kColumns - 1) / kColumns);
  for (int column = 0; column < kColumns; ++column) add_column(meanings_.mid(column * lines, lines), column, lines > kMostTall);
  empty_->setVisible(has_lesson_ && meanings_.isEmpty());
  const QStringList now = active_;
  active_.clear();
  set_active(now);
}

bool CueLegend::fit(double scale) const {
  return std::all_of(rows_.begin(), rows_.end(), [&](const Row* row) { return row->fits(scale); });
}

double CueLegend::scale() const {
  if (scale_ > 0) return scale_;
  scale_ = 1;
  while (scale_ > kSmallest && !fit(scale_)) scale_ -= kStep;
  return scale_ = std::max(scale_, kSmallest);
}

bool CueLegend::has_long_words() const { return scale() < 1; }
QStringList CueLegend::cut_words() const {
  QStringList out;
  for (const Row* row : rows_)
    if (!row->fits(scale())) out += row->accessibleName();
  return out;
}

void CueLegend::set_active(const QStringList& meanings) {
  if (meanings == active_) return;
  active_ = meanings;
  for (int i = 0; i < rows_.size(); ++i) rows_[i]->set_active(active_.contains(meanings_[i]));
}

void CueLegend::set_in_picture(bool shown) {
  heading_->setText(
      (shown ? tr("Cues") : tr("Cues — hidden, but for marks of the task")).toUpper());
}

}  // namespace swage::console
