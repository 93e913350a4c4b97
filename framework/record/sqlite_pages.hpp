// SPDX-License-Identifier: Apache-2.0
//
// The rows of a damaged SQLite file, read page by page without its trees, its list of tables or its header: a file that
// SQLite refuses as a whole is read as far as single pages are intact. The format is that of sqlite.org/fileformat2.html.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <map>
#include <vector>

#include "record/sql.hpp"

namespace swage::record {

class SqlitePages {
 public:
  /// Includes the committed pages of `<path>-wal`. False with a sentence.
  bool open(const std::string& path, std::string& error);
  ~SqlitePages();
  SqlitePages() = default;
  SqlitePages(const SqlitePages&) = delete;
  SqlitePages& operator=(const SqlitePages&) = delete;

  /// Visits every row on every leaf page of any table. Returns the number of rows that could not be read.
  uint64_t each_row(const std::function<void(const Row&)>& visit);
  uint64_t pages() const { return count_; }

 private:
  void read_log(const std::string& path);
  bool page(uint64_t number, std::vector<uint8_t>& out) const;
  bool payload(const std::vector<uint8_t>& page, std::size_t at, std::vector<uint8_t>& out) const;

  int file_ = -1, log_ = -1;
  std::size_t size_ = 0;                          // bytes of a page
  uint64_t count_ = 0;                            // number of pages
  std::map<uint64_t, uint64_t> newer_;  // page -> its offset in the log
};

}  // namespace swage::record
