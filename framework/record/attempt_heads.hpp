// SPDX-License-Identifier: Apache-2.0
//
// A cache of the attempts of a store without their metrics, updated by what was written since: pages query the list of all attempts
// at each visit, and on a server with many stations reading all of it took a second.
// Threads: those of the Database that it reads.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "record/sql.hpp"
#include "record/store.hpp"

namespace swage::record {

/// Columns and joins of one attempt's row for attempt_from(); conditions are appended. `school`: includes tables of version 4.
std::string select_attempts(bool school);
AttemptRow attempt_from(const Row&);
/// Newest first.
void sort_attempts(std::vector<AttemptRow>&);

class AttemptHeads {
 public:
  /// Arguments as in the store; `db` outlives this object.
  AttemptHeads(Database& db, bool school) : db_(db), school_(school) {}

  /// Reads what any program has written since the last call: new attempts, ends, decisions, names, other persons, erasures.
  /// False: the database gave an error, and the cache is cleared.
  bool renew();
  /// Newest first, as of the last renew().
  const std::vector<AttemptRow>& all() const { return all_; }
  /// Number of rows that renew() has read so far.
  uint64_t rows_read() const { return rows_read_; }

 private:
  bool renew_file();
  bool renew_server();
  bool read_all();
  void put(AttemptRow row);
  bool forget_missing();

  Database& db_;
  const bool school_;
  std::vector<AttemptRow> all_;
  std::unordered_map<std::string, std::size_t> place_;  // index of an attempt in all_, by id
  std::vector<Row> file_mark_;  // SQLite: values that change with each commit
  std::string server_mark_;     // PostgreSQL: the oldest transaction still running at the last call; "" before the first call
  uint64_t rows_read_ = 0;
};

}  // namespace swage::record
