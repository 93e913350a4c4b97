// SPDX-License-Identifier: Apache-2.0
//
// From a lesson file to a rig that can be stepped. Threads: [main].
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

/// What played a device while an attempt was recorded.
struct RecordedHand {
  std::string plugin, version;
  uint32_t flags = 0;  // of its swage_device
};

struct Overrides {
  std::string
      device;  // an "as" name ("expert"), a plugin id, or its last word ("mouse"); "": the first choice
  std::string device_params;  // JSON object for the device chosen by name or id, "" for what the file says
  std::string mode = {};  // "practice", "test", "demo" (whose hand is the expert's); "": what the file says
  int32_t eyes = 0;  // SWAGE_EYES_*: how the scene is seen
  std::vector<RecordedHand>
      recorded{};  // of every device, in order: no device plugin is asked; empty: they are
  std::map<std::string, std::string>
      files{};  // path of each file that a lesson names, where it is not beside it
};

/// Creates, configures, places, binds and activates everything. All problems are reported
/// together; nullptr when something is an error. The rig's instances are active; they have not been stepped or reset
/// yet.
std::unique_ptr<host::Rig> assemble(const LessonFile& file, const host::Catalogue& catalogue,
                                    const Overrides& overrides, base::Problems& problems);

}  // namespace swage::assembly
