// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>
#include <deque>

#include "console/cues/ui_theme.hpp"

namespace swage::console {

/// The last ten seconds of one signal. The axis is fixed: what leaves it is cut off and marked, never
/// rescaled.
class TracePlot : public QWidget {
  Q_OBJECT
 public:
  TracePlot(const QString& title, const QString& unit, QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme, const char* colour_role);
  void set_range(double low, double high);
  void set_title(const QString& title);
  void set_limit(double value);  // a dashed line; NaN: none
  void clear();
  /// Time in s, value as shown; not a number leaves a gap.
  void add(double time_s, double value);

  struct Sample {
    double t, v;
  };
  /// Lowest and highest value of each column; columns without a value have low > high.
  struct Column {
    double low, high;
    bool silent = false;  // a sample without a value lies in it
    bool empty() const { return low > high; }
  };
  static std::vector<Column> columns(const std::deque<Sample>& samples, double from, double to, int n);
  /// First and last column of each line. A line goes on over columns without a sample, as between two pictures of a slow machine, and ends
  /// where the signal has no value, or after `longest` such columns.
  static std::vector<std::pair<size_t, size_t>> lines(const std::vector<Column>& columns, size_t longest);
  static constexpr double kWindow_s = 10;

  /// Low, as it grows by itself: a column that scrolls asks for this height, not for the least.
  QSize sizeHint() const override { return {240, 76}; }
  QSize minimumSizeHint() const override { return {140, 48}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();
  double y_of(double value, const QRectF& area) const;
  void paint_axes(QPainter& p, const QRectF& area) const;
  void paint_samples(QPainter& p, const QRectF& area) const;
  QString title_, unit_;
  UiTheme theme_;
  const char* colour_role_ = "plot";
  double low_ = 0, high_ = 1, limit_ = 0;
  bool has_limit_ = false;
  std::deque<Sample> samples_;
};

}  // namespace swage::console
