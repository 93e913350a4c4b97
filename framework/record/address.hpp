// SPDX-License-Identifier: Apache-2.0
//
// Address of a store: a file, or a database of a PostgreSQL server.
#pragma once

#include <string>
#include <string_view>

namespace swage::record {

bool is_postgres(std::string_view where);

/// "" for a possible address, else a sentence: "mysql://..." is not a file.
std::string address_problem(std::string_view where);

/// The address for display and logs: without the password.
std::string shown(std::string_view where);

/// `said` without the password of `where`, for messages of others that repeat the address.
std::string without_password(std::string said, std::string_view where);

}  // namespace swage::record
