// SPDX-License-Identifier: Apache-2.0
//
// swage validate: tests plugins and lesson files.
#include "host/validate.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "assembly/assemble.hpp"
#include "host/nearest.hpp"
#include "step/overlaps.hpp"
#include "step/step.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/stepping_tests.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;
using host::Mark;
using host::ValidateResult;
using Json = nlohmann::ordered_json;

struct Report {
  bool good = true;
  std::string untested;  // why a path was not tested at all, "" where each was
  Json json = Json::array();
};

// reports overlaps of objects at the start of the scene
void look_for_overlaps(host::Rig& rig, base::Problems& problems) {
  try {
    const step::Engine engine(rig, step::Options{}, {});
    for (base::Problem& p : step::start_overlaps(rig, contact::Options())) problems.push_back(std::move(p));
  } catch (const std::exception& refused) {
    problems.push_back({base::Severity::kError, rig.descriptor_path, refused.what()});
  }
}

void validate_lesson(const std::string& path, const ValidateOptions& o, Report& report) {
  base::Problems problems;
  assembly::LessonFile file;
  host::Catalogue::Options options;
  options.plugin_dirs = o.plugin_dirs;
  const bool read = assembly::read_lesson_file(path, file, problems);
  // every hand that the lesson offers must work, not only the first
  std::vector<std::string> hands = {""};
  for (const assembly::LessonDevice& device : file.devices)
    for (const assembly::DeviceChoice& choice : device.choices)
      if (!choice.as.empty()) hands.push_back(choice.as);
  const host::Catalogue catalogue(options);
  for (const std::string& hand : read ? hands : std::vector<std::string>()) {
    base::Problems found;
    const auto rig = assembly::assemble(file, catalogue, {hand, ""}, found);
    if (rig) look_for_overlaps(*rig, found);
    for (base::Problem& p : found) {
      const bool known = std::any_of(problems.begin(), problems.end(), [&](const base::Problem& q) {
        return q.where == p.where && q.message == p.message;
      });
      if (!known) problems.push_back(std::move(p));
    }
  }
  const bool good = !base::failed(problems);
  tell(problems);
  report.good &= good;
  report.json.push_back({{"path", path}, {"good", good}, {"problems", to_json(problems)}});
  if (!o.json) std::printf("%s: %s\n", path.c_str(), good ? "good" : "NOT good");
}

Json to_json(const ValidateResult& r) {
  return {{"test", r.name},
          {"level", r.level},
          {"result", host::text(r.finding.mark)},
          {"text", r.finding.text},
          {"seconds", r.seconds}};
}

// "objects, devices": the kinds of plugins that have this test
std::string kinds_of(const std::string& name, const std::vector<host::ValidateTest>& tests) {
  std::vector<std::string> kinds;
  for (const int32_t kind : {SWAGE_KIND_OBJECT, SWAGE_KIND_COUPLING, SWAGE_KIND_DEVICE, SWAGE_KIND_LESSON})
    if (std::any_of(tests.begin(), tests.end(),
                    [&](const auto& test) { return test.name == name && (test.kinds & host::kind_bit(kind)) != 0; }))
      kinds.push_back(std::string(host::kind_text(kind)) + "s");
  return host::join(kinds);
}

// What a good result does not say, as nobody asked for it: allocation and waiting in the step among others. "" where all was asked.
std::string not_asked(const ValidateOptions& o, const std::vector<host::ValidateTest>& tests) {
  std::vector<std::string> names;
  uint32_t level = 0;
  for (const host::ValidateTest& test : tests) {
    if (test.level <= o.strictness) continue;
    level = std::max(level, test.level);
    if (std::find(names.begin(), names.end(), test.name) == names.end()) names.push_back(test.name);
  }
  return names.empty() || !o.only.empty() ? "" : say::kNotAskedYet(host::join(names), level);
}

void validate_bundle(const std::string& path, const ValidateOptions& o,
                     const std::vector<host::ValidateTest>& tests, Report& report) {
  host::ValidateOptions options;
  options.strictness = o.strictness;
  options.only = o.only;
  options.seed = o.seed;
  options.limit_s = o.limit_s;
  options.in_process = o.in_process;
  if (!o.json) std::printf("%s\n", path.c_str());
  Json list = Json::array();
  std::size_t count[5] = {};
  std::string why_skipped;
  const auto hear = [&](const ValidateResult& r) {
    ++count[static_cast<std::size_t>(r.finding.mark)];
    list.push_back(to_json(r));
    if (o.json) return;
    // a reason for which several tests skip a plugin is printed once
    const bool again = r.finding.mark == Mark::kSkipped && r.finding.text == why_skipped;
    std::printf("  %2u %-14s %-8s %s\n", r.level, r.name.c_str(), host::text(r.finding.mark),
                again ? "(the same)" : r.finding.text.c_str());
    if (r.finding.mark == Mark::kSkipped) why_skipped = r.finding.text;
    std::fflush(stdout);
  };
  const std::vector<ValidateResult> results = host::validate(path, tests, options, hear);
  // the test that is asked for alone may be one of other kinds of plugins; that is no fault of this one
  if (results.empty()) {
    report.untested = say::kNotOfItsKind(o.only, kinds_of(o.only, tests));
    report.json.push_back({{"path", path}, {"good", false}, {"tests", list}, {"reason", report.untested}});
    if (!o.json) std::printf("  %s\n", report.untested.c_str());
    return;
  }
  const bool good = host::passed(results);
  report.good &= good;
  report.json.push_back({{"path", path}, {"good", good}, {"tests", list}});
  const auto of = [&](Mark mark) { return count[static_cast<std::size_t>(mark)]; };
  if (!o.json)
    std::printf("  %s: %zu passed, %zu with a warning, %zu skipped, %zu failed\n", good ? "good" : "NOT good",
                of(Mark::kSuccess), of(Mark::kWarning), of(Mark::kSkipped),
                of(Mark::kFailed) + of(Mark::kCrashed));
  if (const std::string more = not_asked(o, tests); !o.json && good && !more.empty()) std::printf("  %s\n", more.c_str());
}

bool holds_library(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".so") return true;
  return false;
}

// true for what a failed build leaves: the folder of a bundle, by its plugin.json or its name, without a library
bool lacks_library(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored) || holds_library(folder)) return false;
  if (fs::exists(folder / "plugin.json", ignored)) return true;
  const fs::path whole = fs::absolute(folder, ignored).lexically_normal();
  const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
  const bool is_id = !name.empty() && name.find('.') != std::string::npos && name.front() != '.' && name.back() != '.' &&
                     std::all_of(name.begin(), name.end(), [](unsigned char c) {
                       return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_' || c == '.';
                     });
  // a folder of lessons may be called so too; translations lie in bundles
  return is_id && std::all_of(fs::directory_iterator(folder, ignored), fs::directory_iterator(), [](const auto& entry) {
           const std::string file = entry.path().filename().string();
           return !file.ends_with(".json") || file.starts_with("words");
         });
}

// expands a path: a folder stands for each of its lessons or bundles
bool spread(const std::string& path, std::vector<std::string>& out) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) {
    out.push_back(path);
    return fs::exists(path, ignored);
  }
  std::vector<std::string> lessons;
  for (const auto& entry : fs::directory_iterator(path, ignored)) {
    const std::string extension = entry.path().extension();
    if (extension == ".so") {
      out.push_back(path);
      return true;
    }
    // descriptions of tables by swage run --trace are no lessons
    if (extension == ".json" && !entry.path().string().ends_with(".about.json")) lessons.push_back(entry.path().string());
    // a folder of bundles stands for each of them
    if (entry.is_directory(ignored) && holds_library(entry.path())) lessons.push_back(entry.path().string());
  }
  std::sort(lessons.begin(), lessons.end());
  out.insert(out.end(), lessons.begin(), lessons.end());
  return !lessons.empty();
}

}  // namespace

int validate(const ValidateOptions& o) {
  std::vector<host::ValidateTest> tests = host::host_tests();
  for (host::ValidateTest& test : stepping_tests(o.plugin_dirs, o.with)) tests.push_back(std::move(test));
  std::stable_sort(tests.begin(), tests.end(),
                   [](const auto& a, const auto& b) { return a.level < b.level; });

  std::vector<std::string> names;
  for (const host::ValidateTest& test : tests) names.push_back(test.name);
  if (!o.only.empty() && std::find(names.begin(), names.end(), o.only) == names.end())
    return problem(say::kNoTest(o.only, host::did_you_mean(o.only, names), host::join(names)));
  uint32_t level = 10;
  for (const host::ValidateTest& test : tests)
    if (test.name == o.only) level = std::min(level, test.level);
  if (!o.only.empty() && level > o.strictness) return problem(say::kNeedsStrictness(o.only, level));
  std::error_code ignored;
  std::vector<std::string> paths;
  for (const std::string& path : o.paths) {
    if (lacks_library(path)) return problem(say::kNoLibraryIn(path));
    if (!spread(path, paths))
      return problem(fs::exists(path, ignored) ? say::kHoldsNeither(path) : say::kNothingThere(path));
  }

  Report report;
  for (const std::string& path : paths) {
    if (path.ends_with(".json"))
      validate_lesson(path, o, report);
    else
      validate_bundle(path, o, tests, report);
  }
  if (o.json) print(report.json);
  return !report.good ? kNotPassed : report.untested.empty() ? kPassed : kProblem;
}

}  // namespace swage::tools
