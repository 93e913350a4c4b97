// SPDX-License-Identifier: Apache-2.0
//
// The map "holds or slips" as a picture: a row per knot and pretension, a column per friction.
#pragma once

#include <string>
#include <vector>

namespace swage::bench {

struct KnotCell {
  std::string knot;
  double pretension = 0, friction = 0;  // N, 1
  std::string verdict;                  // as pull.hpp says it: holds, slips, breaks, not tight
  double most = 0;                      // N, greatest tension of a leg
  bool doubtful = false;                // passages, or a tenth of its steps unconverged
};

/// SVG. `note`: the command that made it.
std::string knot_map(const std::string& title, const std::string& note, const std::vector<KnotCell>& cells);

}  // namespace swage::bench
