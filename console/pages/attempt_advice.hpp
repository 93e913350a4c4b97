// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a person is told during an attempt besides what its phase asks: that what has fallen can be put back, that what is held at the
// wrong place is let go of, and how the mouse does what it has not done yet. [main]
#pragma once

#include <QCoreApplication>
#include <QString>
#include <cstdint>
#include <string>

#include "console/models/reading.hpp"
#include "console/view3d/scene_input.hpp"

namespace swage::console {

class AttemptAdvice {
  Q_DECLARE_TR_FUNCTIONS(AttemptAdvice)
 public:
  /// Before an attempt: nothing is held, nothing has fallen. What was used stays known.
  void reset() { holds_ = misplaced_ = dropped_ = false; }
  /// An event of the attempt, by its id. What falls is told until it is held or back again; a thread that slips is not put back.
  void hear(const std::string& event_id, uint64_t step);
  /// The newest picture, which may be older than what was heard. Returns whether what is held, or where, has changed.
  bool read(const Reading& reading, uint64_t step);
  /// What to do now; "" for nothing. `by_mouse`: the mouse is the instrument.
  QString words(bool by_mouse) const;

  /// Controls that the person has used, in this attempt or an earlier one: "drag close drive open". Their hints are not shown again.
  void set_used(const QString& used) { used_ = used; }
  void use(const QString& control) { used_ += QLatin1Char(' ') + control; }
  const QString& used() const { return used_; }
  /// Each control is told when it is needed. `test`: without what tells an answer; `drives`: something can be pierced.
  ControlHints hints(bool test, bool drives) const;

 private:
  QString used_;
  bool holds_ = false, misplaced_ = false, dropped_ = false;  // now: jaws hold something, at the wrong place; it has fallen
  uint64_t dropped_at_ = 0;                                   // step
};

}  // namespace swage::console
