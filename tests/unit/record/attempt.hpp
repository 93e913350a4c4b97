// SPDX-License-Identifier: Apache-2.0
//
// A made-up attempt whose every number follows from a seed, so that a reader can tell what a writer wrote.
#pragma once

#include <filesystem>
#include <string>

#include "record/recorder.hpp"
#include "record/store.hpp"

namespace swage::record::test {

/// A folder of its own for each test, removed at the end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

AttemptInfo make_info(uint64_t seed = 7, const std::string& person = "Ada");
/// Every bit pattern is allowed in a sample: NaN with a payload, minus zero, subnormal numbers.
StepRecord make_step(uint64_t seed, uint64_t step);
/// The same hands and the same files, byte for byte.
bool same_attachments(const AttemptInfo&, const AttemptInfo&);
AttemptEnd make_end();

/// Records `steps` steps with an event every 100 and a command every 300; returns the attempt's id.
std::string record_attempt(const std::string& store, uint64_t steps, uint64_t seed = 7,
                           const std::string& person = "Ada");

/// Every word of `recording` is what make_step wrote, from step 0 on without a gap.
void expect_exact(const Recording& recording, uint64_t steps, uint64_t seed = 7);

}  // namespace swage::record::test
