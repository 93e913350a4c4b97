// SPDX-License-Identifier: Apache-2.0
//
// A course: lessons in order, with the requirements of each and their rule. Plain data; stored by school.hpp.
#pragma once

#include <string>
#include <vector>

#include "judge/pass_rule.hpp"

namespace swage::record {

struct CourseStep {
  std::string lesson_id, title;
  std::string digest;                // of the published version to run; "": the lesson's present text
  std::vector<judge::Limit> limits;  // beside the lesson's own verdict, which is always asked
  judge::PassRule rule;
  bool is_open = false;  // may be done at any time, independent of the order
};

struct Course {
  std::string id, title;
  bool in_order = true;  // a step opens when the previous one is passed
  std::vector<CourseStep> steps;
  std::string created_utc, changed_utc, published_utc, archived_utc;
};

std::string to_json(const Course&);
/// False with a sentence for an invalid course; `out` is then unspecified.
bool from_json(const std::string& text, Course& out, std::string& error);

}  // namespace swage::record
