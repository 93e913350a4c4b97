// SPDX-License-Identifier: Apache-2.0
//
// The tables, and how an older store becomes a newer one.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "record/sql.hpp"

namespace swage::record {

/// What leads from version i to i + 1; BLOB is written @BLOB@, the one token in which the two servers differ.
using Step = std::vector<std::string>;
std::span<const Step> schema_steps();

/// 0 for a database without our tables, -1 when it cannot be asked.
int schema_version(Database&);

/// Takes the missing steps in one transaction. False with a sentence when the store is newer than this
/// program.
bool bring_up_to_date(Database&, std::span<const Step> steps, std::string& error);

/// A store, ready to be written: write-ahead log, tables up to date.
std::unique_ptr<Database> open_store(const std::string& where, std::string& error, Trouble* why = nullptr);

/// A store or an exported attempt of this or an earlier version, to be read; refuses with a sentence what Swage did not write.
std::unique_ptr<Database> open_for_reading(const std::string& where, std::string& error,
                                           Trouble* why = nullptr);

/// What an exported attempt has beside the tables of a store: the checksum of its rows.
inline constexpr const char* kExportTable = "CREATE TABLE swage_export (digest TEXT NOT NULL)";

/// "" when every table of its version is as Swage makes it, else a sentence: a view in the place of a table may compute for ever.
/// `alone`: and there is nothing else, as in an export. SQLite only.
std::string foreign_tables(Database&, bool alone);

/// What a person can do about a store that cannot be used, as a further sentence; "" when nothing comes to mind.
std::string remedy(const std::string& where, Trouble why);

}  // namespace swage::record
