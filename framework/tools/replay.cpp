// SPDX-License-Identifier: Apache-2.0
//
// swage replay: steps a kept attempt again and compares every hash.
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "record/recorder.hpp"
#include "session/session.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

// from a file that was exported, else from the store
bool load(const ReplayOptions& o, record::Recording& out, std::string& id, std::string& error) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(o.what, ignored))
    return record::read_recording(o.what, "", out, error);
  if (o.what.ends_with(".swage")) {
    error = "There is no file " + o.what + ".";
    return false;
  }
  const std::string where = store_place(o.store);
  const auto store = existing_store(where, error);
  record::AttemptRow row;
  if (!store || !find_attempt(*store, o.what, row, error)) return false;
  id = row.id;
  return record::read_recording(where, row.id, out, error);
}

// "" when every step is there from the first on
std::string gap_text(const record::Recording& recording) {
  for (std::size_t i = 1; i < recording.step.size(); ++i) {
    const uint64_t expected = recording.step[i - 1] + 1;
    if (recording.step[i] != expected)
      return format(
          "%llu steps are missing from step %llu on: the machine was too slow to record them, so this "
          "attempt "
          "cannot be replayed.",
          static_cast<unsigned long long>(recording.step[i] - expected),
          static_cast<unsigned long long>(expected));
  }
  return recording.step.empty() ? "It has no recorded step." : "";
}

}  // namespace

int replay(const ReplayOptions& o) {
  record::Recording recording;
  std::string id, error;
  if (!load(o, recording, id, error)) return problem(error);
  if (const std::string gap = gap_text(recording); !gap.empty()) return problem(o.what + ": " + gap);

  session::Replay result;
  base::Problems problems;
  const bool stepped = session::replay(recording, o.plugin_dirs, result, problems);
  tell(problems);
  if (!stepped) return kProblem;
  const auto steps = static_cast<unsigned long long>(result.steps);
  const auto first = static_cast<unsigned long long>(result.first_difference);
  if (o.json)
    print({{"attempt", id.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(id)},
           {"lesson", recording.info.lesson_id},
           {"steps", result.steps},
           {"identical", result.identical},
           {"first_difference", result.identical ? nlohmann::ordered_json(nullptr)
                                                 : nlohmann::ordered_json(result.first_difference)},
           {"reason", result.reason}});
  else if (result.identical)
    std::printf("identical %llu steps (%.3f s)\n", steps, static_cast<double>(steps) * recording.info.dt);
  else
    std::printf("differs from step %llu on (%.3f s)%s%s\n", first,
                static_cast<double>(first) * recording.info.dt, result.reason.empty() ? "" : ": ",
                result.reason.c_str());
  return result.identical ? kPassed : kNotPassed;
}

}  // namespace swage::tools
