// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// The least gap of a manifold [m]; 1 m where nothing touches.
inline double least(const Manifold& m) {
  double gap = 1;
  for (int i = 0; i < m.count; ++i) gap = std::min(gap, m.candidate[static_cast<size_t>(i)].touch.gap);
  return gap;
}

}  // namespace swage::contact
