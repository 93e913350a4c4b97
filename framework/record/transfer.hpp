// SPDX-License-Identifier: Apache-2.0
//
// One attempt in one file (".swage"): an SQLite database with the tables of the store and the rows of that
// attempt only.
#pragma once

#include <string>

#include "record/sql.hpp"

namespace swage::record {

/// The file appears whole or not at all.
bool write_attempt_file(Database& store, const std::string& id, const std::string& file, std::string& error);

/// Checks the whole file before a row of it is taken. An attempt that is there already stays as it is.
bool read_attempt_file(Database& store, const std::string& file, std::string& id, std::string& error);

}  // namespace swage::record
