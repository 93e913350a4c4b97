// SPDX-License-Identifier: Apache-2.0
//
// The tables of a store, and their upgrade from older versions.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "record/sql.hpp"

namespace swage::record {

/// Statements that lead from version i to i + 1; BLOB is written @BLOB@, the one token in which the two servers differ.
using Step = std::vector<std::string>;
std::span<const Step> schema_steps();

/// 0 for a database without our tables, -1 when the query fails.
int schema_version(Database&);

/// Applies the missing steps in one transaction. False with a sentence when the store is newer than this
/// program.
bool bring_up_to_date(Database&, std::span<const Step> steps, std::string& error);

/// Opens a store for writing: write-ahead log, tables up to date.
std::unique_ptr<Database> open_store(const std::string& where, std::string& error, Trouble* why = nullptr);

/// Opens a store or an exported attempt of this or an earlier version for reading; refuses with a sentence files not by Swage.
std::unique_ptr<Database> open_for_reading(const std::string& where, std::string& error,
                                           Trouble* why = nullptr);

/// The table that an exported attempt has in addition to those of a store: the checksum of its rows.
inline constexpr const char* kExportTable = "CREATE TABLE swage_export (digest TEXT NOT NULL)";

/// "" when every table has the definition of its version, else a sentence: a view in the place of a table may compute for ever.
/// `alone`: and there is no other table, as in an export. SQLite only.
std::string foreign_tables(Database&, bool alone);

/// A remedy for a store that cannot be used, as a further sentence; "" where none is known.
std::string remedy(const std::string& where, Trouble why);

}  // namespace swage::record
