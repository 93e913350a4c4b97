// SPDX-License-Identifier: Apache-2.0
//
// The place of each value of a lesson; a variant has values from several files. [main]
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace swage::assembly {

class Places {
 public:
  /// All values are in one file. `path` is the lesson's path, `file` the file of its lines: the last one of "based_on".
  Places(std::string path = "", std::string file = "", std::map<std::string, uint32_t> line_of = {});

  /// Sets the place of the value at a pointer, with all values below it.
  void move(const std::string& pointer, const std::string& place);

  /// The element `at` of the list at a pointer, which had `count`, has been removed: the indices after it decrease by one.
  void close_gap(const std::string& list, std::size_t at, std::size_t count);

  /// "lessons/grasp.json:12 #/objects/1/params/arc": file and line of the nearest existing value, and the pointer.
  std::string where(const std::string& pointer) const;

 private:
  std::map<std::string, std::string> below(const std::string& pointer) const;  // the places of the value and of each value below it

  std::string path_, file_;
  std::map<std::string, uint32_t> line_of_;   // JSON pointer -> line, 1-based
  std::map<std::string, std::string> moved_;  // JSON pointer -> place
};

}  // namespace swage::assembly
