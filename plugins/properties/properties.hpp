// SPDX-License-Identifier: Apache-2.0
//
// A file of properties, each with value, unit, status (sourced or assumed) and source: resources/needles, resources/threads. [main]
#pragma once

#include <functional>
#include <map>
#include <string>

namespace swage::properties {

struct Property {
  const char* unit;                 // unit that the file must use
  double si;                        // value of this unit in SI units
  std::function<void(double)> set;  // takes the value in SI units; empty: the property is for the reader only
};

/// Reads the "values" of a file whose "format" is given; `noun` names the described object in messages ("needle"). Values are
/// finite and 0 or above. Returns "" or the fault, with the path in front.
std::string read_properties(const std::string& path, const std::string& format, const std::string& noun,
                            const std::map<std::string, Property>& known);

}  // namespace swage::properties
