// SPDX-License-Identifier: Apache-2.0
//
// The text of a lesson: that of a file, or of one that is another lesson with some values of its own,
//
//     { "format": "swage-lesson/1", "based_on": "110_insertion.json", "id": "...", "title": "...",
//       "remove": ["tray"], "add": { "objects": [ ... ], "couplings": [ ... ], "devices": [ ... ] },
//       "set": { "needle.arc": "2/8", "tissue.form": "left slope" } }
//
// and of either with values set from outside. The result is a whole lesson: it is assembled and recorded, so that an attempt
// needs no other file to be understood. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "assembly/places.hpp"
#include "assembly/settings.hpp"
#include "base/problem.hpp"

namespace swage::assembly {

struct LessonText {
  std::string text;             // "" when there is none to go on with
  nlohmann::ordered_json json;  // the same, parsed
  bool readable = false;        // `json` is what the file says, though perhaps with faults
  std::string beside;           // the file that its relative paths lie beside: at the end of all "based_on"
  bool made = false;            // not the file's own, byte for byte
  Places places;                // where each value is written
};

/// Follows "based_on" (relative to the file that says it), at most eight times; then what each file removes, adds and sets,
/// the given one last, then `settings`. False and problems, with places in the file that is wrong: no such file, not JSON, in a circle, nothing of
/// that name to set. A file is then told about as far as it goes.
bool read_lesson_text(const std::string& path, std::span<const Setting> settings, LessonText& out,
                      base::Problems& problems);

/// The same of a text that is whole. `path` is what it is called.
bool parse_lesson_text(const std::string& text, const std::string& path, LessonText& out,
                       base::Problems& problems);

}  // namespace swage::assembly
