// SPDX-License-Identifier: Apache-2.0
//
// swage attempts void, name, note and export: people's statements about attempts, and attempts in other formats.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "record/export.hpp"
#include "record/identity.hpp"
#include "record/recorder.hpp"
#include "record/sentences.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

struct Found {
  std::unique_ptr<record::School> school;
  record::AttemptRow attempt;
};

// finds the attempt in a writable store; false with the reason printed
bool find(const AttemptWords& o, Found& out) {
  std::string error;
  const std::string where = store_place(o.store);
  const auto store = existing_store(where, error);
  if (!store || !find_attempt(*store, o.id, out.attempt, error)) return problem(error), false;
  out.school = record::School::open(where, error);
  if (!out.school) problem(error);
  return out.school != nullptr;
}

std::string by(const AttemptWords& o) { return o.by.empty() ? user_name() : o.by; }

bool put_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file.good() || problem(say::kNotWritten(path)) == kPassed;
}

int answer(const AttemptWords& o, const Json& json, const std::string& text) {
  if (o.json)
    print(json);
  else
    std::printf("%s\n", printable(text).c_str());
  return kPassed;
}

// Lists an exported file in its store, so that erasing a person finds the file too; notes it where that fails.
void keep_in_mind(const std::string& where, const std::vector<record::Exported>& list, const std::string& kind, const std::string& file) {
  std::set<std::string> people;
  for (const record::Exported& e : list) people.insert(e.attempt.person_id);
  std::string error;
  const auto school = record::School::open(where, error);
  std::error_code ignored;
  const std::string path = std::filesystem::absolute(file, ignored).string();
  if (school && !people.empty() && school->log_export({people.begin(), people.end()}, kind, path)) return;
  tell(base::Severity::kNote, file, say::kFileNotFound());
}

int export_file(const std::string& where, const record::AttemptRow& row, const std::string& file) {
  std::string error;
  const auto store = existing_store(where, error);
  if (!store || !store->export_attempt(row.id, file, error)) return problem(error);
  return kPassed;
}

std::string ending_of(const std::string& as) {
  if (as == "swage") return ".swage";
  return as == "xapi" ? ".xapi.json" : ".csv";
}

// writes a table or statements into `text`; false with the reason printed
bool text_of(const AttemptWords& o, const std::vector<record::Exported>& list, std::string& text) {
  std::string error;
  if (o.as == "csv") text = record::csv_long(list);
  if (o.as == "csv-wide") text = record::csv_wide(list);
  if (o.as == "xapi" && !record::xapi_statements(list, o.home, text, error)) return problem(say::kOfHome(error)), false;
  return true;
}

}  // namespace

int void_attempt(const AttemptWords& o) {
  Found f;
  if (!find(o, f)) return kProblem;
  if (!f.school->set_void(f.attempt.id, !o.undo, o.text, by(o))) return problem(f.school->error());
  return answer(o, {{"attempt", f.attempt.id}, {"void", !o.undo}, {"reason", o.text}, {"by", by(o)}},
             f.attempt.id + (o.undo ? " counts again" : " is void: ") + (o.undo ? "" : o.text));
}

int name_attempt(const AttemptWords& o) {
  Found f;
  record::Person p;
  if (!find(o, f)) return kProblem;
  if (!f.school->find_person(o.person, p)) return problem(say::kAddThem(f.school->error(), o.person));
  if (!f.school->name_attempt(f.attempt.id, p.id, by(o), o.even_if_named)) return problem(f.school->error());
  return answer(o, {{"attempt", f.attempt.id}, {"person", p.code}}, f.attempt.id + " is " + p.name + "'s");
}

int note_attempt(const AttemptWords& o) {
  Found f;
  if (!find(o, f)) return kProblem;
  if (!o.text.empty()) {
    if (!(o.at_s >= 0) || o.at_s > f.attempt.simulated_s)
      return problem(say::kOutsideAttempt(format("%g", o.at_s), format("%.3f", f.attempt.simulated_s)));
    record::Note n{"", f.attempt.id, static_cast<uint64_t>(std::llround(o.at_s * 1000)), o.at_s, "", by(o), o.text};
    if (!f.school->save_note(n)) return problem(f.school->error());
  }
  Json list = Json::array();
  for (const record::Note& n : f.school->notes(f.attempt.id)) {
    list.push_back({{"time_s", n.time_s}, {"by", n.made_by}, {"made_utc", n.made_utc}, {"note", n.text}});
    if (!o.json) std::printf("%9.3f s  %s (%s)\n", n.time_s, printable(n.text).c_str(), printable(n.made_by).c_str());
  }
  if (o.json) print(list);
  return kPassed;
}

bool write_trace(const std::string& file, const std::string& store, const std::string& attempt) {
  record::Recording r;
  std::vector<record::Exported> about;
  std::string error = say::kNotKept();
  if (attempt.empty() || !record::read_recording(store, attempt, r, error) ||
      !record::read_for_export(store, {"", "", attempt}, about, error) || about.empty()) {
    tell(base::Severity::kError, file, say::kNoTrace(error));
    return false;
  }
  std::ofstream out(file);
  out << "time [s]";
  const auto& signals = r.info.script.signals;
  for (const judge::Name& s : signals) out << "," << s.owner << "." << s.id << " [" << s.unit << "]";
  for (const std::string& d : r.info.devices)
    for (const char* what : {"x [m]", "y [m]", "z [m]", "qw [1]", "qx [1]", "qy [1]", "qz [1]", "closure [1]", "grip [N]"}) out << "," << d << "." << what;
  out << "\n";
  const std::size_t devices = r.info.devices.size();
  for (std::size_t i = 0; i < r.step.size(); ++i) {
    out << format("%.6f", static_cast<double>(r.step[i] + 1) * r.info.dt);
    for (std::size_t k = 0; k < signals.size(); ++k)
      out << format(",%.7g", static_cast<double>(r.signal[i * signals.size() + k]));
    for (std::size_t d = 0; d < devices; ++d) {
      const swage_sample& s = r.sample[i * devices + d];
      const double values[] = {s.pose.p.x, s.pose.p.y, s.pose.p.z, s.pose.q.w, s.pose.q.x, s.pose.q.y, s.pose.q.z, s.closure, s.grip_force};
      for (const double v : values) out << format(",%.9g", v);
    }
    out << "\n";
  }
  out.close();
  const bool good = out.good() && put_file(file + ".about.json", record::about_json(about[0]) + "\n");
  if (!good) tell(base::Severity::kError, file, say::kTraceNotWhole());
  return good;
}

int export_attempts(const AttemptWords& given) {
  AttemptWords o = given;
  if (o.trace) o.as = "trace";
  const std::string where = store_place(o.store);
  std::string error;
  const auto store = existing_store(where, error);
  if (!store) return problem(error);
  record::Selection which;
  which.lesson_id = o.lesson;
  record::AttemptRow row;
  const bool all = o.id == "all";
  if (!all && !find_attempt(*store, o.id, row, error)) return problem(error);
  if (!all) which.attempt_id = row.id;
  if (row.state == "running") return problem(record::say::kStillRunning(row.id));
  if (all && (o.as == "swage" || o.as == "trace")) return problem(say::kAllIsTables());
  if (!o.person.empty()) {
    const auto people = store->people();
    const auto found = std::find_if(people.begin(), people.end(), [&](const record::Person& p) { return p.code == o.person || p.name == o.person; });
    if (found == people.end()) return problem(record::say::kNobody(o.person));
    which.person_id = found->id;
  }
  std::vector<record::Exported> list;
  if (!record::read_for_export(where, which, list, error)) return problem(error);
  // an attempt's id names the file only if it is an id: it could be a path
  const std::string file = !o.file.empty() ? o.file : (!all && record::is_id(row.id) ? row.id : "attempts") + ending_of(o.as);
  std::string text;
  if (o.as == "swage") {
    if (const int code = export_file(where, row, file); code != kPassed) return code;
  } else if (o.as == "trace") {
    if (!write_trace(file, where, row.id)) return kProblem;
  } else if (!text_of(o, list, text) || !put_file(file, text)) {
    return kProblem;
  }
  keep_in_mind(where, list, o.as.starts_with("csv") ? "csv" : o.as, file);
  if (!all) return answer(o, {{"attempt", row.id}, {"file", file}}, file);
  return answer(o, {{"attempts", list.size()}, {"file", file}}, file + ": " + std::to_string(list.size()) + " attempts");
}

}  // namespace swage::tools
