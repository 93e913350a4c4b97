// SPDX-License-Identifier: Apache-2.0
//
// An audit: one lesson at every level of its ladders, each level compared with the finest that could be played, and which level is
// enough. The rule: README.md; audit_play.cpp plays, audit_rule.cpp judges, audit_report.cpp writes, audit_runs.cpp keeps
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
  double value = 0;  // NaN: not reported
};

/// Result of the lesson at one level.
struct AuditRun {
  std::string level;
  std::string problem;  // why it could not be played to its end, "" when it was
  std::string outcome, reason;
  double score = 0;
  double cpu_s = 0;        // processor time of a step
  double simulated_s = 0;  // simulated time to the end of the attempt
  std::vector<AuditMetric> metric;
};

/// One metric, compared with that of the reference.
struct AuditDifference {
  std::string id, unit;
  double value = 0, reference = 0;
  double allowed = 0;   // differences up to this count as equal
  double size() const;  // |value - reference| / allowed: above 1 the difference counts
};

struct AuditLevel {
  AuditRun run;
  std::vector<AuditDifference> difference;  // the score, then every metric that both report
  std::vector<std::string> untold;          // metrics that the reference reports and this level does not
  double worst = 0;                         // size of the largest difference; infinite: another verdict, or not played
  std::string why;                          // the largest difference, in words
  bool enough = false;
};

/// A choice named "level" of an object or coupling, the number of its "segments", or a method of the engine: from the simplest to the
/// finest.
struct AuditLadder {
  std::string name;
  std::vector<AuditLevel> level;
  std::size_t own = 0;        // the lesson's own level
  std::size_t reference = 0;  // the finest level that could be played
  std::size_t chosen = 0;     // the simplest of those that are enough and within a tenth of the least cost
  double saves = 0;           // share of the reference's processor time; 0 below a tenth
  std::string plugin;         // id of the plugin with this choice, "" for the engine
};

struct AuditLesson {
  std::string path, id, title, device;
  std::vector<AuditLadder> ladder;
};

struct AuditRule {
  double tolerance = 0.05;  // relative difference that counts as equal
};
/// Compares every level of a ladder with the finest that could be played, and chooses.
void judge(const AuditRule& rule, AuditLadder& ladder);

struct AuditPlan {
  std::string device;                  // hand
  double max_time_s = 120;             // simulated
  double budget_s = 45;                // of processor time, for one run
  std::vector<std::string> only = {};  // names of ladders; all unless given
};
/// Plays a lesson at every level, without judging. `said` is called before each run with a line of progress.
AuditLesson play_levels(const AuditPlan& plan, const host::Catalogue& catalogue, assembly::LessonFile file,
                        void (*said)(const std::string&));

/// The runs as JSON, for a later audit that adds lessons to them.
std::string audit_runs(const std::vector<AuditLesson>& lessons);
/// Reads such JSON; the runs are not judged yet. False when the text is not of this form.
bool read_audit_runs(const std::string& text, std::vector<AuditLesson>& lessons);
/// Adds a lesson at the place of its number, or replaces the one with the same lesson and hand.
void add_lesson(std::vector<AuditLesson>& lessons, AuditLesson lesson);

/// One row a level, and one row a metric of a level.
std::string audit_csv(const std::vector<AuditLesson>& lessons);
std::string audit_metrics_csv(const std::vector<AuditLesson>& lessons);
/// The report: cost of each model and in how many lessons it is enough, the sufficient level per lesson, then the levels of every lesson.
std::string audit_markdown(const std::vector<AuditLesson>& lessons, const AuditRule& rule);
/// One panel per lesson: largest difference against processor time of a step.
std::string audit_svg(const std::vector<AuditLesson>& lessons);

}  // namespace swage::tools
