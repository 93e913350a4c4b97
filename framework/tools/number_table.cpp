// SPDX-License-Identifier: Apache-2.0
#include "tools/number_table.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

#include "toolkit/read_file.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {

bool read_numbers(const std::string& text, std::vector<double>& out) {
  out.clear();
  std::string words = text.substr(0, text.find('#'));
  for (char& c : words)
    if (c == ',' || c == ';' || c == '\t' || c == '\r') c = ' ';
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    double value = 0;
    const char* begin = word.data() + (word[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return false;
    out.push_back(value);
  }
  return true;
}

std::string read_number_table(const std::string& path, std::size_t columns, std::vector<std::vector<double>>& out) {
  std::string bytes, why;
  if (!toolkit::read_file(path, std::size_t{1} << 20, bytes, why)) return say::kOfTable(path, why);
  out.clear();
  std::istringstream in(bytes);
  std::vector<double> row;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const bool numbers = read_numbers(line, row);
    if (!numbers && out.empty() && number == 1) continue;  // a heading
    if (numbers && row.empty()) continue;
    if (!numbers || row.size() != columns)
      return say::kRowOf(path, number, columns);
    out.push_back(row);
  }
  return out.empty() ? say::kNoRow(path) : "";
}

}  // namespace swage::tools
