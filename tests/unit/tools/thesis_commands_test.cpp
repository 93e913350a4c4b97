// SPDX-License-Identifier: Apache-2.0
//
// The commands that lessons/thesis.md prints can be typed as they stand: files, hands, parameters and options exist.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "program.hpp"
#include "test_places.hpp"

namespace swage::tools::test {
namespace {

class ThesisCommands : public Program {
 protected:
  /// What stands in backquotes and begins with `begin`, with $L as the folder of the lessons, word by word.
  static std::vector<std::vector<std::string>> commands(const std::string& page, const std::string& begin) {
    std::vector<std::vector<std::string>> out;
    const std::regex quoted("`([^`]+)`");
    for (auto it = std::sregex_iterator(page.begin(), page.end(), quoted); it != std::sregex_iterator(); ++it) {
      if (!(*it)[1].str().starts_with(begin)) continue;
      const std::string text = std::regex_replace((*it)[1].str(), std::regex("\\$L"), source("lessons"));
      std::istringstream in(text);
      out.emplace_back();
      for (std::string word; in >> word;) out.back().push_back(word);
      out.back().erase(out.back().begin());  // "swage"
    }
    return out;
  }
};

TEST_F(ThesisCommands, RunAsTheyStand) {
  std::ifstream in(source("lessons/thesis.md"));
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const auto runs = commands(page, "swage run ");
  EXPECT_GE(runs.size(), 8u);
  for (std::vector<std::string> words : runs) {
    std::string typed;
    for (const std::string& w : words) typed += " " + w;
    for (const char* more : {"--headless", "--as-fast-as-possible", "--store", ":none:", "--max-time", "0.02"})
      if (std::find(words.begin(), words.end(), more) == words.end()) words.emplace_back(more);
    const Said said = swage(words);
    EXPECT_NE(said.code, 2) << typed << "\n" << said.err;  // 0 passed, 1 not passed: it ran
  }
  for (const char* verb : {"swage study ", "swage audit "}) {
    const auto others = commands(page, verb);
    EXPECT_GE(others.size(), 2u) << verb;
    for (const auto& words : others) EXPECT_TRUE(std::filesystem::exists(words.at(1))) << verb << words.at(1);
  }
}

TEST_F(ThesisCommands, AWrongOneIsFound) {
  const auto wrong = commands("type `swage run $L/series/110_insertion.json --set tissue.from=cylinder`", "swage run ");
  ASSERT_EQ(wrong.size(), 1u);
  std::vector<std::string> words = wrong[0];
  for (const char* more : {"--headless", "--store", ":none:"}) words.emplace_back(more);
  EXPECT_EQ(swage(words).code, 2);
}

}  // namespace
}  // namespace swage::tools::test
