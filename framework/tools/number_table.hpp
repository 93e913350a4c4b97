// SPDX-License-Identifier: Apache-2.0
//
// Tables of numbers as people write them: rows of numbers between commas, semicolons, tabs or spaces; # begins a remark. [main]
#pragma once

#include <string>
#include <vector>

namespace swage::tools {

/// One row; false when a word of it is no number.
bool read_numbers(const std::string& text, std::vector<double>& out);
/// Every row has so many numbers; a first row of words is a heading. "" or file, line and what is wrong.
std::string read_number_table(const std::string& path, std::size_t columns, std::vector<std::vector<double>>& out);

}  // namespace swage::tools
