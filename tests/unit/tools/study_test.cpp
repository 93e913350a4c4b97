// SPDX-License-Identifier: Apache-2.0
//
// swage study: a matrix of attempts, its table and figures.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "host/sentences.hpp"
#include "program.hpp"
#include "toolkit/sentences.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

class Study : public Program {
 protected:
  void SetUp() override {
    write_drop_lesson();
  }
  std::string study(const std::string& levels, const std::string& more = "") const {
    write("study.json",
          R"({ "format": "swage-study/1", "title": "How long", "lesson": "drop.json", "repeats": 2, )" +
              more + R"( "factors": [ { "name": "Duration", "levels": [ )" + levels + R"( ] } ],
        "hands": [ { "name": "nobody", "device": "mouse" } ],
        "figures": [ { "metric": "time.task", "title": "Time", "unit": "ms", "scale": 1000, "file": "time.svg" } ] })");
    return path("study.json");
  }
};

TEST_F(Study, RunsTheMatrixAndWritesTableAndFigures) {
  const std::string file = study(R"({ "name": "short", "set": { "lesson.duration": "0.02 s" } },
                                    { "name": "long", "set": { "lesson.duration": "0.04 s" } })");
  const Said said = swage({"study", file, "--out", path("figures")});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("How long\n"));
  EXPECT_THAT(said.out, testing::ContainsRegex("short +2[0-9](\\.[0-9]+)? \\[2[^,]*, 2[^,]*\\] \\(2 of 2\\)"));
  EXPECT_THAT(said.out, testing::ContainsRegex("long +4[0-9](\\.[0-9]+)? \\[4[^,]*, 4[^,]*\\] \\(2 of 2\\)"));

  std::istringstream csv(read("figures/attempts.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "Duration,hand,seed,passed,reason,score,time.task");
  int rows = 0;
  while (std::getline(csv, line)) ++rows;
  EXPECT_EQ(rows, 4);
  const std::string svg = read("figures/time.svg");
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr(">nobody<"));
  EXPECT_THAT(svg, HasSubstr(">long<"));
}

TEST_F(Study, ALevelMayBeALessonOfItsOwn) {
  const std::string file = study(R"({ "name": "this one", "lesson": "drop.json" }, { "name": "none", "lesson": "no.json" })");
  const Said said = swage({"study", file});
  EXPECT_NE(said.code, 0);
  EXPECT_THAT(said.err, HasSubstr("no.json"));
}

TEST_F(Study, SetsAValueInEveryAttemptUnlessTheStudySaysOtherwise) {
  const std::string file =
      study(R"({ "name": "as it is" }, { "name": "long", "set": { "lesson.duration": "0.04 s" } })");
  const Said said = swage({"study", file, "--set", "lesson.duration=0.02 s"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, testing::ContainsRegex("as it is +2[0-9](\\.[0-9]+)? \\[2[^,]*, 2[^,]*\\] \\(2 of 2\\)"));
  EXPECT_THAT(said.out, testing::ContainsRegex("long +4[0-9](\\.[0-9]+)? \\[4[^,]*, 4[^,]*\\] \\(2 of 2\\)"));
  const Said wrong = swage({"study", file, "--set", "ball.weight=3"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("swage.object.solids" + host::say::kNoSuchParam.words(1)));
}

// two levels, two attempts each: four rows
const char* const kTwo = R"({ "name": "short", "set": { "lesson.duration": "0.02 s" } },
                            { "name": "long", "set": { "lesson.duration": "0.04 s" } })";

TEST_F(Study, ShardsGiveTheFiguresOfOneMachineByteForByte) {
  const std::string file = study(kTwo);
  const Said alone = swage({"study", file, "--out", path("alone")});
  ASSERT_EQ(alone.code, 0) << alone.err;
  EXPECT_FALSE(std::filesystem::exists(path("alone/rows-1-of-1.jsonl"))) << "the table has them";
  for (const char* shard : {"3/3", "1/3"}) EXPECT_EQ(swage({"study", file, "--out", path("many"), "--shard", shard}).code, 0);
  const Said early = swage({"study", file, "--out", path("many"), "--merge"});
  EXPECT_EQ(early.code, 2);
  EXPECT_THAT(early.err, HasSubstr(say::kHolds(path("many"), 3, 4)));
  EXPECT_EQ(swage({"study", file, "--out", path("many"), "--shard", "2/3"}).code, 0);
  const Said merged = swage({"study", file, "--out", path("many"), "--merge"});
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(merged.out, alone.out);
  EXPECT_EQ(read("many/attempts.csv"), read("alone/attempts.csv"));
  EXPECT_EQ(read("many/time.svg"), read("alone/time.svg"));
}

TEST_F(Study, ShardsOfAnotherStudyAreNotMixedIn) {
  EXPECT_EQ(swage({"study", study(kTwo), "--out", path("many"), "--shard", "1/2"}).code, 0);
  // another seed is another study, and so is another value that was set
  const std::string other = study(kTwo, R"("seed": 7,)");
  EXPECT_THAT(swage({"study", other, "--out", path("many"), "--merge"}).err, HasSubstr(say::kHolds(path("many"), 0, 4)));
  const std::string first = study(kTwo);
  EXPECT_THAT(swage({"study", first, "--out", path("many"), "--merge", "--set", "ball.density=2000"}).err, HasSubstr(say::kHolds(path("many"), 0, 4)));
  EXPECT_THAT(swage({"study", first, "--out", path("many"), "--merge"}).err, HasSubstr(say::kHolds(path("many"), 2, 4)));
  EXPECT_THAT(swage({"study", first, "--shard", "1/2"}).err, HasSubstr(say::kNeedsOut()));
  for (const char* wrong : {"0/2", "3/2", "2", "1/", "a/b", "1/2x"})
    EXPECT_THAT(swage({"study", first, "--out", path("many"), "--shard", wrong}).err, HasSubstr(say::kNoShard(wrong))) << wrong;
}

// SWAGE_KILL_TRIALS: how often, 3 unless set
TEST_F(Study, GoesOnAfterAKillWhereItWas) {
  const char* asked = std::getenv("SWAGE_KILL_TRIALS");
  const int trials = asked != nullptr ? std::atoi(asked) : 3;
  std::string levels;
  for (int i = 0; i < std::max(20, 3 * trials); ++i)
    levels += std::string(i ? "," : "") + R"({ "name": "l)" + std::to_string(i) + R"(", "set": { "lesson.duration": "0.)" +
              std::to_string(20 + i) + R"( s" } })";
  const std::string file = study(levels);
  const Said whole = swage({"study", file, "--out", path("whole")});
  ASSERT_EQ(whole.code, 0) << whole.err;
  const auto lines = [&] { return std::ranges::count(read("killed/rows-1-of-1.jsonl"), '\n'); };
  std::mt19937 random(14);
  int kills = 0;
  for (int before = 0; kills < trials; ++kills) {
    Running run({"study", file, "--out", path("killed")}, folder());
    const int last = before + 1 + static_cast<int>(random() % 5);
    while (run.alive() && lines() < last) usleep(2000);
    usleep(static_cast<useconds_t>(random() % 20'000));
    if (!run.alive()) break;
    run.signal(SIGKILL);
    while (run.alive()) usleep(2000);
    before = static_cast<int>(lines());
  }
  EXPECT_EQ(kills, trials) << "it was killed in the middle";
  // a line that a kill has torn counts for nothing
  std::ofstream(path("killed/rows-1-of-1.jsonl"), std::ios::app) << R"({"row":39,"le)";
  const Said rest = swage({"study", file, "--out", path("killed")});
  EXPECT_EQ(rest.code, 0) << rest.err;
  EXPECT_EQ(rest.out, whole.out);
  EXPECT_EQ(read("killed/attempts.csv"), read("whole/attempts.csv"));
  EXPECT_EQ(read("killed/time.svg"), read("whole/time.svg"));
}

TEST_F(Study, SaysWhatIsWrong) {
  EXPECT_THAT(swage({"study", path("none.json")}).err, HasSubstr(toolkit::say::kNoFile()));
  write("study.json", "{");
  EXPECT_THAT(swage({"study", path("study.json")}).err, HasSubstr(say::kNotJson()));
  write("study.json", R"({ "format": "swage-lesson/1" })");
  EXPECT_THAT(swage({"study", path("study.json")}).err,
              HasSubstr("#/format: " + say::kNeedsFormat("swage-study/1")));
  const Said unknown = swage({"study", study("", R"("sead": 3,)")});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("#/sead: " + say::kUnknown()));
  EXPECT_THAT(unknown.err, HasSubstr("#/factors/0/levels: " + say::kNeedsLevels()));
  // what only the lesson can refuse is refused with its sentence
  const Said level = swage({"study", study(R"({ "name": "x", "set": { "ball.weight": 3 } })")});
  EXPECT_EQ(level.code, 2);
  EXPECT_THAT(level.err, HasSubstr("swage.object.solids" + host::say::kNoSuchParam.words(1)));
}

}  // namespace
}  // namespace swage::tools::test
