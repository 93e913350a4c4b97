// SPDX-License-Identifier: Apache-2.0
//
// A variant that adds and leaves out parts: the whole comes out, and each value is told where it is written.
#include "assembly/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../../temp_folder.hpp"
#include "assembly/lesson_text.hpp"
#include "assembly/sentences.hpp"
#include "host/nearest.hpp"

namespace swage::assembly {
namespace parts_test {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;

const std::string kWhole = R"({
  "format": "swage-lesson/1", "id": "a", "title": "A",
  "objects": [
    { "name": "needle", "plugin": "p.needle" },
    { "name": "tray", "plugin": "p.solids" },
    { "name": "pad", "plugin": "p.solids",
      "params": { "gap": "1 mm" } } ],
  "couplings": [
    { "plugin": "p.contact", "between": ["tray", "needle"] },
    { "plugin": "p.contact", "between": ["pad", "needle"] } ],
  "lesson": { "plugin": "p.lesson" }
})";

class Parts : public ::testing::Test {
 protected:
  Parts() { write("whole.json", kWhole); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  bool read(const std::string& more) {
    write("b.json", "{ \"format\": \"swage-lesson/1\", \"id\": \"b\", \"title\": \"B\", \"based_on\": \"whole.json\",\n" + more + "\n}");
    base::Problems problems;
    said_.clear();
    const bool good = read_lesson_text(folder_ / "b.json", {}, text_, problems);
    for (const base::Problem& p : problems) said_.push_back(near(p.where) + ": " + p.message);
    return good;
  }
  std::string near(std::string where) const { return where.erase(0, folder_.path().size() + 1); }
  std::string place(const std::string& pointer) const { return near(text_.places.where(pointer)); }
  std::vector<std::string> names(const char* list) const {
    std::vector<std::string> out;
    for (const Json& use : text_.json[list]) out.push_back(use.value("name", ""));
    return out;
  }

  test::TempFolder folder_;
  LessonText text_;
  std::vector<std::string> said_;
};

TEST_F(Parts, AreLeftOutAndOthersKeepNameAndPlace) {
  ASSERT_TRUE(read(R"("remove": ["tray", "contact"])")) << testing::PrintToString(said_);
  EXPECT_THAT(names("objects"), ElementsAre("needle", "pad"));
  EXPECT_THAT(names("couplings"), ElementsAre("contact_2")) << "a coupling keeps the number that it had among all";
  EXPECT_EQ(place("/objects/1/params/gap"), "whole.json:7 #/objects/2/params/gap");
  EXPECT_EQ(place("/couplings/0/between"), "whole.json:10 #/couplings/1/between");
  EXPECT_EQ(place("/objects/0/name"), "whole.json:4 #/objects/0/name");
  EXPECT_FALSE(text_.json.contains("remove"));
}

TEST_F(Parts, AreAddedBehindTheOthersAndToldWhereTheyAreWritten) {
  ASSERT_TRUE(read("\"set\": { \"ring.size\": \"2 mm\" },\n\"add\": {\n  \"objects\": [ { \"name\": \"ring\",\n    \"plugin\": \"p.solids\" } ],\n"
                   "  \"devices\": [ { \"name\": \"hand\", \"plugin\": \"p.mouse\" } ] }"))
      << testing::PrintToString(said_);
  EXPECT_THAT(names("objects"), ElementsAre("needle", "tray", "pad", "ring"));
  EXPECT_THAT(names("devices"), ElementsAre("hand")) << "a list that the base has not is made";
  EXPECT_EQ(text_.json["objects"][3]["params"]["size"], "2 mm");
  EXPECT_EQ(place("/objects/3/plugin"), "b.json:5 #/add/objects/0/plugin");
  EXPECT_EQ(place("/objects/3/params/size"), "b.json:2 #/set/ring.size");
  EXPECT_EQ(place("/devices/0/name"), "b.json:6 #/add/devices/0/name");
}

TEST_F(Parts, OneTakesThePlaceOfAnother) {
  ASSERT_TRUE(read(R"("add": { "objects": [ { "name": "tray", "plugin": "p.tissue" } ] }, "remove": ["tray"])"));
  EXPECT_THAT(names("objects"), ElementsAre("needle", "pad", "tray"));
  EXPECT_EQ(text_.json["objects"][2]["plugin"], "p.tissue");
}

TEST_F(Parts, WhatCannotBeIsSaid) {
  EXPECT_FALSE(read("\"remove\": [\"needle\",\n\"trai\"], \"add\": { \"lesson\": {} }"));
  EXPECT_THAT(said_, ElementsAre("b.json:3 #/remove/1: " + say::kNobodyToRemove("trai", host::did_you_mean("trai", {"tray"}), "tray, pad, contact, contact_2"),
                                 "b.json:3 #/add/lesson: " + say::kAddIsNoObject()));
  EXPECT_FALSE(read(R"("remove": "tray", "add": [])"));
  EXPECT_THAT(said_, ElementsAre("b.json:2 #/remove: " + say::kRemoveIsNoList(),
                                 "b.json:2 #/add: " + say::kAddIsNoObject()));
}

}  // namespace parts_test
}  // namespace swage::assembly
