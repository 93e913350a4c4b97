// SPDX-License-Identifier: Apache-2.0
//
// Every lesson file below good/ assembles without a word; every one below faulty/ gives exactly the sentences
// beside it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../catalogue.hpp"
#include "assembly/assemble.hpp"
#include "test_places.hpp"

using namespace swage;
namespace fs = std::filesystem;

namespace {

const fs::path kHere = fs::path(SWAGE_SOURCE_DIR) / "tests/descriptors";
const std::string kPlugins = SWAGE_BINARY_DIR "/plugins";

const host::Catalogue& catalogue() {
  static const host::Catalogue& found = test::make_catalogue(kPlugins);
  return found;
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<fs::path> files(const char* folder) {
  std::vector<fs::path> list;
  for (const auto& entry : fs::directory_iterator(kHere / folder))
    if (entry.path().extension() == ".json") list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// what a person is told, one line per problem, without the paths of this machine
std::string told(const fs::path& file, const std::string& device) {
  base::Problems problems;
  assembly::LessonFile lesson;
  const bool whole = assembly::read_lesson_file(file.string(), lesson, problems);
  EXPECT_EQ(whole, !base::failed(problems));
  const bool made = assembly::assemble(lesson, catalogue(), {device, ""}, problems) != nullptr;
  EXPECT_EQ(made, !base::failed(problems)) << "a scene or an error, never both or neither";
  std::string text;
  for (const base::Problem& p : problems) {
    const char* const severity[] = {"note ", "warning ", ""};
    text += severity[static_cast<int>(p.severity)] + p.where + ": " + p.message + "\n";
  }
  replace(text, file.parent_path().string() + "/", "");
  replace(text, kPlugins, "<plugins>");
  replace(text, "(" + std::to_string(catalogue().plugins().size()) + " plugins)", "(n plugins)");
  return text;
}

}  // namespace

TEST(Descriptors, GoodOnesAssembleWithoutAWord) {
  for (const fs::path& file : files("good"))
    for (const char* device : {"", "expert"})
      EXPECT_EQ(told(file, device), "") << file.filename() << " " << device;
}

TEST(Descriptors, FaultyOnesGiveTheirSentences) {
  const auto faulty = files("faulty");
  EXPECT_GE(faulty.size(), 10u);
  for (const fs::path& file : faulty) {
    const fs::path expected = fs::path(file).replace_extension(".txt");
    const std::string said = told(file, "expert");
    EXPECT_FALSE(said.empty()) << file.filename();
    EXPECT_EQ(said, read(expected)) << file.filename();
    // for authors of new faults: what was said, to be read and then kept beside the file
    if (const char* folder = std::getenv("SWAGE_DESCRIPTORS_OUT"))
      std::ofstream(fs::path(folder) / expected.filename()) << said;
  }
}
