// SPDX-License-Identifier: Apache-2.0
//
// Fallback for an attempt whose store cannot be written: a file beside the store, with disk space reserved at the
// start. It is made with every attempt and locked while the program runs, so that it also distinguishes a
// running attempt from a dead one. Format: "SWAGEJ1\n", then batches, each a length, a CRC-32C and the rows.
// A file that ends within a batch is valid up to the batch before.
#pragma once

#include <memory>
#include <string>

#include "record/attempt_rows.hpp"

namespace swage::record {

class Journal {
 public:
  /// nullptr when no file can be made there; the attempt then has no fallback.
  static std::unique_ptr<Journal> create(const std::string& store, const std::string& attempt_id);
  ~Journal();  // releases the lock; removes the file when nothing was written
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool append(const Batch&);  // false when this disk is full, too
  bool empty() const { return size_ == 0; }
  /// True when the path still is the file that was written, with the size that was written.
  bool is_whole() const;
  const std::string& path() const { return path_; }
  void remove();  // after its rows have reached the store

 private:
  Journal(int file, std::string path) : file_(file), path_(std::move(path)) {}
  int file_;
  std::string path_;
  uint64_t size_ = 0;  // bytes written
};

/// True while the program that records this attempt runs (on this machine).
bool is_recording(const std::string& store, const std::string& attempt_id);

/// Merges the journals of dead programs beside the store into it. Returns the number of journals merged; a damaged
/// one is merged as far as it is readable. A journal that the store still refuses is kept for the next time.
int merge_journals(Database& db, const std::string& store);

/// Merges one journal.
bool merge_journal(Database& db, const std::string& path);

}  // namespace swage::record
