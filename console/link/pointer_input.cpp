// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/pointer_input.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace swage::console {
namespace {

// m in the scene per unit of pointer movement: the normal height of a view, by which devices scale the mouse
constexpr double kSpan_m = 10e-3;
constexpr double kNotch = 120;  // eighths of a degree per click of a usual mouse wheel

uint32_t modifier_bits(Qt::KeyboardModifiers m) {
  return (m & Qt::ShiftModifier ? 1U : 0U) | (m & Qt::ControlModifier ? 2U : 0U) |
         (m & Qt::AltModifier ? 4U : 0U);
}

}  // namespace

int PointerInput::key_bit(int key) {
  if (key >= Qt::Key_A && key <= Qt::Key_Z) return key - Qt::Key_A;
  if (key >= Qt::Key_0 && key <= Qt::Key_9) return 26 + key - Qt::Key_0;
  switch (key) {
    case Qt::Key_Left:
      return 36;
    case Qt::Key_Right:
      return 37;
    case Qt::Key_Up:
      return 38;
    case Qt::Key_Down:
      return 39;
    case Qt::Key_Space:
      return 40;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return 41;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return 42;
    case Qt::Key_Minus:
      return 43;
    case Qt::Key_PageUp:
      return 44;
    case Qt::Key_PageDown:
      return 45;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
      return 46;
    default:
      return -1;
  }
}

bool PointerInput::drives(const swage_pointer& p) {
  const auto down = [&](int key) { return (p.keys >> key_bit(key) & 1) != 0; };
  const bool along = down(Qt::Key_C) || (p.modifiers & modifier_bits(Qt::AltModifier)) != 0;
  return down(Qt::Key_T) || down(Qt::Key_G) || (along && (p.buttons & 1U) != 0);
}

swage_pointer PointerInput::state() const {
  swage_pointer p{};
  p.buttons = buttons_;
  p.modifiers = modifiers_;
  p.keys = keys_;
  p.camera = camera_;
  return p;
}

swage_pointer PointerInput::moved(const QPointF& delta_px, double mm_per_pixel) {
  swage_pointer p = state();
  const double scale = 1e-3 * mm_per_pixel / kSpan_m;
  p.dx = delta_px.x() * scale;
  p.dy = -delta_px.y() * scale;
  return p;
}

swage_pointer PointerInput::buttons(const QMouseEvent& event) {
  const Qt::MouseButtons b = event.buttons();
  buttons_ =
      (b & Qt::LeftButton ? 1U : 0U) | (b & Qt::MiddleButton ? 2U : 0U) | (b & Qt::RightButton ? 4U : 0U);
  modifiers_ = modifier_bits(event.modifiers());
  return state();
}

swage_pointer PointerInput::wheel(const QWheelEvent& event) {
  modifiers_ = modifier_bits(event.modifiers());
  swage_pointer p = state();
  // with Alt some platforms report the wheel as horizontal
  const QPoint angle = event.angleDelta();
  p.wheel = (angle.y() != 0 ? angle.y() : angle.x()) / kNotch;
  return p;
}

bool PointerInput::key(const QKeyEvent& event, bool down, swage_pointer& out) {
  modifiers_ = modifier_bits(event.modifiers());
  const int bit = key_bit(event.key());
  const bool modifier =
      event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control || event.key() == Qt::Key_Alt;
  if (bit < 0 && !modifier) return false;
  if (event.isAutoRepeat()) return bit >= 0;
  if (bit >= 0) keys_ = down ? keys_ | (uint64_t{1} << bit) : keys_ & ~(uint64_t{1} << bit);
  if (modifier) {
    const uint32_t m = event.key() == Qt::Key_Shift ? 1U : event.key() == Qt::Key_Control ? 2U : 4U;
    modifiers_ = down ? modifiers_ | m : modifiers_ & ~m;
  }
  out = state();
  return true;
}

swage_pointer PointerInput::released() {
  buttons_ = modifiers_ = 0;
  keys_ = 0;
  return state();
}

void PointerInput::set_camera(const QQuaternion& q) {
  camera_ = {static_cast<double>(q.scalar()), static_cast<double>(q.x()), static_cast<double>(q.y()),
             static_cast<double>(q.z())};
}

}  // namespace swage::console
