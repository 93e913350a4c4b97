// SPDX-License-Identifier: Apache-2.0
//
// A lesson that is another with values of its own comes out whole; what leads nowhere is said where it is written.
#include "assembly/lesson_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../../temp_folder.hpp"
#include "assembly/lesson_file.hpp"

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
              ElementsAre("b.json:3 #/based_on: There is no lesson file \"none.json\" to be based on."));
  EXPECT_EQ(text_.text, "");

  write("b.json", variant("c.json", R"("seed": 9)"));
  write("c.json", variant("b.json", R"("seed": 9)"));
  EXPECT_FALSE(read("b.json"));
  EXPECT_THAT(said_, ElementsAre("c.json:3 #/based_on: It is based on itself, by way of \"b.json\"."));

  write("b.json", variant("c.json", R"("seed": 9)"));
  write("c.json", "{ \"a\" 1 }");
  EXPECT_FALSE(read("b.json"));
  EXPECT_THAT(said_, ElementsAre(HasSubstr("c.json:1: This is not valid JSON")));

  EXPECT_FALSE(read("none.json"));
  EXPECT_THAT(said_, ElementsAre("none.json: There is no such lesson file."));
}

TEST_F(LessonTexts, WhatCannotBeSetIsSaidAllInOneGo) {
  write("b.json",
        variant("series/whole.json", "\"objects\": [],\n\"set\": {\n\"needel.arc\": 1,\n\"arc\": 1 }"));
  EXPECT_FALSE(read("b.json"));
  ASSERT_EQ(said_.size(), 3u);
  EXPECT_THAT(said_[0],
              HasSubstr("b.json:4 #/objects: \"objects\" is what it has from the lesson it is based on."));
  EXPECT_EQ(said_[1],
            "b.json:6 #/set/needel.arc: There is no \"needel\" to set \"needel.arc\". Did you mean "
            "\"needle\"? There is: "
            "needle, lesson.");
  EXPECT_THAT(said_[2], HasSubstr("b.json:7 #/set/arc: \"arc\" is no value of a part"));

  write("b.json", R"({ "format": "swage-lesson/1", "based_on": "series/whole.json", "set": [] })");
  EXPECT_FALSE(read("b.json"));
  EXPECT_EQ(said_.size(), 3u) << "no id, no title, no object of settings";
}

TEST_F(LessonTexts, AnEndlessChainEnds) {
  for (int i = 0; i < 10; ++i)
    write(std::to_string(i) + ".json", variant(std::to_string(i + 1) + ".json", R"("seed": 9)"));
  write("10.json", kWhole);
  EXPECT_FALSE(read("0.json"));
  EXPECT_THAT(said_, ElementsAre(HasSubstr("More than eight lessons are based on one another.")));
  EXPECT_TRUE(read("3.json"));
}

TEST_F(LessonTexts, NothingCanBeSetInWhatIsNoLesson) {
  write("list.json", "[]");
  EXPECT_FALSE(read("list.json", {{"seed", "1"}}));
  EXPECT_THAT(said_, ElementsAre("list.json: It is not a JSON object, so nothing can be set in it."));
}

}  // namespace
}  // namespace swage::assembly
