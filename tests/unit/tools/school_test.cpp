// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/nearest.hpp"
#include "program.hpp"
#include "record/recorder.hpp"
#include "record/sentences.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class SchoolVerbs : public Program {
 protected:
  std::string keep(const std::string& person, const std::string& mode = "test") const {
    record::AttemptInfo info;
    info.person = person;
    info.lesson_id = "org.example.a";
    info.lesson_title = "A lesson";
    info.mode = mode;
    info.device = "mouse";
    info.devices = {"hand"};
    info.script.signals = {{"grasp", "force", "N", ""}};
    info.script.metrics = {{"lesson", "tries", "1", ""}};
    base::Problems problems;
    const auto recorder = record::Recorder::open(store(), info, problems);
    if (!recorder) return "";
    for (uint64_t i = 0; i < 300; ++i) {
      record::StepRecord step{};
      step.step = i;
      step.n_device = step.n_signal = 1;
      step.sample[0].pose.p = {1e-3 * static_cast<double>(i), 0, 0};
      step.signal[0] = 0.5;
      recorder->step(step);
    }
    record::AttemptEnd end;
    end.outcome = judge::Outcome::kPassed;
    end.score = 91;
    end.simulated_s = 0.3;
    end.metric = {2};
    recorder->finish(end);
    return recorder->attempt_id();
  }
  Said say(std::vector<std::string> words) const {
    words.insert(words.end(), {"--store", store()});
    return swage(words);
  }
  nlohmann::json json(std::vector<std::string> words) const {
    words.push_back("--json");
    return say(words).json();
  }
  std::string text(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void expect_refused(const std::vector<std::string>& words, const std::string& sentence) const {
    const Said said = say(words);
    EXPECT_EQ(said.code, 2) << words[0] << " " << words[1];
    EXPECT_THAT(said.err, HasSubstr(sentence));
  }
};

TEST_F(SchoolVerbs, PeopleComeAndGo) {
  const nlohmann::json ada = json({"people", "add", "Ada Meyer", "--hand", "left", "--group", "Residents"});
  EXPECT_EQ(ada["group"], "Residents");
  write("list.csv", "name,group\nBo,Residents\nAda Meyer,Residents\n");
  EXPECT_THAT(say({"people", "import", path("list.csv"), "--dry-run"}).out, HasSubstr("1 of 2 would be added"));
  EXPECT_EQ(json({"people", "list"}).size(), 1u);
  EXPECT_THAT(say({"people", "import", path("list.csv")}).out, HasSubstr("1 of 2 added"));
  EXPECT_EQ(json({"people", "list", "--group", "Residents"}).size(), 2u);
  EXPECT_EQ(json({"people", "edit", "Bo", "--name", "Bo L."})["name"], "Bo L.");
  EXPECT_EQ(say({"people", "archive", "Bo L."}).code, 0);
  EXPECT_EQ(json({"people", "list"}).size(), 1u);
  EXPECT_EQ(json({"people", "list", "--archived"}).size(), 2u);
  EXPECT_EQ(say({"people", "archive", "Bo L.", "--back"}).code, 0);
  EXPECT_EQ(json({"people", "list"}).size(), 2u);
  expect_refused({"people", "add", "Ada Meyer"}, record::say::kNameTaken("Ada Meyer"));
  expect_refused({"people", "edit", "Aad Meyer", "--name", "x"}, record::say::kNobody("Aad Meyer") + host::did_you_mean("Aad Meyer", {"Ada Meyer"}));
  write("bad.csv", "name,shoe size\nFrida B\xF6hm,43\n");
  const Said odd = say({"people", "import", path("bad.csv"), "--dry-run"});
  EXPECT_EQ(odd.code, 0);
  EXPECT_THAT(odd.err, testing::AllOf(HasSubstr(record::say::kColumn("shoe size")), HasSubstr(record::say::kWindowsText(2))));
  EXPECT_THAT(odd.out, HasSubstr("Frida B\xC3\xB6hm"));
  expect_refused({"people", "import", path("none.csv")}, say::kNotRead(path("none.csv")));
}

TEST_F(SchoolVerbs, ErasingIsConfirmedAndReachesExportedFiles) {
  json({"people", "add", "Ada Meyer"});
  const std::string code = json({"people", "list"})[0]["code"];
  keep("Ada Meyer");
  keep("Bo");
  ASSERT_EQ(say({"attempts", "export", "all", path("all.csv"), "--as", "csv"}).code, 0);
  ASSERT_EQ(say({"attempts", "export", "all", path("ada.csv"), "--as", "csv-wide", "--person", "Ada Meyer"}).code, 0);
  ASSERT_EQ(say({"attempts", "backup", path("all.backup")}).code, 0);
  EXPECT_THAT(text("all.csv"), HasSubstr(code));
  expect_refused({"people", "erase", "Ada Meyer"}, say::kFinal("Ada Meyer", 1, "Ada Meyer"));
  expect_refused({"people", "erase", "Ada Meyer", "--confirm", "Bo"}, say::kFinal("Ada Meyer", 1, "Ada Meyer"));
  EXPECT_EQ(json({"people", "list"}).size(), 2u);
  const Said said = say({"people", "erase", "Ada Meyer", "--confirm", "Ada Meyer"});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(json({"people", "list"}).size(), 1u);
  EXPECT_EQ(json({"attempts", "list"}).size(), 1u);
  EXPECT_THAT(text("all.csv"), testing::AllOf(Not(HasSubstr(code)), HasSubstr("Bo")));
  EXPECT_FALSE(std::filesystem::exists(path("ada.csv")));
  EXPECT_THAT(text("all.backup"), Not(HasSubstr("Ada Meyer")));
  EXPECT_EQ(say({"doctor"}).code, 0);
}

TEST_F(SchoolVerbs, WhatPeopleSayAboutAttempts) {
  const std::string id = keep("Guest");
  json({"people", "add", "Ada"});
  EXPECT_EQ(say({"attempts", "name", "last", "Ada"}).code, 0);
  EXPECT_EQ(json({"attempts", "list", "--person", "Ada"}).size(), 1u);
  EXPECT_EQ(say({"attempts", "void", id, "--reason", "the arm was unplugged", "--by", "Mei"}).code, 0);
  nlohmann::json row = json({"attempts", "list"})[0];
  EXPECT_EQ(row["void"], true);
  EXPECT_EQ(row["void_by"], "Mei");
  EXPECT_EQ(say({"attempts", "void", id, "--undo", "--reason", "it was not"}).code, 0);
  EXPECT_EQ(json({"attempts", "list"})[0]["void"], false);
  EXPECT_THAT(say({"attempts", "note", id, "The wrist turns", "--at", "0.25", "--by", "Mei"}).out, HasSubstr("0.250 s  The wrist turns (Mei)"));
  EXPECT_EQ(json({"attempts", "note", id}).size(), 1u);
  expect_refused({"attempts", "note", id, "late", "--at", "7"}, say::kOutsideAttempt("7", "0.300"));
  expect_refused({"attempts", "name", id, "Cy"}, say::kAddThem(record::say::kNobody("Cy"), "Cy"));
  EXPECT_EQ(swage({"attempts", "void", id, "--store", store()}).code, 2) << "a reason is needed";
}

TEST_F(SchoolVerbs, AttemptsLeaveAsTracesTablesAndStatements) {
  const std::string id = keep("Ada");
  EXPECT_EQ(say({"attempts", "export", id, path("t.csv"), "--trace"}).code, 0);
  const std::string trace = text("t.csv");
  EXPECT_EQ(std::count(trace.begin(), trace.end(), '\n'), 301) << "1 kHz";
  EXPECT_THAT(trace, testing::StartsWith("time [s],grasp.force [N],hand.x [m]"));
  EXPECT_THAT(trace, HasSubstr("\n0.003000,0.5,0.002,"));
  const nlohmann::json about = nlohmann::json::parse(text("t.csv.about.json"));
  EXPECT_EQ(about["attempt"], id);
  EXPECT_TRUE(about.contains("lesson_version") && about.contains("calibration") && about["health"].contains("solver.not_converged"));
  EXPECT_EQ(json({"attempts", "export", "all", path("x.json"), "--as", "xapi", "--home", "https://school.example.org"})["attempts"], 1);
  EXPECT_EQ(nlohmann::json::parse(text("x.json"))[0]["actor"]["account"]["name"], "Ada");
  expect_refused({"attempts", "export", "all", path("x.json"), "--as", "xapi"}, say::kOfHome(record::say::kNoHome("")));
  expect_refused({"attempts", "export", "all", path("x.swage")}, say::kAllIsTables());
  expect_refused({"attempts", "export", "all", path("x.csv"), "--as", "csv", "--person", "Cy"}, record::say::kNobody("Cy"));
  expect_refused({"attempts", "export", id, path("no/folder/x.csv"), "--as", "csv"}, say::kNotWritten(path("no/folder/x.csv")));
}

TEST_F(SchoolVerbs, ACourseIsMadeCheckedAndPassed) {
  write("course.json", R"({"format": "swage-course/1", "title": "Basic", "steps": [
    {"lesson": "org.example.a", "title": "A", "limits": [{"metric": "tries", "unit": "1", "most": 3, "gate": true}], "rule": {"kind": "streak", "in_a_row": 2, "later_day": 0}},
    {"file": ")" + source("lessons/series/020_grasp_basic.json") + R"("}]})");
  EXPECT_EQ(json({"courses", "add", path("course.json")})["steps"], 2);
  EXPECT_EQ(json({"courses", "add", path("course.json")})["steps"], 2);
  EXPECT_EQ(json({"courses", "list"}).size(), 1u) << "the same title is the same course";
  const nlohmann::json shown = json({"courses", "show", "Basic"});
  EXPECT_EQ(shown["steps"][1]["lesson"], "swage.series.grasp_basic");
  EXPECT_EQ(shown["steps"][1]["digest"].get<std::string>().size(), 64u) << "frozen";
  json({"people", "add", "Ada", "--group", "Residents"});
  keep("Ada");
  EXPECT_EQ(say({"courses", "assign", "Basic", "--group", "Residents"}).code, 0);
  EXPECT_EQ(json({"courses", "progress", "Basic"})[0]["steps"][0]["passed"], false);
  keep("Ada");
  const nlohmann::json now = json({"courses", "progress", "Basic"})[0];
  EXPECT_EQ(now["steps"][0]["passed"], true);
  EXPECT_EQ(now["passed"], 1);
  EXPECT_EQ(now["steps"][1]["open"], true);
  const nlohmann::json check = json({"courses", "check", "Basic", "--experts", "Ada"});
  EXPECT_EQ(check["steps"][0]["experts"]["all"], 2);
  EXPECT_GT(check["steps"][0]["odds"][2]["passed"], 0.99);
  EXPECT_LT(check["steps"][1]["odds"][0]["passed"], 0.45);

  expect_refused({"courses", "show", "Basc"}, say::kNoCourse("Basc", host::did_you_mean("Basc", {"Basic"})));
  expect_refused({"courses", "assign", "Basic", "--group", "Fellows"}, say::kNoGroup("Fellows"));
  expect_refused({"courses", "check", "Basic", "--experts", "Nobody"}, say::kNobodyAtAll("Nobody"));
  write("wrong.json", R"({"format": "swage-course/1", "title": "W", "steps": [{"lesson": "a", "rule": {"kind": "luck"}}]})");
  expect_refused({"courses", "add", path("wrong.json")}, record::say::kNoSuchRule("luck"));
  EXPECT_EQ(say({"courses", "archive", "Basic"}).code, 0);
  EXPECT_EQ(json({"courses", "list"})[0]["archived"], true);
}

TEST_F(SchoolVerbs, ASyntheticSchoolIsMadeByOneCommandAndSaysSo) {
  const nlohmann::json said = json({"people", "synthetic", "--people", "10", "--attempts", "200", "--lesson", source("lessons/series/020_grasp_basic.json")});
  EXPECT_EQ(said["attempts"], 200);
  const nlohmann::json attempts = json({"attempts", "list"});
  ASSERT_EQ(attempts.size(), 200u);
  for (const auto& a : attempts) EXPECT_EQ(a["synthetic"], true);
  EXPECT_EQ(json({"people", "list"}).size(), 10u);
  EXPECT_EQ(json({"courses", "progress", "Synthetic course"}).size(), 9u);
  EXPECT_EQ(say({"replay", "last"}).code, 0) << "the newest carry the recording of a hand";
  expect_refused({"people", "synthetic"}, record::say::kSyntheticAlready.words(1));
}

}  // namespace
}  // namespace swage::tools::test
