// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Times at which strokes of keys take effect. While a slow picture is painted, events wait: a press is handled late, and often its release with
// it. All keys that are down share one delay, that of the press that was handled latest, so that each key and each modifier lasts as long as
// the person held it, in the same order. The session waits for these times, on its own thread: a timer of the window would be late by a picture.
#pragma once

#include <algorithm>
#include <cstdint>

namespace swage::console {

class KeyTimes {
 public:
  enum class Kind { kPress, kRelease, kModifier };

  /// Time of base::wall_ns() at which an event takes effect; 0: at once. `down`: a key was down before it; `event_ns`: of the events' own
  /// clock; `now_ns`: of base::wall_ns().
  int64_t due_ns(Kind kind, bool down, int64_t event_ns, int64_t now_ns) {
    const int64_t late = now_ns - event_ns;  // and the difference of the clocks, which cancels out
    if (!down && last_ns_ <= now_ns) {
      if (kind == Kind::kPress) delay_ns_ = late;
      return 0;
    }
    if (kind == Kind::kPress) delay_ns_ = std::max(delay_ns_, late);
    const int64_t early = std::clamp(delay_ns_ - late, int64_t{0}, kLongest_ns);
    if (early < kUnfelt_ns && last_ns_ <= now_ns) return 0;
    last_ns_ = std::max(last_ns_, now_ns + early);
    return last_ns_;
  }

 private:
  static constexpr int64_t kUnfelt_ns = 20'000'000;     // an event that takes effect this much too early is not felt
  static constexpr int64_t kLongest_ns = 1'000'000'000;  // longer than a picture takes: the clock of the events may have jumped
  int64_t delay_ns_ = 0;
  int64_t last_ns_ = 0;  // latest time that was told
};

}  // namespace swage::console
