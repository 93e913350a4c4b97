// SPDX-License-Identifier: Apache-2.0
//
// A file of properties, each with value, unit, status (sourced or assumed) and source: resources/needles, resources/threads. [main]
#pragma once

#include <functional>
#include <map>
#include <string>

namespace swage::properties {

struct Property {
  const char* unit;                 // as the file must write it
  double si;                        // SI units in one of it
  std::function<void(double)> set;  // takes the value in SI units; none: the property is for people
};

/// Reads the "values" of a file whose "format" is given; `noun` is what the file describes, for messages ("needle"). Values are
/// finite and 0 or above. Returns "" or what is wrong, with the path in front.
std::string read_properties(const std::string& path, const std::string& format, const std::string& noun,
                            const std::map<std::string, Property>& known);

}  // namespace swage::properties
