// SPDX-License-Identifier: Apache-2.0
//
// Where an attempt goes when its store cannot be written: a file beside the store, its room reserved while
// there was some. It is made with every attempt and locked as long as the program lives, so it also tells a
// running attempt from a dead one. Format: "SWAGEJ1\n", then batches, each a length, a CRC-32C and the rows.
// A file that ends within a batch is read up to the batch before.
#pragma once

#include <memory>
#include <string>

#include "record/attempt_rows.hpp"

namespace swage::record {

class Journal {
 public:
  /// nullptr when no file can be made there; the attempt then has no second place to go.
  static std::unique_ptr<Journal> create(const std::string& store, const std::string& attempt_id);
  ~Journal();  // gives the lock back; removes the file when nothing was written
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  bool append(const Batch&);  // false when this too is full
  bool empty() const { return size_ == 0; }
  /// Whether the file of this name still is the one that was written, as long as what was written.
  bool is_whole() const;
  const std::string& path() const { return path_; }
  void remove();  // its rows have reached the store

 private:
  Journal(int file, std::string path) : file_(file), path_(std::move(path)) {}
  int file_;
  std::string path_;
  uint64_t size_ = 0;  // bytes written
};

/// True while the program that records this attempt lives (on this machine).
bool is_recording(const std::string& store, const std::string& attempt_id);

/// Brings what dead programs left beside the store into it. Returns the number of journals merged; a damaged
/// one is merged as far as it reads. A journal that the store still refuses stays for the next time.
int merge_journals(Database& db, const std::string& store);

/// One journal, whoever wrote it.
bool merge_journal(Database& db, const std::string& path);

}  // namespace swage::record
