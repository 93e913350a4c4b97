// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean": the names closest to the typed one. [main]
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swage::host {

/// Edits (insert, delete, replace, swap of neighbours) from a to b.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Closest of `names`, or "" when none is close enough to be suggested (edits: a third of its letters, at
/// least two).
std::string nearest(std::string_view typed, const std::vector<std::string>& names);

/// "a, b, c"; `quote` puts each in quotation marks.
std::string join(const std::vector<std::string>& names, bool quote = false);

/// " Did you mean "x"?" or "".
std::string did_you_mean(std::string_view typed, const std::vector<std::string>& names);

}  // namespace swage::host
