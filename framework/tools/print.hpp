// SPDX-License-Identifier: Apache-2.0
//
// Output of the verbs: results on standard output, problems on standard error. [main]
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <sstream>
#include <string>

#include "base/problem.hpp"

namespace swage::tools {

/// Text from files and people without control sequences of a terminal: control characters become \\xNN, line ends and tabs stay.
std::string printable(const std::string& text);

/// "error: <where>: <message>"
void tell(base::Severity severity, const std::string& where, const std::string& message);
void tell(const base::Problems& problems);

/// Shows the progress of a long task in one line that the next call replaces; "" clears it. Prints nothing without a terminal.
void progress(const std::string& text);

/// Prints an error and returns its exit code: `return problem("...")`.
int problem(const std::string& message);

void print(const nlohmann::ordered_json& json);
nlohmann::ordered_json to_json(const base::Problems& problems);
/// A number as JSON; null for NaN and infinity, which JSON does not have.
nlohmann::ordered_json number(double value);

/// A stream whose numbers have a decimal point and no grouping, even if a plugin changes the locale of the process.
std::ostringstream plain_stream();

/// Value with four digits in the usual unit of its magnitude (base/quantity.hpp): 0.0012 m is "1.2 mm", 2e-6 m "2 um", 0.004 N "4 mN".
std::string quantity_text(double value, const std::string& unit);

std::string format(const char* form, ...) __attribute__((format(printf, 1, 2)));

}  // namespace swage::tools
