// SPDX-License-Identifier: Apache-2.0
//
// The attempts of a store without their metrics, kept between calls and renewed by what was written since: a list of everybody is
// asked for at each visit of a page, and on a server with many stations reading all of it anew took a second.
// Threads: as the Database that it reads.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "record/sql.hpp"
#include "record/store.hpp"

namespace swage::record {

/// Columns and joins of one attempt's row for attempt_from(); conditions are appended. `school`: with what tables of version 4 say.
std::string select_attempts(bool school);
AttemptRow attempt_from(const Row&);
/// Newest first.
void sort_attempts(std::vector<AttemptRow>&);

class AttemptHeads {
 public:
  /// Both as of the store's; `db` outlives it.
  AttemptHeads(Database& db, bool school) : db_(db), school_(school) {}

  /// Reads what was written since the last call, by whomever: new attempts, ends, decisions, names, other persons, erasures.
  /// False: the database gave an error, and what is known is forgotten.
  bool renew();
  /// Newest first, as of the last renew().
  const std::vector<AttemptRow>& all() const { return all_; }
  /// Rows that renew() has read since the beginning.
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
  std::unordered_map<std::string, std::size_t> place_;  // of an attempt in all_, by id
  std::vector<Row> file_mark_;  // SQLite: what changes with each commit
  std::string server_mark_;     // PostgreSQL: the oldest transaction that was still running; "" before the first call
  uint64_t rows_read_ = 0;
};

}  // namespace swage::record
