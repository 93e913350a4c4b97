// SPDX-License-Identifier: Apache-2.0
//
// A whole store in one file, and back. The file is itself a store (SQLite), whatever the store is: a school moves from files to a
// server by one backup and one restore. [main]
#pragma once

#include <cstdint>
#include <string>

namespace swage::record {

struct Copied {
  uint64_t people = 0, attempts = 0;  // that are in the copy
  uint64_t added = 0;                 // attempts that were not there before
};

/// Everything that is in the store at this moment, while others go on writing. The file appears whole or not at all, read back and
/// compared before it gets its name; one that is there already is replaced.
bool backup_store(const std::string& store, const std::string& file, Copied& out, std::string& error);

/// What the file holds is put into the store. What is there already stays as it is, so that twice does no more than once.
bool restore_store(const std::string& file, const std::string& store, Copied& out, std::string& error);

}  // namespace swage::record
