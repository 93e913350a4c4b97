// SPDX-License-Identifier: Apache-2.0
//
// Values of a lesson that are set from outside: one lesson, many variants. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace swage::assembly {

/// One value. `what`: "needle.arc" (instance and parameter), "lesson.drive" (of the lesson), "environment.charge", or a key of the file
/// such as "seed", "mirror" or "title". `value`: JSON; other text counts as a string.
struct Setting {
  std::string what, value;
};

/// "grasp" of "swage.coupling.grasp": the default name of a coupling.
std::string last_word(const std::string& plugin_id);

/// Names of a lesson's couplings in their order: "name", else the last word of the plugin's id, numbered where it is in use
/// ("grasp", "grasp_2"); "" for one with neither.
std::vector<std::string> coupling_names(const nlohmann::ordered_json& lesson);

/// Splits "needle.arc=2/8"; false when it has no '='.
bool parse_setting(const std::string& text, Setting& out);

/// Sets the value in the lesson file; false and a problem when there is no such instance. assemble() checks as usual that the parameter
/// exists and admits the value. `place` is Problem::where; `pointers` receives where the value was set: in
/// a device every alternative that has the parameter already, else the first.
bool set_in(nlohmann::ordered_json& file, const Setting& setting, const std::string& place,
            base::Problems& problems, std::vector<std::string>& pointers);

}  // namespace swage::assembly
