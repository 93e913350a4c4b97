// SPDX-License-Identifier: Apache-2.0
//
// Attempts and people in one SQL store: SQLite by default, PostgreSQL with the same schema.
// Threads: a Store belongs to the thread that opened it; the recorder has its own on its writer thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace swage::record {

/// `name` is what people see; where none was given it is the code. Everything that leaves the store says the code.
struct Person {
  std::string id, name;
  std::string created_utc;  // ISO 8601
  uint32_t attempts = 0;
  std::string code = {};          // pseudonym, unique in the store
  std::string handedness = {};    // "left", "right"; "" when nobody said
  std::string group_id = {};      // "" for none
  std::string archived_utc = {};  // "" for those who train
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
  std::string remark;  // what bends its numbers: "at 52 % of real speed"; "" usually
  double score = 0, simulated_s = 0;
  bool is_void = false;  // technical fault, or an instructor's decision, which outweighs it
  std::vector<MetricValue> metrics;
  std::string person_code;
  std::string void_reason, void_by;  // of the instructor's decision, "" when there was none
  std::string lesson_digest;         // of the lesson's text, "" in attempts of a Swage that kept none
  bool is_scripted = false;          // a plan or a recording held the instrument
  bool is_synthetic = false;         // its numbers were drawn: "swage people synthetic"
};

/// What the lesson of today says about an attempt of then; kept beside what was said then.
struct Grade {
  std::string attempt_id, graded_utc, app_version;
  std::vector<std::pair<std::string, std::string>> plugins;  // id, version of everything that judged
  bool identical = false;  // the steps had the same bits as then; false: the scene went another way
  std::string outcome, reason;
  double score = 0;
  std::vector<MetricValue> metrics;
};

class Store {
 public:
  /// `where`: a file path for SQLite, or "postgresql://user@host/database". nullptr and `error` on failure.
  static std::unique_ptr<Store> open(const std::string& where, std::string& error);
  /// Only to be looked at: an exported attempt, or a store that this user may not change. Nothing is made, upgraded or recovered.
  static std::unique_ptr<Store> open_to_read(const std::string& where, std::string& error);
  /// As open(); where that is refused only because nothing may be written there, as open_to_read().
  static std::unique_ptr<Store> open_as_allowed(const std::string& where, std::string& error);
  /// The user's own store: $XDG_DATA_HOME/swage/attempts.db; folder 0700, file 0600. "" for a user without a home.
  static std::string default_path();
  virtual ~Store() = default;

  /// Why the last call gave less than there is, as a sentence; "" when it gave everything. An empty list is no answer without it.
  virtual std::string trouble() const { return {}; }
  /// Whether anything was written, by whomever, since the last time this was asked. Cheap: may be asked every second.
  virtual bool changed() { return false; }
  virtual bool read_only() const { return false; }
  /// Reads every page of the store: what is damaged, as a sentence, "" when it is whole. Takes seconds for gigabytes.
  virtual std::string damage() { return {}; }

  virtual std::vector<Person> people() = 0;
  virtual Person person(const std::string& name) = 0;  // by code or name; made when it does not exist
  /// Newest first; "" stands for every person or lesson.
  virtual std::vector<AttemptRow> attempts(const std::string& person_id,
                                           const std::string& lesson_id = "") = 0;
  /// The same without metrics: for lists of everybody, where thousands of attempts have a hundred thousand metrics.
  virtual std::vector<AttemptRow> attempt_heads(const std::string& person_id = "", const std::string& lesson_id = "") {
    return attempts(person_id, lesson_id);
  }
  virtual bool attempt(const std::string& id, AttemptRow& out) = 0;
  virtual std::vector<EventRow> events(const std::string& attempt_id) = 0;
  /// Attempts that were running when their program died become "recovered". Returns how many.
  virtual int recover() = 0;
  virtual bool add_grade(const Grade&, std::string& error) {
    error = "Nothing can be kept here.";
    return false;
  }
  /// Newest first; none unless somebody has judged again.
  virtual std::vector<Grade> grades(const std::string&) { return {}; }
  /// One self-contained file (everything that `swage replay` needs) out of, and into, the store.
  virtual bool export_attempt(const std::string& id, const std::string& file, std::string& error) = 0;
  virtual bool import_attempt(const std::string& file, std::string& id, std::string& error) = 0;
};

}  // namespace swage::record
