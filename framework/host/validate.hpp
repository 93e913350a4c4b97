// SPDX-License-Identifier: Apache-2.0
//
// The tests behind `swage validate`. Each runs in a forked child with a time limit, so that a crash or a hang
// is a result. Rooms above (step, tools) add their own tests with add_test. Threads:
// [main].
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/plugin_info.hpp"

namespace swage::host {

enum class Mark : int32_t { kSuccess, kWarning, kSkipped, kFailed, kCrashed };

const char* text(Mark mark);  // "success", ...

/// Result of one test. Warning is for results that depend on the speed of the machine.
struct Finding {
  Mark mark = Mark::kSuccess;
  std::string text;  // sentences; "" for a plain success
};

struct ValidateOptions {
  uint32_t strictness = 5;  // 1 to 10: tests up to this level
  std::string only;         // name of one test; "" for all
  uint64_t seed = 1;        // of random tests; a finding reports it
  double limit_s = 20;      // of processor time per test, or of waiting; see child.hpp
  bool in_process = false;  // for debuggers: no child, no limit
};

/// Input of a test. `plugins`: every plugin of the library.
struct Subject {
  std::string library_path;
  std::vector<PluginInfo> plugins;
  uint64_t seed = 1;
};

constexpr uint32_t kind_bit(int32_t kind) { return 1u << kind; }
inline constexpr uint32_t kAllKinds = ~0u;

struct ValidateTest {
  uint32_t level = 1;
  std::string name;  // "load"
  std::string asks;  // one sentence
  std::function<Finding(const Subject&)> run;
  uint32_t kinds = kAllKinds;  // kinds of plugins to which it applies, kind_bit() each
};

struct ValidateResult {
  std::string name;
  uint32_t level = 0;
  Finding finding;
  double seconds = 0;  // wall
};

/// The tests of this room, levels 1 to 7, in order.
std::vector<ValidateTest> host_tests();

/// Runs those of `tests` (host_tests() and more) that apply to the plugins in the bundle folder or library at `path`.
/// `progress` is called with each result.
std::vector<ValidateResult> validate(const std::string& path, const std::vector<ValidateTest>& tests,
                                     const ValidateOptions& options,
                                     const std::function<void(const ValidateResult&)>& progress = {});

/// True when nothing failed or crashed.
bool passed(const std::vector<ValidateResult>& results);

}  // namespace swage::host
