// SPDX-License-Identifier: Apache-2.0
//
// A store in memory, for tests of the console only.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "record/store.hpp"

namespace swage::test {

class FakeStore final : public record::Store {
 public:
  explicit FakeStore(std::vector<record::AttemptRow> attempts) : attempts_(std::move(attempts)) {}

  std::vector<record::Person> people() override {
    std::vector<record::Person> out;
    for (const record::AttemptRow& a : attempts_) {
      record::Person* known = nullptr;
      for (record::Person& p : out) known = p.id == a.person_id ? &p : known;
      if (!known) known = &out.emplace_back(record::Person{a.person_id, a.person_name, a.started_utc, 0});
      ++known->attempts;
    }
    return out;
  }
  record::Person person(const std::string& name) override { return {name, name, "", 0}; }
  std::vector<record::AttemptRow> attempts(const std::string& person, const std::string& lesson) override {
    std::vector<record::AttemptRow> out;
    std::vector<record::AttemptRow> all = attempts_;
    if (shared) all.insert(all.end(), shared->more.begin(), shared->more.end());
    for (const record::AttemptRow& a : all) {
      if ((person.empty() || a.person_id == person) && (lesson.empty() || a.lesson_id == lesson))
        out.push_back(a);
    }
    return {out.rbegin(), out.rend()};
  }
  bool attempt(const std::string& id, record::AttemptRow& out) override {
    for (const record::AttemptRow& a : attempts_) {
      if (a.id == id) return out = a, true;
    }
    return false;
  }
  bool changed() override { return shared ? std::exchange(shared->changed, false) : false; }
  std::string trouble() const override { return shared ? shared->trouble : std::string(); }
  /// Changes by another program while the store is open.
  struct Shared {
    bool changed = false;
    std::string trouble;
    std::vector<record::AttemptRow> more;
  };
  std::shared_ptr<Shared> shared;
  std::vector<record::EventRow> events(const std::string&) override { return events_of_any; }
  std::vector<record::EventRow> events_of_any;
  int recover() override { return to_recover; }
  int to_recover = 0;
  bool export_attempt(const std::string&, const std::string& file, std::string& error) override {
    error = file + " is a fake.";
    return false;
  }
  bool import_attempt(const std::string&, std::string&, std::string&) override { return false; }

 private:
  std::vector<record::AttemptRow> attempts_;
};

/// Attempts of Arun, improving over three days, and an aborted one of Bea.
inline std::vector<record::AttemptRow> sample_attempts() {
  std::vector<record::AttemptRow> out;
  for (int i = 0; i < 14; ++i) {
    record::AttemptRow a;
    a.id = "a" + std::to_string(i);
    a.person_id = "p1";
    a.person_name = "Arun P.";
    a.lesson_id = i % 5 == 4 ? "swage.series.carry" : "swage.series.grasp";
    a.lesson_title = i % 5 == 4 ? "Carry and hold" : "Grasp the needle";
    a.mode = i > 9 ? "test" : "practice";
    a.device = "mouse";
    a.started_utc = "2026-11-" + std::to_string(17 + i / 5) + "T09:" + std::to_string(10 + i) + ":00Z";
    a.state = "complete";
    a.outcome = i > 5 && i != 8 ? "passed" : "failed";
    a.reason = a.outcome == "passed" ? "lesson.done" : i % 2 ? "failed.dropped" : "failed.out_of_time";
    a.score = a.outcome == "passed" ? 60 + 2 * i : 0;
    a.simulated_s = 70 - 3.2 * i;
    a.metrics = {{"grasp.tries", "1", static_cast<double>(6 - i / 3)},
                 {"force.peak", "N", 1.6 - 0.06 * i + (i % 3) * 0.08},
                 {"motion.path", "m", 0.09 - 0.004 * i}};
    out.push_back(a);
  }
  record::AttemptRow b = out.front();
  b.id = "b0";
  b.person_id = "p2";
  b.person_name = "Bea L.";
  b.state = "aborted";
  b.outcome = "aborted";
  b.reason = "";
  out.push_back(b);
  return out;
}

}  // namespace swage::test
