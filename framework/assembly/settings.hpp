// SPDX-License-Identifier: Apache-2.0
//
// Values of a lesson, set from outside: one lesson, many variants. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace swage::assembly {

/// One value. `what`: "needle.arc" (instance and parameter), "lesson.drive" (of the lesson), "environment.charge", or a key of the file itself such
/// as "seed", "mirror" or "title". `value`: JSON; text that is no JSON counts as a string.
struct Setting {
  std::string what, value;
};

/// "grasp" of "swage.coupling.grasp": the name of a coupling that has no other.
std::string last_word(const std::string& plugin_id);

/// Names of a lesson's couplings in their order: "name", else the last word of the plugin's id, numbered where it is taken
/// ("grasp", "grasp_2"); "" for what has neither.
std::vector<std::string> coupling_names(const nlohmann::ordered_json& lesson);

/// "needle.arc=2/8" taken apart; false when it has no '='.
bool parse_setting(const std::string& text, Setting& out);

/// Puts the value into the lesson file; false and a problem when the instance is not there. Whether the parameter exists and
/// bears the value is seen by assemble() as usual. `place` stands before the sentence; `pointers` says where the value is now: of
/// a device every alternative that knows the parameter already, else the first, is set.
bool set_in(nlohmann::ordered_json& file, const Setting& setting, const std::string& place,
            base::Problems& problems, std::vector<std::string>& pointers);

}  // namespace swage::assembly
