// SPDX-License-Identifier: Apache-2.0
//
// How verbs speak: results on standard output, problems on standard error. [main]
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <sstream>
#include <string>

#include "base/problem.hpp"

namespace swage::tools {

/// Text from files and people, without what a terminal would obey: control characters become \\xNN, line ends and tabs stay.
std::string printable(const std::string& text);

/// "error: <where>: <message>"
void tell(base::Severity severity, const std::string& where, const std::string& message);
void tell(const base::Problems& problems);

/// How far a long work is, in one line that the next one replaces; "" clears it. Nothing where nobody watches.
void progress(const std::string& text);

/// An error, and the exit code that goes with it: `return problem("...")`.
int problem(const std::string& message);

void print(const nlohmann::ordered_json& json);
nlohmann::ordered_json to_json(const base::Problems& problems);
/// NaN and infinity have no JSON: null.
nlohmann::ordered_json number(double value);

/// A stream whose numbers have a point and no groups, whatever a plugin makes of the locale of the process.
std::ostringstream plain_stream();

/// Four digits in the unit that people use at this scale (base/quantity.hpp): 0.0012 m is "1.2 mm", 2e-6 m "2 um", 0.004 N "4 mN".
std::string quantity_text(double value, const std::string& unit);

std::string format(const char* form, ...) __attribute__((format(printf, 1, 2)));

}  // namespace swage::tools
