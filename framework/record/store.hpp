// SPDX-License-Identifier: Apache-2.0
//
// Attempts and people in one SQL store: SQLite by default, PostgreSQL with the same schema.
// Threads: a Store belongs to the thread that opened it; the recorder has its own on its writer thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace swage::record {

struct Person {
  std::string id, name;
  std::string created_utc;  // ISO 8601
  uint32_t attempts = 0;
};

struct MetricValue {
  std::string id, unit;
  double value = 0;
};

struct EventRow {
  uint64_t step = 0;
  double time_s = 0;
  std::string owner, id;  // owner "note": id is what a person said; owner "gap": `value` steps are missing
  double value = 0;
};

struct AttemptRow {
  std::string id, person_id, person_name;
  std::string lesson_id, lesson_title, mode, device;
  std::string started_utc, ended_utc;
  std::string state;    // "running", "complete", "aborted", "recovered"
  std::string outcome;  // judge::text
  std::string reason;
  double score = 0, simulated_s = 0;
  bool is_void = false;
  std::vector<MetricValue> metrics;
};

class Store {
 public:
  /// `where`: a file path for SQLite, or "postgresql://user@host/database". nullptr and `error` on failure.
  static std::unique_ptr<Store> open(const std::string& where, std::string& error);
  /// The user's own store: $XDG_DATA_HOME/swage/attempts.db; folder 0700, file 0600.
  static std::string default_path();
  virtual ~Store() = default;

  virtual std::vector<Person> people() = 0;
  virtual Person person(const std::string& name) = 0;  // made when it does not exist
  /// Newest first; "" stands for every person or lesson.
  virtual std::vector<AttemptRow> attempts(const std::string& person_id,
                                           const std::string& lesson_id = "") = 0;
  virtual bool attempt(const std::string& id, AttemptRow& out) = 0;
  virtual std::vector<EventRow> events(const std::string& attempt_id) = 0;
  /// Attempts that were running when their program died become "recovered". Returns how many.
  virtual int recover() = 0;
  /// One self-contained file (everything that `swage replay` needs) out of, and into, the store.
  virtual bool export_attempt(const std::string& id, const std::string& file, std::string& error) = 0;
  virtual bool import_attempt(const std::string& file, std::string& id, std::string& error) = 0;
};

}  // namespace swage::record
