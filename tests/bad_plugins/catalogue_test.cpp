// SPDX-License-Identifier: Apache-2.0
//
// Every evil plugin of evil_scene.cpp and evil_devices.cpp in a session of its own. What becomes of each stands in the guide
// (framework/sdk/guide/misbehaviour.md); the table there is the expectation here.
//
//   refused    the scene does not open; a sentence names the plugin
//   contained  the attempt is void; a sentence names the plugin
//   left       the result is kept; a sentence names the device that was left behind
//   named      the program ends, and not as if all were well; the next start names the plugin, and the record is whole
//   judged     the lesson ends the attempt with its verdict; the score stays within 0 and 100
//   harmless   nothing comes of it: the same bits as with the good one
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "host/call_watch.hpp"
#include "host/catalogue.hpp"
#include "record/store.hpp"
#include "session/bounded_call.hpp"
#include "session/sentinel.hpp"
#include "session/session.hpp"
#include "test_places.hpp"

namespace swage::session {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPage = SWAGE_SOURCE_DIR "/framework/sdk/guide/misbehaviour.md";
constexpr const char* kPrefix = "org.example.bad.";
constexpr std::size_t kAtOnce = 8;  // attempts: fewer take longer; with more, those that need a processor wait for it

std::string slurp(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

const host::Catalogue& catalogue() {
  static const host::Catalogue all = [] {
    host::Catalogue::Options options;
    options.plugin_dirs = {EVIL_PLUGINS_DIR};
    options.install_dir = "/nowhere";
    options.use_environment = false;
    options.describe_limit_s = 60;
    return host::Catalogue(options);
  }();
  return all;
}

/// What became of one plugin.
struct Fate {
  std::string outcome, said;
  uint64_t hash = 0;
};

std::string lesson_with(const host::PluginInfo& p) {
  const std::string quoted = "\"" + p.id + "\"";
  const bool device = p.kind == SWAGE_KIND_DEVICE, lesson = p.kind == SWAGE_KIND_LESSON;
  const std::string ball = p.kind == SWAGE_KIND_OBJECT ? quoted : "\"org.example.ball\"";
  std::string text = R"({ "format": "swage-lesson/1", "id": "test.evil", "title": "Evil",
    "objects": [ { "name": "good", "plugin": "org.example.ball" },
                 { "name": "thing", "plugin": )" + ball + R"(, "pose": { "p": [0.0019, 0, 0] } } ],)";
  const std::string coupling = p.kind == SWAGE_KIND_COUPLING ? quoted : "\"swage.coupling.contact\"";
  text += R"( "couplings": [ { "name": "between", "plugin": )" + coupling + R"(, "between": ["good", "thing"] } ],)";
  if (device) text += R"( "devices": [ { "name": "hand", "plugin": )" + quoted + " } ],";
  return text + R"( "lesson": { "plugin": )" + (lesson ? quoted : "\"swage.lesson.look\"") + " } }";
}

bool clocked(const host::PluginInfo& p) {
  return p.kind == SWAGE_KIND_DEVICE || p.id.find("sleeps") != std::string::npos || p.id.ends_with("burns");
}

// Whether the plugin never comes back from this function: "org.example.bad.device.open_blocks" from "open".
bool hangs_in(const host::PluginInfo& p, const std::string& function) {
  return p.id.ends_with("." + function + "_loops") || p.id.ends_with("." + function + "_blocks");
}

// Limits in s. Whoever hangs is not waited for. The short one is given only to the function that hangs: on a busy machine any other call
// may need that long, and then the plugin would be accused of what it does not do.
constexpr double kShort_s = 0.5, kLong_s = 10;
double limit_of(const host::PluginInfo& p, const std::string& function) { return hangs_in(p, function) ? kShort_s : kLong_s; }

// The watch of calls outside of the step has one limit for all of them, so that of a plugin that hangs in one leaves the others time, too.
constexpr double kWatched_s = 2;
double call_limit(const host::PluginInfo& p) {
  constexpr const char* kWatched[] = {"create", "configure", "activate", "extension", "reset", "bind", "deactivate", "destroy"};
  return std::any_of(std::begin(kWatched), std::end(kWatched), [&](const char* f) { return hangs_in(p, f); }) ? kWatched_s : kLong_s;
}

std::string outcome_of(const Result& result) {
  const bool passed = result.outcome == judge::Outcome::kPassed, failed = result.outcome == judge::Outcome::kFailed;
  if (result.outcome == judge::Outcome::kVoid) return "contained";
  if (left_behind() > 0) return "left";
  if (!passed && !failed) return "harmless";
  return result.score >= 0 && result.score <= 100 ? "judged" : "a score of " + std::to_string(result.score);
}

// in a process of its own: opens, runs, writes what it heard
[[noreturn]] void attempt(const std::string& folder, const host::PluginInfo& p) {
  if (!freopen((folder + "/stderr").c_str(), "w", stderr)) _exit(99);
  alarm(120);  // s: a test that fails must end; 5 s are usual, on a busy machine 20
  host::CallWatch::set_limit(call_limit(p));
  driver_limits() = {limit_of(p, "open"), limit_of(p, "close"), limit_of(p, "exchange")};
  Options options;
  options.lesson_path = folder + "/lesson.json";
  options.plugin_dirs = {EVIL_PLUGINS_DIR, BALL_DIR, SWAGE_BINARY_DIR "/plugins"};
  options.store_path = folder + "/attempts.db";
  options.pace = clocked(p) ? Pace::kRealtime : Pace::kFastest;
  // s of the scene: drivers have threads of their own, which a busy machine lets wait, and a lost hand is told after half a second
  options.max_time_s = clocked(p) ? 2 : 0.1;
  Problems problems;
  std::ofstream out(folder + "/told");
  uint64_t hash = 0;
  std::string outcome = "refused";
  {
    auto session = Session::open(options, problems);
    if (session) {
      session->start();
      // a hand that is lost pauses the lesson: then somebody stops it
      const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(4);
      while (!session->finished() && std::chrono::steady_clock::now() < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      session->stop();
      const Result result = session->result();
      problems.insert(problems.end(), result.problems.begin(), result.problems.end());
      outcome = outcome_of(result);
      hash = result.hash;
    }
  }
  out << outcome << " " << hash << "\n";
  for (const Problem& problem : problems)
    if (problem.severity >= base::Severity::kWarning) out << problem.where << ": " << problem.message << "\n";
  out.close();
  _exit(0);
}

/// Runs body(i) for i < n in a child each, several at once: most of what they do is waiting, for a limit or for a lost hand.
void in_children(std::size_t n, const std::function<void(std::size_t)>& body,
                 const std::function<void(std::size_t, int status)>& ended) {
  std::map<pid_t, std::size_t> running;
  for (std::size_t next = 0; next < n || !running.empty();) {
    if (next < n && running.size() < kAtOnce) {
      std::fflush(nullptr);
      const pid_t child = fork();
      ASSERT_GE(child, 0);
      if (child == 0) {
        body(next);
        _exit(0);
      }
      running[child] = next++;
      continue;
    }
    int status = 0;
    const auto found = running.find(waitpid(-1, &status, 0));
    if (found == running.end()) continue;
    ended(found->second, status);
    running.erase(found);
  }
}

class EvilPlugins : public ::testing::Test {
 protected:
  EvilPlugins() {
    char name[] = "/tmp/swage-evil-XXXXXX";
    home_ = mkdtemp(name);
    unsetenv("SWAGE_PLUGIN_PATH");
  }
  ~EvilPlugins() override { fs::remove_all(home_); }

  std::vector<Fate> fates_of(const std::vector<const host::PluginInfo*>& plugins) {
    std::vector<Fate> fates(plugins.size());
    for (const host::PluginInfo* p : plugins) {
      fs::create_directory(folder_of(*p));
      std::ofstream(folder_of(*p) + "/lesson.json") << lesson_with(*p);
    }
    in_children(
        plugins.size(),
        [&](std::size_t i) {
          set_homes(folder_of(*plugins[i]));
          attempt(folder_of(*plugins[i]), *plugins[i]);
        },
        [&](std::size_t i, int status) { fates[i] = fate_of(*plugins[i], status); });
    return fates;
  }

  std::string folder_of(const host::PluginInfo& p) const { return home_ + "/" + p.id; }

  static void set_homes(const std::string& folder) {
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    setenv("XDG_DATA_HOME", folder.c_str(), 1);
  }

  Fate fate_of(const host::PluginInfo& p, int status) {
    const std::string folder = folder_of(p);
    std::istringstream told(slurp(folder + "/told"));
    std::string first;
    Fate fate;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && std::getline(told, first)) {
      std::istringstream(first) >> fate.outcome >> fate.hash;
      fate.said.assign(std::istreambuf_iterator<char>(told), {});
    } else {
      fate = after_the_end(folder, status);
    }
    fs::remove_all(folder);
    return fate;
  }

  // the program has ended: what the next start says of it
  Fate after_the_end(const std::string& folder, int status) {
    set_homes(folder);
    Fate fate;
    fate.outcome = "named";
    Sentinel::Report report;
    if (Sentinel::take(Sentinel::default_folder(), report))
      fate.said = Sentinel::problem(report).message;
    else
      fate.outcome = "unnamed";
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) fate.outcome = "hung";
    const bool quits = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    fate.said += quits                ? " (exit code 0)"
                 : WIFSIGNALED(status) ? " (signal " + std::to_string(WTERMSIG(status)) + ")"
                                       : " (exit code " + std::to_string(WEXITSTATUS(status)) + ")";
    std::string error;
    if (!record::Store::open(folder + "/attempts.db", error)) fate.outcome = "damaged: " + error;
    return fate;
  }

 private:
  std::string home_;
};

/// The rows of the page: "| `forces` | contained | ..." with the columns of kinds, and "| `object.force_nan` | contained |".
std::map<std::string, std::string> expected() {
  std::map<std::string, std::string> out;
  std::istringstream page(slurp(kPage));
  std::vector<std::string> columns;
  for (std::string line; std::getline(page, line);) {
    if (line.empty() || line[0] != '|') {
      columns.clear();
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream in(line.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) {
      std::erase(cell, '`');
      const auto from = cell.find_first_not_of(' '), to = cell.find_last_not_of(' ');
      cells.push_back(from == std::string::npos ? "" : cell.substr(from, to - from + 1));
    }
    if (cells.size() < 2 || cells[0].starts_with("---")) continue;
    if (columns.empty()) {
      columns = cells;
    } else if (columns[0] == "word") {
      continue;  // the table that says what the words mean
    } else if (columns[0] == "function") {
      for (std::size_t i = 1; i < std::min(cells.size(), columns.size()); ++i) out[cells[0] + "_" + columns[i]] = cells[i];
    } else {
      out[cells[0]] = cells[1];
    }
  }
  return out;
}

/// What the clock judges: a sanitizer slows host and plugin alike, and the machine is then behind before the plugin is.
bool judged_by_the_clock([[maybe_unused]] const std::string& name) {
#ifdef SWAGE_SANITIZED
  // of a hand that refuses or changes the language: half a second of real time may end before it counts as lost
  static const std::set<std::string> all = {"device.step_sleeps", "device.exchange_rounds", "device.exchange_refuses", "device.exchange_translates", "object.sleeps", "object.burns", "object.shapes_many", "lesson.marks_many"};
  return all.contains(name);
#else
  return false;
#endif
}

TEST_F(EvilPlugins, EachEndsAsTheGuideSays) {
  const std::map<std::string, std::string> table = expected();
  std::map<int32_t, uint64_t> good;
  std::vector<const host::PluginInfo*> tried;
  const char* only = std::getenv("EVIL_ONLY");
  const auto name_of = [](const host::PluginInfo& p) { return p.id.substr(std::string(kPrefix).size()); };
  for (const host::PluginInfo& p : catalogue().plugins())
    if (only == nullptr || p.id.find(only) != std::string::npos || p.id.ends_with(".good")) tried.push_back(&p);
  const std::vector<Fate> fates = fates_of(tried);
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i]->id.ends_with(".good")) good[tried[i]->kind] = fates[i].hash;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const host::PluginInfo& p = *tried[i];
    const Fate& fate = fates[i];
    const std::string name = name_of(p);
    if (std::getenv("EVIL_PRINT")) std::printf("%s | %s | %s\n", name.c_str(), fate.outcome.c_str(), fate.said.c_str());
    const auto row = table.find(name);
    if (row == table.end()) {
      ADD_FAILURE() << name << " does not stand in " << kPage << ": " << fate.outcome << " " << fate.said;
      continue;
    }
    if (judged_by_the_clock(name)) continue;
    EXPECT_EQ(fate.outcome, row->second) << name << ": " << fate.said;
    if (fate.outcome == "harmless") {
      if (!clocked(p)) {
        EXPECT_EQ(fate.hash, good[p.kind]) << name;
      }
    } else if (fate.outcome != "judged") {
      EXPECT_NE(fate.said.find(p.id), std::string::npos) << name << ": " << fate.said;
    }
  }
  EXPECT_TRUE(only != nullptr || tried.size() >= 110u) << tried.size();
}

// What a catalogue says of the library with this fault; "" when it does not refuse it.
std::string refusal(const std::string& home, const std::string& fault) {
  fs::create_directory(home + "/" + fault);
  fs::copy_file(EVIL_LOAD, home + "/" + fault + "/evil.so");
  host::Catalogue::Options options;
  options.plugin_dirs = {home + "/" + fault};
  options.install_dir = "/nowhere";
  options.use_environment = false;
  options.describe_limit_s = 0.5;
  const host::Catalogue found(options);
  return found.plugins().empty() && found.refused().size() == 1 ? found.refused()[0].reason : "";
}

// A library that misbehaves while it is loaded does so in a child, and is refused with a sentence.
TEST(EvilLibraries, AreRefusedBeforeAnybodyLoadsThem) {
  char name[] = "/tmp/swage-evil-load-XXXXXX";
  const std::string home = mkdtemp(name);
  std::vector<std::string> faults = {"init_refuses",        "factory_null",        "descriptor_null",
                                     "descriptor_nameless", "descriptor_kindless", "descriptor_endless"};
  for (const char* function : {"constructor", "init", "factory", "descriptor"})
    for (const char* what : {"throws", "loops", "blocks", "crashes", "overflows", "aborts", "exits", "quits", "rounds", "translates"})
      faults.push_back(std::string(function) + "_" + what);
#ifdef SWAGE_SANITIZED_THREADS
  // the sanitizer's report of them stands behind the sentence
  std::erase_if(faults, [](const std::string& fault) { return fault == "constructor_throws" || fault == "constructor_exits"; });
#endif
  in_children(
      faults.size(), [&](std::size_t i) { std::ofstream(home + "/said_" + faults[i]) << refusal(home, faults[i]); },
      [&](std::size_t i, int status) {
        const std::string reason = slurp(home + "/said_" + faults[i]);
        if (std::getenv("EVIL_PRINT")) std::printf("load.%s | refused | %s\n", faults[i].c_str(), reason.c_str());
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << faults[i] << ": " << status;
        EXPECT_TRUE(reason.size() > 10 && reason.ends_with(".")) << faults[i] << ": " << reason;
      });
  fs::remove_all(home);
}

TEST_F(EvilPlugins, TheGuideNamesNoneThatIsNotThere) {
  for (const auto& [name, outcome] : expected())
    EXPECT_NE(catalogue().find(kPrefix + name), nullptr) << name;
}

}  // namespace
}  // namespace swage::session
