// SPDX-License-Identifier: Apache-2.0
//
// The verbs of the program `swage`. Each is one function: options in, text (or JSON) on standard output, problems on standard
// error, exit code out. Threads: [main].
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace swage::tools {

// Exit codes of every verb.
inline constexpr int kPassed = 0;
inline constexpr int kNotPassed =
    1;  // the verb ran with a negative result: lesson not passed, replay differs, plugin not valid
inline constexpr int kProblem = 2;  // the verb failed, or its options are wrong

struct RunOptions {
  std::string lesson, device, device_params, person = "Guest", store, mode;
  std::vector<std::string> plugin_dirs;
  std::vector<std::string> settings;  // "needle.arc=2/8"
  bool headless = false, fast = false, safe_mode = false, json = false;
  double max_time_s = 0;  // simulated; 0: until the lesson ends
  std::string trace;      // CSV file for every signal of every step, "" for none
};
int run(const RunOptions&);

struct StudyOptions {
  std::string file, out;  // out: folder for figures and table, "" for none
  std::string store = ":none:";
  std::vector<std::string> plugin_dirs;
  std::vector<std::string> settings;  // of every attempt, before those of the study: "needle.level=bending"
  std::string shard;                  // "2/8": only every eighth attempt; "" all
  bool merge = false;                 // runs nothing; makes the figures from the rows of all shards in `out`
};
int study(const StudyOptions&);

struct ReplayOptions {
  std::string what;  // file, attempt id or its beginning, "last"; for grading also "all"
  std::string store;
  std::vector<std::string> plugin_dirs;
  bool grade = false;  // judges with the present lesson, and stores that beside the former verdict
  bool json = false;
};
int replay(const ReplayOptions&);

struct PullVerbOptions {
  std::string what;  // as in ReplayOptions, without "all"
  std::string store;
  std::vector<std::string> plugin_dirs;
  double at_s = -1;     // simulated, moment of the attempt; below 0: its end
  double load = 0.1;    // N, that the knot is to bear
  double friction = 0;  // of the thread on itself; 0: as in the attempt
  bool json = false;
};
int pull(const PullVerbOptions&);

struct ValidateOptions {
  std::vector<std::string> paths;  // bundles, libraries and lesson files
  std::vector<std::string> plugin_dirs;
  std::string with;  // lesson file whose scene the plugins are tested in, "" to make one
  std::string only;
  uint32_t strictness = 5;
  uint64_t seed = 1;
  double limit_s = 20;  // s of processor time per test, or of waiting
  bool in_process = false, json = false;
};
int validate(const ValidateOptions&);

struct AuditOptions {
  std::vector<std::string> lessons, plugin_dirs;
  std::vector<std::string> only;  // names of ladders; all unless given
  std::string device = "expert";
  double tolerance = 0.05;  // relative
  double max_time_s = 300;  // simulated
  double budget_s = 45;     // of processor time, for one run
  std::string out;          // folder for tables and chart, "" for none
  bool series = false;      // also every lesson that comes with Swage
  bool add = false;         // keeps the lessons of an earlier audit in the folder
  bool json = false;
};
int audit(const AuditOptions&);

struct DescribeOptions {
  std::string what;  // plugin id or path of a bundle; "": everything installed
  std::string with;  // lesson file in whose scene the plugin declares its signals and events, "" to make one
  std::vector<std::string> plugin_dirs;
  bool schema = false, markdown = false, json = false;
};
int describe(const DescribeOptions&);

struct WordsOptions {
  std::vector<std::string> what;  // lesson files, bundles, ids
  std::string language = "de";
  std::vector<std::string> plugin_dirs;
  bool all = false;  // also lists translated words
};
int words(const WordsOptions&);

struct NewOptions {
  std::string kind, id, name, dir;
};
int make_new(const NewOptions&);

struct DoctorOptions {
  std::string store;
  std::vector<std::string> plugin_dirs;
  bool json = false;
};
int doctor(const DoctorOptions&);

struct BenchOptions {
  std::string which;  // "charts", "stability", "bar"
  std::vector<std::string> rest;
};
int bench(const BenchOptions&);

struct NeedleOptions {
  std::string model = "micro_100";  // name in the library, or path of a file
  int pieces = 12;                  // of the bending needle
  double width_mm = 0.5;            // of the flat jaws of the squeeze test
  bool json = false;
};
int list_needles(const NeedleOptions&);
int bench_needle(const NeedleOptions&);

struct AttemptsOptions {
  std::string store, person, lesson;
  std::string file;                // backup; salvage: the new store, "" for the place of the damaged one
  std::vector<std::string> files;  // import
  bool json = false;
  bool force = false;              // backup: a file that is there is replaced
};
int list_attempts(const AttemptsOptions&);
int import_attempts(const AttemptsOptions&);
int salvage_store(const AttemptsOptions&);
int backup_attempts(const AttemptsOptions&);
int restore_attempts(const AttemptsOptions&);

}  // namespace swage::tools
