// SPDX-License-Identifier: Apache-2.0
//
// The text of a lesson: that of a file, or of one that is another lesson with some values of its own,
//
//     { "format": "swage-lesson/1", "based_on": "110_insertion.json", "id": "...", "title": "...",
//       "set": { "needle.arc": "2/8", "tissue.form": "left slope" } }
//
// and of either with values set from outside. What comes out is whole: it is assembled and recorded, so that an attempt says by
// itself what it was. [main]
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "assembly/settings.hpp"
#include "base/problem.hpp"

namespace swage::assembly {

struct LessonText {
  std::string text;    // "" when there is none to go on with
  std::string beside;  // the file that its relative paths lie beside: at the end of all "based_on"
  bool made = false;   // not the file's own, byte for byte; its lines then say nothing
};

/// Follows "based_on" (relative to the file that says it), at most eight times; then what each file sets, the given one last,
/// then `settings`. False and problems, with places in the file that is wrong: no such file, not JSON, in a circle, nothing of
/// that name to set. A file is then told about as far as it goes.
bool read_lesson_text(const std::string& path, std::span<const Setting> settings, LessonText& out,
                      base::Problems& problems);

/// Reads JSON of at most 4 MiB, nested at most 32 deep. False and problems otherwise, and where a key is there twice; `json` and
/// `line_of` (pointer to line, from 1) then still hold what was read.
bool parse_json(const std::string& text, const std::string& path, nlohmann::ordered_json& json,
                std::map<std::string, uint32_t>& line_of, base::Problems& problems);

/// "lessons/grasp.json:12 #/objects/1/params/arc": path, line of the nearest place that exists, pointer.
std::string place_in(const std::string& path, const std::map<std::string, uint32_t>& line_of,
                     const std::string& pointer);

}  // namespace swage::assembly
