// SPDX-License-Identifier: Apache-2.0
//
// Records one attempt while it runs. The step pushes fixed-size records into a ring; a writer thread
// compresses them to chunks of a quarter of a second and commits each, so that killing the program loses at
// most that much.
#pragma once

#include <swage/abi/device.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/problem.hpp"
#include "judge/verdict.hpp"
#include "record/display.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::record {

/// The hand that used a device. In a replay the device is not called; its flags tell how to read the samples.
struct HandInfo {
  std::string name,
      choice;  // of the device in the lesson; selected alternative ("expert", "" without a name)
  std::string plugin, version, params;  // params: JSON object
  uint32_t flags = 0;                   // of its swage_device
};

/// A file that the lesson names in a parameter, stored so that the attempt can be understood and replayed elsewhere.
struct FileInfo {
  std::string name;   // as in the lesson
  std::string bytes;  // its content at that time
};

/// Identification of an attempt; written before the first step.
struct AttemptInfo {
  std::string person = "Guest";
  std::string lesson_id, lesson_title, mode, device;
  std::string descriptor_text, descriptor_path;
  std::vector<std::pair<std::string, std::string>> plugins;  // id, version of every instance, in order
  std::vector<std::string> devices;                          // names, in the order of StepRecord::sample
  std::vector<HandInfo> hands;                               // one per device; empty in attempts of format 1
  std::vector<FileInfo> files;
  Display display;  // at the beginning of the attempt
  judge::Script script;
  uint64_t seed = 0;
  double dt = 1e-3;  // s
  bool realtime =
      false;  // true: a full ring drops and counts; false: step() waits for the writer, nothing is lost
  bool synthetic = false;  // its numbers are random, not measured
};

/// A command that changed the scene, applied at the start of the step with that number.
struct CommandRecord {
  uint64_t step = 0;
  uint32_t kind = 0;                // step::CommandKind
  uint32_t object = 0;              // index of the object, or SWAGE_NONE; ordinal of the instance for a live parameter
  uint32_t parameter = SWAGE_NONE;  // of a live parameter: index into the plugin's table
  uint32_t reserved = 0;
  double number[4] = {0, 0, 0, 0};  // its value, SI
};

/// One step: the data needed for a replay, and the signals of the instructor's plots. The counts are those of the
/// attempt: AttemptInfo::devices and AttemptInfo::script.signals.
struct StepRecord {
  uint64_t step = 0;
  uint64_t hash = 0;  // of the state after the step
  uint32_t n_device = 0, n_signal = 0;
  swage_sample sample[snapshot::kMaxDevices];
  double signal[snapshot::kMaxSignals];
};

/// How the attempt ended.
struct AttemptEnd {
  judge::Outcome outcome = judge::Outcome::kRunning;
  std::string reason;
  double score = 0, simulated_s = 0;
  bool is_void = false;
  std::vector<double> metric;  // in the order of script.metrics, NaN: not reported
  snapshot::LoopHealth health;
  double forces_off_s = 0;  // s during which a force guard was switched off
};

/// Where a finished attempt was stored; read back from the disk, not remembered.
struct Kept {
  enum class Where : uint8_t { kNowhere, kBeside, kStore };
  Where where = Where::kNowhere;
  std::string file;           // kBeside: the journal, which the store merges when it is next opened
  uint64_t missing_steps = 0;  // a replay ends at the first of them
};

/// Problem::where of problems about the record begins with this word.
inline constexpr std::string_view kRecordPlace = "record ";

class Recorder {
 public:
  /// Opens the store, writes the attempt as "running" and starts the writer thread. [main]
  /// A locked store, a full disk or a server that does not respond falls back to a journal file, reported in `problems`.
  static std::unique_ptr<Recorder> open(const std::string& store_path, const AttemptInfo&,
                                        base::Problems& problems);
  virtual ~Recorder() = default;

  virtual void step(
      const StepRecord&) noexcept = 0;  // [rt] wait-free; a full ring drops and counts (realtime)
  virtual void event(const judge::Event&) noexcept = 0;           // [rt] wait-free
  virtual void command(const CommandRecord&) noexcept = 0;        // [rt] wait-free
  virtual void note(uint64_t step, const std::string& text) = 0;  // [main] a person's note on a moment
  virtual void finish(const AttemptEnd&) = 0;  // [main] flushes, checkpoints, joins the writer
  virtual Kept kept() const = 0;               // [main] once finished
  virtual void discard() = 0;                  // [main] instead of finish(): nothing is stored
  virtual std::string attempt_id() const = 0;  // [any]
  virtual uint64_t dropped() const = 0;        // [any] records lost: ring or disk full
  virtual bool healthy() const = 0;            // [any] false once writing failed
  virtual base::Problems problems() = 0;       // [main] problems since the last call
};

/// The data of a recorded attempt that a replay needs, read back. As columns, because a quarter of an hour
/// has 900 000 steps. At most 900 MB of them are read: an hour of one hand.
struct Recording {
  AttemptInfo info;
  std::vector<uint64_t> step, hash;  // one each per recorded step; a jump in `step` is a gap
  std::vector<swage_sample> sample;  // info.devices.size() per step, bit-exact
  std::vector<float> signal;         // info.script.signals.size() per step, rounded to single precision
  std::vector<CommandRecord> commands;
  std::vector<judge::Event> events;  // of the script; notes and gaps are in Store::events
};

/// Reads an attempt from a store, or from a file that Store::export_attempt wrote (then `attempt_id` may be
/// ""). [main]
bool read_recording(const std::string& store_or_file, const std::string& attempt_id, Recording&,
                    std::string& error);

/// The same check without storing the data: false with a sentence when it could not be read. Needs little memory for any length. [main]
bool check_recording(const std::string& store_or_file, const std::string& attempt_id, std::string& error);

}  // namespace swage::record
