// SPDX-License-Identifier: Apache-2.0
//
// Statements of the Experience API 1.0.3 (github.com/adlnet/xAPI-Spec, xAPI-Data.md). cmi5 allows "passed" once per registration,
// so the verb of an attempt is always "attempted"; its result has the outcome.
#include <QtCore/QString>
#include <QtCore/QUuid>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "record/export.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

using Json = nlohmann::ordered_json;

// UUID version 5 of RFC 4122: the same name gives the same identifier, and every record store accepts that version.
std::string named_id(const std::string& name) {
  static const QUuid kSpace(QStringLiteral("6f6a9bd6-6a2f-4d1c-9d2e-0b7c1f3a5e88"));
  return QUuid::createUuidV5(kSpace, QString::fromStdString(name)).toString(QUuid::WithoutBraces).toStdString();
}

// Characters that are allowed in the path of an IRI; all others become %XX.
std::string in_iri(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '_';
    char hex[4];
    std::snprintf(hex, sizeof hex, "%%%02X", static_cast<unsigned char>(c));
    out += plain ? std::string(1, c) : std::string(hex);
  }
  return out;
}

std::string duration(double seconds) {
  char out[32];
  std::snprintf(out, sizeof out, "PT%.2fS", std::isfinite(seconds) && seconds > 0 ? seconds : 0.0);
  return out;
}

Json metrics_json(const Exported& e) {
  Json out = Json::object();
  for (const MetricValue& m : e.attempt.metrics) {
    if (!std::isfinite(m.value)) continue;
    out[m.id] = {{"value", m.value}, {"unit", m.unit}, {"version", e.metric_version}};
  }
  return out;
}

Json result(const Exported& e, const std::string& home) {
  const AttemptRow& a = e.attempt;
  Json out;
  if (std::isfinite(a.score) && a.score >= 0 && a.score <= 100)
    out["score"] = {{"scaled", a.score / 100}, {"raw", a.score}, {"min", 0}, {"max", 100}};
  // a void attempt and practice have no success: cmi5 excludes both from satisfaction
  if (a.mode == "test" && !a.is_void && a.state == "complete") out["success"] = a.outcome == "passed";
  out["completion"] = a.state == "complete";
  out["duration"] = duration(a.simulated_s);
  out["extensions"] = {{home + "/x/metrics", metrics_json(e)}};
  return out;
}

Json context(const Exported& e, const std::string& home) {
  const AttemptRow& a = e.attempt;
  Json health = Json::object();
  for (const Health& h : e.health)
    if (std::isfinite(h.value)) health[h.id] = h.value;
  Json extensions;
  const auto add = [&](const char* key, Json value) { extensions[home + "/x/" + key] = std::move(value); };
  add("attempt", a.id);
  add("mode", a.mode);
  add("valid", !a.is_void);
  if (!a.void_reason.empty()) add("ruling", a.void_reason);
  add("lesson-version", a.lesson_digest);
  add("plugins", e.plugins);
  add("input", e.input);
  add("display", e.display);
  add("device", a.device);
  add("scripted", a.is_scripted);
  add("synthetic", a.is_synthetic);
  add("realtime", e.realtime);
  add("health", std::move(health));
  const Json calibration = Json::parse(e.calibration, nullptr, false);
  add("calibration", calibration.is_discarded() ? Json::array() : calibration);
  return {{"registration", named_id(home + " " + a.person_code + " " + a.lesson_id)},
          {"platform", "Swage " + e.app_version},
          {"extensions", extensions}};
}

Json statement(const Exported& e, const std::string& home) {
  const AttemptRow& a = e.attempt;
  const std::string version = a.lesson_digest.empty() ? "" : "/" + a.lesson_digest.substr(0, 16);
  Json definition = {{"type", "http://adlnet.gov/expapi/activities/simulation"}};
  if (!a.lesson_title.empty()) definition["name"] = {{"en", a.lesson_title}};
  return {{"id", named_id(home + " " + a.id)},
          {"version", "1.0.3"},
          {"actor", {{"objectType", "Agent"}, {"account", {{"homePage", home}, {"name", a.person_code}}}}},
          {"verb", {{"id", "http://adlnet.gov/expapi/verbs/attempted"}, {"display", {{"en", "attempted"}}}}},
          {"object", {{"objectType", "Activity"}, {"id", home + "/lesson/" + in_iri(a.lesson_id) + version}, {"definition", definition}}},
          {"result", result(e, home)},
          {"context", context(e, home)},
          {"timestamp", a.ended_utc.empty() ? a.started_utc : a.ended_utc}};
}

bool is_home(const std::string& home) {
  const std::size_t scheme = home.starts_with("https://") ? 8 : home.starts_with("http://") ? 7 : 0;
  return scheme > 0 && home.size() > scheme && home.back() != '/' && home.find_first_of(" <>\"{}|\\^`\n\t") == std::string::npos;
}

}  // namespace

bool xapi_statements(const std::vector<Exported>& list, const std::string& home, std::string& out, std::string& error) {
  if (!is_home(home)) {
    error = say::kNoHome(home);
    return false;
  }
  Json statements = Json::array();
  for (const Exported& e : list)
    if (e.attempt.state != "running") statements.push_back(statement(e, home));
  out = statements.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  return true;
}

}  // namespace swage::record
