// SPDX-License-Identifier: Apache-2.0
//
// A decimal comma changes nothing: not where the whole process has it, as the window does, not where a plugin sets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <locale>

#include "../unit/tools/program.hpp"
#include "session/session.hpp"
#include "test_places.hpp"

using namespace swage;
namespace fs = std::filesystem;

namespace {

const std::string kSeries = SWAGE_SOURCE_DIR "/lessons/series/";

std::string told(const base::Problems& problems) {
  std::string out;
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError) out += p.where + ": " + p.message + "\n";
  return out;
}

uint64_t hash_of(const std::string& lesson) {
  session::Options options;
  options.lesson_path = kSeries + lesson;
  options.device = "expert";
  options.store_path = ":none:";
  options.pace = session::Pace::kFastest;
  options.max_time_s = 1;
  base::Problems problems;
  const auto session = session::Session::open(options, problems);
  EXPECT_NE(session, nullptr) << told(problems);
  if (!session) return 0;
  session->start();
  session->wait();
  return session->result().hash;
}

}  // namespace

TEST(Locale, TheOneOfTheTestHasAComma) {
  ASSERT_NE(std::setlocale(LC_ALL, ""), nullptr) << "LC_ALL and LOCPATH name the tests' own; see CMakeLists.txt";
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", 0.5);
  EXPECT_STREQ(text, "0,5");
  EXPECT_EQ(std::strtod("3.4", nullptr), 3);
}

TEST(Locale, EveryHandOfEveryLessonIsReadAndMovesTheSame) {
  std::setlocale(LC_ALL, "C");
  std::vector<fs::path> lessons;
  for (const auto& entry : fs::directory_iterator(kSeries))
    if (entry.is_regular_file()) lessons.push_back(entry.path().filename());
  std::sort(lessons.begin(), lessons.end());
  ASSERT_GT(lessons.size(), 10u);
  for (const fs::path& lesson : lessons) {
    std::setlocale(LC_ALL, "C");
    const uint64_t plain = hash_of(lesson);
    ASSERT_NE(std::setlocale(LC_ALL, ""), nullptr);
    std::locale::global(std::locale(""));
    EXPECT_EQ(hash_of(lesson), plain) << lesson;
    std::locale::global(std::locale::classic());
  }
}

class LocaleProgram : public tools::test::Program {
 protected:
  static tools::test::Said in(const char* language, const std::vector<std::string>& arguments) {
    setenv("LC_ALL", language, 1);
    return tools::test::swage(arguments);
  }
};

TEST_F(LocaleProgram, SaysTheSameInEveryLanguage) {
  const std::vector<std::string> run = {"run", kSeries + "020_grasp_basic.json", "--headless", "--as-fast-as-possible",
                                        "--device", "expert", "--store", ":none:", "--max-time", "0.5"};
  std::vector<std::string> json = run;
  json.push_back("--json");
  const auto metrics = [](const tools::test::Said& said) { return said.json()["metrics"].dump(); };
  EXPECT_EQ(metrics(in("de_DE.UTF-8", json)), metrics(in("C", json)));
  const std::string out = in("de_DE.UTF-8", run).out;
  EXPECT_THAT(out, testing::HasSubstr("after 0.500 s"));
}

TEST_F(LocaleProgram, APluginThatSetsItIsRefusedAndChangesNothing) {
  write("lesson.json", R"({ "format": "swage-lesson/1", "id": "test.locale", "title": "Locale", "scene_length": "2.5 mm",
    "devices": [ { "name": "hand", "as": "expert", "plugin": "swage.device.scripted", "params": { "file": ")" SWAGE_SOURCE_DIR
                       R"(/lessons/hands/020_expert.json", "tremor": "0.5 um" } } ],
    "objects": [ { "name": "pebble", "plugin": "org.example.sets_locale", "pose": { "p": ["0.5 mm", 0, 0.25] } } ],
    "lesson": { "plugin": "swage.lesson.look" } })");
  const tools::test::Said said =
      in("de_DE.UTF-8", {"run", path("lesson.json"), "--headless", "--as-fast-as-possible", "--store", ":none:", "--max-time",
                         "0.25", "--plugin-dir", SWAGE_BINARY_DIR "/tests/locale_plugins"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, testing::HasSubstr("changes the language of the program (setlocale)"));
  EXPECT_THAT(said.err, testing::Not(testing::ContainsRegex("[0-9],[0-9]")));
}
