// SPDX-License-Identifier: Apache-2.0
#include "record/progress.hpp"

#include <time.h>

#include <algorithm>
#include <cstdio>

#include "judge/metrics.hpp"

namespace swage::record {
namespace {

bool is_of(const CourseStep& step, const AttemptRow& a) {
  return a.lesson_id == step.lesson_id && (step.digest.empty() || a.lesson_digest == step.digest);
}

bool is_passed(const AttemptRow& a) { return a.outcome == "passed"; }

StepStanding stand(const CourseStep& step, std::span<const AttemptRow* const> oldest_first) {
  StepStanding out;
  out.broken.assign(step.limits.size(), 0);
  std::vector<judge::Scored> scored;
  for (const AttemptRow* a : oldest_first) {
    if (!counts(step, *a)) {
      out.practice += is_of(step, *a) && a->mode != "test" && !a->is_scripted;
      continue;
    }
    const judge::Met met = meets(step, *a);
    for (const std::size_t i : met.broken) ++out.broken[i];
    out.since_met = met.all ? 0 : out.since_met + 1;
    scored.push_back({day_of(a->started_utc), met.all});
  }
  out.tests = scored.size();
  out.rule = judge::standing(step.rule, scored);
  return out;
}

}  // namespace

// A machine that was too slow, forces that were off and missing steps distort times, speeds and forces.
bool is_sound(const AttemptRow& a) { return !a.is_void && (a.remark.empty() || !a.void_by.empty()); }

bool counts(const CourseStep& step, const AttemptRow& a) {
  return is_of(step, a) && a.mode == "test" && a.state == "complete" && is_sound(a) && !a.is_scripted;
}

judge::Met meets(const CourseStep& step, const AttemptRow& a) {
  judge::Met met = judge::meets(step.limits, judge::metrics_of(a.metrics));
  met.all = met.all && is_passed(a);
  return met;
}

std::vector<StepStanding> standing(const Course& course, std::span<const AttemptRow> attempts) {
  std::vector<const AttemptRow*> sorted;
  for (const AttemptRow& a : attempts) sorted.push_back(&a);
  std::sort(sorted.begin(), sorted.end(), [](const AttemptRow* a, const AttemptRow* b) {
    return a->started_utc != b->started_utc ? a->started_utc < b->started_utc : a->id < b->id;
  });
  std::vector<StepStanding> out;
  bool open = true;
  for (const CourseStep& step : course.steps) {
    out.push_back(stand(step, sorted));
    out.back().is_open = open || step.is_open || !course.in_order;
    open = open && (out.back().rule.passed || step.is_open);
  }
  return out;
}

std::vector<std::vector<std::pair<std::string, double>>> metrics_of(const CourseStep& step, std::span<const AttemptRow> attempts) {
  std::vector<std::vector<std::pair<std::string, double>>> out;
  for (const AttemptRow& a : attempts) {
    if (!is_of(step, a) || a.state != "complete" || !is_sound(a)) continue;
    out.emplace_back();
    if (is_passed(a)) out.back() = judge::metrics_of(a.metrics);
  }
  return out;
}

int32_t day_of(const std::string& utc) {
  tm at{};
  if (std::sscanf(utc.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d", &at.tm_year, &at.tm_mon, &at.tm_mday, &at.tm_hour, &at.tm_min, &at.tm_sec) != 6)
    return -1;
  at.tm_year -= 1900;
  at.tm_mon -= 1;
  const time_t seconds = timegm(&at);
  tm local{};
  if (localtime_r(&seconds, &local) == nullptr) return -1;
  tm day{};
  day.tm_year = local.tm_year;
  day.tm_mon = local.tm_mon;
  day.tm_mday = local.tm_mday;
  return static_cast<int32_t>(timegm(&day) / 86400);
}

}  // namespace swage::record
