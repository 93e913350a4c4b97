// SPDX-License-Identifier: Apache-2.0
//
// Attempts and people in one SQL store: SQLite by default, PostgreSQL with the same schema.
// Threads: a Store belongs to the thread that opened it; the recorder has its own connection on its writer thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace swage::record {

/// `name` is displayed; where none was given it is the code. Everything that leaves the store has the code.
struct Person {
  std::string id, name;
  std::string created_utc;  // ISO 8601
  uint32_t attempts = 0;
  std::string code = {};          // pseudonym, unique in the store
  std::string handedness = {};    // "left", "right"; "" where unknown
  std::string group_id = {};      // "" for none
  std::string archived_utc = {};  // "" for active people
};
/// The code under which attempts of people without a name are kept.
inline constexpr const char* kGuest = "Guest";

struct MetricValue {
  std::string id, unit;
  double value = 0;
};

struct EventRow {
  uint64_t step = 0;
  double time_s = 0;
  std::string owner, id;  // owner "note": id is a person's text; owner "gap": `value` steps are missing
  double value = 0;
};

struct AttemptRow {
  std::string id, person_id, person_name;
  std::string lesson_id, lesson_title, mode, device;
  std::string started_utc, ended_utc;
  std::string state;    // "running", "complete", "aborted", "recovered"
  std::string outcome;  // judge::text
  std::string reason;
  std::string remark;  // cause that distorts its numbers: "at 52 % of real speed"; usually ""
  double score = 0, simulated_s = 0;
  bool is_void = false;  // technical fault, or an instructor's decision, which has priority
  std::vector<MetricValue> metrics;
  std::string person_code;
  std::string void_reason, void_by;  // of the instructor's decision, "" without one
  std::string lesson_digest;         // of the lesson's text, "" for attempts of earlier versions without one
  bool is_scripted = false;          // a plan or a recording controlled the instrument
  bool is_synthetic = false;         // its numbers are random: "swage people synthetic"
};

/// Result of the present lesson for an earlier attempt; stored beside the original one.
struct Grade {
  std::string attempt_id, graded_utc, app_version;
  std::vector<std::pair<std::string, std::string>> plugins;  // id, version of all plugins of the grading
  bool identical = false;  // the steps had the same bits as in the recording; false: the scene developed differently
  std::string outcome, reason;
  double score = 0;
  std::vector<MetricValue> metrics;
};

class Store {
 public:
  /// `where`: a file path for SQLite, or "postgresql://user@host/database". nullptr and `error` on failure.
  static std::unique_ptr<Store> open(const std::string& where, std::string& error);
  /// For reading only: an exported attempt, or a store that this user may not change. Nothing is created, upgraded or recovered.
  static std::unique_ptr<Store> open_to_read(const std::string& where, std::string& error);
  /// As open(); where that fails only because writing is not allowed, as open_to_read().
  static std::unique_ptr<Store> open_as_allowed(const std::string& where, std::string& error);
  /// The user's own store: $XDG_DATA_HOME/swage/attempts.db; folder 0700, file 0600. "" for a user without a home.
  static std::string default_path();
  virtual ~Store() = default;

  /// Why the last result is incomplete, as a sentence; "" when it is complete. An empty list must be checked with it.
  virtual std::string trouble() const { return {}; }
  /// True when any program has written since the last call. Cheap: may be called every second.
  virtual bool changed() { return false; }
  virtual bool read_only() const { return false; }
  /// Reads every page of the store and returns the damage as a sentence, "" for none. Takes seconds for gigabytes.
  virtual std::string damage() { return {}; }

  virtual std::vector<Person> people() = 0;
  virtual Person person(const std::string& name) = 0;  // by code or name; created when it does not exist
  /// Newest first; "" stands for every person or lesson.
  virtual std::vector<AttemptRow> attempts(const std::string& person_id,
                                           const std::string& lesson_id = "") = 0;
  /// The same without metrics: for lists of all people, where thousands of attempts have a hundred thousand metrics.
  virtual std::vector<AttemptRow> attempt_heads(const std::string& person_id = "", const std::string& lesson_id = "") {
    return attempts(person_id, lesson_id);
  }
  virtual bool attempt(const std::string& id, AttemptRow& out) = 0;
  virtual std::vector<EventRow> events(const std::string& attempt_id) = 0;
  /// Attempts whose program died while they ran become "recovered". Returns their number.
  virtual int recover() = 0;
  virtual bool add_grade(const Grade&, std::string& error) {
    error = "Nothing can be kept here.";
    return false;
  }
  /// Newest first; none unless the attempt was graded again.
  virtual std::vector<Grade> grades(const std::string&) { return {}; }
  /// Writes an attempt to one self-contained file (all data for `swage replay`), and reads it into the store.
  virtual bool export_attempt(const std::string& id, const std::string& file, std::string& error) = 0;
  virtual bool import_attempt(const std::string& file, std::string& id, std::string& error) = 0;
};

}  // namespace swage::record
