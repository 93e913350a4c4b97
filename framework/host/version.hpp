// SPDX-License-Identifier: Apache-2.0
//
// Semantic versions of plugins and the ranges that lessons require.
#pragma once

#include <cstdint>
#include <string_view>

namespace swage::host {

struct Version {
  uint32_t major = 0, minor = 0, patch = 0;
  auto operator<=>(const Version&) const = default;
};

/// "1", "1.2" or "1.2.3"; absent numbers are 0. False when it is none of these.
bool parse_version(std::string_view text, Version& out);

/// Ranges: "^1.2" (1.2 and later, same major; below 1.0 same minor), ">=1.2", and "1.2.3" or "1.2" exactly.
/// `valid` is false when the range cannot be read.
bool in_range(std::string_view version, std::string_view range, bool& valid);

}  // namespace swage::host
