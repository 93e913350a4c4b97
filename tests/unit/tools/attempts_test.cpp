// SPDX-License-Identifier: Apache-2.0
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "program.hpp"
#include "record/recorder.hpp"
#include "record/sentences.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

class Attempts : public Program {
 protected:
  std::string keep(const std::string& person, const std::string& lesson, bool passed = true) const {
    record::AttemptInfo info;
    info.person = person;
    info.lesson_id = lesson;
    info.lesson_title = "A lesson";
    info.mode = "practice";
    info.device = "expert";
    info.script.metrics = {{"lesson", "tries", "1", ""}};
    base::Problems problems;
    const auto recorder = record::Recorder::open(store(), info, problems);
    if (!recorder) return "";
    for (uint64_t i = 0; i < 300; ++i) {
      record::StepRecord step{};
      step.step = i;
      recorder->step(step);
    }
    record::AttemptEnd end;
    end.outcome = passed ? judge::Outcome::kPassed : judge::Outcome::kFailed;
    end.reason = "grasp.held";
    end.score = passed ? 91 : 26;
    end.simulated_s = 0.3;
    end.metric = {2};
    recorder->finish(end);
    return recorder->attempt_id();
  }
};

TEST_F(Attempts, AreListedNewestFirst) {
  const std::string first = keep("Ada", "org.example.a"), second = keep("Bo", "org.example.b");
  const Said said = swage({"attempts", "list", "--store", store()});
  EXPECT_EQ(said.code, 0);
  EXPECT_LT(said.out.find(second), said.out.find(first));
  EXPECT_THAT(said.out, testing::ContainsRegex("Ada +org.example.a +passed +91.0 +0.3 s +grasp.held"));

  const nlohmann::json list =
      swage({"attempts", "list", "--store", store(), "--person", "Ada", "--json"}).json();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["attempt"], first);
  EXPECT_EQ(list[0]["metrics"][0]["value"], 2.0);
  EXPECT_EQ(
      swage({"attempts", "list", "--store", store(), "--lesson", "org.example.b", "--json"}).json().size(),
      1u);

  const Said nobody = swage({"attempts", "list", "--store", store(), "--person", "Adda"});
  EXPECT_EQ(nobody.code, 2);
  EXPECT_THAT(nobody.err, HasSubstr(record::say::kNobody("Adda")));
}

// As in the console: what a lesson computed on the way to a failure is no score.
TEST_F(Attempts, AFailedOneIsListedWithoutAScore) {
  keep("Ada", "org.example.a", false);
  EXPECT_THAT(swage({"attempts", "list", "--store", store()}).out, testing::ContainsRegex("Ada +org.example.a +failed +- +0.3 s"));
}

TEST_F(Attempts, GoOutAndComeBack) {
  const std::string id = keep("Ada", "org.example.a");
  EXPECT_EQ(swage({"attempts", "export", "last", path("one.swage"), "--store", store()}).out,
            path("one.swage") + "\n");
  EXPECT_EQ(swage({"attempts", "export", id.substr(0, 12), path("two.swage"), "--store", store()}).code, 0);
  const Said back =
      swage({"attempts", "import", path("one.swage"), path("two.swage"), "--store", path("b.db"), "--json"});
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_EQ(back.json()[1]["attempt"], id);
  EXPECT_EQ(swage({"attempts", "list", "--store", path("b.db"), "--json"}).json().size(), 1u);
}

TEST_F(Attempts, SayWhatIsMissing) {
  const auto expect = [&](const std::vector<std::string>& arguments, const std::string& sentence) {
    const Said said = swage(arguments);
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr(sentence));
  };
  expect({"attempts", "list", "--store", store()},
         say::kNoStore(store()));
  EXPECT_FALSE(std::filesystem::exists(store())) << "looking makes no store";
  keep("Ada", "org.example.a");
  keep("Ada", "org.example.a");
  expect({"attempts", "export", "ffff", "--store", store()},
         say::kNoAttempt("ffff"));
  expect({"attempts", "export", "0", "--store", store()}, say::kManyAttempts("0", 2));
  expect({"attempts", "import", path("none.swage"), "--store", store()},
         "none.swage" + record::say::kUnreadable.words(1) + "No such file");
  expect({"replay", path("none.swage")}, say::kNoFile(path("none.swage")));
  expect({"replay", "last", "--store", path("none.db")}, say::kNoStore(path("none.db")));
}

TEST_F(Attempts, EscapeSequencesDoNotReachTheTerminal) {
  keep("Eve\x1b]0;owned\x07\xC2\x9B" "2J", "org.example.\x1b[31m");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"attempts", "list", "--store", store()},
        std::vector<std::string>{"attempts", "list", "--store", store(), "--json"},
        std::vector<std::string>{"attempts", "list", "--store", store(), "--person", "No\x1b[2Jbody"},
        std::vector<std::string>{"attempts", "import", path("no\x1b[2Jfile"), "--store", store()},
        std::vector<std::string>{"doctor", "--store", path("no\x1b[2Jstore")}}) {
    const Said said = swage(arguments);
    EXPECT_THAT(said.out + said.err, testing::Not(testing::AnyOf(HasSubstr("\x1b"), HasSubstr("\xC2\x9B"))))
        << arguments[1];
  }
}

TEST_F(Attempts, ADamagedStoreSaysSoAndIsSalvaged) {
  const std::string id = keep("Ada", "org.example.a");
  keep("Bo", "org.example.b");
  {
    // the page that lists the tables is whole, that of the attempts is not
    std::fstream file(store(), std::ios::in | std::ios::out | std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    file.clear();
    const auto page = static_cast<std::streamoff>(bytes.find("A lesson") / 4096 * 4096);
    file.seekp(page);
    file.write(std::string(8, '\x55').data(), 8);
  }
  const Said list = swage({"attempts", "list", "--store", store()});
  EXPECT_EQ(list.code, 2);
  EXPECT_THAT(list.out, testing::Not(HasSubstr("no attempts")));
  EXPECT_THAT(list.err, HasSubstr("swage attempts salvage --store " + store()));
  const Said doctor = swage({"doctor", "--store", store()});
  EXPECT_EQ(doctor.code, 2);
  EXPECT_THAT(doctor.out, testing::ContainsRegex("bad +store"));
  const Said salvage = swage({"attempts", "salvage", "--store", store()});
  EXPECT_EQ(salvage.code, 0) << salvage.err;
  EXPECT_THAT(salvage.out, HasSubstr("the store is " + store() + "\n"));
  EXPECT_THAT(salvage.out, HasSubstr("the damaged one lies in " + store() + ".damaged-"));
  EXPECT_EQ(swage({"attempts", "list", "--store", store()}).code, 0);
  EXPECT_EQ(swage({"doctor", "--store", store()}).code, 0);
}

TEST_F(Attempts, AnotherKindOfServerIsNoFile) {
  for (const char* verb : {"list", "import"}) {
    std::vector<std::string> arguments = {"attempts", verb, "--store", "mysql://ada:secret@host/swage"};
    if (verb == std::string("import")) arguments.push_back("one.swage");
    const Said said = swage(arguments);
    EXPECT_EQ(said.code, 2);
    EXPECT_THAT(said.err, HasSubstr(record::say::kNoStoreKind("mysql")));
    EXPECT_THAT(said.err, testing::Not(HasSubstr("secret")));
  }
}

TEST_F(Attempts, AUserWithoutAHomeIsToldAndTheRootOfTheDiskStaysAsItIs) {
  const bool before = std::filesystem::exists("/.local");
  unsetenv("HOME");
  unsetenv("XDG_DATA_HOME");
  const Said said = swage({"doctor", "--json"});
  setenv("HOME", folder().c_str(), 1);
  EXPECT_EQ(std::filesystem::exists("/.local"), before);
  EXPECT_THAT(said.out, testing::Not(HasSubstr("\"/.local")));
}

}  // namespace
}  // namespace swage::tools::test
