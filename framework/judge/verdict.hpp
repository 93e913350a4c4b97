// SPDX-License-Identifier: Apache-2.0
//
// Reports of lessons: names are declared once, numbers are passed while stepping.
#pragma once

#include <swage/abi/lesson.h>

#include <cstdint>
#include <string>
#include <vector>

namespace swage::judge {

/// A declared name; `owner` is the instance that declared it.
struct Name {
  std::string owner, id, unit, doc;
};

/// An event of a step. `event` indexes Script::events.
struct Event {
  uint64_t step = 0;
  uint32_t event = 0;
  uint32_t reserved = 0;
  double value = 0;
};

enum class Outcome : uint32_t { kRunning, kPassed, kFailed, kVoid, kAborted };

/// All names that a scene declares, fixed at activation.
struct Script {
  std::vector<Name> signals, metrics, cues, events, phases;
  struct Mark {
    swage_mark mark;
    std::string meaning;
  };
  std::vector<Mark> marks;
};

/// The running verdict of one attempt. Capacities fixed at activation.
struct Verdict {
  Outcome outcome = Outcome::kRunning;
  uint32_t reason = SWAGE_NONE;  // event index that explains the outcome
  uint32_t phase = SWAGE_NONE;
  uint32_t reserved = 0;
  double score = 0;  // 0..100
  uint64_t finished_step = 0;
  std::vector<double> metric;        // NaN until reported
  std::vector<uint32_t> object_cue;  // SWAGE_NONE: none
  std::vector<uint32_t> mark_cue;
  std::vector<swage_vec3> mark_p_W;
};

const char* text(Outcome outcome);  // "running", "passed", "failed", "void", "aborted"

}  // namespace swage::judge
