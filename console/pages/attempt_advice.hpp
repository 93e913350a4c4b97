// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Advice to the person during an attempt, beyond the task of its phase: put back a dropped object or a bent needle, release an object that is held at the
// wrong place, and how to use mouse controls not used so far. [main]
#pragma once

#include <QCoreApplication>
#include <QString>
#include <cstdint>
#include <string>

#include "console/models/reading.hpp"
#include "console/view3d/camera.hpp"
#include "console/view3d/scene_input.hpp"

namespace swage::console {

class AttemptAdvice {
  Q_DECLARE_TR_FUNCTIONS(AttemptAdvice)
 public:
  /// To be called before an attempt: nothing is held, dropped or bent. Used controls are kept.
  void reset() { closed_ = holds_ = misplaced_ = dropped_ = bent_ = put_back_ = near_ = false; }
  /// An event of the attempt, by its id. A dropped object is advised on until it is held or reset; a slipping thread is not.
  void hear(const std::string& event_id, uint64_t step);
  /// Updates from a snapshot, which may be older than the events heard. Returns whether the held object, or its grasp, has changed.
  bool read(const Reading& reading, uint64_t step);
  /// The present advice; "" for none. `by_mouse`: the mouse is the instrument.
  QString words(bool by_mouse) const;

  /// Controls that the person has used, in this attempt or an earlier one: "drag close drive open side". Their hints are not shown again.
  void set_used(const QString& used) { used_ = used; }
  void use(const QString& control);
  const QString& used() const { return used_; }
  /// The hints needed now. `test`: without those that reveal an answer; `drives`: an object can be pierced; `view`: the present one.
  ControlHints hints(bool test, bool drives, CameraPreset view = CameraPreset::kOrbit) const;

 private:
  QString used_;
  bool closed_ = false;                                       // the person has closed the jaws in this attempt, and not opened them
  bool holds_ = false, misplaced_ = false, dropped_ = false;  // the jaws hold an object; at the wrong place; an object was dropped
  bool bent_ = false, put_back_ = false;                      // a needle is bent; the work was put back in this attempt
  bool near_ = false;                                         // it was at its target once: a needle that is still in its holder is not driven
  uint64_t dropped_at_ = 0;                                   // step of the drop
};

}  // namespace swage::console
