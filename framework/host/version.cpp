// SPDX-License-Identifier: Apache-2.0
#include "host/version.hpp"

#include <charconv>

namespace swage::host {

bool parse_version(std::string_view text, Version& out) {
  out = {};
  uint32_t* const part[3] = {&out.major, &out.minor, &out.patch};
  const char* at = text.data();
  const char* end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [rest, status] = std::from_chars(at, end, *part[i]);
    if (status != std::errc{}) return false;
    if (rest == end) return true;
    if (*rest != '.') return false;
    at = rest + 1;
  }
  return false;
}

namespace {

// ^: the range in which semantic versions are compatible
bool compatible(const Version& have, const Version& want) {
  if (have < want || have.major != want.major) return false;
  return want.major > 0 || have.minor == want.minor;
}

}  // namespace

bool in_range(std::string_view version, std::string_view range, bool& valid) {
  Version have, want;
  const bool caret = range.starts_with("^");
  const bool at_least = range.starts_with(">=");
  range.remove_prefix(caret ? 1 : at_least ? 2 : 0);
  while (!range.empty() && range.front() == ' ') range.remove_prefix(1);
  valid = parse_version(range, want);
  if (!valid || !parse_version(version, have)) return false;
  if (caret) return compatible(have, want);
  return at_least ? have >= want : have == want;
}

}  // namespace swage::host
