// SPDX-License-Identifier: Apache-2.0
//
// swage replay: steps a stored attempt again and compares every hash.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "record/recorder.hpp"
#include "session/session.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

// "" when the recording has every step from the first on
std::string gap_text(const record::Recording& recording) {
  for (std::size_t i = 1; i < recording.step.size(); ++i) {
    const uint64_t expected = recording.step[i - 1] + 1;
    if (recording.step[i] != expected)
      return say::kMissingSteps(recording.step[i] - expected, expected);
  }
  return recording.step.empty() ? say::kNoSteps() : "";
}

// Prints the stored verdict and the verdict of the lesson now, one below the other.
void print_grade(const record::AttemptRow& then, const record::Grade& now) {
  std::printf("%s  %s  %s\n", printable(then.id).c_str(), printable(then.lesson_id).c_str(),
              now.identical ? "the same bits" : "OTHER BITS: the scene went another way than then");
  std::printf("  %-20s %12s %12s\n", "", "then", "now");
  std::printf("  %-20s %12s %12s\n", "outcome", printable(then.outcome).c_str(), printable(now.outcome).c_str());
  std::printf("  %-20s %12.4g %12.4g\n", "score", then.score, now.score);
  for (const record::MetricValue& m : now.metrics) {
    const auto old = std::find_if(then.metrics.begin(), then.metrics.end(), [&](const auto& t) { return t.id == m.id; });
    std::printf("  %-20s %12s %12s\n", printable(m.id).c_str(),
                old == then.metrics.end() ? "-" : printable(quantity_text(old->value, old->unit)).c_str(),
                printable(quantity_text(m.value, m.unit)).c_str());
  }
}

record::Grade grade_of(const record::AttemptRow& then, const session::Replay& now) {
  record::Grade g;
  g.attempt_id = then.id;
  g.plugins = now.plugins;
  g.identical = now.identical;
  // an attempt that a time limit or a person stopped from outside keeps its outcome
  const bool open = now.verdict.outcome == judge::Outcome::kRunning;
  g.outcome = open ? then.outcome : judge::text(now.verdict.outcome);
  g.reason = open ? then.reason : now.verdict.reason;
  g.score = now.verdict.score;
  for (const session::Result::Metric& m : now.verdict.metrics)
    if (std::isfinite(m.value)) g.metrics.push_back({m.id, m.unit, m.value});
  return g;
}

bool same_verdict(const record::AttemptRow& then, const record::Grade& now) {
  // tolerance for the rounding of numbers stored as text; otherwise equal verdicts are equal to the last bit
  if (then.outcome != now.outcome || std::abs(then.score - now.score) > 1e-9) return false;
  for (const record::MetricValue& m : then.metrics)
    for (const record::MetricValue& n : now.metrics)
      if (m.id == n.id && std::abs(m.value - n.value) > 1e-9 * (1 + std::abs(m.value))) return false;
  return true;
}

enum class Judged { kSame, kOther, kNot };

Judged grade_one(record::Store& store, const std::string& where, const ReplayOptions& o,
                 const record::AttemptRow& then, nlohmann::ordered_json& list) {
  record::Recording recording;
  std::string error;
  session::Replay result;
  base::Problems problems;
  if (!record::read_recording(where, then.id, recording, error) || recording.step.empty()) {
    tell(base::Severity::kError, then.id, error.empty() ? say::kNoSteps() : error);
    return Judged::kNot;
  }
  const std::string gap = gap_text(recording);
  const bool stepped = gap.empty() && session::judge_again(recording, o.plugin_dirs, pull_lesson(), result, problems);
  tell(problems);
  if (!stepped) {
    if (!gap.empty()) tell(base::Severity::kError, then.id, gap);
    return Judged::kNot;
  }
  const record::Grade now = grade_of(then, result);
  if (!store.add_grade(now, error)) {
    tell(base::Severity::kError, then.id, error);
    return Judged::kNot;
  }
  const bool same = same_verdict(then, now);
  if (o.json)
    list.push_back({{"attempt", then.id},
                    {"identical", now.identical},
                    {"same", same},
                    {"then", {{"outcome", then.outcome}, {"score", number(then.score)}}},
                    {"now", {{"outcome", now.outcome}, {"score", number(now.score)}}}});
  else
    print_grade(then, now);
  return same ? Judged::kSame : Judged::kOther;
}

// exit code: 0, every verdict is unchanged; 1, some differ; 2, some could not be judged
int grade(const ReplayOptions& o) {
  const std::string where = store_place(o.store);
  std::string error;
  const auto store = existing_store(where, error);
  if (!store) return problem(error);
  std::vector<record::AttemptRow> attempts;
  if (o.what == "all") {
    attempts = store->attempts("");
    if (!store->trouble().empty()) return problem(store->trouble());
  } else if (!find_attempt(*store, o.what, attempts.emplace_back(), error)) {
    return problem(error);
  }
  auto list = nlohmann::ordered_json::array();
  int code = kPassed;
  for (const record::AttemptRow& a : attempts) {
    if (a.state == "running") continue;
    const Judged judged = grade_one(*store, where, o, a, list);
    if (judged == Judged::kNot) code = kProblem;
    if (judged == Judged::kOther && code == kPassed) code = kNotPassed;
  }
  if (o.json) print(list);
  return code;
}

}  // namespace

int replay(const ReplayOptions& o) {
  if (o.grade) return grade(o);
  record::Recording recording;
  std::string id, error;
  if (!load_attempt(o.what, o.store, recording, id, error)) return problem(error);
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
    std::printf("%s\n", say::kIdentical(steps, format("%.3f", static_cast<double>(steps) * recording.info.dt)).c_str());
  else
    std::printf("%s%s%s\n", say::kDiffers(first, format("%.3f", static_cast<double>(first) * recording.info.dt)).c_str(),
                result.reason.empty() ? "" : ": ", result.reason.c_str());
  return result.identical ? kPassed : kNotPassed;
}

}  // namespace swage::tools
