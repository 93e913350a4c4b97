// SPDX-License-Identifier: Apache-2.0
//
// Takes the reports of a lesson while it observes, and keeps the running verdict of the attempt.
#pragma once

#include <cstdint>
#include <vector>

#include "judge/verdict.hpp"

namespace swage::judge {

/// Range of the script's names that belong to the lesson: it counts its own from 0.
struct Owned {
  uint32_t first = 0, count = 0;
};

/// Built on [main]; everything else on [rt] and wait-free. An index out of range or a number that is not
/// finite is a mistake of the lesson: it changes nothing and is counted.
class Referee {
 public:
  Referee() = default;
  Referee(const Referee&) = delete;
  Referee& operator=(const Referee&) = delete;

  /// Sizes the verdict for a script. `object_count`: objects of the scene. [main]
  void prepare(const Script&, Owned metric, Owned cue, Owned event, Owned phase, uint32_t object_count);

  /// Clears the verdict. [rt]
  void clear() noexcept;

  /// The table to pass to observe(); reports through it get this step number. [rt]
  const swage_verdict* begin(uint64_t step) noexcept;

  /// Ends the attempt from outside, e.g. as void. The first end is kept. [rt]
  void finish(Outcome, double score, uint32_t reason, uint64_t step) noexcept;

  const Verdict& verdict() const noexcept { return verdict_; }
  uint64_t mistakes() const noexcept { return mistakes_; }

  /// Events reported since begin(), in order; global indices.
  const std::vector<Event>& events() const noexcept { return events_; }

  /// For restoring a saved verdict of the same script; sizes do not change. [main or rt, between steps]
  Verdict& saved() noexcept { return verdict_; }

 private:
  static Referee& self(const swage_verdict* table) { return *static_cast<Referee*>(table->host_data); }
  static void on_cue(const swage_verdict*, uint32_t object, uint32_t cue);
  static void on_mark(const swage_verdict*, uint32_t mark, uint32_t cue, const swage_vec3* p_W);
  static void on_metric(const swage_verdict*, uint32_t metric, double value);
  static void on_event(const swage_verdict*, uint32_t event, double value);
  static void on_phase(const swage_verdict*, uint32_t phase);
  static void on_finish(const swage_verdict*, int32_t passed, double score, uint32_t reason);

  bool owns(const Owned& range, uint32_t index) noexcept;  // counts the mistake otherwise

  swage_verdict table_{};
  Owned metric_, cue_, event_, phase_;
  Verdict verdict_;
  std::vector<Event> events_;
  std::vector<swage_vec3> mark_start_;
  uint64_t step_ = 0;
  uint64_t mistakes_ = 0;
};

}  // namespace swage::judge
