// SPDX-License-Identifier: Apache-2.0
#include "host/nearest.hpp"

#include <algorithm>

namespace swage::host {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // optimal string alignment: three rows of the usual table
  const std::size_t n = b.size();
  std::vector<std::size_t> before(n + 1), above(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= n; ++j) {
      const std::size_t replace = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[n];
}

std::string nearest(std::string_view typed, const std::vector<std::string>& names) {
  // names are short; a text of a megabyte is no typing mistake
  if (typed.size() > 200) return "";
  const std::size_t limit = std::max<std::size_t>(2, typed.size() / 3);
  std::size_t best = limit + 1;
  std::string found;
  for (const std::string& name : names) {
    const std::size_t d = edit_distance(typed, name);
    // two edits turn any two letters into any others
    if (d < best && d < name.size()) {
      best = d;
      found = name;
    }
  }
  return found;
}

std::string join(const std::vector<std::string>& names, bool quote) {
  std::string list;
  for (const std::string& name : names) {
    if (!list.empty()) list += ", ";
    list += quote ? "\"" + name + "\"" : name;
  }
  return list;
}

std::string did_you_mean(std::string_view typed, const std::vector<std::string>& names) {
  const std::string name = nearest(typed, names);
  return name.empty() ? "" : " Did you mean \"" + name + "\"?";
}

}  // namespace swage::host
