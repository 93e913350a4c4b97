// SPDX-License-Identifier: Apache-2.0
//
// The finished attempts of a study, in a file per shard beside its figures: after a kill they are not repeated, and shards of several
// machines are merged. One line of JSON per attempt; numbers are written so that they are read back bit for bit.
//
// [main]
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>

#include "tools/study.hpp"

namespace swage::tools {

/// Shard `index` of `count`, from 1: it has every row whose number modulo `count` is index - 1.
struct Shard {
  uint64_t index = 1, count = 1;
  bool has(uint64_t row) const { return row % count == index - 1; }
};
/// Reads "2/8"; false for any other text.
bool read_shard(const std::string& text, Shard& out);

/// Hash of everything that determines the results of a study: its file, its lessons, the settings, this version of Swage.
std::string study_name(const Study& study, const std::string& file_text, const std::vector<std::string>& settings);

using StudyRows = std::map<uint64_t, StudyRow>;  // by number

/// Reads the rows of the study of that name in a folder, of all shards, without a line that a kill left incomplete.
StudyRows read_rows(const std::string& folder, const std::string& name);
/// Removes the row files of that study.
void remove_rows(const std::string& folder, const std::string& name);

/// Appends to the file of a shard; replaces the file of another study.
class RowWriter {
 public:
  RowWriter(const std::string& folder, const Shard& shard, const std::string& name);
  bool add(uint64_t number, const StudyRow& row);  // returns when the row is on disk; false: it cannot be written
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace swage::tools
