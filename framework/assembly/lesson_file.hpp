// SPDX-License-Identifier: Apache-2.0
//
// A lesson file as read: format "swage-lesson/1", its structure checked, parameters still JSON text. Threads:
// [main].
#pragma once

#include <swage/environment.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assembly/places.hpp"
#include "assembly/settings.hpp"
#include "base/problem.hpp"
#include "host/hand_shaping.hpp"
#include "judge/pull_rule.hpp"

namespace swage::assembly {

/// One plugin of the file with its parameters as JSON text, checked later against the plugin's table.
struct PluginUse {
  std::string plugin;
  std::string params;   // JSON object
  std::string pointer;  // of the JSON object that holds "plugin" and "params": "/objects/1"
};

struct DeviceChoice : PluginUse {
  std::string as;  // name by which it can be chosen, "" for none
};

struct LessonDevice {
  std::string name;
  std::vector<DeviceChoice> choices;  // in order of preference; at least one
  double motion_scale = 1;            // hand movement over scene movement
  double force_scale = 0;             // N at the hand per N in the scene
  swage_pose X_WD0{{0, 0, 0}, {1, 0, 0, 0}};
  host::HandFilters filters;
  std::string clutch_of;  // name of the device whose buttons are the clutch, "" for its own
  host::Reaction reaction;
  host::HandCoupling coupling;
};

struct LessonObject : PluginUse {
  std::string name;
  std::string follow_pose, follow_closure;  // names of devices, "" for none
  swage_pose X_WO{{0, 0, 0}, {1, 0, 0, 0}};
};

struct LessonCoupling : PluginUse {
  std::string name;  // "name", else the last word of the plugin's id, numbered when there are several
  std::string a, b;  // names of objects
};

/// Practice shows cues; a test hides them and counts; a demo is played by the expert's hand and not recorded.
inline constexpr const char* kModes[] = {"practice", "test", "demo"};
/// Mode under which an attempt of a scripted hand is recorded, for any requested mode; judged as a test.
inline constexpr const char* kHandMode = "hand";
inline constexpr uint32_t kAllChannels = 15;

struct LessonFile {
  std::string path;  // as given; "" for text that has no file
  std::string
      beside;        // another file to which FILE parameters are relative: the one this is based on, or ""
  std::string text;  // the assembled text: as read, byte for byte, unless values were set (lesson_text.hpp)
  std::string id, title, summary;
  std::string goal;  // what the trainee learns
  std::string reset_label, reset_tip;  // of the button that resets the work; "": the program's own
  uint64_t seed = 0;
  double rate_hz = 1000;
  double scene_length = 1e-3;  // m
  swage_vec3 gravity{0, 0, -9.80665};
  swage_environment environment = kStillAir;
  std::string environment_text;  // the JSON object of "environment" as written, "" for none
  double max_time_s = 0;          // simulated; 0: no limit
  bool tips_only = false;         // only the tips of instruments are drawn
  std::string view;               // one of snapshot::kViews, "": as the program has it
  judge::PullRule pull;           // of the knot of a passed attempt
  bool mirror = false;            // for the left hand (toolkit/mirror.hpp)
  std::string mode;  // one of kModes, "": the mode of the run, else a test with cues
  uint32_t cues = kAllChannels;   // SWAGE_CHANNEL_* that cues may use when they are shown
  std::vector<std::pair<std::string, std::string>> requirements;  // plugin id, version range
  std::vector<LessonDevice> devices;
  std::vector<LessonObject> objects;
  std::vector<LessonCoupling> couplings;
  PluginUse lesson;
  Places places;        // place of each value, in this file or in one that it is based on
  bool faulty = false;  // the file has an error; assemble() then only looks for further ones

  std::string where(const std::string& pointer) const { return places.where(pointer); }
  /// Folder to which FILE parameters are relative.
  std::string folder() const;
};

/// Reads and checks the structure: syntax, unknown and duplicate keys, types, units, names that refer to each
/// other. Reports all faults. False when one is an error; `out` then has the readable
/// part.
bool read_lesson_file(const std::string& path, LessonFile& out, base::Problems& problems);
/// The same with settings applied: settings.hpp.
bool read_lesson_file(const std::string& path, std::span<const Setting> settings, LessonFile& out,
                      base::Problems& problems);
bool parse_lesson(const std::string& text, const std::string& path, LessonFile& out,
                  base::Problems& problems);

}  // namespace swage::assembly
