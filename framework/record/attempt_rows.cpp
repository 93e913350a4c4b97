// SPDX-License-Identifier: Apache-2.0
#include "record/attempt_rows.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "record/codec.hpp"
#include "record/identity.hpp"
#include "record/school.hpp"

namespace swage::record {

const char* const kAttemptColumns =
    "attempt_id, session_id, exercise, title, mode, device, started_utc, ended_utc, state, outcome, reason, "
    "score,"
    " simulated_s, is_void, dropped, seed, dt_s, realtime, descriptor, descriptor_path, plugins, devices, "
    "script,"
    " loop_health";

namespace {

using nlohmann::json;

struct Statement {
  std::string sql;
  std::size_t arity;
};

const Statement& statement(Kind kind) {
  // the order is that of Kind
  static const Statement kStatements[kKinds] = {
      // a person is identified by the code, or by the name that an instructor gave
      {"INSERT INTO person (person_id, pseudonym, created_utc) SELECT w.id, w.name, w.utc FROM"
       " (SELECT CAST(? AS TEXT) AS id, CAST(? AS TEXT) AS name, CAST(? AS TEXT) AS utc) w"
       " WHERE NOT EXISTS (SELECT 1 FROM roster n WHERE n.display_name = w.name) ON CONFLICT DO NOTHING",
       3},
      {"INSERT INTO session (session_id, person_id, station, app_version, started_utc)"
       " SELECT w.id, p.person_id, w.station, w.app, w.utc FROM (SELECT CAST(? AS TEXT) AS id, CAST(? AS TEXT) AS station,"
       " CAST(? AS TEXT) AS app, CAST(? AS TEXT) AS utc, CAST(? AS TEXT) AS name) w, person p"
       " LEFT JOIN roster n ON n.person_id = p.person_id WHERE p.pseudonym = w.name OR n.display_name = w.name"
       " ORDER BY CASE WHEN p.pseudonym = w.name THEN 0 ELSE 1 END, p.person_id LIMIT 1 ON CONFLICT DO NOTHING",
       5},
      {"INSERT INTO device (device_id, plugin, serial, descriptor) VALUES (?, ?, ?, ?) ON CONFLICT DO "
       "NOTHING",
       4},
      {"INSERT INTO attempt (" + std::string(kAttemptColumns) +
           ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO "
           "NOTHING",
       24},
      {"INSERT INTO metric (attempt_id, seq, name, value, unit) VALUES (?, ?, ?, ?, ?) ON CONFLICT DO "
       "NOTHING",
       5},
      {"INSERT INTO event (attempt_id, seq, step, t_us, kind, script_index, owner, body, value)"
       " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING",
       9},
      {"INSERT INTO chunk (attempt_id, stream, seq, t0_us, n, codec, crc32c, data, dictionary)"
       " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING",
       9},
      {"UPDATE attempt SET ended_utc = ?, state = ?, outcome = ?, reason = ?, score = ?, simulated_s = ?, "
       "is_void = ?,"
       " dropped = ?, loop_health = ? WHERE attempt_id = ?",
       10},
      {"INSERT INTO hand (attempt_id, seq, name, choice, plugin, version, params, flags)"
       " VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING",
       8},
      {"INSERT INTO file (attempt_id, name, crc32c, data) VALUES (?, ?, ?, ?) ON CONFLICT DO NOTHING", 4},
      {"INSERT INTO provenance (attempt_id, lesson_digest, input, calibration, is_scripted, is_synthetic)"
       " VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING",
       6},
      {"INSERT INTO note (note_id, attempt_id, step, t_us, made_utc, made_by, body) VALUES (?, ?, ?, ?, ?, ?, ?)"
       " ON CONFLICT DO NOTHING",
       7},
      {"INSERT INTO ruling (ruling_id, attempt_id, kind, made_utc, made_by, reason) VALUES (?, ?, ?, ?, ?, ?)"
       " ON CONFLICT DO NOTHING",
       6},
      {"INSERT INTO rating (attempt_id, item, points, made_utc, made_by) VALUES (?, ?, ?, ?, ?) ON CONFLICT DO NOTHING", 5},
  };
  return kStatements[static_cast<std::size_t>(kind)];
}

// session: all attempts of one person in one run of the program
std::string session_of(const std::string& person) {
  static std::mutex mutex;
  static std::map<std::string, std::string> sessions;
  const std::lock_guard lock(mutex);
  std::string& id = sessions[person];
  if (id.empty()) id = make_id();
  return id;
}

json to_json(const std::vector<judge::Name>& names) {
  json out = json::array();
  for (const judge::Name& n : names)
    out.push_back({{"owner", n.owner}, {"id", n.id}, {"unit", n.unit}, {"doc", n.doc}});
  return out;
}

std::vector<judge::Name> names_from(const json& list) {
  std::vector<judge::Name> out;
  for (const json& n : list) out.push_back({n.at("owner"), n.at("id"), n.at("unit"), n.at("doc")});
  return out;
}

// index of the coupling that draws, null where the object does
json coupling_json(const base::DrawingHealth& h) { return h.coupling == base::kNoCoupling ? json(nullptr) : json(h.coupling); }

std::string health_json(const snapshot::LoopHealth& h, double forces_off_s) {
  json out = {{"executed", h.executed},
              {"late", h.late},
              {"overrun", h.overrun},
              {"dropped", h.dropped},
              {"worst_wake_s", h.worst_wake_s},
              {"worst_step_s", h.worst_step_s},
              {"mean_step_cpu_s", h.mean_step_cpu_s},
              {"realtime", h.realtime},
              {"quarantined", h.quarantined},
              {"forces_off_s", forces_off_s}};
  for (const auto& field : base::kSolverHealthFields) out["solver"][field.id] = h.solver.*field.count;
  out["solver"]["steps"] = h.solver.steps;
  for (const auto& field : base::kDrawingHealthFields) out["visuals"][field.id] = h.visuals.*field.count;
  if (h.visuals.faulty > 0)
    out["visuals"]["first"] = {{"object", h.visuals.object}, {"coupling", coupling_json(h.visuals)}, {"index", h.visuals.index},
                               {"kind", h.visuals.kind}, {"member", base::visual_member(h.visuals.member)}};
  out["phase_s"] = json::array();
  for (const double s : h.phase_s) out["phase_s"].push_back(s);
  return out.dump();
}

// reads the output of to_json; any other text is refused
template <class Read>
bool parse(const std::string& text, const Read& read) {
  try {
    read(json::parse(text));
    return true;
  } catch (const json::exception&) {
    return false;
  }
}

// Calibrations of an attempt: sensor, date, and residual of the fit.
std::string calibrations_json(const std::vector<FileInfo>& files) {
  json out = json::array();
  for (const FileInfo& f : files) {
    const json c = json::parse(f.bytes, nullptr, false);
    const bool in_use = f.name.starts_with(kCalibrationFile);
    const bool ours = c.is_object() && c.contains("format") && c["format"].is_string() &&
                      c["format"].get<std::string>().starts_with("swage-calibration/");
    if (!c.is_object() || (!in_use && !ours)) continue;
    json entry = {{"file", f.name}, {"crc32c", crc32c(f.bytes.data(), f.bytes.size())}};
    for (const char* key : {"serial", "date", "expires", "residual"})
      if (c.contains(key)) entry[key] = c[key];
    if (c.contains("displacement") && c["displacement"].is_object() && c["displacement"].contains("worst"))
      entry["residual"] = c["displacement"]["worst"];
    out.push_back(std::move(entry));
  }
  return out.dump();
}

// in the order of the columns of `attempt`
Write attempt_row(const std::string& attempt_id, const std::string& session, const std::string& now,
                  const AttemptInfo& info) {
  return {Kind::kAttempt,
          {attempt_id,
           session,
           info.lesson_id,
           info.lesson_title,
           info.mode,
           info.device,
           now,
           std::string(),
           std::string("running"),
           std::string(judge::text(judge::Outcome::kRunning)),
           std::string(),
           0.0,
           0.0,
           int64_t{0},
           int64_t{0},
           static_cast<int64_t>(info.seed),
           info.dt,
           int64_t{info.realtime},
           info.descriptor_text,
           info.descriptor_path,
           record::to_json(info.plugins),
           record::to_json(info.devices),
           record::to_json(info.script),
           std::string("{}")}};
}

}  // namespace

std::size_t arity(Kind kind) { return statement(kind).arity; }

bool write(Database& db, const Write& w) { return db.run(statement(w.kind).sql, w.values); }

bool write_batch(Database& db, const Batch& batch) {
  if (!db.begin()) return false;
  for (const Write& w : batch) {
    if (write(db, w)) continue;
    db.rollback();
    return false;
  }
  if (db.commit()) return true;
  db.rollback();
  return false;
}

Batch attempt_rows(const std::string& attempt_id, const AttemptInfo& info) {
  const std::string now = utc_now();
  const std::string session = session_of(info.person);
  Batch out;
  out.push_back({Kind::kPerson, {make_id(), info.person, now}});
  out.push_back({Kind::kSession, {session, station(), std::string(SWAGE_VERSION), now, info.person}});
  out.push_back({Kind::kDevice, {make_id(), info.device, std::string(), std::string()}});
  out.push_back(attempt_row(attempt_id, session, now, info));
  for (std::size_t i = 0; i < info.hands.size(); ++i) {
    const HandInfo& h = info.hands[i];
    out.push_back({Kind::kHand,
                   {attempt_id, static_cast<int64_t>(i), h.name, h.choice, h.plugin, h.version, h.params,
                    int64_t{h.flags}}});
  }
  const auto add_file = [&](const std::string& name, const std::string& bytes) {
    out.push_back({Kind::kFile,
                   {attempt_id, name, int64_t{crc32c(bytes.data(), bytes.size())}, Blob(bytes.begin(), bytes.end())}});
  };
  for (const FileInfo& f : info.files) add_file(f.name, f.bytes);
  if (!info.display.mode.empty()) add_file(kDisplayFile, to_json(info.display));
  out.push_back(provenance_row(attempt_id, info));
  return out;
}

Write provenance_row(const std::string& attempt_id, const AttemptInfo& info) {
  bool scripted = false, force = false;
  for (const HandInfo& h : info.hands) {
    scripted |= (h.flags & SWAGE_DEVICE_SCRIPTED) != 0;
    force |= (h.flags & SWAGE_DEVICE_FORCE) != 0;
  }
  return {Kind::kProvenance,
          {attempt_id, lesson_digest(info.descriptor_text), std::string(scripted ? "scripted" : force ? "force" : "position"),
           calibrations_json(info.files), int64_t{scripted}, int64_t{info.synthetic}}};
}

Batch end_rows(const std::string& attempt_id, const AttemptInfo& info, const AttemptEnd& end,
               uint64_t dropped) {
  Batch out;
  const auto& names = info.script.metrics;
  for (std::size_t i = 0; i < end.metric.size() && i < names.size(); ++i) {
    if (std::isnan(end.metric[i])) continue;
    out.push_back(
        {Kind::kMetric, {attempt_id, static_cast<int64_t>(i), names[i].id, end.metric[i], names[i].unit}});
  }
  const bool aborted = end.outcome == judge::Outcome::kAborted || end.outcome == judge::Outcome::kRunning;
  const judge::Outcome outcome = aborted ? judge::Outcome::kAborted : end.outcome;
  out.push_back({Kind::kEnd,
                 {utc_now(), std::string(aborted ? "aborted" : "complete"), std::string(judge::text(outcome)),
                  end.reason, end.score, end.simulated_s, int64_t{end.is_void}, static_cast<int64_t>(dropped),
                  health_json(end.health, end.forces_off_s), attempt_id}});
  return out;
}

// one omitted step in twenty is not perceptible
std::string remark(const std::string& loop_health, bool realtime, int64_t steps_missing) {
  constexpr double kSlow = 0.95;
  std::string out;
  const auto add = [&](const char* form, double number) {
    char text[96];
    std::snprintf(text, sizeof text, form, number);
    out += (out.empty() ? "" : ", ") + std::string(text);
  };
  parse(loop_health, [&](const json& h) {
    const double made = h.value("executed", 0.0), lost = h.value("dropped", 0.0);
    if (realtime && lost > 0 && made / (made + lost) < kSlow) add("at %.0f %% of real speed", 1e2 * made / (made + lost));
    if (const double off = h.value("forces_off_s", 0.0); off > 0) add("no forces for %.1f s", off);
  });
  if (steps_missing > 0) add("%.0f steps not recorded", static_cast<double>(steps_missing));
  return out;
}

std::string to_json(const judge::Script& script) {
  json out = {{"signals", to_json(script.signals)},
              {"metrics", to_json(script.metrics)},
              {"cues", to_json(script.cues)},
              {"events", to_json(script.events)},
              {"phases", to_json(script.phases)}};
  out["marks"] = json::array();
  for (const judge::Script::Mark& m : script.marks)
    out["marks"].push_back({{"kind", m.mark.kind},
                            {"object", m.mark.object},
                            {"meaning", m.meaning},
                            {"number", {m.mark.number[0], m.mark.number[1]}},
                            {"p_W", {m.mark.p_W.x, m.mark.p_W.y, m.mark.p_W.z}}});
  return out.dump();
}

bool from_json(const std::string& text, judge::Script& script) {
  return parse(text, [&](const json& j) {
    script.signals = names_from(j.at("signals"));
    script.metrics = names_from(j.at("metrics"));
    script.cues = names_from(j.at("cues"));
    script.events = names_from(j.at("events"));
    script.phases = names_from(j.at("phases"));
    script.marks.clear();
    for (const json& m : j.at("marks")) {
      judge::Script::Mark mark;
      mark.meaning = m.at("meaning");
      mark.mark = swage_mark{m.at("kind"),
                             m.at("object"),
                             swage_str{nullptr, 0},
                             {m.at("number").at(0), m.at("number").at(1)},
                             {m.at("p_W").at(0), m.at("p_W").at(1), m.at("p_W").at(2)}};
      script.marks.push_back(mark);
    }
  });
}

std::string to_json(const std::vector<std::pair<std::string, std::string>>& plugins) {
  json out = json::array();
  for (const auto& [id, version] : plugins) out.push_back({{"id", id}, {"version", version}});
  return out.dump();
}

bool from_json(const std::string& text, std::vector<std::pair<std::string, std::string>>& plugins) {
  return parse(text, [&](const json& j) {
    plugins.clear();
    for (const json& p : j) plugins.emplace_back(p.at("id"), p.at("version"));
  });
}

std::string metrics_json(const std::vector<MetricValue>& metrics) {
  json out = json::array();
  for (const MetricValue& m : metrics) out.push_back({{"id", m.id}, {"unit", m.unit}, {"value", m.value}});
  return out.dump();
}

bool metrics_from_json(const std::string& text, std::vector<MetricValue>& metrics) {
  return parse(text, [&](const json& j) {
    metrics.clear();
    for (const json& m : j) metrics.push_back({m.at("id"), m.at("unit"), m.at("value").get<double>()});
  });
}

std::string to_json(const std::vector<std::string>& names) { return json(names).dump(); }

bool from_json(const std::string& text, std::vector<std::string>& names) {
  return parse(text, [&](const json& j) { names = j.get<std::vector<std::string>>(); });
}

}  // namespace swage::record
