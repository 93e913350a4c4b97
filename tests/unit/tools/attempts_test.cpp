// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "program.hpp"
#include "record/recorder.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;

class Attempts : public Program {
 protected:
  std::string keep(const std::string& person, const std::string& lesson) const {
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
    end.outcome = judge::Outcome::kPassed;
    end.reason = "grasp.held";
    end.score = 91;
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
  EXPECT_THAT(nobody.err, HasSubstr("Nobody in the store is called \"Adda\"."));
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
         "There is no store " + store() + ": no attempt has been kept there yet.");
  EXPECT_FALSE(std::filesystem::exists(store())) << "looking makes no store";
  keep("Ada", "org.example.a");
  keep("Ada", "org.example.a");
  expect({"attempts", "export", "ffff", "--store", store()},
         "There is no attempt \"ffff\". \"swage attempts list\" shows them.");
  expect({"attempts", "export", "0", "--store", store()}, "\"0\" may be 2 attempts: give more of the id.");
  expect({"attempts", "import", path("none.swage"), "--store", store()},
         "none.swage cannot be read: No such file");
  expect({"replay", path("none.swage")}, "There is no file " + path("none.swage"));
  expect({"replay", "last", "--store", path("none.db")}, "There is no store");
}

}  // namespace
}  // namespace swage::tools::test
