// SPDX-License-Identifier: Apache-2.0
#include "record/export.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "record/attempt_rows.hpp"
#include "record/schema.hpp"

namespace swage::record {
namespace {

using nlohmann::json;

using Plugins = std::vector<std::pair<std::string, std::string>>;

std::string plugin_list(const Plugins& plugins) {
  std::vector<std::string> seen;
  for (const auto& [id, version] : plugins)
    if (const std::string both = id + " " + version; std::find(seen.begin(), seen.end(), both) == seen.end()) seen.push_back(both);
  std::string out;
  for (const std::string& s : seen) out += (out.empty() ? "" : "; ") + s;
  return out;
}

// The version of the lesson plugin, which computes the metrics.
std::string metric_version(const std::string& lesson_plugin, const Plugins& plugins) {
  for (const auto& [id, version] : plugins)
    if (id == lesson_plugin) return id + " " + version;
  return "";
}

std::string lesson_plugin(const std::string& descriptor) {
  const json lesson = json::parse(descriptor, nullptr, false);
  if (!lesson.is_object() || !lesson.contains("lesson") || !lesson["lesson"].is_object()) return "";
  const json& plugin = lesson["lesson"].value("plugin", json());
  return plugin.is_string() ? plugin.get<std::string>() : "";
}

std::vector<Health> health_of(const std::string& loop_health, int64_t steps_not_recorded) {
  std::vector<Health> out;
  const json h = json::parse(loop_health, nullptr, false);
  const auto add = [&](const std::string& id, const char* unit, const json& from, const char* key) {
    if (from.is_object() && from.contains(key) && from[key].is_number()) out.push_back({id, unit, from[key].get<double>()});
  };
  for (const char* key : {"executed", "late", "overrun", "dropped"}) add(std::string("steps.") + key, "1", h, key);
  add("steps.worst_wake", "s", h, "worst_wake_s");
  add("steps.worst", "s", h, "worst_step_s");
  add("forces_off", "s", h, "forces_off_s");
  out.push_back({"steps.not_recorded", "1", static_cast<double>(steps_not_recorded)});
  if (!h.is_object()) return out;
  for (const auto& field : base::kSolverHealthFields) add(std::string("solver.") + field.id, "1", h.value("solver", json()), field.id);
  for (const auto& field : base::kDrawingHealthFields) add(std::string("visuals.") + field.id, "1", h.value("visuals", json()), field.id);
  return out;
}

// Reads everything that Store::attempts does not give.
bool read_details(Database& db, const Selection& which, std::map<std::string, Exported>& out) {
  const int version = schema_version(db);
  const bool school = version >= 4, files = version >= 2;
  const std::string sql =
      std::string("SELECT a.attempt_id, s.station, s.app_version, a.plugins, a.dt_s, a.realtime, a.loop_health, a.dropped, a.descriptor") +
      (school ? ", v.input, v.calibration" : ", '', '[]'") + (files ? ", f.data" : "") +
      " FROM attempt a JOIN session s ON s.session_id = a.session_id" +
      (school ? " LEFT JOIN provenance v ON v.attempt_id = a.attempt_id" : "") +
      (files ? " LEFT JOIN file f ON f.attempt_id = a.attempt_id AND f.name = '" + std::string(kDisplayFile) + "'" : "") +
      " WHERE (? = '' OR s.person_id = ?) AND (? = '' OR a.exercise = ?) AND (? = '' OR a.attempt_id = ?)";
  std::map<std::string, std::string> known;  // cache, lesson plugin by text: attempts have few different texts
  return db.each(sql, {which.person_id, which.person_id, which.lesson_id, which.lesson_id, which.attempt_id, which.attempt_id},
                 [&](const Row& r) {
                   Exported& e = out[text(r[0])];
                   Plugins plugins;
                   from_json(text(r[3]), plugins);
                   const auto [at, is_new] = known.try_emplace(text(r[8]));
                   if (is_new) at->second = lesson_plugin(at->first);
                   e.station = text(r[1]);
                   e.app_version = text(r[2]);
                   e.plugins = plugin_list(plugins);
                   e.metric_version = metric_version(at->second, plugins);
                   e.dt_s = real(r[4]);
                   e.realtime = integer(r[5]) != 0;
                   e.health = health_of(text(r[6]), integer(r[7]));
                   e.input = text(r[9]);
                   e.calibration = text(r[10]).empty() ? "[]" : text(r[10]);
                   Display display;
                   if (const Blob* data = files ? std::get_if<Blob>(&r[11]) : nullptr)
                     from_json(std::string(data->begin(), data->end()), display);
                   e.display = words(display);
                   return true;
                 });
}

std::string number(double value) {
  if (!std::isfinite(value)) return "";
  char out[40];
  std::snprintf(out, sizeof out, "%.17g", value);
  double shorter = 0;
  char brief[40];
  std::snprintf(brief, sizeof brief, "%.15g", value);
  return std::sscanf(brief, "%lf", &shorter) == 1 && shorter == value ? brief : out;
}

void line(std::string& out, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) out += (i > 0 ? "," : "") + csv_field(fields[i]);
  out += "\r\n";
}

const std::vector<std::string> kAboutColumns = {
    "attempt", "person", "lesson", "title", "lesson_version", "mode", "started_utc", "ended_utc", "state", "outcome", "reason",
    "score", "simulated_s", "void", "void_reason", "void_by", "scripted", "synthetic", "input", "device", "station",
    "app_version", "plugins", "metric_version", "calibration", "display", "realtime", "dt_s", "remark"};

std::vector<std::string> about(const Exported& e) {
  const AttemptRow& a = e.attempt;
  const auto yes = [](bool b) { return std::string(b ? "1" : "0"); };
  return {a.id, a.person_code, a.lesson_id, a.lesson_title, a.lesson_digest, a.mode, a.started_utc, a.ended_utc, a.state, a.outcome, a.reason,
          number(a.score), number(a.simulated_s), yes(a.is_void), a.void_reason, a.void_by, yes(a.is_scripted), yes(a.is_synthetic), e.input, a.device, e.station,
          e.app_version, e.plugins, e.metric_version, e.calibration, e.display, yes(e.realtime), number(e.dt_s), a.remark};
}

}  // namespace

bool read_for_export(const std::string& where, const Selection& which, std::vector<Exported>& out, std::string& error) {
  out.clear();
  const auto store = Store::open_to_read(where, error);
  const auto db = store ? open_for_reading(where.empty() ? Store::default_path() : where, error) : nullptr;
  if (!db) return false;
  std::vector<AttemptRow> attempts;
  if (which.attempt_id.empty())
    attempts = store->attempts(which.person_id, which.lesson_id);
  else if (!store->attempt(which.attempt_id, attempts.emplace_back()))
    attempts.clear();
  error = store->trouble();
  std::map<std::string, Exported> details;
  if (error.empty() && !read_details(*db, which, details)) error = "The store " + shown(where) + " cannot be read: " + db->error() + ".";
  if (!error.empty()) return false;
  std::reverse(attempts.begin(), attempts.end());
  for (AttemptRow& a : attempts) {
    Exported e = std::move(details[a.id]);
    e.grades = store->grades(a.id);
    std::reverse(e.grades.begin(), e.grades.end());
    e.attempt = std::move(a);
    out.push_back(std::move(e));
  }
  error = store->trouble();
  return error.empty();
}

std::string csv_field(const std::string& given) {
  std::string text = given;
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  // a number is kept; other text that begins like a formula is escaped
  double ignored = 0;
  char rest = 0;
  const bool is_number = std::sscanf(text.c_str(), "%lf%c", &ignored, &rest) == 1;
  if (!is_number && !text.empty() && std::string("=+-@\t").find(text[0]) != std::string::npos) text.insert(text.begin(), '\'');
  if (text.find_first_of("\",") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string csv_long(const std::vector<Exported>& list) {
  std::string out;
  std::vector<std::string> head = kAboutColumns;
  head.insert(head.end(), {"judged_utc", "judged_by", "metric", "value", "unit"});
  line(out, head);
  for (const Exported& e : list) {
    const std::vector<std::string> who = about(e);
    const auto add = [&](const std::string& when, const std::string& by, const std::string& id, double value, const std::string& unit) {
      std::vector<std::string> row = who;
      row.insert(row.end(), {when, by, id, number(value), unit});
      line(out, row);
    };
    for (const MetricValue& m : e.attempt.metrics) add(e.attempt.ended_utc, e.metric_version, m.id, m.value, m.unit);
    for (const Health& h : e.health) add(e.attempt.ended_utc, e.app_version, "health." + h.id, h.value, h.unit);
    for (const Grade& g : e.grades) {
      const std::string by = plugin_list(g.plugins);
      add(g.graded_utc, by, "score", g.score, "1");
      for (const MetricValue& m : g.metrics) add(g.graded_utc, by, m.id, m.value, m.unit);
    }
  }
  return out;
}

std::string csv_wide(const std::vector<Exported>& list) {
  std::vector<std::pair<std::string, std::string>> columns, healths;  // id, unit
  const auto know = [](auto& known, const std::string& id, const std::string& unit) {
    const std::pair<std::string, std::string> column(id, unit);
    if (std::find(known.begin(), known.end(), column) == known.end()) known.push_back(column);
  };
  for (const Exported& e : list) {
    for (const MetricValue& m : e.attempt.metrics) know(columns, m.id, m.unit);
    for (const Health& h : e.health) know(healths, h.id, h.unit);
  }
  std::string out;
  std::vector<std::string> head = kAboutColumns;
  for (const auto& [id, unit] : columns) head.push_back(id + " [" + unit + "]");
  for (const auto& [id, unit] : healths) head.push_back("health." + id + " [" + unit + "]");
  line(out, head);
  for (const Exported& e : list) {
    std::vector<std::string> row = about(e);
    const auto find = [](const auto& values, const auto& column) {
      for (const auto& v : values)
        if (v.id == column.first && v.unit == column.second) return number(v.value);
      return std::string();
    };
    for (const auto& c : columns) row.push_back(find(e.attempt.metrics, c));
    for (const auto& c : healths) row.push_back(find(e.health, c));
    line(out, row);
  }
  return out;
}

std::string about_json(const Exported& e) {
  nlohmann::ordered_json out;
  const std::vector<std::string> values = about(e);
  for (std::size_t i = 0; i < values.size(); ++i) out[kAboutColumns[i]] = values[i];
  for (const Health& h : e.health) out["health"][h.id] = h.value;
  return out.dump(2, ' ', false, json::error_handler_t::replace);
}

}  // namespace swage::record
