// SPDX-License-Identifier: Apache-2.0
//
// What bad luck and bad will do to a file of attempts.
#pragma once

#include <string>

#include "base/rng.hpp"

namespace swage::record::test {

/// Bad luck: flips, zeroes, overwrites, cuts, doubles or exchanges parts of a file. Returns what was done.
std::string damage_file(const std::string& path, base::Xoshiro256& random);

/// Bad will: some columns of some rows of a store get values that nobody expects. Returns the SQL.
std::string craft_rows(const std::string& path, base::Xoshiro256& random);

/// Bad will: tables become views, get triggers, indexes and columns.
std::string craft_tables(const std::string& path, base::Xoshiro256& random);

}  // namespace swage::record::test
