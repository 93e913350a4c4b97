// SPDX-License-Identifier: Apache-2.0
//
// A lesson file with other values: one lesson, many variants. The changed text is what is assembled and recorded, so that an
// attempt says by itself what it was. [main]
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace swage::assembly {

/// One value. `what`: "needle.arc" (instance and parameter), "lesson.drive" (of the lesson), or a key of the file itself such
/// as "seed", "mirror" or "title". `value`: JSON; text that is no JSON counts as a string.
struct Setting {
  std::string what, value;
};

/// "needle.arc=2/8" taken apart; false when it has no '='.
bool parse_setting(const std::string& text, Setting& out);

/// The text with the settings in it, or "" and `problems`: not JSON, an instance that is not there. Whether the parameter exists
/// and bears the value is seen by assemble() as usual. `name` stands in messages. Of a device every alternative that knows the
/// parameter already, else the first, is set.
std::string with_settings(const std::string& text, std::span<const Setting> settings, const std::string& name,
                          base::Problems& problems);

}  // namespace swage::assembly
