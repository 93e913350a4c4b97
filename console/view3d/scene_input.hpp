// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Mouse and keys over the picture. Usually they move the camera. While the mouse is the instrument everything
// goes to the instrument, and only Ctrl with the left button (and Ctrl+Shift with the wheel) still moves the
// camera. A drag moves the instrument in the plane of the panel that it began in. [main]
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>

#include "console/link/pointer_input.hpp"
#include "console/view3d/needle_circle.hpp"
#include "console/view3d/panels.hpp"

class QWidget;

namespace swage::console {

/// What is told over the picture, each when it is needed.
struct ControlHints {
  bool drag = false, close = false, drive = false, open = false;  // until it was used once
  bool put_back = false;                                         // what has fallen
  bool operator==(const ControlHints&) const = default;
};

class SceneInput : public QObject {
  Q_OBJECT
 public:
  /// `widget`: whose events these are.
  SceneInput(QWidget* widget, const SceneState& scene, ViewPoint& point, PanelLayout& panels);
  void set_instrument(bool on);
  bool instrument() const { return instrument_; }
  void set_hints(const ControlHints& hints);
  const ControlHints& hints() const { return hints_; }
  /// What the mouse does here now. `led`: one of several tools is led; `banner`: the picture has one.
  QString hint(bool focus, bool led, bool banner) const;

  void press(QMouseEvent* event);
  void move(QMouseEvent* event);
  void release(QMouseEvent* event);
  void wheel(QWheelEvent* event);
  /// Whether the key was for the picture; another is for the window.
  bool key_down(QKeyEvent* event);
  bool key_up(QKeyEvent* event);
  /// The keyboard went elsewhere: nothing is down any more.
  void focus_lost();

 Q_SIGNALS:
  void pointer(const swage_pointer& input);
  /// Comes before the pointer that drives the needle along it; nothing when there is no needle at the tips. World, as shown.
  void circle(const std::optional<NeedleCircle>& about);
  /// The person has done what a hint told: "drag", "close", "drive", "open".
  void control_used(const QString& what);
  void microscope_zoomed(float zoom);
  /// The camera moves.
  void looked();
  /// Something painted over the picture changed.
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

  QWidget* widget_;
  const SceneState& scene_;
  ViewPoint& point_;
  PanelLayout& panels_;
  PointerInput input_;
  QPointF last_mouse_;
  bool instrument_ = false;
  bool drives_ = false;       // along the needle's circle
  bool turned_view_ = false;  // a drag turned the view while no attempt took it
  ControlHints hints_;
};

}  // namespace swage::console
