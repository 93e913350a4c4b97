// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Converts Qt's mouse, wheel and key events to swage_pointer of the plugin boundary.
#pragma once

#include <swage/abi/device.h>

#include <QPointF>
#include <QQuaternion>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace swage::console {

/// Keeps the pressed keys and buttons, and scales pointer movement to displacement in the scene.
class PointerInput {
 public:
  /// Each returns the input to send; deltas since the last event.
  swage_pointer moved(const QPointF& delta_px, double mm_per_pixel);
  swage_pointer buttons(const QMouseEvent& event);
  swage_pointer wheel(const QWheelEvent& event);
  /// False for keys that no instrument uses and for repeats, which are the window's.
  bool key(const QKeyEvent& event, bool down, swage_pointer& out);
  swage_pointer released();  // for a lost keyboard focus: no key or button is down any more
  void set_camera(const QQuaternion& q_WC);

  /// Whether this input rotates the needle along its own circle: C or Alt with the left button, T, G.
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
