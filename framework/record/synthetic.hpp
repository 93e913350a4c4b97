// SPDX-License-Identifier: Apache-2.0
//
// A school that never was, for trying pages and for tests of speed: people, days, and attempts whose numbers are drawn between those
// of really run novice and expert hands, with a learning effect: each is a mean of real ones with weights of its own, so that what holds
// between the metrics of every real attempt, as a mean force below its peak, holds here. Every attempt is marked synthetic. [main]
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swage::record {

/// Attempts of one lesson that scripted hands have really made, in the store `SyntheticSchool::from`.
struct SyntheticLesson {
  std::string expert;                // attempt id
  std::vector<std::string> novices;  // at least one; passed
  std::vector<std::string> failed = {};  // of novices that did not pass; none: nobody fails
};

struct SyntheticSchool {
  std::string from;  // store with the attempts of the hands
  std::vector<SyntheticLesson> lessons;
  uint32_t people = 30;      // a tenth of them experts
  uint32_t attempts = 5000;  // of all together
  uint32_t recordings = 30;  // newest attempts that carry the recording of a hand, to be opened and replayed; of all together
  uint64_t seed = 1;
};

/// Writes people ("Synthetic 01"), groups, a course with limits from the experts, and the attempts. False with a sentence; refuses a
/// store that holds a synthetic school already.
bool write_synthetic_school(const std::string& where, const SyntheticSchool&, std::string& error);

}  // namespace swage::record
