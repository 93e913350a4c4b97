// SPDX-License-Identifier: Apache-2.0
//
// swage run and swage replay, without a window.
#include "host/child.hpp"
#include "program.hpp"
#include "record/sql.hpp"
#include "record/store.hpp"

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

TEST_F(Run, AnAttemptThatIsCutShortIsNotPassed) {
  const Said said = run(lesson("100 s"), {"--as-fast-as-possible", "--max-time", "0.2"});
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, testing::Not(HasSubstr("passed")));
}

TEST_F(Run, CtrlCEndsAsAbortedAndKeepsIt) {
  const host::ChildResult child =
      host::run_program({"/usr/bin/timeout", "--preserve-status", "-s", "INT", "1.5", SWAGE_PROGRAM, "run",
                         lesson("100 s"), "--headless", "--store", store()},
                        60);
  EXPECT_EQ(child.exit_code, 1) << child.err;
  EXPECT_THAT(child.err, HasSubstr("Interrupted: the attempt ends as aborted."));
  EXPECT_THAT(child.out, HasSubstr("aborted"));
  const nlohmann::json list = swage({"attempts", "list", "--store", store(), "--json"}).json();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["state"], "aborted");
  EXPECT_GT(list[0]["simulated_s"].get<double>(), 0.1);
}

TEST_F(Run, ProblemsNameFileAndKey) {
  const Said none = run(path("none.json"));
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.out, "");
  EXPECT_THAT(none.err, HasSubstr("none.json"));
  const Said wrong = run(lesson("100 s", R"("sed": 4,)"), {"--json"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("drop.json"));
  EXPECT_THAT(wrong.err, HasSubstr("Did you mean \"seed\"?"));
  EXPECT_THAT(wrong.json()["problems"][0]["where"].get<std::string>(), HasSubstr("#/sed"));
  const Said hand = run(source("lessons/series/020_grasp_basic.json"), {"--device", "expret"});
  EXPECT_EQ(hand.code, 2);
  EXPECT_THAT(hand.err, HasSubstr("There is no device \"expret\" for this lesson. Did you mean \"expert\"?"));
}

TEST_F(Run, AMouseWithoutAWindowIsRefused) {
  const Said said = run(source("lessons/series/020_grasp_basic.json"));
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(
      said.err,
      HasSubstr("\"hand\" is a mouse, and without a window nobody can move it. Choose another hand with "
                "--device (expert, novice, clumsy), or an end with --max-time."));
}

TEST_F(Run, WithoutADisplayItRunsWithoutAWindow) {
  const Said said = swage({"run", lesson(), "--as-fast-as-possible", "--store", store()});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.err, HasSubstr("running without a window."));
}

TEST_F(Run, TheExpertPassesTheClumsyHandDoesNotAndBothReplay) {
  const std::string grasp = source("lessons/series/020_grasp_basic.json");
  const Said expert = run(grasp, {"--as-fast-as-possible", "--device", "expert"});
  EXPECT_EQ(expert.code, 0) << expert.out << expert.err;
  EXPECT_THAT(expert.out, testing::ContainsRegex("force.mean +0.[0-9]+ N +Mean grip force"));
  EXPECT_EQ(swage({"replay", "last", "--store", store()}).code, 0);
  const Said clumsy = run(grasp, {"--as-fast-as-possible", "--device", "clumsy", "--json"});
  EXPECT_EQ(clumsy.code, 1) << clumsy.out << clumsy.err;
  EXPECT_EQ(clumsy.json()["outcome"], "failed");
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

TEST_F(Run, ReplayFindsTheFirstStepThatDiffers) {
  const std::string id = run(lesson(), {"--as-fast-as-possible", "--json"}).json()["attempt"];
  // the scene was another one
  tamper(
      "UPDATE attempt SET descriptor = replace(descriptor, '\"scene_length\"', '\"gravity\": [0, 0, -9], "
      "\"scene_length\"')");
  const Said said = swage({"replay", id, "--store", store()});
  EXPECT_EQ(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr("differs from step 0 on (0.000 s)"));
  tamper("DELETE FROM chunk WHERE stream = 'hash' AND seq = 1");
  const Said damaged = swage({"replay", id, "--store", store()});
  EXPECT_EQ(damaged.code, 2);
  EXPECT_THAT(damaged.err, HasSubstr("damaged"));
}

}  // namespace
}  // namespace swage::tools::test
