// SPDX-License-Identifier: Apache-2.0
//
// Backup of a whole store to one file, and restore. The file is itself a store (SQLite) for either kind of store: a school moves
// from files to a server by one backup and one restore. [main]
#pragma once

#include <cstdint>
#include <string>

namespace swage::record {

struct Copied {
  uint64_t people = 0, attempts = 0;  // number in the copy
  uint64_t added = 0;                 // attempts that did not exist before
};

/// Copies everything in the store at this moment, while others continue to write. The file appears complete or not at all, read back
/// and compared before it gets its name; an existing file is replaced.
bool backup_store(const std::string& store, const std::string& file, Copied& out, std::string& error);

/// Inserts the contents of the file into the store. Existing rows are kept, so that a second call has no further effect.
bool restore_store(const std::string& file, const std::string& store, Copied& out, std::string& error);

}  // namespace swage::record
