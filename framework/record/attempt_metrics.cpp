// SPDX-License-Identifier: Apache-2.0
#include "record/attempt_metrics.hpp"

namespace swage::record {
namespace {

constexpr std::size_t kMostKept = 6000;  // attempts; 30 metrics each take some 20 MB. In a larger school some are read again
constexpr std::size_t kFew = 8;          // attempts that are queried one by one; more are cheaper in one statement

std::string stamp(const AttemptRow& a) { return a.state + "|" + a.ended_utc; }

}  // namespace

bool AttemptMetrics::fill(std::vector<AttemptRow>& rows, const std::string& which, const Row& values) {
  std::vector<AttemptRow*> missing;
  for (AttemptRow& row : rows) {
    const auto found = known_.find(row.id);
    if (found != known_.end() && found->second.as_of == stamp(row))
      row.metrics = found->second.metrics;
    else
      missing.push_back(&row);
  }
  if (missing.size() > kFew) {
    if (!read_all(missing, which, values)) return false;
  } else {
    for (AttemptRow* row : missing)
      if (!read_one(*row)) return false;
  }
  if (known_.size() + missing.size() > kMostKept) known_.clear();
  for (const AttemptRow* row : missing)
    if (row->state != "running" && known_.size() < kMostKept) known_[row->id] = {stamp(*row), row->metrics};
  return true;
}

bool AttemptMetrics::read_one(AttemptRow& row) {
  return db_.each("SELECT name, unit, value FROM metric WHERE attempt_id = ? ORDER BY seq", {row.id}, [&](const Row& r) {
    row.metrics.push_back({text(r[0]), text(r[1]), real(r[2])});
    return true;
  });
}

bool AttemptMetrics::read_all(std::vector<AttemptRow*>& missing, const std::string& which, const Row& values) {
  std::unordered_map<std::string, AttemptRow*> place;
  for (AttemptRow* row : missing) place[row->id] = row;
  const std::string sql =
      "SELECT m.attempt_id, m.name, m.unit, m.value FROM metric m JOIN attempt a ON a.attempt_id = m.attempt_id"
      " JOIN session s ON s.session_id = a.session_id JOIN person p ON p.person_id = s.person_id" + which +
      " ORDER BY m.attempt_id, m.seq";
  return db_.each(sql, values, [&](const Row& r) {
    if (const auto at = place.find(text(r[0])); at != place.end())
      at->second->metrics.push_back({text(r[1]), text(r[2]), real(r[3])});
    return true;
  });
}

}  // namespace swage::record
