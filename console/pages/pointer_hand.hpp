// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The hand of an attempt that the pointer leads, where its device is the mouse. [main]
#pragma once

#include <optional>

#include "console/link/run_control.hpp"
#include "console/view3d/needle_circle.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

class PointerHand {
 public:
  /// Both outlive it.
  PointerHand(RunControl* control, const host::Catalogue& catalogue) : control_(control), catalogue_(catalogue) {}
  /// There is one in the attempt that runs, or ran last.
  bool is_led() const;
  /// About which circle it turns a needle; nothing: there is none at its tips. Goes as a change of its parameters: so it is recorded,
  /// and replayed. `mirrored_lesson`: the hand moves in the mirror image of what is shown.
  void turn_about(const std::optional<NeedleCircle>& circle, bool mirrored_lesson);

 private:
  RunControl* control_;
  const host::Catalogue& catalogue_;
};

}  // namespace swage::console
