// SPDX-License-Identifier: Apache-2.0
//
// One run of one lesson: the only room with threads, and the facade for tools and console.
#pragma once

#include <swage/abi/device.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/problem.hpp"
#include "judge/verdict.hpp"
#include "record/display.hpp"
#include "session/cue_force.hpp"
#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::record {
struct Recording;
}

namespace swage::session {

/// How simulated time relates to the wall clock.
enum class Pace : uint32_t {
  kRealtime,  // 1 kHz, absolute deadlines
  kFastest,   // no clock: scripts, tests, replays; bit-reproducible
};

struct Options {
  std::string lesson_path;
  std::vector<std::string> plugin_dirs;  // before SWAGE_PLUGIN_PATH, the user's folder and the install
  std::string device;  // which hand: an "as" name of the lesson file ("expert"), a plugin id, or its last
                       // word ("mouse"); "" takes the lesson's first choice
  std::string device_params;  // JSON object for it, "" for defaults
  std::vector<std::string>
      settings;  // other values than the file's: "needle.arc=2/8", "seed=7"; kept with the attempt
  std::vector<CuePulse> cue_pulses;  // how cues feel, from a theme; for devices that take forces
  std::string person = "Guest";
  std::string store_path;  // attempts database; "" for the user's own, ":none:" to keep nothing
  std::string
      mode;  // "practice", "test" (no cues), "demo" (the expert's hand, not kept); "": what the file says
  record::Display display;  // how the scene is seen; kept with the attempt, and lessons may ask how many eyes see it
  Pace pace = Pace::kRealtime;
  bool start_paused = false;
  bool safe_mode = false;  // stock plugins only
  double max_time_s = 0;   // simulated; 0: until the lesson finishes
};

using Problem = base::Problem;
using Problems = base::Problems;

/// SWAGE_EYES_* of a display.
int32_t eyes_of(const record::Display& display);

/// How a run ended.
struct Result {
  judge::Outcome outcome = judge::Outcome::kRunning;
  std::string reason;      // event id, e.g. "grasp.dropped"
  std::string attempt_id;  // "" when nothing was kept
  bool not_kept = false;   // it was to be kept and is not: `problems` say why
  std::string kept_beside;  // file with the attempt while its store cannot be written; "" when it is in the store
  double speed = 1;         // simulated over real time; below 1 the machine could not keep up
  double forces_off_s = 0;  // s in which a force guard stood switched off after a fault
  uint64_t missing_steps = 0;  // of what is kept: a replay ends at the first of them
  double score = 0;
  double simulated_s = 0;
  uint64_t steps = 0;
  uint64_t hash = 0;  // of the last step
  struct Metric {
    std::string id, unit, doc;
    double value = 0;
  };
  std::vector<Metric> metrics;
  snapshot::LoopHealth health;
  Problems problems;
};

/// All methods are [main] unless said otherwise. One object, one attempt.
class Session {
 public:
  /// Loads, checks and assembles. On failure returns nullptr and says why in `problems`.
  static std::unique_ptr<Session> open(const Options&, Problems& problems);
  virtual ~Session() = default;

  virtual const snapshot::SceneCard& card() const = 0;
  virtual void start() = 0;  // starts the threads; returns at once
  virtual void pause(bool on) = 0;
  virtual void reset_object(const std::string& object_name) = 0;  // back to its start, counted and recorded
  virtual void mark(const std::string& note) = 0;                 // remembers the moment two seconds ago
  /// New values of LIVE parameters, as a JSON object like in a lesson file: {"friction": 0.2}. Checked, then taken over at a
  /// step boundary and recorded. False and `problems` when something is wrong; then nothing changes.
  virtual bool change(const std::string& instance_name, const std::string& params_json,
                      Problems& problems) = 0;
  virtual void stop() = 0;            // the attempt ends as aborted unless it had finished; joins the threads
  virtual bool finished() const = 0;  // [any]
  virtual void wait() = 0;            // until finished or stopped

  virtual void pointer(const swage_pointer&) = 0;  // [any one thread] accumulates until the next step
  virtual bool latest(
      snapshot::Snapshot& out) const = 0;          // [any] newest whole snapshot; false before the first
  virtual bool next_event(judge::Event& out) = 0;  // [one reader] false when the ring is empty
  virtual Result result() const = 0;               // complete once finished or stopped
};

/// What stepping a recorded attempt again gave.
struct Replay {
  uint64_t steps = 0;  // compared
  bool identical = false;
  uint64_t first_difference = 0;  // step number; when not identical
  std::string reason;  // why stepping ended early or which object differs, "" when it cannot be known
  /// What the lesson says now, having seen every step; its outcome is kRunning where the attempt was ended from outside.
  Result verdict;
  std::vector<std::pair<std::string, std::string>> plugins;  // id, version of everything in the scene now
};

/// Builds the scene from the recording's own descriptor, steps it without a clock on the recorded samples and
/// commands, and compares the hash of every step. False and `problems` when it cannot be built (a plugin is
/// missing). `to_the_end`: goes on where the bits differ, for the verdict of the lesson as it is now. [main]
bool replay(const record::Recording&, const std::vector<std::string>& plugin_dirs, Replay& out,
            Problems& problems, bool to_the_end = false);

}  // namespace swage::session
