// SPDX-License-Identifier: Apache-2.0
//
// Progress of a person in a course: which stored attempts count, and the result by the rule. [main]
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::record {

/// True when an attempt counts for a step: in Test, ended by itself, not void, by a person's hand, of the step's lesson and version,
/// with nothing that distorts its numbers (AttemptRow::remark) unless an instructor has ruled that it counts.
bool counts(const CourseStep&, const AttemptRow&);

/// False for an attempt that is void, or whose numbers are distorted (AttemptRow::remark) unless an instructor has ruled that it counts.
bool is_sound(const AttemptRow&);

/// Whether an attempt meets the requirements of a step: the lesson's own verdict, and the limits. An attempt that failed after a second
/// would keep every limit of time, so that limits alone are not enough.
judge::Met meets(const CourseStep&, const AttemptRow&);

struct StepStanding {
  judge::Standing rule;
  std::size_t practice = 0;            // attempts of the lesson outside of Test
  std::size_t tests = 0;               // attempts that counted
  std::size_t since_met = 0;           // counted attempts since the last one that met all
  std::vector<std::size_t> broken;     // number of violations of each limit, in attempts that counted
  bool is_open = false;                // may be done now
};

/// For one person; `attempts` in any order. Days are those of this machine's time zone.
std::vector<StepStanding> standing(const Course&, std::span<const AttemptRow> attempts);

/// The metrics of attempts in the form for judge::meet_together() and judge::expert_band(): of the step's lesson, complete, sound. An
/// attempt that was not passed meets nothing and has no value: an empty list.
std::vector<std::vector<std::pair<std::string, double>>> metrics_of(const CourseStep&, std::span<const AttemptRow> attempts);

/// Number of the day of a time such as "2025-06-01T09:30:00.125Z", in this machine's time zone. -1 for an invalid time.
int32_t day_of(const std::string& utc);

}  // namespace swage::record
