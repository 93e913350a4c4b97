// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_input.hpp"

#include <QCursor>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScreen>
#include <QWheelEvent>
#include <QWidget>
#include <utility>

#include "base/clock.hpp"
#include "console/view3d/overlay.hpp"

namespace swage::console {
namespace {

constexpr float kTurn_deg_px = 0.4F;
constexpr float kTurn_deg_key = 6;
constexpr int kEdge_px = 2;

}  // namespace

SceneInput::SceneInput(QWidget* widget, const SceneState& scene, ViewPoint& point, PanelLayout& panels)
    : QObject(widget), widget_(widget), scene_(scene), point_(point), panels_(panels) {}

void SceneInput::set_instrument(bool on) {
  if (instrument_ == on) return;
  instrument_ = on;
  drives_ = nothing_to_drive_ = false;  // a key that is down when an attempt ends is released unseen
  turned_view_ = false;
  input_ = PointerInput();
  keys_ = 0;
  panels_.set_keys_down(false);
  panels_.hold({});
  Q_EMIT words_changed();
}

void SceneInput::set_hints(const ControlHints& hints) {
  if (hints_ == hints) return;
  hints_ = hints;
  Q_EMIT words_changed();
}

QString SceneInput::hint(bool focus, bool led, bool banner) const {
  if (!instrument_) return turned_view_ && banner ? tr("The instrument waits: a drag turns the view") : QString();
  if (!focus) return tr("Click here: then mouse and keys move the instrument");
  QStringList all;
  if (led) all += tr("Tab: the other instrument");
  if (hints_.put_back) all += tr("F7: put it back");
  if (hints_.side == 1) all += tr("F11: look from the side, where keys go along the needle");
  if (hints_.side > 1) all += tr("F11, %1 times: look from the side, where keys go along the needle").arg(hints_.side);
  if (hints_.drag) all += tr("Drag, wheel: move the instrument; keys A D: sideways, W S: up and down, Q E: away and near");
  if (hints_.close) all += tr("Hold Space: close the jaws, B: open them");
  if (hints_.open) all += tr("Hold B: open the jaws");
  if (nothing_to_drive_) all += tr("No bent needle is at the tips that could be driven");
  if (hints_.drive) all += tr("Hold T: drive the needle, once its point stands square to the tissue");
  return all.join(QString::fromUtf16(kHintGap));
}

void SceneInput::used(const char* what) {
  const QLatin1String name(what);
  bool& hint = name == QLatin1String("drag")    ? hints_.drag
               : name == QLatin1String("close") ? hints_.close
               : name == QLatin1String("open")  ? hints_.open
                                                : hints_.drive;
  if (!std::exchange(hint, false)) return;
  Q_EMIT words_changed();
  Q_EMIT control_used(name);
}

// directions refer to the panel under the pointer, as far as it shows the tips
void SceneInput::look_from(const QPointF& position) { input_.set_camera(panels_.moved_in(position).view.eye.q_WC()); }

// the tips follow the pointer in every view and at every magnification
swage_pointer SceneInput::moved(const QPointF& from, const QPointF& to) {
  const Panel panel = panels_.at(from);
  const Eye& eye = panel.view.eye;
  const double px = panel.size.height();
  QPointF delta((to.x() - from.x()) * panel.size.width() / panel.at.width(), (to.y() - from.y()) * px / panel.at.height());
  // in a mirror the tips follow the hand and not the screen
  const Mirror mirror = point_.stereo() ? point_.stereo()->mirror : Mirror::kNone;
  if (mirror == Mirror::kLeftRight) delta.setX(-delta.x());
  if (mirror == Mirror::kUpDown) delta.setY(-delta.y());
  input_.set_camera(eye.q_WC());
  return input_.moved(delta, scene_.parts().tips.empty() ? eye.mm_per_pixel(px) : eye.mm_per_pixel(px, scene_.middle_of_tips()));
}

// the needle's circle is fixed when a drive begins
void SceneInput::tell_circle(const swage_pointer& input) {
  const bool drives = PointerInput::drives(input);
  const bool drove = std::exchange(drives_, drives);
  if (!drives && std::exchange(nothing_to_drive_, false)) Q_EMIT words_changed();
  if (drove || !drives || !scene_.have_snapshot()) return;
  const std::optional<NeedleCircle> about = needle_circle(scene_.card(), scene_.parts(), scene_.X_WB(), scene_.middle_of_tips());
  nothing_to_drive_ = !about;
  if (about) used("drive");
  else Q_EMIT words_changed();
  Q_EMIT circle(about);
}

bool SceneInput::moves_camera(const QMouseEvent& event) const {
  if (!instrument_) return event.buttons() != Qt::NoButton;
  return event.buttons() & Qt::LeftButton && event.modifiers() & Qt::ControlModifier;
}

void SceneInput::press(QMouseEvent* event) {
  last_mouse_ = event->position();
  widget_->setFocus();
  if (!instrument_ || moves_camera(*event)) return;
  if (!panels_.held()) panels_.hold(panels_.moved_in(last_mouse_).inset);
  look_from(last_mouse_);
  const swage_pointer out = input_.buttons(*event);
  tell_circle(out);
  if (event->button() == Qt::MiddleButton) used(event->modifiers() & Qt::ControlModifier ? "open" : "close");
  Q_EMIT pointer(out);
}

void SceneInput::move(QMouseEvent* event) {
  const QPointF from = std::exchange(last_mouse_, event->position()), delta = last_mouse_ - from;
  if (moves_camera(*event)) {
    const bool pan = event->modifiers() & Qt::ShiftModifier || (!instrument_ && event->buttons() & Qt::RightButton);
    const auto dx = static_cast<float>(delta.x()), dy = static_cast<float>(delta.y());
    const auto h = static_cast<float>(widget_->height());
    pan ? point_.camera.pan(dx / h, -dy / h) : point_.camera.turn(-kTurn_deg_px * dx, kTurn_deg_px * dy);
    turned_view_ = !instrument_;
    Q_EMIT looked();
  } else if (instrument_ && event->buttons() != Qt::NoButton) {
    input_.buttons(*event);
    Q_EMIT pointer(moved(from, last_mouse_));
    if (panels_.held()) used("drag");
    wrap_pointer(event->globalPosition().toPoint());
  }
}

// moves the pointer to the opposite edge of the screen, so that a drag does not end there
void SceneInput::wrap_pointer(const QPoint& global) {
  const QScreen* screen = widget_->screen();
  if (QGuiApplication::platformName() != QLatin1String("xcb") || !screen) return;
  if (screen->virtualGeometry().adjusted(kEdge_px, kEdge_px, -kEdge_px, -kEdge_px).contains(global)) return;
  const QPoint middle = widget_->rect().center();
  QCursor::setPos(widget_->mapToGlobal(middle));
  last_mouse_ = middle;
}

// On a busy machine the last motion events of a drag are merged into its release: they still belong to the drag.
void SceneInput::release(QMouseEvent* event) {
  const QPointF from = std::exchange(last_mouse_, event->position());
  if (!instrument_) return;
  if (from != last_mouse_) Q_EMIT pointer(moved(from, last_mouse_));
  const swage_pointer out = input_.buttons(*event);
  tell_circle(out);
  Q_EMIT pointer(out);
  if (event->buttons() == Qt::NoButton) panels_.hold({});
}

void SceneInput::wheel(QWheelEvent* event) {
  event->accept();
  const Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::ShiftModifier;
  if (instrument_ && (event->modifiers() & both) != both) {
    look_from(event->position());
    Q_EMIT pointer(input_.wheel(*event));
    return;
  }
  const QPoint angle = event->angleDelta();
  if (point_.microscope()) return zoom_microscope(angle.y() > 0 ? 1 : -1);
  point_.camera.zoom(static_cast<float>(angle.y() != 0 ? angle.y() : angle.x()) / 120);
  Q_EMIT looked();
}

void SceneInput::zoom_microscope(int notches) {
  if (!point_.zoom_microscope(notches)) return;
  Q_EMIT looked();
  Q_EMIT microscope_zoomed(point_.stereo()->microscope.zoom);
}

// Ctrl with Page up and down, also from a pedal that sends them: zoom; with Shift: focus.
bool SceneInput::microscope_key(const QKeyEvent& event) {
  const bool up = event.key() == Qt::Key_PageUp, down = event.key() == Qt::Key_PageDown;
  if (!point_.microscope() || !(event.modifiers() & Qt::ControlModifier) || !(up || down)) return false;
  if (!(event.modifiers() & Qt::ShiftModifier)) {
    zoom_microscope(up ? 1 : -1);
  } else if (point_.focus_microscope(up ? 1 : -1)) {
    Q_EMIT looked();
  }
  return true;
}

// the keys that devices/mouse reads
bool SceneInput::moves_instrument(int key) {
  return key == Qt::Key_A || key == Qt::Key_D || key == Qt::Key_W || key == Qt::Key_S || key == Qt::Key_Q || key == Qt::Key_E;
}

bool SceneInput::key_down(QKeyEvent* event) {
  if (microscope_key(*event)) return true;
  swage_pointer out{};
  if (!panels_.held()) input_.set_camera(panels_.panels().front().view.eye.q_WC());
  if (!instrument_ || !input_.key(*event, true, out)) return camera_key(event->key());
  if (event->isAutoRepeat()) return true;
  tell_circle(out);
  panels_.set_keys_down(out.keys != 0);
  if (moves_instrument(event->key())) used("drag");
  if (event->key() == Qt::Key_Space) used("close");
  if (event->key() == Qt::Key_B) used("open");
  send_key(*event, out);
  return true;
}

// camera without a mouse: arrows turn, plus and minus zoom, Home frames
bool SceneInput::camera_key(int key) {
  OrbitCamera& camera = point_.camera;
  switch (key) {
    case Qt::Key_Left:
      camera.turn(-kTurn_deg_key, 0);
      break;
    case Qt::Key_Right:
      camera.turn(kTurn_deg_key, 0);
      break;
    case Qt::Key_Up:
      camera.turn(0, kTurn_deg_key);
      break;
    case Qt::Key_Down:
      camera.turn(0, -kTurn_deg_key);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera.zoom(1);
      break;
    case Qt::Key_Minus:
      camera.zoom(-1);
      break;
    case Qt::Key_Home:
      camera.look(CameraPreset::kOrbit);
      break;
    default:
      return false;
  }
  Q_EMIT looked();
  return true;
}

bool SceneInput::key_up(QKeyEvent* event) {
  swage_pointer out{};
  if (!instrument_ || !input_.key(*event, false, out)) return false;
  if (event->isAutoRepeat()) return true;
  panels_.set_keys_down(out.keys != 0);
  tell_circle(out);
  send_key(*event, out);
  return true;
}

void SceneInput::send_key(const QKeyEvent& event, const swage_pointer& input) {
  constexpr int64_t kMs = 1'000'000;  // ns
  const KeyTimes::Kind kind = PointerInput::key_bit(event.key()) < 0        ? KeyTimes::Kind::kModifier
                              : event.type() == QEvent::KeyPress ? KeyTimes::Kind::kPress
                                                                 : KeyTimes::Kind::kRelease;
  const bool down = std::exchange(keys_, input.keys) != 0;
  Q_EMIT pointer(input, key_times_.due_ns(kind, down, static_cast<int64_t>(event.timestamp()) * kMs, base::wall_ns()));
}

void SceneInput::focus_lost() {
  keys_ = 0;
  panels_.set_keys_down(false);
  // a key released in another window must not keep the jaws closing
  if (instrument_) Q_EMIT pointer(input_.released());
  drives_ = nothing_to_drive_ = false;
  panels_.hold({});
}

}  // namespace swage::console
