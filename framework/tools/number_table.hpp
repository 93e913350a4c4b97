// SPDX-License-Identifier: Apache-2.0
//
// Tables of numbers in text files: rows of numbers separated by commas, semicolons, tabs or spaces; # begins a comment. [main]
#pragma once

#include <string>
#include <vector>

namespace swage::tools {

/// Reads one row; false when a word is not a number.
bool read_numbers(const std::string& text, std::vector<double>& out);
/// Reads a table of rows with `columns` numbers; a first row of words is a heading. "" or file, line and fault.
std::string read_number_table(const std::string& path, std::size_t columns, std::vector<std::vector<double>>& out);

}  // namespace swage::tools
