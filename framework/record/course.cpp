// SPDX-License-Identifier: Apache-2.0
#include "record/course.hpp"

#include <QtCore/QCryptographicHash>
#include <cmath>
#include <nlohmann/json.hpp>

#include "record/school.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

using nlohmann::json;

constexpr const char* kCourseFormat = "swage-course/1";

json limit_json(const judge::Limit& l) {
  json out = {{"metric", l.metric}, {"unit", l.unit}, {"gate", l.is_gate}, {"source", l.source}};
  if (std::isfinite(l.least)) out["least"] = l.least;
  if (std::isfinite(l.most)) out["most"] = l.most;
  return out;
}

judge::Limit limit_from(const json& j) {
  judge::Limit l;
  l.metric = j.at("metric");
  l.unit = j.value("unit", "");
  l.is_gate = j.value("gate", false);
  l.source = j.value("source", "");
  if (j.contains("least")) l.least = j.at("least");
  if (j.contains("most")) l.most = j.at("most");
  return l;
}

json rule_json(const judge::PassRule& r) {
  if (r.kind == judge::PassRule::Kind::kLcCusum)
    return {{"kind", "lc-cusum"}, {"adequate", r.adequate}, {"inadequate", r.inadequate}, {"signal", r.signal},
            {"a_day", r.a_day},   {"warm_up", r.warm_up}};
  return {{"kind", "streak"}, {"in_a_row", r.in_a_row}, {"later_day", r.later_day}, {"a_day", r.a_day}, {"warm_up", r.warm_up}};
}

judge::PassRule rule_from(const json& j) {
  judge::PassRule r;
  const std::string kind = j.at("kind");
  if (kind != "streak" && kind != "lc-cusum") throw std::invalid_argument(say::kNoSuchRule(kind));
  r.kind = kind == "streak" ? judge::PassRule::Kind::kStreak : judge::PassRule::Kind::kLcCusum;
  r.in_a_row = j.value("in_a_row", r.in_a_row);
  r.later_day = j.value("later_day", r.later_day);
  r.a_day = j.value("a_day", r.a_day);
  r.warm_up = j.value("warm_up", r.warm_up);
  r.adequate = j.value("adequate", r.adequate);
  r.inadequate = j.value("inadequate", r.inadequate);
  r.signal = j.value("signal", r.signal);
  return r;
}

json step_json(const CourseStep& s) {
  json limits = json::array();
  for (const judge::Limit& l : s.limits) limits.push_back(limit_json(l));
  return {{"lesson", s.lesson_id}, {"title", s.title},       {"digest", s.digest},
          {"limits", limits},      {"rule", rule_json(s.rule)}, {"open", s.is_open}};
}

CourseStep step_from(const json& j) {
  CourseStep s;
  s.lesson_id = j.at("lesson");
  s.title = j.value("title", "");
  s.digest = j.value("digest", "");
  s.is_open = j.value("open", false);
  if (j.contains("limits"))
    for (const json& l : j.at("limits")) s.limits.push_back(limit_from(l));
  if (j.contains("rule")) s.rule = rule_from(j.at("rule"));
  return s;
}

// "" for a valid course
std::string fault_of(const Course& c) {
  if (c.title.empty()) return say::kNeedsTitle();
  for (std::size_t i = 0; i < c.steps.size(); ++i) {
    const CourseStep& s = c.steps[i];
    const std::string at = say::kOfStep(i + 1, c.title);
    if (s.lesson_id.empty()) return say::kNeedsLesson(at);
    if (const std::string wrong = judge::problem_of(s.rule); !wrong.empty()) return at + wrong;
    for (const judge::Limit& l : s.limits) {
      if (l.metric.empty()) return say::kNeedsMetric(at);
      if (!(l.least <= l.most)) return say::kEmptyLimit(at, l.metric);
      if (!std::isfinite(l.least) && !std::isfinite(l.most)) return say::kNoLimit(at, l.metric);
    }
  }
  return "";
}

}  // namespace

std::string to_json(const Course& c) {
  json steps = json::array();
  for (const CourseStep& s : c.steps) steps.push_back(step_json(s));
  const json out = {{"format", kCourseFormat}, {"title", c.title}, {"in_order", c.in_order}, {"steps", steps}};
  return out.dump(1);
}

bool from_json(const std::string& text, Course& out, std::string& error) {
  try {
    const json j = json::parse(text);
    if (!j.is_object() || j.value("format", "") != kCourseFormat) {
      error = std::string("It is no course: \"format\" must be \"") + kCourseFormat + "\".";
      return false;
    }
    out.title = j.at("title");
    out.in_order = j.value("in_order", true);
    out.steps.clear();
    if (j.contains("steps"))
      for (const json& s : j.at("steps")) out.steps.push_back(step_from(s));
    error = fault_of(out);
  } catch (const std::exception& e) {
    error = std::string("It is no course that can be read: ") + e.what() + ".";
  }
  return error.empty();
}

std::string lesson_digest(const std::string& lesson_text) {
  // sorted keys, one form of each number; the seed belongs to the attempt, not to the lesson
  nlohmann::json lesson = nlohmann::json::parse(lesson_text, nullptr, false);
  if (lesson.is_object()) lesson.erase("seed");
  const std::string canonical = lesson.is_discarded() ? lesson_text : lesson.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const QByteArray bytes(canonical.data(), static_cast<qsizetype>(canonical.size()));
  return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().toStdString();
}

}  // namespace swage::record
