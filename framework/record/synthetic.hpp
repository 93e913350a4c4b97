// SPDX-License-Identifier: Apache-2.0
//
// A synthetic school, for trying pages and for tests of speed: people, days, and attempts with random numbers between those
// of real novice and expert attempts, with a learning effect: each attempt is a mean of real ones with its own weights, so that relations
// between the metrics of every real attempt, such as a mean force below its peak, hold here. Every attempt is marked synthetic. [main]
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swage::record {

/// Attempts of one lesson by scripted hands, in the store `SyntheticSchool::from`.
struct SyntheticLesson {
  std::string expert;                // attempt id
  std::vector<std::string> novices;  // at least one; passed
  std::vector<std::string> failed = {};  // of novices that did not pass; empty: nobody fails
};

struct SyntheticSchool {
  std::string from;  // store with the attempts of the hands
  std::vector<SyntheticLesson> lessons;
  uint32_t people = 30;      // a tenth of them experts
  uint32_t attempts = 5000;  // total
  uint32_t recordings = 30;  // total of the newest attempts that have the recording of a hand, to be opened and replayed
  uint64_t seed = 1;
};

/// Writes people ("Synthetic 01"), groups, a course with limits from the experts, and the attempts. False with a sentence; refuses a
/// store that has a synthetic school already.
bool write_synthetic_school(const std::string& where, const SyntheticSchool&, std::string& error);

}  // namespace swage::record
