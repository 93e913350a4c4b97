// SPDX-License-Identifier: Apache-2.0
//
// swage attempts: the attempts in the store.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/nearest.hpp"
#include "record/address.hpp"
#include "record/backup.hpp"
#include "record/identity.hpp"
#include "record/salvage.hpp"
#include "record/school.hpp"
#include "record/sentences.hpp"
#include "record/store.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

// `may_make`: creates a missing store, for an import
std::unique_ptr<record::Store> open(const AttemptsOptions& o, bool may_make = false) {
  std::string error;
  const std::string where = store_place(o.store);
  auto store = may_make ? record::Store::open(where, error) : existing_store(where, error);
  if (!store) {
    problem(error);
    return nullptr;
  }
  // attempts whose program ended early are listed as such
  store->recover();
  if (store->read_only())
    tell(base::Severity::kNote, record::shown(where), say::kOnlyRead());
  return store;
}

Json to_json(const record::AttemptRow& a) {
  Json metrics = Json::array();
  for (const record::MetricValue& m : a.metrics)
    metrics.push_back({{"id", m.id}, {"value", number(m.value)}, {"unit", m.unit}});
  return {{"attempt", a.id},
          {"person", a.person_name},
          {"code", a.person_code},
          {"lesson", a.lesson_id},
          {"title", a.lesson_title},
          {"mode", a.mode},
          {"device", a.device},
          {"started_utc", a.started_utc},
          {"ended_utc", a.ended_utc},
          {"state", a.state},
          {"outcome", a.outcome},
          {"reason", a.reason},
          {"score", number(a.score)},
          {"simulated_s", number(a.simulated_s)},
          {"void", a.is_void},
          {"void_reason", a.void_reason},
          {"void_by", a.void_by},
          {"scripted", a.is_scripted},
          {"synthetic", a.is_synthetic},
          {"lesson_version", a.lesson_digest},
          {"remark", a.remark},
          {"metrics", metrics}};
}

}  // namespace

int list_attempts(const AttemptsOptions& o) {
  const auto store = open(o);
  if (!store) return kProblem;
  std::string person_id;
  if (!o.person.empty()) {
    std::vector<std::string> names;
    for (const record::Person& p : store->people()) {
      names.push_back(p.name);
      if (p.name == o.person) person_id = p.id;
    }
    if (!store->trouble().empty()) return problem(store->trouble());
    if (person_id.empty())
      return problem(record::say::kNobody(o.person) + host::did_you_mean(o.person, names));
  }

  const std::vector<record::AttemptRow> attempts = store->attempts(person_id, o.lesson);
  if (!store->trouble().empty()) return problem(store->trouble());
  if (o.json) {
    Json out = Json::array();
    for (const record::AttemptRow& a : attempts) out.push_back(to_json(a));
    print(out);
    return kPassed;
  }
  if (attempts.empty()) std::printf("no attempts in %s\n", record::shown(store_place(o.store)).c_str());
  for (const record::AttemptRow& a : attempts) {
    const std::string how = a.is_void ? "void" : a.state == "complete" ? a.outcome : a.state;
    // an attempt that was not passed has no score, as in the console; --json gives the lesson's own
    const bool scored = a.outcome == "passed" && std::isfinite(a.score);
    std::printf("%s  %s  %-16s %-28s %-10s %5s  %8.1f s  %s\n", printable(a.id).c_str(), printable(a.started_utc.substr(0, 16)).c_str(),
                printable(a.person_name).c_str(), printable(a.lesson_id).c_str(), printable(how).c_str(),
                (scored ? format("%.1f", a.score) : std::string("-")).c_str(), a.simulated_s,
                printable(a.remark.empty() ? a.reason : a.reason + " (" + a.remark + ")").c_str());
  }
  return kPassed;
}

int import_attempts(const AttemptsOptions& o) {
  const auto store = open(o, true);
  if (!store) return kProblem;
  Json list = Json::array();
  bool good = true;
  for (const std::string& file : o.files) {
    std::string id, error;
    if (!store->import_attempt(file, id, error)) {
      problem(error);
      good = false;
      continue;
    }
    list.push_back({{"file", file}, {"attempt", id}});
    if (!o.json) std::printf("%s  %s\n", id.c_str(), file.c_str());
  }
  if (o.json) print(list);
  return good ? kPassed : kProblem;
}

int salvage_store(const AttemptsOptions& o) {
  const std::string where = store_place(o.store);
  record::Salvaged out;
  std::string error;
  const bool done = o.file.empty() ? record::salvage_in_place(where, out, error)
                                   : record::salvage(where, o.file, out, error);
  if (!done) return problem(error);
  if (o.json) {
    print({{"store", o.file.empty() ? where : o.file},
           {"damaged", out.damaged},
           {"whole", out.whole},
           {"shortened", out.shortened},
           {"altered", out.altered},
           {"lost", out.headless},
           {"lost_rows", out.lost_rows}});
    return kPassed;
  }
  std::printf("%llu attempts whole, %llu with a recording that ends early, %llu with rows that are not what they were, "
              "%llu lost\n",
              static_cast<unsigned long long>(out.whole), static_cast<unsigned long long>(out.shortened),
              static_cast<unsigned long long>(out.altered),
              static_cast<unsigned long long>(out.headless));
  std::printf("the store is %s\n", o.file.empty() ? where.c_str() : o.file.c_str());
  if (!out.damaged.empty()) std::printf("the damaged one lies in %s\n", out.damaged.c_str());
  return kPassed;
}

int backup_attempts(const AttemptsOptions& o) {
  record::Copied out;
  std::string error;
  const std::string where = store_place(o.store);
  std::error_code unknown;
  if (!o.force && std::filesystem::exists(o.file, unknown)) return problem(say::kBackupThere(o.file));
  if (!existing_store(where, error) || !record::backup_store(where, o.file, out, error)) return problem(error);
  // the file is listed, so that erasing a person later covers it too
  std::error_code ignored;
  std::vector<std::string> ids;
  const auto school = record::School::open(where, error);
  if (school)
    for (const record::Person& p : school->people()) ids.push_back(p.id);
  if (school && !ids.empty()) school->log_export(ids, "backup", std::filesystem::absolute(o.file, ignored).string());
  if (o.json)
    print({{"file", o.file}, {"people", out.people}, {"attempts", out.attempts}});
  else
    std::printf("%llu attempts of %llu people in %s\n", static_cast<unsigned long long>(out.attempts),
                static_cast<unsigned long long>(out.people), o.file.c_str());
  return kPassed;
}

int restore_attempts(const AttemptsOptions& o) {
  record::Copied out;
  std::string error;
  const std::string where = store_place(o.store);
  if (!record::restore_store(o.file, where, out, error)) return problem(error);
  if (o.json)
    print({{"store", record::shown(where)}, {"attempts", out.attempts}, {"added", out.added}});
  else
    std::printf("%llu of %llu attempts were added to %s, the others were there\n",
                static_cast<unsigned long long>(out.added), static_cast<unsigned long long>(out.attempts),
                record::shown(where).c_str());
  return kPassed;
}

}  // namespace swage::tools
