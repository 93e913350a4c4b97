// SPDX-License-Identifier: Apache-2.0
//
// A lesson that is another with values of its own comes out whole; what leads nowhere is said where it is written.
#include "assembly/lesson_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "../../temp_folder.hpp"
#include "assembly/lesson_file.hpp"
#include "assembly/sentences.hpp"
#include "host/nearest.hpp"
#include "toolkit/sentences.hpp"

namespace swage::assembly {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kWhole = R"({
  "format": "swage-lesson/1", "id": "a", "title": "A", "summary": "S", "seed": 1,
  "objects": [ { "name": "needle", "plugin": "p.needle", "params": { "arc": "3/8", "size": "5 mm" } } ],
  "lesson": { "plugin": "p.lesson" }
})";

class LessonTexts : public ::testing::Test {
 protected:
  LessonTexts() { write("series/whole.json", kWhole); }

  void write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::string variant(const std::string& based_on, const std::string& more, const std::string& id = "b") {
    return R"({
"format": "swage-lesson/1", "id": ")" +
           id + R"(", "title": "B",
"based_on": ")" +
           based_on + "\",\n" + more + "}";
  }
  bool read(const std::string& name, const std::vector<Setting>& settings = {}) {
    base::Problems problems;
    said_.clear();
    const bool good = read_lesson_text(folder_ / name, settings, text_, problems);
    for (const base::Problem& p : problems) said_.push_back(p.where + ": " + p.message);
    for (std::string& s : said_)
      for (std::size_t at; (at = s.find(folder_.path() + "/")) != std::string::npos;)
        s.erase(at, folder_.path().size() + 1);
    return good;
  }
  Json json() const { return Json::parse(text_.text); }

  test::TempFolder folder_;
  LessonText text_;
  std::vector<std::string> said_;
};

TEST_F(LessonTexts, AWholeLessonStaysAsItIsByteForByte) {
  ASSERT_TRUE(read("series/whole.json"));
  EXPECT_EQ(text_.text, kWhole);
  EXPECT_FALSE(text_.made);
}

TEST_F(LessonTexts, SettingsComeFromOutside) {
  ASSERT_TRUE(read("series/whole.json", {{"needle.arc", "4/8"}, {"seed", "7"}}));
  EXPECT_TRUE(text_.made);
  EXPECT_EQ(json()["objects"][0]["params"]["arc"], "4/8");
  EXPECT_EQ(json()["seed"], 7);
}

TEST_F(LessonTexts, AVariantIsItsBaseWithValuesOfItsOwn) {
  write("mine/b.json",
        variant("../series/whole.json", R"("seed": 9, "set": { "needle.arc": "2/8", "lesson.drive": 0.4 })"));
  ASSERT_TRUE(read("mine/b.json")) << testing::PrintToString(said_);
  EXPECT_TRUE(text_.made);
  const Json lesson = json();
  EXPECT_EQ(lesson["id"], "b");
  EXPECT_EQ(lesson["title"], "B");
  EXPECT_EQ(lesson["summary"], "S") << "what it does not say it has from its base";
  EXPECT_EQ(lesson["seed"], 9);
  EXPECT_EQ(lesson["objects"][0]["params"], Json({{"arc", "2/8"}, {"size", "5 mm"}}));
  EXPECT_EQ(lesson["lesson"]["params"]["drive"], 0.4);
  EXPECT_FALSE(lesson.contains("based_on") || lesson.contains("set"));
}

TEST_F(LessonTexts, FilesAreLookedUpBesideTheLessonThatNamesThem) {
  write("mine/b.json", variant("../series/whole.json", R"("seed": 9)"));
  LessonFile file;
  base::Problems problems;
  ASSERT_TRUE(read_lesson_file(folder_ / "mine/b.json", file, problems));
  EXPECT_EQ(file.path, folder_ / "mine/b.json");
  EXPECT_TRUE(std::filesystem::equivalent(file.folder(), folder_ / "series"));
}

TEST_F(LessonTexts, VariantsOfVariantsTheNearestHasTheLastWord) {
  write("b.json", variant("series/whole.json",
                          R"("goal": "G", "set": { "needle.arc": "2/8", "needle.size": "4 mm" })"));
  write("c.json", variant("b.json", R"("set": { "needle.size": "3 mm" })", "c"));
  ASSERT_TRUE(read("c.json", {{"needle.wire", "1"}})) << testing::PrintToString(said_);
  EXPECT_EQ(json()["id"], "c");
  EXPECT_EQ(json()["goal"], "G");
  EXPECT_EQ(json()["objects"][0]["params"], Json({{"arc", "2/8"}, {"size", "3 mm"}, {"wire", 1}}));
}

TEST_F(LessonTexts, WhatLeadsNowhereIsSaidWhereItIsWritten) {
  write("b.json", variant("none.json", R"("seed": 9)"));
  EXPECT_FALSE(read("b.json"));
  EXPECT_THAT(said_,
              ElementsAre("b.json:3 #/based_on: " + say::kNoBase("none.json")));
  EXPECT_EQ(text_.text, "");

  write("b.json", variant("c.json", R"("seed": 9)"));
  write("c.json", variant("b.json", R"("seed": 9)"));
  EXPECT_FALSE(read("b.json"));
  EXPECT_THAT(said_, ElementsAre("c.json:3 #/based_on: " + say::kBaseIsItself("b.json")));

  write("b.json", variant("c.json", R"("seed": 9)"));
  write("c.json", "{ \"a\" 1 }");
  EXPECT_FALSE(read("b.json"));
  EXPECT_THAT(said_, ElementsAre("c.json:1: " + say::kNotJson(7)));

  EXPECT_FALSE(read("none.json"));
  EXPECT_THAT(said_, ElementsAre("none.json: " + say::kNoFile()));
}

TEST_F(LessonTexts, WhatCannotBeSetIsSaidAllInOneGo) {
  write("b.json",
        variant("series/whole.json", "\"objects\": [],\n\"set\": {\n\"needel.arc\": 1,\n\"arc\": 1 }"));
  EXPECT_FALSE(read("b.json"));
  ASSERT_EQ(said_.size(), 3u);
  EXPECT_EQ(said_[0],
              "b.json:4 #/objects: " + say::kFromBase("objects"));
  EXPECT_EQ(said_[1],
            "b.json:6 #/set/needel.arc: " + say::kNobodyToSet("needel", "needel.arc", host::did_you_mean("needel", {"needle"}), "needle, lesson"));
  EXPECT_EQ(said_[2], "b.json:7 #/set/arc: " + say::kNoPart("arc"));

  write("b.json", R"({ "format": "swage-lesson/1", "based_on": "series/whole.json", "set": [] })");
  EXPECT_FALSE(read("b.json"));
  EXPECT_EQ(said_.size(), 3u) << "no id, no title, no object of settings";
}

TEST_F(LessonTexts, AnEmptyFileIsNoLesson) {
  for (const char* text : {"", " \n\t"}) {
    write("empty.json", text);
    EXPECT_FALSE(read("empty.json"));
    EXPECT_THAT(said_, ElementsAre(HasSubstr("empty.json: " + say::kEmpty())));
    LessonFile file;
    base::Problems problems;
    EXPECT_FALSE(read_lesson_file(folder_ / "empty.json", file, problems));
    EXPECT_EQ(problems.size(), 1u);
  }
}

TEST_F(LessonTexts, ABaseThatIsNoFileIsRefused) {
  std::filesystem::create_symlink("loop.json", folder_ / "loop.json");
  ASSERT_EQ(mkfifo((folder_ / "pipe.json").c_str(), 0600), 0);
  std::filesystem::create_directory(folder_ / "folder.json");
  std::ofstream(folder_ / "huge.json").close();
  std::filesystem::resize_file(folder_ / "huge.json", std::uintmax_t{8} << 30);
  const std::pair<std::string, std::string> bases[] = {
      {"loop.json", std::strerror(ELOOP)},
      {"pipe.json", toolkit::say::kPipe()},
      {"folder.json", toolkit::say::kFolder()},
      {"huge.json", toolkit::say::kTooLarge("4 MiB")},
      {std::string(300, 'a') + ".json", "File name too long."}};
  for (const auto& [base, why] : bases) {
    write("b.json", variant(base, R"("seed": 9)"));
    EXPECT_FALSE(read("b.json"));
    EXPECT_THAT(said_, ElementsAre(testing::AllOf(HasSubstr("b.json:3 #/based_on: "), HasSubstr(why))));
    EXPECT_FALSE(read(base)) << base;
    EXPECT_THAT(said_, ElementsAre(HasSubstr(why)));
  }
}

// what is wrong is told where it is written: in the variant what the variant says, in its base what that says
TEST_F(LessonTexts, AVariantKeepsFilesAndLines) {
  write("b.json", variant("series/whole.json",
                          "\"seed\": -1,\n\"cues\": [\"smell\"],\n\"set\": { \"needle.arc\": \"2/8\",\n\"needle.size\": \"4 mm\" }"));
  write("c.json", variant("b.json", "\"set\": {\n\"needle.size\": \"3 mm\" }", "c"));
  LessonFile file;
  base::Problems problems;
  EXPECT_FALSE(read_lesson_file(folder_ / "c.json", {{{"needle.wire", "1"}}}, file, problems));
  const std::string f = folder_.path() + "/";
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].where, f + "b.json:4 #/seed");
  EXPECT_EQ(problems[1].where, f + "b.json:5 #/cues");
  EXPECT_EQ(file.where("/objects/0/params/arc"), f + "b.json:6 #/set/needle.arc");
  EXPECT_EQ(file.where("/objects/0/params/size/0"), f + "c.json:5 #/set/needle.size");
  EXPECT_EQ(file.where("/objects/0/params/wire"), f + "c.json #/objects/0/params/wire");
  EXPECT_EQ(file.where("/objects/0/plugin"), f + "series/whole.json:3 #/objects/0/plugin");
  EXPECT_EQ(file.where("/title"), f + "c.json:2 #/title");
  EXPECT_EQ(file.where(""), f + "c.json");
}

TEST_F(LessonTexts, TextsForATerminalOrWithoutAnEndAreRefused) {
  LessonText out;
  base::Problems problems;
  EXPECT_FALSE(parse_lesson_text(R"({ "title": "a\u001b[31mb", "x-\u009b": 1 })", "l", out, problems));
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].where, "l:1 #/title");
  EXPECT_EQ(problems[0].message, say::kControl("a\\x1b[31mb"));
  problems.clear();
  EXPECT_TRUE(parse_lesson_text(R"({ "title": "two\nlines \u00e9" })", "l", out, problems));
  EXPECT_FALSE(parse_lesson_text("{ \"title\": \"" + std::string(10'001, 'a') + "\" }", "l", out, problems));
  EXPECT_EQ(problems.back().message, say::kLongText());
}

TEST_F(LessonTexts, AnEndlessChainEnds) {
  for (int i = 0; i < 10; ++i)
    write(std::to_string(i) + ".json", variant(std::to_string(i + 1) + ".json", R"("seed": 9)"));
  write("10.json", kWhole);
  EXPECT_FALSE(read("0.json"));
  EXPECT_THAT(said_, ElementsAre(HasSubstr(say::kTooManyBases())));
  EXPECT_TRUE(read("3.json"));
}

TEST_F(LessonTexts, NothingCanBeSetInWhatIsNoLesson) {
  write("list.json", "[]");
  EXPECT_FALSE(read("list.json", {{"seed", "1"}}));
  EXPECT_THAT(said_, ElementsAre("list.json: " + say::kNothingToSetIn()));
}

}  // namespace
}  // namespace swage::assembly
