// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From Qt's mouse, wheel and key events to the boundary's swage_pointer.
#pragma once

#include <swage/abi/device.h>

#include <QPointF>
#include <QQuaternion>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace swage::console {

/// Keeps which keys and buttons are down, and turns movement of the pointer into way over what is seen.
class PointerInput {
 public:
  /// Each returns what to send; deltas since the last event.
  swage_pointer moved(const QPointF& delta_px, double mm_per_pixel);
  swage_pointer buttons(const QMouseEvent& event);
  swage_pointer wheel(const QWheelEvent& event);
  /// false for keys that no instrument uses and for repeats: leave those to the window.
  bool key(const QKeyEvent& event, bool down, swage_pointer& out);
  swage_pointer released();  // the view lost the keyboard: nothing is down any more
  void set_camera(const QQuaternion& q_WC);

  /// Whether the mouse turns the needle along its own circle for this input: C or Alt with the left button, T, G.
  static bool drives(const swage_pointer& input);
  /// Bit of swage_pointer.keys, or -1.
  static int key_bit(int qt_key);

 private:
  swage_pointer state() const;
  uint32_t buttons_ = 0, modifiers_ = 0;
  uint64_t keys_ = 0;
  swage_quat camera_{1, 0, 0, 0};
};

}  // namespace swage::console
