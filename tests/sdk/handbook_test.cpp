// SPDX-License-Identifier: Apache-2.0
//
// The handbooks of instructor and trainee name controls as the window does: each text in bold is a source text of the
// translations, which are taken from the console's code.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "host/rating_scales.hpp"
#include "test_places.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = SWAGE_SOURCE_DIR;

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

/// What stands between two marks, wherever a pair of them is.
std::set<std::string> between(const std::string& text, const std::string& open, const std::string& close) {
  std::set<std::string> out;
  for (size_t at = 0; (at = text.find(open, at)) != std::string::npos;) {
    const size_t from = at + open.size(), end = text.find(close, from);
    if (end == std::string::npos) break;
    out.insert(text.substr(from, end - from));
    at = end + close.size();
  }
  return out;
}

/// Texts of the window, without the marks of their keys.
std::set<std::string> window_texts() {
  std::set<std::string> out;
  for (std::string text : between(read(kRoot / "console/translations/swage_de.ts"), "<source>", "</source>")) {
    for (const auto& [code, sign] : {std::pair{"&quot;", "\""}, {"&apos;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
      text = replaced(text, code, sign);
    out.insert(replaced(text, "&", ""));
  }
  return out;
}

TEST(Handbook, NamesControlsAsTheWindowDoes) {
  const std::set<std::string> texts = window_texts();
  ASSERT_GT(texts.size(), 500u);
  for (const char* name : {"instructor.md", "trainee.md"}) {
    const std::string page = read(kRoot / "resources/handbook" / name);
    std::set<std::string> named = between(page, "**", "**");
    EXPECT_GT(named.size(), 10u) << name;
    named.erase("in bold");
    for (const std::string& control : named) EXPECT_TRUE(texts.contains(control)) << name << ": " << control;
  }
}

TEST(Handbook, ItsScaleIsOne) {
  const std::set<std::string> blocks = between(read(kRoot / "resources/handbook/instructor.md"), "```json\n", "```");
  ASSERT_EQ(blocks.size(), 1u);
  swage::judge::RatingScale scale;
  std::string error;
  EXPECT_TRUE(swage::host::read_rating_scale(*blocks.begin(), scale, error)) << error;
}

}  // namespace
