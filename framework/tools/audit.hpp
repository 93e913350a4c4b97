// SPDX-License-Identifier: Apache-2.0
//
// An audit: one lesson at every level of its ladders, each level beside the finest one that could be played, and which level is
// enough. The rule stands in README.md; audit_play.cpp plays, audit_rule.cpp judges, audit_report.cpp writes, audit_runs.cpp keeps
// the runs for an audit in pieces. [main]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assembly/assemble.hpp"
#include "base/problem.hpp"
#include "host/catalogue.hpp"

namespace swage::tools {

struct AuditMetric {
  std::string id, unit;
  double value = 0;  // NaN: it was not reported
};

/// How the lesson went with one level.
struct AuditRun {
  std::string level;
  std::string problem;  // why it could not be played to its end, "" when it was
  std::string outcome, reason;
  double score = 0;
  double cpu_s = 0;        // of processor time, a step
  double simulated_s = 0;  // to its end
  std::vector<AuditMetric> metric;
};

/// One metric beside that of the reference.
struct AuditDifference {
  std::string id, unit;
  double value = 0, reference = 0;
  double allowed = 0;   // differences up to this count as equal
  double size() const;  // |value - reference| over that: above 1 it counts
};

struct AuditLevel {
  AuditRun run;
  std::vector<AuditDifference> difference;  // the score, then every metric that both could tell
  std::vector<std::string> untold;          // metrics that the reference reports and this level cannot
  double worst = 0;                         // size of the largest; infinite: another verdict, or not played
  std::string why;                          // that one, in words
  bool enough = false;
};

/// A choice named "level" of an object or coupling, the number of its "segments", or a method of the engine: from the simplest to the
/// finest.
struct AuditLadder {
  std::string name;
  std::vector<AuditLevel> level;
  std::size_t own = 0;        // what the lesson has
  std::size_t reference = 0;  // the finest that could be played
  std::size_t chosen = 0;     // of those that are enough and cost the least, to a tenth: the simplest
  double saves = 0;           // share of the reference's processor time; 0 below a tenth
  std::string plugin;         // whose choice it is, "" for the engine
};

struct AuditLesson {
  std::string path, id, title, device;
  std::vector<AuditLadder> ladder;
};

struct AuditRule {
  double tolerance = 0.05;  // share of a value that still counts as equal
};
/// Compares every level of a ladder with the finest that could be played, and chooses.
void judge(const AuditRule& rule, AuditLadder& ladder);

struct AuditPlan {
  std::string device;                  // hand
  double max_time_s = 120;             // simulated
  double budget_s = 45;                // of processor time, for one run
  std::vector<std::string> only = {};  // names of ladders; all unless given
};
/// Plays a lesson at every level; judges nothing. `said` is called before each run with its progress in words.
AuditLesson play_levels(const AuditPlan& plan, const host::Catalogue& catalogue, assembly::LessonFile file,
                        void (*said)(const std::string&));

/// What was played, as JSON, for a later audit that adds lessons to it.
std::string audit_runs(const std::vector<AuditLesson>& lessons);
/// Reads that, unjudged. False when it is no such text.
bool read_audit_runs(const std::string& text, std::vector<AuditLesson>& lessons);
/// Puts a lesson in the place of the same lesson and hand, or where its number belongs.
void add_lesson(std::vector<AuditLesson>& lessons, AuditLesson lesson);

/// One row a level, and one row a metric of a level.
std::string audit_csv(const std::vector<AuditLesson>& lessons);
std::string audit_metrics_csv(const std::vector<AuditLesson>& lessons);
/// What each model costs and in how many lessons it is enough, which level is enough for which lesson, then every lesson's levels.
std::string audit_markdown(const std::vector<AuditLesson>& lessons, const AuditRule& rule);
/// A panel a lesson: largest difference against processor time of a step.
std::string audit_svg(const std::vector<AuditLesson>& lessons);

}  // namespace swage::tools
