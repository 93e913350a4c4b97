// SPDX-License-Identifier: Apache-2.0
//
// Metrics that several lessons report in the same form. [rt]
#pragma once

#include <swage/lesson.hpp>

#include "common/watches.hpp"

namespace swage::lessons {

/// Reports the smoothness of all hands: SPARC after the first movement, LDLJ after the first long one.
inline void report_smoothness(const Verdict& verdict, Metric sparc, Metric ldlj, std::span<const PathState> hands) noexcept {
  if (const auto value = smoothness(hands, &MovesState::sparc)) verdict.metric(sparc, *value);
  if (const auto value = smoothness(hands, &MovesState::ldlj)) verdict.metric(ldlj, *value);
}

}  // namespace swage::lessons
