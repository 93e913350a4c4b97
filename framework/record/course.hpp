// SPDX-License-Identifier: Apache-2.0
//
// A course: lessons in order, what is asked of each, and how that is proved. Plain data; school.hpp keeps it.
#pragma once

#include <string>
#include <vector>

#include "judge/pass_rule.hpp"

namespace swage::record {

struct CourseStep {
  std::string lesson_id, title;
  std::string digest;                // of the published version that is run; "": the lesson as it is today
  std::vector<judge::Limit> limits;  // none: the lesson's own verdict is asked
  judge::PassRule rule;
  bool is_open = false;  // may be done at any time, whatever the order
};

struct Course {
  std::string id, title;
  bool in_order = true;  // a step opens when the one before it is passed
  std::vector<CourseStep> steps;
  std::string created_utc, changed_utc, published_utc, archived_utc;
};

std::string to_json(const Course&);
/// False with a sentence for what is no course; `out` is then unspecified.
bool from_json(const std::string& text, Course& out, std::string& error);

}  // namespace swage::record
