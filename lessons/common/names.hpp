// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace swage::lessons {

/// "a, b" -> {"a", "b"}
inline std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names(1);
  for (const char c : text) {
    if (c == ',')
      names.emplace_back();
    else if (c != ' ')
      names.back() += c;
  }
  std::erase(names, std::string());
  return names;
}

}  // namespace swage::lessons
