// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QPen>
#include <QWidget>
#include <utility>
#include <vector>

#include "console/cues/ui_theme.hpp"
#include "console/models/review.hpp"

namespace swage::console {

/// Traces of one attempt below each other on a common time axis, with event marks above and one cursor through all.
/// Click or drag sets the cursor; arrows step 10 ms, with Shift 1 ms, with Ctrl 1 s; Home and End; , and . go from event to
/// event.
class Timeline : public QWidget {
  Q_OBJECT
 public:
  explicit Timeline(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  /// Both outlive their use here; nullptr clears the timeline.
  void set_review(const Review* review, const record::Recording* recording);
  /// Another attempt on a shifted clock: time t of the first corresponds to t + `later_s` of the other. Its traces are dashed,
  /// its events hollow. Both outlive their use here; nullptr: none.
  void set_other(const Review* review, const record::Recording* recording, double later_s);
  /// Position of a time of the other attempt, px.
  double x_of_other(double time_s) const { return x_of(time_s - later_s_); }
  /// Indices into Review::traces, top to bottom.
  void set_shown(const QVector<int>& traces);
  void set_technical(bool shown);
  void set_cursor(double time_s);  // moves the cursor without emitting a signal
  double cursor() const { return cursor_s_; }
  /// For print: neither the cursor nor values at it are drawn.
  void hide_cursor() { has_cursor_ = false; }
  /// The span that is played in a loop, s; an empty span: none.
  void set_loop(double from_s, double to_s);
  double x_of(double time_s) const;  // px

  QSize sizeHint() const override { return {800, 220}; }  // fits a window of 770 lines with a line of text above
  QSize minimumSizeHint() const override { return {300, 160}; }
  bool has_other() const { return other_ != nullptr; }
  /// Moves the cursor to the next event, or with -1 to the previous one.
  void go_to_moment(int direction);

 Q_SIGNALS:
  void moved(double time_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF area() const;
  QRectF plot(int i) const;
  void go(double time_s);
  void paint_axis(QPainter& p) const;
  void paint_loop(QPainter& p) const;
  void paint_trace(QPainter& p, int i) const;
  void paint_moments(QPainter& p) const;
  void paint_scale(QPainter& p, const Trace& trace, const QRectF& area) const;
  void paint_line(QPainter& p, const Trace& trace, const record::Recording& recording, double shift_s, const QRectF& area,
                  const QPen& pen) const;
  void paint_other_moments(QPainter& p) const;
  /// Recorded minimum and maximum of each column of pixels.
  using Spans = std::vector<std::pair<float, float>>;
  const Spans& spans(const Trace& trace, const record::Recording& recording, double shift_s, size_t columns) const;
  const Trace* in_other(const Trace& trace) const;
  Trace common(const Trace& trace) const;
  const Moment* moment_at(const QPointF& pos) const;
  void describe();

  const Review* review_ = nullptr;
  const record::Recording* recording_ = nullptr;
  const Review* other_ = nullptr;
  const record::Recording* other_recording_ = nullptr;
  double later_s_ = 0;
  struct Drawn {
    const record::Recording* recording;
    size_t index, columns;
    double shift_s;
    Spans spans;
  };
  mutable std::vector<Drawn> drawn_;  // cache: nothing is read again while only the cursor moves
  QVector<int> shown_;
  UiTheme theme_;
  bool has_cursor_ = true;
  double cursor_s_ = 0, loop_from_s_ = 0, loop_to_s_ = 0;
  bool technical_ = false;
};

}  // namespace swage::console
