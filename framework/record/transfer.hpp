// SPDX-License-Identifier: Apache-2.0
//
// An attempt in one file (".swage"): an SQLite database with the tables of the store and the rows of that
// attempt only.
#pragma once

#include <string>

#include "record/sql.hpp"

namespace swage::record {

/// Writes the file, which appears complete or not at all.
bool write_attempt_file(Database& store, const std::string& id, const std::string& file, std::string& error);

/// Checks the whole file before a row is inserted. An attempt that exists already is not changed.
bool read_attempt_file(Database& store, const std::string& file, std::string& id, std::string& error);

}  // namespace swage::record
