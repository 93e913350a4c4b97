// SPDX-License-Identifier: Apache-2.0
//
// A lesson file as read: format "swage-lesson/1", its structure checked, parameters still text. Threads:
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

namespace swage::assembly {

/// One plugin of the file with its parameters as JSON text, checked later against the plugin's table.
struct PluginUse {
  std::string plugin;
  std::string params;   // JSON object
  std::string pointer;  // of the JSON object that holds "plugin" and "params": "/objects/1"
};

struct DeviceChoice : PluginUse {
  std::string as;  // name to choose it by, "" for none
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

/// Practice shows cues, a test does not and counts, a demo is the expert's hand and is not kept.
inline constexpr const char* kModes[] = {"practice", "test", "demo"};
/// What an attempt of a scripted hand is kept as, whatever it was asked for; judged as a test.
inline constexpr const char* kHandMode = "hand";
inline constexpr uint32_t kAllChannels = 15;

struct LessonFile {
  std::string path;  // as given; "" for text that has no file
  std::string
      beside;        // another file that relative FILE parameters lie beside: the one this is based on, or ""
  std::string text;  // what is assembled: as read, byte for byte, unless something was set (lesson_text.hpp)
  std::string id, title, summary;
  std::string goal;  // what the trainee learns
  uint64_t seed = 0;
  double rate_hz = 1000;
  double scene_length = 1e-3;  // m
  swage_vec3 gravity{0, 0, -9.80665};
  swage_environment environment = kStillAir;
  std::string environment_text;  // the JSON object of "environment" as written, "" for none
  double max_time_s = 0;          // simulated; 0: no limit
  bool tips_only = false;         // of instruments only the tips are drawn
  bool mirror = false;            // for the left hand (toolkit/mirror.hpp)
  std::string mode;  // one of kModes, "": as the run says, and else a test with cues
  uint32_t cues = kAllChannels;   // SWAGE_CHANNEL_* that cues may use while they are shown
  std::vector<std::pair<std::string, std::string>> requirements;  // plugin id, version range
  std::vector<LessonDevice> devices;
  std::vector<LessonObject> objects;
  std::vector<LessonCoupling> couplings;
  PluginUse lesson;
  Places places;        // where each value is written, in this file or in one that it is based on
  bool faulty = false;  // something in it is an error; assemble() then only looks for more

  std::string where(const std::string& pointer) const { return places.where(pointer); }
  /// Relative FILE parameters start there.
  std::string folder() const;
};

/// Reads and checks the structure: syntax, unknown and double keys, types, units, names that refer to each
/// other. Reports everything that is wrong. False when something is an error; `out` then holds what could be
/// read.
bool read_lesson_file(const std::string& path, LessonFile& out, base::Problems& problems);
/// The same with other values: settings.hpp.
bool read_lesson_file(const std::string& path, std::span<const Setting> settings, LessonFile& out,
                      base::Problems& problems);
bool parse_lesson(const std::string& text, const std::string& path, LessonFile& out,
                  base::Problems& problems);

}  // namespace swage::assembly
