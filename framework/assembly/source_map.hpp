// SPDX-License-Identifier: Apache-2.0
//
// The line of each value in a JSON text, which the parser does not keep. [main]
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace swage::assembly {

// Limits: a lesson has some hundred values with keys of some letters; a text beyond these limits is no lesson, and reporting
// each of its values would take minutes.
inline constexpr std::size_t kMostValues = 20'000;
inline constexpr std::size_t kMostKey = 200;

struct SourceMap {
  std::size_t values = 0;
  bool cut = false;  // more than kMostValues, or a key longer than kMostKey: the rest was not read
  std::map<std::string, uint32_t> line_of;                       // JSON pointer -> line, 1-based
  std::vector<std::pair<std::string, std::string>> double_keys;  // pointer of the object, key
};

/// Deepest nesting of brackets in a text, valid JSON or not.
uint32_t nesting(const std::string& text);

/// Maps a text that is valid JSON, nested at most 64 deep.
SourceMap map_source(const std::string& json_text);

/// A key as one step of a JSON pointer: "~" and "/" are escaped.
std::string pointer_step(const std::string& key);

}  // namespace swage::assembly
