// SPDX-License-Identifier: Apache-2.0
//
// swage courses: lessons in order, the requirements of each, and the progress of each trainee.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "assembly/lesson_text.hpp"
#include "host/nearest.hpp"
#include "judge/learning.hpp"
#include "record/identity.hpp"
#include "record/progress.hpp"
#include "toolkit/read_file.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

bool find(record::School& school, const std::string& meant, record::Course& out) {
  std::vector<std::string> titles;
  for (record::Course& c : school.courses()) {
    titles.push_back(c.title);
    if (c.title != meant && c.id != meant) continue;
    out = std::move(c);
    return true;
  }
  if (!school.error().empty()) return problem(school.error()), false;
  return problem(say::kNoCourse(meant, host::did_you_mean(meant, titles))), false;
}

// "in a row: 2, on a later day: 2, a day: 10"
std::string words(const judge::PassRule& r) {
  std::string out = r.kind == judge::PassRule::Kind::kStreak
                        ? format("%u in Test in a row", r.in_a_row) + (r.later_day > 0 ? format(", and the first %u of a later day", r.later_day) : "")
                        : format("LC-CUSUM %g %% / %g %%, h = %g", 100 * r.adequate, 100 * r.inadequate, r.signal);
  if (r.a_day > 0) out += format(", at most %u a day", r.a_day);
  if (r.warm_up > 0) out += format(", after %u to warm up", r.warm_up);
  return out;
}

std::string words(const judge::Limit& l) {
  std::string out = l.metric;
  if (std::isfinite(l.least)) out += format(" >= %g", l.least);
  if (std::isfinite(l.most)) out += format(" <= %g", l.most);
  return out + (l.unit == "1" || l.unit.empty() ? "" : " " + l.unit) + (l.is_gate ? ", safety gate" : "");
}

// Publishes the lesson files that steps name; each step then refers to the published version.
bool freeze_files(record::School& school, const std::string& folder, Json& course) {
  if (!course.is_object() || !course.contains("steps") || !course["steps"].is_array()) return true;
  for (Json& step : course["steps"]) {
    if (!step.is_object() || !step.contains("file") || !step["file"].is_string()) continue;
    const std::string path = (std::filesystem::path(folder) / step["file"].get<std::string>()).lexically_normal();
    assembly::LessonText lesson;
    base::Problems problems;
    if (!assembly::read_lesson_text(path, {}, lesson, problems)) return tell(problems), false;
    record::LessonVersion version;
    if (!school.publish_lesson(lesson.json.value("id", ""), lesson.json.value("title", ""), lesson.text, version))
      return problem(school.error()), false;
    step["lesson"] = version.lesson_id;
    step["digest"] = version.digest;
    if (!step.contains("title")) step["title"] = version.title;
  }
  return true;
}

// attempts of a person or of a group; false with the reason printed
bool attempts_of(record::Store& store, record::School& school, const std::string& who, std::vector<record::AttemptRow>& out) {
  std::string group;
  for (const record::Group& g : school.groups())
    if (g.name == who) group = g.id;
  bool found = !group.empty();
  for (const record::Person& p : school.people()) {
    if (p.name != who && p.code != who && (group.empty() || p.group_id != group)) continue;
    found = true;
    for (record::AttemptRow& a : store.attempts(p.id)) out.push_back(std::move(a));
  }
  return found || problem(say::kNobodyAtAll(who)) == kPassed;
}

struct Odds {
  double succeeds = 0;
  judge::RuleOdds odds;
};
std::vector<Odds> odds_of(const judge::PassRule& rule, uint32_t attempts) {
  std::vector<Odds> out;
  for (const double p : {0.5, 0.7, 0.9}) out.push_back({p, judge::simulate(rule, p, attempts)});
  return out;
}

Json limits_json(const record::CourseStep& step, const std::vector<record::AttemptRow>& experts, bool print_it) {
  const auto metrics = record::metrics_of(step, experts);
  const judge::MetTogether met = judge::meet_together(step.limits, metrics);
  Json list = Json::array();
  for (std::size_t i = 0; i < step.limits.size(); ++i) {
    std::vector<double> values;
    for (const auto& attempt : metrics)
      for (const auto& [id, value] : attempt)
        if (id == step.limits[i].metric) values.push_back(value);
    const double p10 = judge::quantile(values, 0.1), p50 = judge::quantile(values, 0.5), p90 = judge::quantile(values, 0.9);
    list.push_back({{"limit", words(step.limits[i])}, {"met", met.each[i]}, {"p10", number(p10)}, {"median", number(p50)}, {"p90", number(p90)}});
    if (print_it)
      std::printf("    %-44s met by %zu of %zu expert attempts, %.4g (%.4g to %.4g)\n", printable(words(step.limits[i])).c_str(), met.each[i],
                  met.attempts, p50, p10, p90);
  }
  if (print_it && !step.limits.empty()) std::printf("    all limits together: %zu of %zu expert attempts\n", met.all, met.attempts);
  return {{"attempts", met.attempts}, {"all", met.all}, {"each", list}};
}

}  // namespace

int list_courses(const CourseOptions& o) {
  const auto school = existing_school(store_place(o.store));
  if (!school) return kProblem;
  const std::vector<record::Course> courses = school->courses();
  if (!school->error().empty()) return problem(school->error());
  Json list = Json::array();
  for (const record::Course& c : courses) {
    list.push_back({{"course", c.id}, {"title", c.title}, {"steps", c.steps.size()}, {"changed_utc", c.changed_utc}, {"archived", !c.archived_utc.empty()}});
    if (!o.json) std::printf("%-36s %zu lessons%s\n", printable(c.title).c_str(), c.steps.size(), c.archived_utc.empty() ? "" : "  archived");
  }
  if (o.json) print(list);
  if (!o.json && courses.empty()) std::printf("no course yet: swage courses add FILE\n");
  return kPassed;
}

int add_course(const CourseOptions& o) {
  std::string text, why;
  if (!toolkit::read_file(o.file, toolkit::kMostFileBytes, text, why)) return problem(say::kOfFile(o.file, why));
  std::string error;
  const auto school = record::School::open(store_place(o.store), error);
  if (!school) return problem(error);
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return problem(say::kOfFile(o.file, say::kNotJson()));
  if (!freeze_files(*school, std::filesystem::path(o.file).parent_path(), json)) return kProblem;
  record::Course course;
  if (!record::from_json(json.dump(), course, error)) return problem(say::kOfFile(o.file, error));
  // a course with the same title is replaced and keeps its id
  for (const record::Course& c : school->courses())
    if (c.title == course.title) course.id = c.id, course.created_utc = c.created_utc;
  course.published_utc = record::utc_now();
  if (!school->save_course(course)) return problem(say::kOfFile(o.file, school->error()));
  if (o.json)
    print({{"course", course.id}, {"title", course.title}, {"steps", course.steps.size()}});
  else
    std::printf("%s: %zu lessons\n", printable(course.title).c_str(), course.steps.size());
  return kPassed;
}

int show_course(const CourseOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Course c;
  if (!school || !find(*school, o.course, c)) return kProblem;
  if (o.json) return print(Json::parse(record::to_json(c))), kPassed;
  std::printf("%s, %s\n", printable(c.title).c_str(), c.in_order ? "in order" : "in any order");
  for (std::size_t i = 0; i < c.steps.size(); ++i) {
    const record::CourseStep& s = c.steps[i];
    std::printf("%2zu  %s (%s%s)\n    passed by %s\n", i + 1, printable(s.title).c_str(), printable(s.lesson_id).c_str(),
                s.digest.empty() ? "" : (", version " + s.digest.substr(0, 8)).c_str(), words(s.rule).c_str());
    for (const judge::Limit& l : s.limits) std::printf("    %s\n", printable(words(l)).c_str());
  }
  return kPassed;
}

int check_course(const CourseOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Course c;
  std::string error;
  if (!school || !find(*school, o.course, c)) return kProblem;
  const auto store = existing_store(store_place(o.store), error);
  std::vector<record::AttemptRow> experts;
  if (!store || (!o.experts.empty() && !attempts_of(*store, *school, o.experts, experts))) return kProblem;
  Json steps = Json::array();
  for (const record::CourseStep& s : c.steps) {
    Json odds = Json::array();
    if (!o.json) std::printf("%s\n    %s; of 100 trainees who make %u attempts\n", printable(s.title).c_str(), words(s.rule).c_str(), o.attempts);
    for (const Odds& x : odds_of(s.rule, o.attempts)) {
      odds.push_back({{"succeeds", x.succeeds}, {"passed", x.odds.passed}, {"typical", number(x.odds.typical)}});
      if (!o.json)
        std::printf("    succeeds %.0f times in 10: %5.1f pass%s\n", 10 * x.succeeds, 100 * x.odds.passed,
                    std::isfinite(x.odds.typical) ? format(", at attempt %.0f", x.odds.typical).c_str() : "");
    }
    Json step = {{"lesson", s.lesson_id}, {"rule", words(s.rule)}, {"odds", odds}};
    if (!o.experts.empty()) step["experts"] = limits_json(s, experts, !o.json);
    steps.push_back(std::move(step));
  }
  if (o.json) print({{"course", c.title}, {"steps", steps}});
  return kPassed;
}

int assign_course(const CourseOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Course c;
  if (!school || !find(*school, o.course, c)) return kProblem;
  record::Assignment a;
  a.course_id = c.id;
  a.due_utc = o.due;
  a.to_group = !o.group.empty();
  for (const record::Group& g : school->groups())
    if (a.to_group && g.name == o.group) a.who_id = g.id;
  record::Person p;
  if (!a.to_group && school->find_person(o.person, p)) a.who_id = p.id;
  if (a.who_id.empty()) return problem(a.to_group ? say::kNoGroup(o.group) : school->error());
  for (const record::Assignment& known : school->assignments())
    if (known.course_id == a.course_id && known.who_id == a.who_id) a.id = known.id, a.made_utc = known.made_utc;
  if (!school->assign(a)) return problem(school->error());
  if (o.json)
    print({{"course", c.title}, {"to", a.to_group ? o.group : p.code}, {"due", a.due_utc}});
  else
    std::printf("%s is assigned to %s\n", printable(c.title).c_str(), printable(a.to_group ? o.group : p.name).c_str());
  return kPassed;
}

int archive_course(const CourseOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Course c;
  if (!school || !find(*school, o.course, c)) return kProblem;
  c.archived_utc = o.back ? "" : record::utc_now();
  if (!school->save_course(c)) return problem(school->error());
  std::printf("%s is %s\n", printable(c.title).c_str(), o.back ? "in use again" : "archived");
  return kPassed;
}

int course_progress(const CourseOptions& o) {
  const auto school = existing_school(store_place(o.store));
  record::Course c;
  std::string error;
  if (!school || !find(*school, o.course, c)) return kProblem;
  const auto store = existing_store(store_place(o.store), error);
  if (!store) return problem(error);
  const std::vector<record::Assignment> tasks = school->assignments();
  const auto takes_part = [&](const record::Person& p) {
    if (!o.person.empty()) return p.name == o.person || p.code == o.person;
    return p.archived_utc.empty() && std::any_of(tasks.begin(), tasks.end(), [&](const record::Assignment& a) {
             return a.course_id == c.id && a.who_id == (a.to_group ? p.group_id : p.id);
           });
  };
  Json list = Json::array();
  for (const record::Person& p : school->people()) {
    if (!takes_part(p)) continue;
    const std::vector<record::StepStanding> steps = record::standing(c, store->attempts(p.id));
    const auto passed = std::count_if(steps.begin(), steps.end(), [](const auto& s) { return s.rule.passed; });
    Json each = Json::array();
    std::string marks;
    for (const record::StepStanding& s : steps) {
      each.push_back({{"passed", s.rule.passed}, {"open", s.is_open}, {"tests", s.tests}, {"practice", s.practice}, {"since_met", s.since_met}, {"broken", s.broken}});
      marks += s.rule.passed ? " passed" : s.is_open ? format(" %zu tests", s.tests) : " -";
    }
    list.push_back({{"code", p.code}, {"name", p.name}, {"passed", passed}, {"steps", each}});
    if (!o.json) std::printf("%-28s %2td of %zu passed: %s\n", printable(p.name).c_str(), passed, steps.size(), marks.c_str());
  }
  if (o.json) print(list);
  if (!o.json && list.empty()) std::printf("nobody has this course: swage courses assign \"%s\" --group NAME\n", printable(c.title).c_str());
  return kPassed;
}

}  // namespace swage::tools
