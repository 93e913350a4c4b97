// SPDX-License-Identifier: Apache-2.0
//
// Where a person stands in a course: which stored attempts count, and what the rule says about them. [main]
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::record {

/// Whether an attempt counts for a step: in Test, ended by itself, not void, by a person's hand, of the step's lesson and version,
/// with nothing that bends its numbers (AttemptRow::remark) unless an instructor has said that it counts all the same.
bool counts(const CourseStep&, const AttemptRow&);

/// Whether an attempt meets what a step asks: its limits, or the lesson's own verdict where there are none.
judge::Met meets(const CourseStep&, const AttemptRow&);

struct StepStanding {
  judge::Standing rule;
  std::size_t practice = 0;            // attempts of the lesson outside of Test
  std::size_t tests = 0;               // attempts that counted
  std::size_t since_met = 0;           // counted attempts since the last one that met all
  std::vector<std::size_t> broken;     // how often each limit was broken, in attempts that counted
  bool is_open = false;                // may be done now
};

/// Of one person; `attempts` in any order. Days are those of this machine's time zone.
std::vector<StepStanding> standing(const Course&, std::span<const AttemptRow> attempts);

/// The metrics of attempts as judge::meet_together() and judge::expert_band() take them: of the step's lesson, complete, not void, not
/// bent.
std::vector<std::vector<std::pair<std::string, double>>> metrics_of(const CourseStep&, std::span<const AttemptRow> attempts);

/// Number of the day of a time such as "2025-06-01T09:30:00.125Z", in this machine's time zone. -1 for what is no time.
int32_t day_of(const std::string& utc);

}  // namespace swage::record
