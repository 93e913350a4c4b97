// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Mouse and keys over the picture. Usually they move the camera. While the mouse is the instrument everything
// goes to the instrument, and only Ctrl with the left button (and Ctrl+Shift with the wheel) still moves the
// camera. A drag moves the instrument in the plane of the panel that it began in.
#include <QCursor>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScreen>
#include <QWheelEvent>
#include <span>
#include <utility>

#include "console/view3d/led_tool.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {
namespace {

constexpr float kTurn_deg_px = 0.4F;
constexpr int kEdge_px = 2;

}  // namespace

void SceneView::set_instrument(bool on) {
  if (instrument_ == on) return;
  instrument_ = on;
  turned_view_ = false;
  input_ = PointerInput();
  dragging_ = false;
  update();
}

// directions are those of the panel under the pointer
void SceneView::look_from(const QPointF& position) { input_.set_camera(panel_at(position).view.eye.q_WC()); }

// the tips stay under the pointer in every view and at every magnification
swage_pointer SceneView::moved(const QPointF& from, const QPointF& to) {
  const Panel panel = panel_at(from);
  const Eye& eye = panel.view.eye;
  const double px = panel.size.height();
  QPointF delta((to.x() - from.x()) * panel.size.width() / panel.at.width(),
                      (to.y() - from.y()) * px / panel.at.height());
  // in a mirror the tips go with the hand and not with the screen
  if (stereo_ && stereo_->mirror == Mirror::kLeftRight) delta.setX(-delta.x());
  if (stereo_ && stereo_->mirror == Mirror::kUpDown) delta.setY(-delta.y());
  input_.set_camera(eye.q_WC());
  return input_.moved(delta,
                      parts_.tips.empty() ? eye.mm_per_pixel(px) : eye.mm_per_pixel(px, middle_of_tips()));
}

void SceneView::tell(const swage_pointer& input) {
  if (moved_ns_ < 0) moved_ns_ = clock_.nsecsElapsed();
  Q_EMIT pointer(input);
}

// where the needle is when a drive begins is where its circle stays
void SceneView::tell_circle(const swage_pointer& input) {
  const bool drives = PointerInput::drives(input);
  if (std::exchange(drives_, drives) || !drives || !have_snapshot_) return;
  Q_EMIT circle(
      needle_circle(card_, parts_, std::span(snapshot_->X_WB, snapshot_->n_body), middle_of_tips()));
}

void SceneView::set_control_hints(bool drag, bool close, bool drive) {
  hint_drag_ = drag, hint_close_ = close, hint_drive_ = drive;
  update();
}

void SceneView::used(const char* what) {
  const QLatin1String name(what);
  bool& hint = name == QLatin1String("drag") ? hint_drag_ : name == QLatin1String("close") ? hint_close_ : hint_drive_;
  if (!std::exchange(hint, false)) return;
  update();
  Q_EMIT control_used(name);
}

bool SceneView::moves_camera(const QMouseEvent& event) const {
  if (!instrument_) return event.buttons() != Qt::NoButton;
  return event.buttons() & Qt::LeftButton && event.modifiers() & Qt::ControlModifier;
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  last_mouse_ = event->position();
  setFocus();
  if (!instrument_ || moves_camera(*event)) return;
  if (!dragging_) {
    drags_in_ = panel_at(last_mouse_).inset;
    dragging_ = true;
  }
  look_from(last_mouse_);
  const swage_pointer out = input_.buttons(*event);
  tell_circle(out);
  tell(out);
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF from = std::exchange(last_mouse_, event->position()), delta = last_mouse_ - from;
  if (moves_camera(*event)) {
    const bool pan =
        event->modifiers() & Qt::ShiftModifier || (!instrument_ && event->buttons() & Qt::RightButton);
    const auto dx = static_cast<float>(delta.x()), dy = static_cast<float>(delta.y());
    const auto h = static_cast<float>(height());
    pan ? camera_.pan(dx / h, -dy / h) : camera_.turn(-kTurn_deg_px * dx, kTurn_deg_px * dy);
    turned_view_ = !instrument_;
    touch();
  } else if (instrument_ && event->buttons() != Qt::NoButton) {
    input_.buttons(*event);
    tell(moved(from, last_mouse_));
    if (dragging_) used("drag");
    wrap_pointer(event->globalPosition().toPoint());
  }
}

// a long drag does not end at the edge of the screen
void SceneView::wrap_pointer(const QPoint& global) {
  if (QGuiApplication::platformName() != QLatin1String("xcb") || !screen()) return;
  if (screen()->virtualGeometry().adjusted(kEdge_px, kEdge_px, -kEdge_px, -kEdge_px).contains(global)) return;
  const QPoint middle = rect().center();
  QCursor::setPos(mapToGlobal(middle));
  last_mouse_ = middle;
}

// On a busy machine the last reports of a drag are merged into the letting go: they still belong to it.
void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  const QPointF from = std::exchange(last_mouse_, event->position());
  if (!instrument_) return;
  if (from != last_mouse_) tell(moved(from, last_mouse_));
  const swage_pointer out = input_.buttons(*event);
  tell_circle(out);
  tell(out);
  dragging_ = event->buttons() != Qt::NoButton;
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (instrument_) return mousePressEvent(event);
  look(CameraPreset::kOrbit);
}

void SceneView::wheelEvent(QWheelEvent* event) {
  event->accept();
  const Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;
  if (instrument_ && (event->modifiers() & both) != both) {
    look_from(event->position());
    tell(input_.wheel(*event));
    return;
  }
  const QPoint angle = event->angleDelta();
  if (stereo_ && stereo_->microscope.on) return zoom_microscope(angle.y() > 0 ? 1 : -1);
  camera_.zoom(static_cast<float>(angle.y() != 0 ? angle.y() : angle.x()) / 120);
  touch();
}

// Tab hands over to the other instrument where the mouse leads two; else it goes on to the next button, as everywhere.
bool SceneView::focusNextPrevChild(bool next) {
  if (instrument_ && mouse_hands(card_) > 1) return false;
  return QWidget::focusNextPrevChild(next);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (stereo_ && stereo_->microscope.on && event->modifiers() & Qt::ControlModifier) {
    if (event->key() == Qt::Key_PageUp) return zoom_microscope(1);
    if (event->key() == Qt::Key_PageDown) return zoom_microscope(-1);
  }
  swage_pointer out{};
  if (!dragging_) input_.set_camera(panels().front().view.eye.q_WC());
  if (instrument_ && input_.key(*event, true, out)) {
    if (event->isAutoRepeat()) return;
    tell_circle(out);
    if (event->key() == Qt::Key_Space) used("close");
    if (event->key() == Qt::Key_T) used("drive");
    tell(out);
    return;
  }
  // without a mouse: arrows turn, plus and minus zoom, Home frames
  switch (event->key()) {
    case Qt::Key_Left:
      camera_.turn(-6, 0);
      break;
    case Qt::Key_Right:
      camera_.turn(6, 0);
      break;
    case Qt::Key_Up:
      camera_.turn(0, 6);
      break;
    case Qt::Key_Down:
      camera_.turn(0, -6);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera_.zoom(1);
      break;
    case Qt::Key_Minus:
      camera_.zoom(-1);
      break;
    case Qt::Key_Home:
      camera_.look(CameraPreset::kOrbit);
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  touch();
}

void SceneView::keyReleaseEvent(QKeyEvent* event) {
  swage_pointer out{};
  if (instrument_ && input_.key(*event, false, out)) {
    if (event->isAutoRepeat()) return;
    tell_circle(out);
    tell(out);
    return;
  }
  QWidget::keyReleaseEvent(event);
}

void SceneView::focusInEvent(QFocusEvent* event) {
  update();
  QWidget::focusInEvent(event);
}

void SceneView::focusOutEvent(QFocusEvent* event) {
  // a key that is let go elsewhere must not go on closing the jaws
  if (instrument_) tell(input_.released());
  drives_ = false;
  dragging_ = false;
  update();
  QWidget::focusOutEvent(event);
}

}  // namespace swage::console
