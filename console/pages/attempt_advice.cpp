// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/attempt_advice.hpp"

namespace swage::console {

void AttemptAdvice::hear(const std::string& event_id, uint64_t step) {
  if (event_id == "needle.dropped" || event_id == "thing.dropped" || event_id == "ring.dropped") dropped_ = true, dropped_at_ = step;
  if (event_id == "host.reset") dropped_ = false, put_back_ = true;
}

bool AttemptAdvice::read(const Reading& reading, uint64_t step) {
  const bool holds = reading.held.value_or(false), misplaced = holds && reading.spot == false;
  if (holds && step > dropped_at_) dropped_ = false;
  // the lesson remembers a bend; the needle that was put back is straight
  const bool bent = !put_back_ && reading.meanings.contains(QLatin1String("needle.bent"));
  const bool near = near_ || reading.at_target.value_or(true);
  const bool changed = holds != holds_ || misplaced != misplaced_ || bent != bent_ || near != near_;
  near_ = near, holds_ = holds, misplaced_ = misplaced, bent_ = bent;
  return changed;
}

QString AttemptAdvice::words(bool by_mouse) const {
  if (dropped_) return tr("Dropped: put it back with F7, or take it where it lies.");
  if (bent_) return tr("The needle is bent: F7 puts back a straight one, or stop (Shift+F5) and begin anew (F5).");
  if (!misplaced_) return {};
  return by_mouse ? tr("Held at the wrong place: open the jaws (B), and take it at the mark.")
                  : tr("Held at the wrong place: open the jaws, and take it at the mark.");
}

void AttemptAdvice::use(const QString& control) {
  if (!used_.split(QLatin1Char(' ')).contains(control)) used_ += QLatin1Char(' ') + control;
  if (control == QLatin1String("close")) closed_ = true;
  if (control == QLatin1String("open")) closed_ = false;
}

ControlHints AttemptAdvice::hints(bool test, bool drives, CameraPreset view) const {
  const auto wanted = [&](const char* what) { return !used_.contains(QLatin1String(what)); };
  // jaws stay closed when the key is released: who has closed them on nothing is told how to open them
  const bool open = (closed_ && !holds_) || (!test && misplaced_);
  return {wanted("drag"), wanted("close"), drives && holds_ && near_ && wanted("drive"), open && wanted("open"), !test && (dropped_ || bent_),
          drives && wanted("side") ? steps_between(view, CameraPreset::kSide) : 0};
}

}  // namespace swage::console
