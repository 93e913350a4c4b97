// SPDX-License-Identifier: Apache-2.0
//
// Metrics of attempts, kept between calls: those of an attempt that has ended do not change any more, and each visit of a page asks
// for the same ones. Threads: as the Database that it reads.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "record/sql.hpp"
#include "record/store.hpp"

namespace swage::record {

class AttemptMetrics {
 public:
  explicit AttemptMetrics(Database& db) : db_(db) {}

  /// Fills in the metrics of these rows. `which`, `values`: the condition that chose them, over the tables attempt a, session s,
  /// person p. False: the database gave an error.
  bool fill(std::vector<AttemptRow>& rows, const std::string& which, const Row& values);

 private:
  struct Known {
    std::string as_of;  // what the attempt said of itself then: one that was cut off may still be completed from its journal
    std::vector<MetricValue> metrics;
  };
  bool read_one(AttemptRow& row);
  bool read_all(std::vector<AttemptRow*>& missing, const std::string& which, const Row& values);

  Database& db_;
  std::unordered_map<std::string, Known> known_;  // by attempt
};

}  // namespace swage::record
