// SPDX-License-Identifier: Apache-2.0
//
// swage run and swage replay, without a window.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "assembly/sentences.hpp"
#include "host/nearest.hpp"
#include "host/sentences.hpp"
#include "program.hpp"
#include "record/recorder.hpp"
#include "record/school.hpp"
#include "record/sql.hpp"
#include "record/store.hpp"
#include "session/sentences.hpp"
#include "test_places.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

class Run : public Program {
 protected:
  // a ball falls for as long as the lesson looks; `extra` is put into the lesson file as it is
  std::string lesson(const std::string& duration = "0.5 s", const std::string& extra = "") const {
    write("drop.json", R"({
      "format": "swage-lesson/1", "id": "org.example.drop", "title": "Drop", "scene_length": "1 mm", )" +
                           extra + R"(
      "requires": { "swage.object.solids": "^1", "swage.lesson.look": "^1" },
      "objects": [ { "name": "ball", "plugin": "swage.object.solids" } ],
      "lesson": { "plugin": "swage.lesson.look", "params": { "duration": ")" +
                           duration + R"(" } } })");
    return path("drop.json");
  }
  void tamper(const char* sql) const {
    std::string error;
    const auto db = record::Database::open(store(), record::Access::kWrite, error);
    ASSERT_TRUE(db && db->run(sql)) << error;
  }
  record::AttemptRow only_attempt() const {
    std::string error;
    const auto db = record::Store::open(store(), error);
    const auto all = db ? db->attempts("") : std::vector<record::AttemptRow>();
    EXPECT_EQ(all.size(), 1u) << error;
    return all.empty() ? record::AttemptRow() : all[0];
  }
  // false: the program ended before
  bool until_some_is_kept(Running& child) const {
    record::Recording recording;
    std::string error;
    while (child.alive() && recording.step.size() < 100) {
      usleep(10'000);
      const auto db = std::filesystem::exists(store()) ? record::Store::open(store(), error) : nullptr;
      const auto all = db ? db->attempts("") : std::vector<record::AttemptRow>();
      if (!all.empty()) record::read_recording(store(), all[0].id, recording, error);
    }
    return child.alive();
  }
  Said run(const std::string& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"run", file, "--headless", "--store", store(), "--person", "Ada"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return swage(arguments);
  }
};

TEST_F(Run, SaysHowItWentAndWhereItIsKept) {
  const Said said = run(lesson(), {"--as-fast-as-possible"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("Drop (org.example.drop)\n"));
  EXPECT_THAT(said.out, HasSubstr("passed"));
  EXPECT_THAT(said.out, HasSubstr("score 100 of 100, after 0.5"));
  EXPECT_THAT(said.out, testing::ContainsRegex("time.task +0.5[0-9]* s +Simulated time that was looked at."));
  EXPECT_THAT(said.out, testing::ContainsRegex("loop: 50[0-9] steps, mean "));
  EXPECT_THAT(said.out, testing::ContainsRegex("kept as attempt [0-9a-f-]{36} in " + store()));
}

// who sleeps in a paced run is named once, and the machine is not blamed for it
TEST_F(Run, APluginThatSleepsIsBlamed) {
  const std::string id = "org.example.bad.coupling_sleeps";
  std::filesystem::create_directories(path("plugins"));
  std::filesystem::copy(SWAGE_BINARY_DIR "/tests/bad_plugins/bundles/" + id, path("plugins/" + id),
                        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  write("sleepy.json", R"({ "format": "swage-lesson/1", "id": "org.example.sleepy", "title": "Sleepy", "scene_length": "1 mm",
    "requires": { "swage.object.solids": "^1", ")" + id + R"(": "^1", "swage.lesson.look": "^1" },
    "objects": [ { "name": "ring", "plugin": "swage.object.solids" },
                 { "name": "hook", "plugin": "swage.object.solids", "pose": { "p": ["20 mm", "0 mm", "0 mm"] } } ],
    "couplings": [ { "name": "nap", "plugin": ")" + id + R"(", "between": ["ring", "hook"] } ],
    "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "0.5 s" } } })");
#if defined(__OPTIMIZE__) && !defined(SWAGE_SANITIZED)  // elsewhere a step has more time
  const Said said = run(path("sleepy.json"), {"--plugin-dir", path("plugins")});
  EXPECT_EQ(said.code, 1) << said.out << said.err;
  EXPECT_THAT(said.err, HasSubstr("error: nap (" + id));
  EXPECT_THAT(said.err, testing::Not(HasSubstr(session::say::kTooSlow.words(1))));
#endif
}

// A name that nobody entered gets a made code; only the roster has the name.
TEST_F(Run, WhoIsNewGetsAMadeCodeWhichIsTold) {
  const Said said = run(lesson(), {"--as-fast-as-possible"});
  ASSERT_EQ(said.code, 0) << said.err;
  std::string error;
  const auto school = record::School::open(store(), error);
  ASSERT_TRUE(school) << error;
  record::Person ada;
  ASSERT_TRUE(school->find_person("Ada", ada)) << school->error();
  EXPECT_NE(ada.code, "Ada");
  EXPECT_THAT(said.err, HasSubstr(say::kNewHere("Ada", ada.code)));
  EXPECT_EQ(run(lesson(), {"--as-fast-as-possible"}).err.find("is new here"), std::string::npos) << "said once";
  EXPECT_EQ(school->people().size(), 1u);
  ASSERT_EQ(swage({"attempts", "export", "all", path("all.csv"), "--as", "csv", "--store", store()}).code, 0);
  EXPECT_THAT(read("all.csv"), testing::AllOf(HasSubstr(ada.code), testing::Not(HasSubstr("Ada"))));
}

TEST_F(Run, WritesEverySignalOfEveryStepWhereAsked) {
  const Said said = run(source("lessons/series/020_grasp_basic.json"),
                        {"--as-fast-as-possible", "--device", "expert", "--trace", path("t.csv")});
  ASSERT_EQ(said.code, 0) << said.err;
  const std::string trace = read("t.csv");
  EXPECT_THAT(trace, testing::StartsWith("time [s],"));
  EXPECT_THAT(trace.substr(0, trace.find('\n')), HasSubstr("grasp.force [N]"));
  EXPECT_NEAR(static_cast<double>(std::count(trace.begin(), trace.end(), '\n')), 1000 * only_attempt().simulated_s, 3) << "1 kHz";
}

TEST_F(Run, AsJson) {
  const nlohmann::json answer = run(lesson(), {"--as-fast-as-possible", "--json"}).json();
  EXPECT_EQ(answer["lesson"], "org.example.drop");
  EXPECT_EQ(answer["outcome"], "passed");
  EXPECT_EQ(answer["metrics"][0]["id"], "time.task");
  EXPECT_EQ(answer["metrics"][0]["unit"], "s");
  EXPECT_EQ(answer["hash"].get<std::string>().size(), 16u);
  EXPECT_TRUE(answer["problems"].is_array());
  std::string error;
  record::AttemptRow row;
  ASSERT_TRUE(record::Store::open(store(), error)->attempt(answer["attempt"], row)) << error;
  EXPECT_EQ(row.person_name, "Ada");
  EXPECT_EQ(row.state, "complete");
  EXPECT_EQ(row.outcome, "passed");
}

TEST_F(Run, WithoutAClockItGivesTheSameBits) {
  const nlohmann::json a = run(lesson(), {"--as-fast-as-possible", "--json"}).json();
  const nlohmann::json b = run(lesson(), {"--as-fast-as-possible", "--json"}).json();
  EXPECT_EQ(a["hash"], b["hash"]);
  const nlohmann::json c = run(lesson("0.501 s"), {"--as-fast-as-possible", "--json"}).json();
  EXPECT_NE(a["hash"], c["hash"]);
}

TEST_F(Run, KeepsNothingWhenTold) {
  const Said said = swage({"run", lesson(), "--headless", "--as-fast-as-possible", "--store", ":none:"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("\nnot kept\n"));
}

// What a shell can take away from a program before it starts it.
TEST_F(Run, ALimitOnFilesIsASentenceAndNoSignal) {
#ifdef SWAGE_SANITIZED_THREADS
  GTEST_SKIP() << "The sanitizer does not leave SIGXFSZ to the program.";
#endif
  const std::string file = lesson("3 s");
  for (const char* blocks : {"0", "20", "100"}) {
    const Said said = swage({"-c", "ulimit -f " + std::string(blocks) + "; exec " SWAGE_PROGRAM " run " + file +
                                       " --headless --as-fast-as-possible --store " + path(blocks) + ".db"},
                            "/bin/bash");
    // kept, or said that it is not; never both, and never a signal
    const bool kept = said.out.find("kept as attempt") != std::string::npos;
    EXPECT_EQ(said.code == 0, kept) << blocks << said.out << said.err;
    if (!kept) {
      EXPECT_EQ(said.code, 2) << said.out << said.err;
      EXPECT_THAT(said.err, HasSubstr("ulimit -f")) << blocks;
    }
  }
}

TEST_F(Run, WithoutStandardStreamsTheStoreStaysWhole) {
  const Said said = swage({"-c", "exec " SWAGE_PROGRAM " run " + lesson() +
                                     " --headless --as-fast-as-possible --store " + store() + " <&- >&- 2>&-"},
                          "/bin/bash");
  EXPECT_EQ(said.code, 0);
  EXPECT_EQ(only_attempt().state, "complete");
  EXPECT_EQ(swage({"replay", "last", "--store", store()}).code, 0);
}

// What the lesson says today is kept beside what it said then, and neither replaces the other.
TEST_F(Run, TheLessonOfTodayJudgesAnAttemptOfThen) {
  run(lesson(), {"--as-fast-as-possible"});
  const Said same = swage({"replay", "last", "--grade", "--store", store()});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("the same bits"));
  EXPECT_THAT(same.out, testing::ContainsRegex("outcome +passed +passed"));
  // an earlier version of the lesson was stricter
  tamper("UPDATE attempt SET outcome = 'failed', score = 12");
  const nlohmann::json other = swage({"replay", "all", "--grade", "--json", "--store", store()}).json();
  ASSERT_EQ(other.size(), 1u);
  EXPECT_FALSE(other[0]["same"]);
  EXPECT_EQ(other[0]["then"]["outcome"], "failed");
  EXPECT_EQ(other[0]["now"]["outcome"], "passed");
  EXPECT_EQ(swage({"replay", "all", "--grade", "--store", store()}).code, 1);
  EXPECT_EQ(only_attempt().outcome, "failed");
  std::string error;
  const auto grades = record::Store::open(store(), error)->grades(only_attempt().id);
  ASSERT_EQ(grades.size(), 3u);
  EXPECT_EQ(grades[0].outcome, "passed");
  EXPECT_EQ(grades[0].score, 100);
  EXPECT_TRUE(grades[0].identical);
  EXPECT_FALSE(grades[0].metrics.empty());
  EXPECT_FALSE(grades[0].plugins.empty());
}

TEST_F(Run, AKeptAttemptIsNoLesson) {
  run(lesson(), {"--as-fast-as-possible"});
  ASSERT_EQ(swage({"attempts", "export", "last", path("one.swage"), "--store", store()}).code, 0);
  const Said said = run(path("one.swage"));
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr(say::kIsAttempt(path("one.swage"), path("one.swage"), path("one.swage"))));
}

TEST_F(Run, APlaceThatMayNotBeWrittenOffersToRunUnrecorded) {
  const Said said = swage({"run", lesson(), "--headless", "--as-fast-as-possible", "--store", "/proc/a.db"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("--store :none:"));
}

TEST_F(Run, AnAttemptThatIsCutShortIsNotPassed) {
  const Said said = run(lesson("100 s"), {"--as-fast-as-possible", "--max-time", "0.2"});
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, testing::Not(HasSubstr("passed")));
}

// The attempt would last a thousand seconds; it is interrupted as soon as some of it is in the store.
TEST_F(Run, CtrlCEndsAsAbortedAndKeepsIt) {
  Running child({"run", lesson("1000 s"), "--headless", "--store", store()}, folder());
  ASSERT_TRUE(until_some_is_kept(child));
  child.signal(SIGINT);
  const Said said = child.end();
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.err, HasSubstr(say::kInterrupted()));
  EXPECT_THAT(said.out, HasSubstr("aborted"));
  const record::AttemptRow row = only_attempt();
  EXPECT_EQ(row.state, "aborted");
  EXPECT_GT(row.simulated_s, 0.1);
}

// a group of processes that is interrupted may hear of it twice
TEST_F(Run, TwoSignalsAreNoReasonToLoseTheAttempt) {
  Running child({"run", lesson("1000 s"), "--headless", "--store", store()}, folder());
  ASSERT_TRUE(until_some_is_kept(child));
  child.signal(SIGTERM);
  child.signal(SIGINT);
  EXPECT_EQ(child.end().code, 1);
  EXPECT_EQ(only_attempt().state, "aborted");
}

TEST_F(Run, ProblemsNameFileAndKey) {
  const Said none = run(path("none.json"));
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.out, "");
  EXPECT_THAT(none.err, HasSubstr("none.json"));
  const Said wrong = run(lesson("100 s", R"("sed": 4,)"), {"--json"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("drop.json"));
  EXPECT_THAT(wrong.err, HasSubstr(host::did_you_mean("sed", {"seed"})));
  EXPECT_THAT(wrong.json()["problems"][0]["where"].get<std::string>(), HasSubstr("#/sed"));
  const Said hand = run(source("lessons/series/020_grasp_basic.json"), {"--device", "expret"});
  EXPECT_EQ(hand.code, 2);
  EXPECT_THAT(hand.err, HasSubstr(assembly::say::kNoDevice.words(0) + "expret" + assembly::say::kNoDevice.words(1) + host::did_you_mean("expret", {"expert"})));
}

TEST_F(Run, AMouseWithoutAWindowIsRefused) {
  const Said said = run(source("lessons/series/020_grasp_basic.json"));
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(
      said.err,
      HasSubstr(say::kIsMouse("hand", " (expert, novice, clumsy)")));
  EXPECT_THAT(swage({"attempts", "list", "--store", store(), "--json"}).json(), testing::IsEmpty());
}

TEST_F(Run, WithoutADisplayItRunsWithoutAWindow) {
  const Said said = swage({"run", lesson(), "--as-fast-as-possible", "--store", store()});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.err, testing::AnyOf(HasSubstr(say::kNoConsole()), HasSubstr(say::kNoDisplay())));
}

TEST_F(Run, TheExpertPassesTheClumsyHandDoesNotAndBothReplay) {
  const std::string grasp = source("lessons/series/020_grasp_basic.json");
  const Said expert = run(grasp, {"--as-fast-as-possible", "--device", "expert"});
  EXPECT_EQ(expert.code, 0) << expert.out << expert.err;
  EXPECT_THAT(expert.out, HasSubstr("SMaRT: 5.0 of 5 over 3 of 9 items"));
  EXPECT_THAT(expert.out, testing::ContainsRegex("force.mean +0.[0-9]+ N +Mean grip force"));
  EXPECT_EQ(swage({"replay", "last", "--store", store()}).code, 0);
  const Said clumsy = run(grasp, {"--as-fast-as-possible", "--device", "clumsy", "--json"});
  EXPECT_EQ(clumsy.code, 1) << clumsy.out << clumsy.err;
  EXPECT_EQ(clumsy.json()["outcome"], "failed");
  EXPECT_EQ(clumsy.json()["ratings"][1]["id"], "smart");
  EXPECT_LT(clumsy.json()["ratings"][1]["mean"], 2);
  EXPECT_TRUE(clumsy.json()["ratings"][0]["mean"].is_null());  // no knot was tied
  EXPECT_THAT(clumsy.json()["reason"].get<std::string>(), testing::StartsWith("failed."));
  EXPECT_EQ(swage({"replay", "last", "--store", store()}).code, 0);
}

TEST_F(Run, ReplayGivesTheSameHashes) {
  const std::string id = run(lesson(), {"--as-fast-as-possible", "--json"}).json()["attempt"];
  const Said said = swage({"replay", id, "--store", store()});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, testing::MatchesRegex("identical 50[0-9] steps \\(0.50[0-9] s\\)\n"));
  EXPECT_EQ(swage({"attempts", "export", id, path("one.swage"), "--store", store()}).code, 0);
  const nlohmann::json answer = swage({"replay", path("one.swage"), "--json"}).json();
  EXPECT_EQ(answer["identical"], true);
  EXPECT_EQ(answer["first_difference"], nullptr);
  EXPECT_EQ(swage({"replay", "last", "--store", store()}).code, 0);
}

// Another place with another store: no lesson, no hand on file, and no device plugin at all.
TEST_F(Run, AnExportedAttemptReplaysElsewhere) {
  namespace fs = std::filesystem;
  for (const char* name : {"here/series", "here/hands", "there/bin", "there/plugins"})
    fs::create_directories(path(name));
  fs::copy(source("lessons/series/020_grasp_basic.json"), path("here/series"));
  fs::copy(source("lessons/hands/020_expert.json"), path("here/hands"));
  const Said ran = run(path("here/series/020_grasp_basic.json"),
                       {"--as-fast-as-possible", "--device", "expert", "--max-time", "2"});
  ASSERT_EQ(ran.code, 1) << ran.err;
  ASSERT_EQ(swage({"attempts", "export", "last", path("one.swage"), "--store", store()}).code, 0);
  fs::remove_all(path("here"));
  fs::remove(store());

  const fs::path built = fs::path(SWAGE_PROGRAM).parent_path().parent_path();
  fs::copy(SWAGE_PROGRAM, path("there/bin/swage"));
  fs::copy(built / "bin/swage-describe", path("there/bin/swage-describe"));
  for (const auto& bundle : fs::directory_iterator(built / "plugins"))
    if (const std::string id = bundle.path().filename().string(); !id.starts_with("swage.device."))
      fs::create_directory_symlink(bundle.path(), path("there/plugins/" + id));
  const auto there = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--store", path("there.db")});
    return swage(arguments, path("there/bin/swage"));
  };
  const Said no_device = there({"run", source("lessons/series/020_grasp_basic.json"), "--headless"});
  EXPECT_THAT(no_device.err, HasSubstr(host::say::kNotInstalled("swage.device.mouse")));
  const Said taken = there({"attempts", "import", path("one.swage")});
  ASSERT_EQ(taken.code, 0) << taken.err;
  const Said said = there({"replay", "last"});
  EXPECT_EQ(said.out, say::kIdentical(2000, "2.000") + "\n");
  EXPECT_EQ(said.err, "");
}

TEST_F(Run, ReplayFindsTheFirstStepThatDiffers) {
  const std::string id = run(lesson(), {"--as-fast-as-possible", "--json"}).json()["attempt"];
  // the scene was another one
  tamper(
      "UPDATE attempt SET descriptor = replace(descriptor, '\"scene_length\"', '\"gravity\": [0, 0, -9], "
      "\"scene_length\"')");
  const Said said = swage({"replay", id, "--store", store()});
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr(say::kDiffers(0, "0.000")));
  tamper("DELETE FROM chunk WHERE stream = 'hash' AND seq = 1");
  const Said damaged = swage({"replay", id, "--store", store()});
  EXPECT_EQ(damaged.code, 2);
  EXPECT_THAT(damaged.err, HasSubstr("damaged"));
}

}  // namespace
}  // namespace swage::tools::test
