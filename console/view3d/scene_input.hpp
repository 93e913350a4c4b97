// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Mouse and keys over the picture. Usually they move the camera. While an instrument is driven by the mouse, all
// events are the instrument's; only Ctrl with the left button (and Ctrl+Shift with the wheel) still moves the
// camera. A drag moves the instrument in the plane of the panel that it began in; over a close-up that does not show the tips, in that of the
// whole picture. [main]
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>

#include "console/link/pointer_input.hpp"
#include "console/view3d/key_times.hpp"
#include "console/view3d/needle_circle.hpp"
#include "console/view3d/panels.hpp"

class QWidget;

namespace swage::console {

/// Which hints are shown over the picture.
struct ControlHints {
  bool drag = false, close = false, drive = false, open = false;  // until the control was used once
  bool put_back = false;                                         // for a dropped object, and a bent needle
  int side = 0;  // presses of F11 that lead to the view from the side, until a needle was seen from there once; 0: not shown
  bool operator==(const ControlHints&) const = default;
};

class SceneInput : public QObject {
  Q_OBJECT
 public:
  /// `widget`: source of the events.
  SceneInput(QWidget* widget, const SceneState& scene, ViewPoint& point, PanelLayout& panels);
  void set_instrument(bool on);
  bool instrument() const { return instrument_; }
  void set_hints(const ControlHints& hints);
  const ControlHints& hints() const { return hints_; }
  /// The present use of the mouse, as text. `led`: one of several tools is active; `banner`: the picture shows a banner.
  QString hint(bool focus, bool led, bool banner) const;

  void press(QMouseEvent* event);
  void move(QMouseEvent* event);
  void release(QMouseEvent* event);
  void wheel(QWheelEvent* event);
  /// True when the key was handled; otherwise the window handles it.
  bool key_down(QKeyEvent* event);
  bool key_up(QKeyEvent* event);
  /// The keyboard focus was lost: no key or button is down any more.
  void focus_lost();

 Q_SIGNALS:
  /// `due_ns`: time of base::wall_ns() at which it takes effect; 0: at once.
  void pointer(const swage_pointer& input, qint64 due_ns = 0);
  /// Emitted before pointer() when the needle is driven along its circle; no value without a needle at the tips. World frame, as shown.
  void circle(const std::optional<NeedleCircle>& about);
  /// The person has used a control of the hints: "drag", "close", "drive", "open".
  void control_used(const QString& what);
  void microscope_zoomed(float zoom);
  /// The camera moved.
  void looked();
  /// A text over the picture changed.
  void words_changed();

 private:
  bool moves_camera(const QMouseEvent& event) const;
  void look_from(const QPointF& position);
  swage_pointer moved(const QPointF& from, const QPointF& to);
  void tell_circle(const swage_pointer& input);
  void used(const char* what);
  void wrap_pointer(const QPoint& global);
  void zoom_microscope(int notches);
  bool microscope_key(const QKeyEvent& event);
  static bool moves_instrument(int key);
  bool camera_key(int key);
  void send_key(const QKeyEvent& event, const swage_pointer& input);

  QWidget* widget_;
  const SceneState& scene_;
  ViewPoint& point_;
  PanelLayout& panels_;
  PointerInput input_;
  QPointF last_mouse_;
  bool instrument_ = false;
  bool drives_ = false;       // along the needle's circle
  bool nothing_to_drive_ = false;  // a driving key is down and no circle is at the tips
  bool turned_view_ = false;  // a drag turned the view while no attempt was running
  ControlHints hints_;
  uint64_t keys_ = 0;  // of the instrument that are down, as in swage_pointer
  KeyTimes key_times_;
};

}  // namespace swage::console
