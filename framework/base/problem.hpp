// SPDX-License-Identifier: Apache-2.0
//
// A problem reported to a person: place, fault, allowed values, remedy.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace swage::base {

enum class Severity : int32_t { kNote, kWarning, kError };

struct Problem {
  Severity severity = Severity::kError;
  std::string
      where;  // "lessons/grasp.json #/objects/1/params/wire_diameter", a plugin's path, an instance's name
  std::string message;  // one or more sentences; the remedy last
};

using Problems = std::vector<Problem>;

/// True when the list contains an error.
inline bool failed(const Problems& problems) {
  for (const Problem& p : problems)
    if (p.severity == Severity::kError) return true;
  return false;
}

}  // namespace swage::base
