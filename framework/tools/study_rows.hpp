// SPDX-License-Identifier: Apache-2.0
//
// The attempts of a study as they come, in a file per shard beside its figures: attempts on file are not repeated after a kill, and
// shards of many machines are merged. A line of JSON per attempt; numbers are written so that they are read back bit for bit.
//
// [main]
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>

#include "tools/study.hpp"

namespace swage::tools {

/// Shard `index` of `count`, from 1: it does every row whose number leaves index - 1 when divided by count.
struct Shard {
  uint64_t index = 1, count = 1;
  bool has(uint64_t row) const { return row % count == index - 1; }
};
/// "2/8"; false for what is none.
bool read_shard(const std::string& text, Shard& out);

/// What decides the numbers of a study: its file, its lessons, what was set, this version of Swage. Another name, other numbers.
std::string study_name(const Study& study, const std::string& file_text, const std::vector<std::string>& settings);

using StudyRows = std::map<uint64_t, StudyRow>;  // by number

/// The rows that the folder holds of the study of that name, of all shards. A line cut off by a kill is left out.
StudyRows read_rows(const std::string& folder, const std::string& name);
/// Removes the files of rows of that study.
void remove_rows(const std::string& folder, const std::string& name);

/// Appends to the file of a shard; one of another study is begun anew.
class RowWriter {
 public:
  RowWriter(const std::string& folder, const Shard& shard, const std::string& name);
  bool add(uint64_t number, const StudyRow& row);  // on the disk when it returns; false: it cannot be written
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace swage::tools
