// SPDX-License-Identifier: Apache-2.0
//
// Points that people give attempts on items of rating scales, as rows. [main]
#pragma once

#include <string>
#include <vector>

#include "record/school.hpp"
#include "record/sql.hpp"

namespace swage::record {

/// All ratings of the attempt in the first value, by item.
extern const char* const kSelectRatings;
std::vector<ObserverRating> ratings_from(const std::string& attempt_id, const std::vector<Row>& rows);
/// One row; it takes the place of the row of the same person and item.
bool write_rating(Database& db, const ObserverRating& rating);

}  // namespace swage::record
