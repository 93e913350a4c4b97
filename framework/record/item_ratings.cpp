// SPDX-License-Identifier: Apache-2.0
#include "record/item_ratings.hpp"

namespace swage::record {

const char* const kSelectRatings = "SELECT item, points, made_utc, made_by FROM rating WHERE attempt_id = ? ORDER BY item, made_by";

std::vector<ObserverRating> ratings_from(const std::string& attempt_id, const std::vector<Row>& rows) {
  std::vector<ObserverRating> out;
  for (const Row& r : rows) out.push_back({attempt_id, text(r[0]), real(r[1]), text(r[2]), text(r[3])});
  return out;
}

bool write_rating(Database& db, const ObserverRating& r) {
  return db.run("INSERT INTO rating (attempt_id, item, points, made_utc, made_by) VALUES (?, ?, ?, ?, ?)"
                " ON CONFLICT (attempt_id, item, made_by) DO UPDATE SET points = excluded.points, made_utc = excluded.made_utc",
                {r.attempt_id, r.item, r.points, r.made_utc, r.made_by});
}

}  // namespace swage::record
