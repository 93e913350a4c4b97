// SPDX-License-Identifier: Apache-2.0
//
// People as rows, for store.cpp and school.cpp: code, name, group.
#pragma once

#include <string>
#include <vector>

#include "record/sql.hpp"
#include "record/store.hpp"

namespace swage::record {

/// `school`: includes tables of version 4. Further conditions are appended.
std::string select_people(bool school);
Person person_from(const Row&);
/// Sorts by name, independent of the server's collation; people without a name by code.
void sort_by_name(std::vector<Person>&);

/// Erases all rows of a person, with tombstones for it and its attempts, in the transaction of the caller.
bool erase_rows(Database&, const std::string& person_id);

/// Makes deleted rows unreadable: SQLite's log is emptied into the file, whose deleted bytes are overwritten.
void forget_deleted(Database&);

}  // namespace swage::record
