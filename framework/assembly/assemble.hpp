// SPDX-License-Identifier: Apache-2.0
//
// Assembles the rig for a lesson file. Threads: [main].
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assembly/lesson_file.hpp"
#include "base/problem.hpp"
#include "host/catalogue.hpp"
#include "host/rig.hpp"

namespace swage::assembly {

/// The device that was used while an attempt was recorded.
struct RecordedHand {
  std::string plugin, version;
  uint32_t flags = 0;  // of its swage_device
};

struct Overrides {
  std::string
      device;  // an "as" name ("expert"), a plugin id, or its last word ("mouse"); "": the first choice
  std::string device_params;  // JSON object for the device chosen by name or id, "" for that of the file
  std::string mode = {};  // "practice", "test", "demo" (the expert's hand); "": the mode of the file
  int32_t eyes = 0;  // SWAGE_EYES_*: how the scene is displayed
  std::vector<RecordedHand>
      recorded{};  // of every device, in order: no device plugin is used; empty: device plugins are used
  std::map<std::string, std::string>
      files{};  // path of each file that a lesson names, where it is not relative to the lesson
};

/// Creates, configures, places, binds and activates all instances. All problems are reported
/// together; nullptr when one of them is an error. The rig's instances are active, but not yet stepped or
/// reset.
std::unique_ptr<host::Rig> assemble(const LessonFile& file, const host::Catalogue& catalogue,
                                    const Overrides& overrides, base::Problems& problems);

}  // namespace swage::assembly
