// SPDX-License-Identifier: Apache-2.0
//
// Where a store is: a file, or a database of a PostgreSQL server.
#pragma once

#include <string>
#include <string_view>

namespace swage::record {

bool is_postgres(std::string_view where);

/// "" when a store can be there, else a sentence: "mysql://..." is no file.
std::string address_problem(std::string_view where);

/// As it may be shown and logged: without the password.
std::string shown(std::string_view where);

/// `said` without the password of `where`, whoever repeated it.
std::string without_password(std::string said, std::string_view where);

}  // namespace swage::record
