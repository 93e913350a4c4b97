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

/// Relation of simulated time to the wall clock.
enum class Pace : uint32_t {
  kRealtime,  // 1 kHz, absolute deadlines
  kFastest,   // no clock: scripts, tests, replays; bitwise reproducible
};

struct Options {
  std::string lesson_path;
  std::vector<std::string> plugin_dirs;  // searched before SWAGE_PLUGIN_PATH, the user's folder and the install
  std::string device;  // the hand: an "as" name of the lesson file ("expert"), a plugin id, or its last
                       // word ("mouse"); "" takes the lesson's first choice
  std::string device_params;  // JSON object for it, "" for defaults
  std::vector<std::string>
      settings;  // values that replace those of the file: "needle.arc=2/8", "seed=7"; stored with the attempt
  std::vector<CuePulse> cue_pulses;  // pulses of cues, from a theme; for devices that take forces
  std::string person = "Guest";
  std::string store_path;  // attempts database; "" for the user's own, ":none:" to store nothing
  std::string
      mode;  // "practice", "test" (no cues), "demo" (the expert's hand, not recorded); "": the mode of the file
  record::Display display;  // how the scene is displayed; stored with the attempt, and lessons may query how many eyes see it
  Pace pace = Pace::kRealtime;
  bool start_paused = false;
  bool safe_mode = false;  // stock plugins only
  double max_time_s = 0;   // simulated; 0: until the lesson finishes
  std::string pull_lesson;  // file of lesson 139, in which a knot is pulled (knot_copy.hpp); "": beside the lesson
};

/// The pull of a knot after its attempt, so far.
struct PullProgress {
  double bears = 0, load = 0;  // N; load: up to which it is pulled
};

using Problem = base::Problem;
using Problems = base::Problems;

/// SWAGE_EYES_* of a display.
int32_t eyes_of(const record::Display& display);

/// Result of a run.
struct Result {
  judge::Outcome outcome = judge::Outcome::kRunning;
  std::string reason;      // event id, e.g. "grasp.dropped"
  std::string attempt_id;  // "" when nothing was stored
  bool not_kept = false;   // it should have been stored but is not: the reason is in `problems`
  std::string kept_beside;  // file with the attempt while its store cannot be written; "" when it is in the store
  double speed = 1;         // simulated over real time; below 1 the machine could not keep up
  double forces_off_s = 0;  // s during which a force guard was switched off after a fault
  uint64_t missing_steps = 0;  // in the stored attempt: a replay ends at the first of them
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
  /// Loads, checks and assembles. On failure returns nullptr, with the reasons in `problems`.
  static std::unique_ptr<Session> open(const Options&, Problems& problems);
  virtual ~Session() = default;

  virtual const snapshot::SceneCard& card() const = 0;
  virtual void start() = 0;  // starts the threads; returns at once
  virtual void pause(bool on) = 0;
  virtual void reset_object(const std::string& object_name) = 0;  // resets it to its start, counted and recorded
  virtual void mark(const std::string& note) = 0;                 // marks the moment two seconds ago
  /// Sets LIVE parameters, from a JSON object as in a lesson file: {"friction": 0.2}. Checked, then applied at a
  /// step boundary and recorded. False and `problems` when a value is invalid; then nothing changes.
  virtual bool change(const std::string& instance_name, const std::string& params_json,
                      Problems& problems) = 0;
  virtual void stop() = 0;            // ends the attempt as aborted unless it had finished; joins the threads
  virtual bool finished() const = 0;  // [any]
  virtual void wait() = 0;            // until finished or stopped, and its knot pulled
  /// Once finished: pulls the knot of an attempt that was passed where the lesson asks for it, by so many steps at most. False when nothing is
  /// left to do. Who calls stop() instead of going on gets a result without it.
  virtual bool pull_knot(uint64_t most_steps, PullProgress& out) = 0;

  /// Movements accumulate until the next step. `due_ns`: time of base::wall_ns() until which this input waits, and all that comes behind it.
  /// A window that handles a stroke of a key late so tells for how long the key was down. [any one thread]
  virtual void pointer(const swage_pointer& input, int64_t due_ns) = 0;
  void pointer(const swage_pointer& input) { pointer(input, 0); }
  virtual bool latest(
      snapshot::Snapshot& out) const = 0;          // [any] newest whole snapshot; false before the first
  virtual bool next_event(judge::Event& out) = 0;  // [one reader] false when the ring is empty
  virtual Result result() const = 0;               // complete once finished or stopped
};

/// Result of stepping a recorded attempt again.
struct Replay {
  uint64_t steps = 0;  // compared
  bool identical = false;
  uint64_t first_difference = 0;  // step number; when not identical
  std::string reason;  // cause of an early end, or the object that differs, "" when unknown
  /// Verdict of the present lesson after all steps; its outcome is kRunning where the attempt was ended from outside.
  Result verdict;
  std::vector<std::pair<std::string, std::string>> plugins;  // id, version of all plugins in the scene now
};

/// Builds the scene from the recording's own descriptor, steps it without a clock on the recorded samples and
/// commands, and compares the hash of every step. False and `problems` when it cannot be built (a plugin is
/// missing). [main]
bool replay(const record::Recording&, const std::vector<std::string>& plugin_dirs, Replay& out, Problems& problems);

/// The same, for the verdict of the present lesson: continues where the bits differ, and pulls the knot where the lesson asks for it. `pull_lesson`: as
/// in Options. [main]
bool judge_again(const record::Recording&, const std::vector<std::string>& plugin_dirs, const std::string& pull_lesson, Replay& out,
                 Problems& problems);

}  // namespace swage::session
