// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "console/cues/ui_theme.hpp"

namespace swage::console {

/// A bar with a good band and a limit, and the value in large digits above. Screen readers get the same text.
class ForceMeter : public QWidget {
  Q_OBJECT
 public:
  explicit ForceMeter(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  void set_range(double most, double low, double limit);  // N
  /// `held`: by both jaws. A force on one jaw only is no grip.
  void set_value(std::optional<double> newtons, bool held = true);
  std::optional<double> value() const { return value_; }
  double limit() const { return limit_; }
  /// False where the limit is infinite: the force is shown and not judged.
  bool judges() const;
  QSize sizeHint() const override { return {220, 84}; }
  QSize minimumSizeHint() const override { return {140, 84}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString nothing() const;
  double x_of(double newtons, const QRectF& bar) const;
  void paint_number(QPainter& p) const;
  void paint_bar(QPainter& p, const QRectF& bar) const;
  void paint_scale(QPainter& p, const QRectF& bar) const;
  UiTheme theme_;
  double most_ = 2, low_ = 0.4, limit_ = 0.9;
  std::optional<double> value_;
  bool held_ = true;
  QString shown_;
};

}  // namespace swage::console
