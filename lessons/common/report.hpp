// SPDX-License-Identifier: Apache-2.0
//
// What several lessons tell alike. [rt]
#pragma once

#include <swage/lesson.hpp>

#include "common/watches.hpp"

namespace swage::lessons {

/// Smoothness of all hands; told once there was a movement, and a long one.
inline void report_smoothness(const Verdict& verdict, Metric sparc, Metric ldlj, std::span<const PathState> hands) noexcept {
  if (const auto value = smoothness(hands, &MovesState::sparc)) verdict.metric(sparc, *value);
  if (const auto value = smoothness(hands, &MovesState::ldlj)) verdict.metric(ldlj, *value);
}

}  // namespace swage::lessons
