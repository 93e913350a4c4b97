// SPDX-License-Identifier: Apache-2.0
//
// Declarations of every lesson in build(): the cues and metrics of its card, and checks of its intervals. [main]
#pragma once

#include <swage/lesson.hpp>

#include <cstddef>

#include "common/sentences.hpp"

namespace swage::lessons {

/// Declares the cues and metrics of a card; each array has one entry for each row of its table. `shows(i)`: whether a lesson with
/// these parameters can show cue i at all; the others stay out of its legend. `tells(i)`: likewise for reporting metric i.
template <size_t cues, size_t metrics, class Shows, class Tells>
void declare_card(LessonBuilder& builder, const swage_cue_info (&cue_info)[cues], Cue (&cue)[cues],
                  const swage_metric_info (&metric_info)[metrics], Metric (&metric)[metrics], const Shows& shows, const Tells& tells) {
  for (size_t i = 0; i < cues; ++i)
    if (shows(i)) cue[i] = builder.cue(cue_info[i]);
  for (size_t i = 0; i < metrics; ++i)
    if (tells(i)) metric[i] = builder.metric(metric_info[i]);
}

template <size_t cues, size_t metrics, class Shows>
void declare_card(LessonBuilder& builder, const swage_cue_info (&cue_info)[cues], Cue (&cue)[cues],
                  const swage_metric_info (&metric_info)[metrics], Metric (&metric)[metrics], const Shows& shows) {
  declare_card(builder, cue_info, cue, metric_info, metric, shows, [](size_t) { return true; });
}

template <size_t cues, size_t metrics>
void declare_card(LessonBuilder& builder, const swage_cue_info (&cue_info)[cues], Cue (&cue)[cues],
                  const swage_metric_info (&metric_info)[metrics], Metric (&metric)[metrics]) {
  declare_card(builder, cue_info, cue, metric_info, metric, [](size_t) { return true; });
}

/// Reports an interval whose first number is not below its second.
inline void require_ordered(LessonBuilder& builder, const char* key, const Interval& range) {
  if (range.low >= range.high) builder.error(key, say::kOrdered());
}

}  // namespace swage::lessons
