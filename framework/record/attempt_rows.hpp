// SPDX-License-Identifier: Apache-2.0
//
// The records of an attempt, as rows with the same meaning in the store, in an exported file and in the
// fallback journal. Writing a row twice has no further effect.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "record/recorder.hpp"
#include "record/sql.hpp"
#include "record/store.hpp"

namespace swage::record {

/// The kinds of row; numbers are part of the journal's format.
enum class Kind : uint8_t {
  kPerson,
  kSession,
  kDevice,
  kAttempt,
  kMetric,
  kEvent,
  kChunk,
  kEnd,
  kHand,
  kFile,
  kProvenance,
  kNote,
  kRuling,
  kRating
};
inline constexpr uint8_t kKinds = 14;

struct Write {
  Kind kind = Kind::kPerson;
  Row values;
};
using Batch = std::vector<Write>;

/// Number of values of a row of this kind.
std::size_t arity(Kind);
bool write(Database&, const Write&);
/// Writes all rows or none, in one transaction.
bool write_batch(Database&, const Batch&);

/// Columns of the attempt table in the order of a kAttempt row.
extern const char* const kAttemptColumns;

/// Person, session, device, the attempt itself in state "running", its hands and its files.
Batch attempt_rows(const std::string& attempt_id, const AttemptInfo&);
/// Lesson version, class of input, calibration: origin of the numbers. Part of attempt_rows().
Write provenance_row(const std::string& attempt_id, const AttemptInfo&);
/// Metrics and the end of the attempt.
Batch end_rows(const std::string& attempt_id, const AttemptInfo&, const AttemptEnd&, uint64_t dropped);

/// Limits of the validity of an attempt's numbers (slow machine, forces off, steps not recorded), from its columns; "" for none.
std::string remark(const std::string& loop_health, bool realtime, int64_t steps_missing);

// The parts of an attempt row that are JSON text.
std::string to_json(const judge::Script&);
bool from_json(const std::string& text, judge::Script&);
std::string to_json(const std::vector<std::pair<std::string, std::string>>& plugins);
bool from_json(const std::string& text, std::vector<std::pair<std::string, std::string>>& plugins);
std::string metrics_json(const std::vector<MetricValue>& metrics);
bool metrics_from_json(const std::string& text, std::vector<MetricValue>& metrics);
std::string to_json(const std::vector<std::string>& names);
bool from_json(const std::string& text, std::vector<std::string>& names);

}  // namespace swage::record
