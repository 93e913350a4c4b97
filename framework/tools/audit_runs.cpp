// SPDX-License-Identifier: Apache-2.0
//
// The runs of an audit as JSON, so that a long audit can be made in pieces.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "tools/audit.hpp"
#include "tools/print.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "swage-audit/1";

Json to_json(const AuditRun& run) {
  Json out = {{"level", run.level},          {"problem", run.problem}, {"outcome", run.outcome},
              {"reason", run.reason},        {"score", run.score},     {"cpu_s", run.cpu_s},
              {"simulated_s", run.simulated_s}};
  for (const AuditMetric& m : run.metric) out["metrics"].push_back({m.id, m.unit, number(m.value)});
  return out;
}

AuditRun run_from(const Json& json) {
  AuditRun out;
  json.at("level").get_to(out.level);
  json.at("problem").get_to(out.problem);
  json.at("outcome").get_to(out.outcome);
  json.at("reason").get_to(out.reason);
  json.at("score").get_to(out.score);
  json.at("cpu_s").get_to(out.cpu_s);
  json.at("simulated_s").get_to(out.simulated_s);
  for (const Json& m : json.value("metrics", Json::array()))
    out.metric.push_back({m.at(0), m.at(1), m.at(2).is_null() ? std::numeric_limits<double>::quiet_NaN() : m.at(2).get<double>()});
  return out;
}

AuditLesson lesson_from(const Json& json) {
  AuditLesson out{json.at("path"), json.at("id"), json.at("title"), json.at("device"), {}};
  for (const Json& row : json.at("ladders")) {
    AuditLadder& ladder = out.ladder.emplace_back();
    row.at("name").get_to(ladder.name);
    row.at("plugin").get_to(ladder.plugin);
    for (const Json& run : row.at("runs")) ladder.level.emplace_back().run = run_from(run);
    row.at("own").get_to(ladder.own);
    if (ladder.own >= ladder.level.size()) throw std::out_of_range("own");
  }
  return out;
}

std::string file_name(const AuditLesson& lesson) { return std::filesystem::path(lesson.path).filename().string(); }

}  // namespace

std::string audit_runs(const std::vector<AuditLesson>& lessons) {
  Json all = {{"format", kFormat}, {"lessons", Json::array()}};
  for (const AuditLesson& lesson : lessons) {
    Json& out = all["lessons"].emplace_back(
        Json{{"path", lesson.path}, {"id", lesson.id}, {"title", lesson.title}, {"device", lesson.device}, {"ladders", Json::array()}});
    for (const AuditLadder& ladder : lesson.ladder) {
      Json& row = out["ladders"].emplace_back(Json{{"name", ladder.name}, {"plugin", ladder.plugin}, {"own", ladder.own}});
      for (const AuditLevel& level : ladder.level) row["runs"].push_back(to_json(level.run));
    }
  }
  return all.dump(1) + "\n";
}

bool read_audit_runs(const std::string& text, std::vector<AuditLesson>& lessons) {
  try {
    const Json all = Json::parse(text);
    if (all.at("format") != kFormat) return false;
    for (const Json& lesson : all.at("lessons")) add_lesson(lessons, lesson_from(lesson));
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void add_lesson(std::vector<AuditLesson>& lessons, AuditLesson lesson) {
  const auto same = [&](const AuditLesson& l) { return l.id == lesson.id && l.device == lesson.device; };
  std::erase_if(lessons, same);
  const auto after = [&](const AuditLesson& l) { return file_name(l) > file_name(lesson); };
  lessons.insert(std::find_if(lessons.begin(), lessons.end(), after), std::move(lesson));
}

}  // namespace swage::tools
