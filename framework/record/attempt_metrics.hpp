// SPDX-License-Identifier: Apache-2.0
//
// A cache of the metrics of attempts: those of an ended attempt do not change any more, and each visit of a page queries
// the same ones. Threads: those of the Database that it reads.
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

  /// Fills in the metrics of these rows. `which`, `values`: the condition that selected them, over the tables attempt a, session s,
  /// person p. False: the database gave an error.
  bool fill(std::vector<AttemptRow>& rows, const std::string& which, const Row& values);

 private:
  struct Known {
    std::string as_of;  // state of the attempt at that time: an interrupted one may still be completed from its journal
    std::vector<MetricValue> metrics;
  };
  bool read_one(AttemptRow& row);
  bool read_all(std::vector<AttemptRow*>& missing, const std::string& which, const Row& values);

  Database& db_;
  std::unordered_map<std::string, Known> known_;  // by attempt
};

}  // namespace swage::record
