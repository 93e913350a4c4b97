// SPDX-License-Identifier: Apache-2.0
//
// The text of a lesson: that of a file, or of a file that modifies another lesson,
//
//     { "format": "swage-lesson/1", "based_on": "110_insertion.json", "id": "...", "title": "...",
//       "remove": ["tray"], "add": { "objects": [ ... ], "couplings": [ ... ], "devices": [ ... ] },
//       "set": { "needle.arc": "2/8", "tissue.form": "left slope" } }
//
// and of either with settings. The result is a complete lesson: it is assembled and recorded, so that an attempt
// can be understood without further files. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "assembly/places.hpp"
#include "assembly/settings.hpp"
#include "base/problem.hpp"

namespace swage::assembly {

struct LessonText {
  std::string text;             // "" when it cannot be used
  nlohmann::ordered_json json;  // the same, parsed
  bool readable = false;        // `json` is the content of the file, possibly with faults
  std::string beside;           // the file to which its paths are relative: the last one of "based_on"
  bool made = false;            // modified: not byte for byte the file's text
  Places places;                // place of each value
};

/// Follows "based_on" (relative to the file that has it), at most eight times; then applies what each file removes, adds and sets,
/// the given file last, then `settings`. False and problems, with places in the faulty file: no such file, not JSON, circular, no part of
/// that name. The faulty file is then checked as far as possible.
bool read_lesson_text(const std::string& path, std::span<const Setting> settings, LessonText& out,
                      base::Problems& problems);

/// The same for a complete text. `path` names it in problems.
bool parse_lesson_text(const std::string& text, const std::string& path, LessonText& out,
                       base::Problems& problems);

}  // namespace swage::assembly
