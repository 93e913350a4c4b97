// SPDX-License-Identifier: Apache-2.0
//
// swage audit: plays lessons at every level of their ladders with a scripted hand, and reports which level is enough. Explained in
// README.md.
#include "tools/audit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/guard.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

void print_level(const AuditLadder& ladder, const AuditLevel& level) {
  const AuditRun& run = level.run;
  const auto i = static_cast<std::size_t>(&level - ladder.level.data());
  if (!run.problem.empty())
    return static_cast<void>(
        std::printf("  %-17s %s\n", run.level.c_str(), say::kNotPlayed(run.problem).c_str()));
  std::printf("  %-17s %-8s score %5.1f  %7.1f us a step  ", run.level.c_str(), run.outcome.c_str(),
              run.score, 1e6 * run.cpu_s);
  if (i == ladder.reference) return static_cast<void>(std::printf("reference\n"));
  std::printf("%s %8s", level.enough ? "enough " : "differs",
              std::isinf(level.worst) ? "-" : format("%.2f", level.worst).c_str());
  std::printf("%s%s\n", level.why.empty() ? "" : "  ", level.why.c_str());
  for (const std::string& id : level.untold) std::printf("%20scannot tell %s\n", "", id.c_str());
}

void print_ladder(const AuditLadder& ladder) {
  std::printf("\n%s\n", ladder.name.c_str());
  for (const AuditLevel& level : ladder.level) print_level(ladder, level);
  if (!ladder.level[ladder.reference].run.problem.empty())
    return static_cast<void>(std::printf("  no level could be played: nothing is known\n"));
  const std::string &own = ladder.level[ladder.own].run.level, &best = ladder.level[ladder.chosen].run.level,
                    &finest = ladder.level[ladder.reference].run.level;
  std::printf("  enough: %s", best.c_str());
  if (ladder.saves > 0)
    std::printf(", saves %.0f %% of the processor time of %s", 100 * ladder.saves, finest.c_str());
  std::printf("; the lesson has %s%s\n", own.c_str(),
              ladder.level[ladder.own].enough ? "" : ", which is NOT enough");
}

Json to_json(const AuditLadder& ladder) {
  Json out = {{"ladder", ladder.name},
              {"own", ladder.level[ladder.own].run.level},
              {"reference", ladder.level[ladder.reference].run.level},
              {"chosen", ladder.level[ladder.chosen].run.level},
              {"saves", number(ladder.saves)}};
  for (const AuditLevel& level : ladder.level) {
    const AuditRun& run = level.run;
    Json& row = out["levels"].emplace_back();
    row = {
        {"level", run.level},         {"enough", level.enough},     {"difference", number(level.worst)},
        {"why", level.why},           {"outcome", run.outcome},     {"reason", run.reason},
        {"score", number(run.score)}, {"cpu_s", number(run.cpu_s)}, {"simulated_s", number(run.simulated_s)},
        {"problem", run.problem},     {"untold", level.untold}};
    for (const AuditMetric& m : run.metric) row["metrics"][m.id] = number(m.value);
    for (const AuditDifference& d : level.difference) row["differences"][d.id] = number(d.size());
  }
  return out;
}

constexpr const char* kRuns = "/audit_runs.json";

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file.good();
}

bool write_all(const std::string& out, const std::vector<AuditLesson>& lessons, const AuditRule& rule) {
  std::error_code ignored;
  std::filesystem::create_directories(out, ignored);
  return write(out + kRuns, audit_runs(lessons)) && write(out + "/audit.csv", audit_csv(lessons)) &&
         write(out + "/audit_metrics.csv", audit_metrics_csv(lessons)) &&
         write(out + "/audit.md", audit_markdown(lessons, rule)) &&
         write(out + "/audit.svg", audit_svg(lessons));
}

/// Reads the lessons of an earlier audit from its folder and judges them by this rule. False with the problem printed.
bool read_earlier(const std::string& out, const AuditRule& rule, std::vector<AuditLesson>& lessons) {
  std::ifstream file(out + kRuns, std::ios::binary);
  if (!file) return true;
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!read_audit_runs(text, lessons))
    return problem(say::kNoRecord(out + kRuns)), false;
  for (AuditLesson& lesson : lessons)
    for (AuditLadder& ladder : lesson.ladder) judge(rule, ladder);
  return true;
}

/// Adds every lesson that comes with Swage, in the order of their numbers. False with the problem printed.
bool add_series(std::vector<std::string>& lessons) {
  std::vector<std::string> searched, found;
  const std::string folder = data_folder("lessons/series", searched);
  if (folder.empty()) {
    std::string places;
    for (const std::string& place : searched) places += (places.empty() ? "" : ", ") + place;
    return problem(say::kNoSeries(places)), false;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") found.push_back(entry.path().string());
  std::sort(found.begin(), found.end());
  lessons.insert(lessons.end(), found.begin(), found.end());
  return true;
}

/// Reads a lesson and plays it; false with the problems printed.
bool play(const AuditOptions& o, const std::string& path, AuditLesson& out) {
  host::Catalogue::Options search;
  search.plugin_dirs = o.plugin_dirs;
  const host::Catalogue catalogue(search);
  base::Problems problems;
  assembly::LessonFile file;
  if (!assembly::read_lesson_file(path, file, problems) ||
      !assembly::assemble(file, catalogue, {o.device, ""}, problems)) {
    tell(problems);
    return false;
  }
  out = play_levels({o.device, o.max_time_s, o.budget_s, o.only}, catalogue, std::move(file), progress);
  progress("");
  return true;
}

}  // namespace

int audit(const AuditOptions& o) {
  const host::ScopedRole main_role(SWAGE_THREAD_MAIN);
  const AuditRule rule{o.tolerance};
  std::vector<std::string> paths = o.lessons;
  if (o.series && !add_series(paths)) return kProblem;
  if (paths.empty()) return problem(say::kNameLessons());

  bool good = true;
  Json all = Json::array();
  std::vector<AuditLesson> lessons;
  if (o.add && o.out.empty()) return problem(say::kAddNeedsOut());
  if (o.add && !read_earlier(o.out, rule, lessons)) return kProblem;
  for (const std::string& path : paths) {
    AuditLesson lesson;
    if (!play(o, path, lesson)) return kProblem;
    if (!o.json)
      std::printf("%s%s: hand %s, tolerance %.3g %%\n", path == paths.front() ? "" : "\n", lesson.title.c_str(),
                  o.device.c_str(), 100 * o.tolerance);
    if (lesson.ladder.empty()) return problem(say::kNoLadder(path));
    Json out = {{"lesson", path}, {"device", o.device}, {"tolerance", o.tolerance}};
    for (AuditLadder& ladder : lesson.ladder) {
      judge(rule, ladder);
      good &= ladder.level[ladder.own].enough;
      if (o.json)
        out["ladders"].push_back(to_json(ladder));
      else
        print_ladder(ladder);
    }
    all.push_back(std::move(out));
    add_lesson(lessons, std::move(lesson));
    std::fflush(stdout);
  }
  if (o.json) print(all);
  if (!o.out.empty() && !write_all(o.out, lessons, rule))
    return problem(say::kNotWritten(o.out));
  return good ? kPassed : kNotPassed;
}

}  // namespace swage::tools
