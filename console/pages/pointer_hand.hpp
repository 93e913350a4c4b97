// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The device of an attempt that is driven by the pointer, if that is the mouse. [main]
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "console/link/run_control.hpp"
#include "console/view3d/needle_circle.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

/// The circle as the parameters of a pointer device, JSON. A zero axis without a circle.
std::string circle_params(const std::optional<NeedleCircle>& circle);

class PointerHand {
 public:
  /// Both outlive it.
  PointerHand(RunControl* control, const host::Catalogue& catalogue) : control_(control), catalogue_(catalogue) {}
  /// True when the running or the last attempt has such a device.
  bool is_led() const;
  /// Sets the circle along which it rotates a needle; no value: no needle at its tips. Sent as a parameter change, so that it is recorded
  /// and replayed. `mirrored_lesson`: the scene is displayed as the mirror image of the computed one. Returns why the device refused
  /// it; empty where none did.
  QString turn_about(const std::optional<NeedleCircle>& circle, bool mirrored_lesson);

 private:
  RunControl* control_;
  const host::Catalogue& catalogue_;
};

}  // namespace swage::console
