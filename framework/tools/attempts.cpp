// SPDX-License-Identifier: Apache-2.0
//
// swage attempts: what the store keeps.
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/nearest.hpp"
#include "record/store.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;

// importing may make the store
std::unique_ptr<record::Store> open(const AttemptsOptions& o, bool may_make = false) {
  std::string error;
  const std::string where = store_place(o.store);
  auto store = may_make ? record::Store::open(where, error) : existing_store(where, error);
  if (!store) {
    problem(error);
    return nullptr;
  }
  // attempts whose program died are shown as what they are
  store->recover();
  return store;
}

Json to_json(const record::AttemptRow& a) {
  Json metrics = Json::array();
  for (const record::MetricValue& m : a.metrics)
    metrics.push_back({{"id", m.id}, {"value", number(m.value)}, {"unit", m.unit}});
  return {{"attempt", a.id},
          {"person", a.person_name},
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
    if (person_id.empty())
      return problem("Nobody in the store is called \"" + o.person + "\"." +
                     host::did_you_mean(o.person, names));
  }

  const std::vector<record::AttemptRow> attempts = store->attempts(person_id, o.lesson);
  if (o.json) {
    Json out = Json::array();
    for (const record::AttemptRow& a : attempts) out.push_back(to_json(a));
    print(out);
    return kPassed;
  }
  if (attempts.empty()) std::printf("no attempts in %s\n", store_place(o.store).c_str());
  for (const record::AttemptRow& a : attempts) {
    const std::string how = a.state == "complete" ? a.outcome : a.state;
    std::printf("%s  %.16s  %-16s %-28s %-10s %5.1f  %8.1f s  %s\n", a.id.c_str(), a.started_utc.c_str(),
                a.person_name.c_str(), a.lesson_id.c_str(), how.c_str(),
                std::isfinite(a.score) ? a.score : 0.0, a.simulated_s, a.reason.c_str());
  }
  return kPassed;
}

int export_attempt(const AttemptsOptions& o) {
  const auto store = open(o);
  record::AttemptRow row;
  std::string error;
  if (!store) return kProblem;
  if (!find_attempt(*store, o.id, row, error)) return problem(error);
  if (row.state == "running") return problem("Attempt " + row.id + " is still running.");
  const std::string file = o.file.empty() ? row.id + ".swage" : o.file;
  if (!store->export_attempt(row.id, file, error)) return problem(error);
  if (o.json)
    print({{"attempt", row.id}, {"file", file}});
  else
    std::printf("%s\n", file.c_str());
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

}  // namespace swage::tools
