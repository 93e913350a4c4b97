// SPDX-License-Identifier: Apache-2.0
//
// Where each value of a lesson is written; a variant has values from several files. [main]
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace swage::assembly {

class Places {
 public:
  /// Everything is in one file. `path` is what the lesson is called, `file` where its lines are: that at the end of "based_on".
  Places(std::string path = "", std::string file = "", std::map<std::string, uint32_t> line_of = {});

  /// The value at a pointer, with all below it, is written at `place`.
  void move(const std::string& pointer, const std::string& place);

  /// The element `at` of the list at a pointer, which had `count`, has been removed: the elements behind it move up.
  void close_gap(const std::string& list, std::size_t at, std::size_t count);

  /// "lessons/grasp.json:12 #/objects/1/params/arc": file and line of the nearest place that exists, pointer there.
  std::string where(const std::string& pointer) const;

 private:
  std::map<std::string, std::string> below(const std::string& pointer) const;  // the place of it and of each value below it

  std::string path_, file_;
  std::map<std::string, uint32_t> line_of_;   // JSON pointer -> line, 1-based
  std::map<std::string, std::string> moved_;  // JSON pointer -> place
};

}  // namespace swage::assembly
