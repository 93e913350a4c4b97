// SPDX-License-Identifier: Apache-2.0
//
// What the files of the series say, without running them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "test_places.hpp"

namespace swage::stage {
namespace {

/// Every lesson of the series with its path.
std::vector<std::pair<std::string, nlohmann::json>> all() {
  std::vector<std::pair<std::string, nlohmann::json>> lessons;
  for (const auto& entry : std::filesystem::directory_iterator(SWAGE_SOURCE_DIR "/lessons/series")) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream in(entry.path());
    lessons.emplace_back(entry.path(), nlohmann::json::parse(in));
  }
  return lessons;
}

// red and green are the same to some, and another theme has other colours: a text names none
TEST(SeriesTexts, NameNoColour) {
  const std::regex colour(R"(\b(red|green|blue|yellow|pink|white|black|orange)\b)", std::regex::icase);
  for (const auto& [path, lesson] : all()) {
    for (const char* key : {"title", "summary", "goal"})
      EXPECT_FALSE(std::regex_search(lesson.value(key, std::string()), colour)) << path << " " << key;
  }
}

// 5 mm in a lesson are 5 mm in those that are based on it, and the file says of what
TEST(SeriesTexts, MeasureNeedlesAsTheLessonTheyAreBasedOn) {
  int needles = 0, variants = 0;
  for (const auto& [path, lesson] : all()) {
    const auto set = lesson.value("set", nlohmann::json::object());
    EXPECT_FALSE(set.contains("needle.size_of") || set.contains("needle.size")) << path;
    variants += set.contains("needle.arc") ? 1 : 0;
    for (const auto& object : lesson.value("objects", nlohmann::json::array())) {
      if (object["plugin"] != "swage.object.needle" || !object["params"].contains("size")) continue;
      EXPECT_TRUE(object["params"].contains("size_of")) << path;
      ++needles;
    }
  }
  EXPECT_GT(needles, 5);
  EXPECT_GT(variants, 5);
}

}  // namespace
}  // namespace swage::stage
