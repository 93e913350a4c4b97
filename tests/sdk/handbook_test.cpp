// SPDX-License-Identifier: Apache-2.0
//
// The handbooks of instructor and trainee name controls as the window does: each text in bold is a source text of the
// translations, which are taken from the console's code, and in the German pages its translation.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>

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

/// A text of the translations as the window shows it: without the marks of its keys.
std::string shown(std::string text) {
  for (const auto& [code, sign] : {std::pair{"&quot;", "\""}, {"&apos;", "'"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
    text = replaced(text, code, sign);
  return replaced(text, "&", "");
}

/// Texts of the window in English, each with all that it is called in German.
std::map<std::string, std::set<std::string>> window_texts() {
  std::map<std::string, std::set<std::string>> out;
  for (const std::string& message : between(read(kRoot / "console/translations/swage_de.ts"), "<message", "</message>")) {
    const std::set<std::string> source = between(message, "<source>", "</source>");
    if (source.size() != 1) continue;
    std::set<std::string>& german = out[shown(*source.begin())];
    for (const std::string& words : between(message, "<translation>", "</translation>")) german.insert(shown(words));
  }
  return out;
}

/// Names of controls in a page.
std::set<std::string> named_in(const std::string& page, const std::string& in_bold) {
  std::set<std::string> out = between(read(kRoot / "resources/handbook" / page), "**", "**");
  out.erase(in_bold);
  return out;
}

TEST(Handbook, NamesControlsAsTheWindowDoes) {
  const auto texts = window_texts();
  ASSERT_GT(texts.size(), 500u);
  for (const char* name : {"instructor", "trainee"}) {
    const std::set<std::string> named = named_in(std::string(name) + ".md", "in bold");
    EXPECT_GT(named.size(), 10u) << name;
    for (const std::string& control : named) EXPECT_TRUE(texts.contains(control)) << name << ": " << control;
  }
}

// the German page names the same controls, by their German words, and nothing else
TEST(Handbook, NamesTheSameControlsInGerman) {
  const auto texts = window_texts();
  for (const char* name : {"instructor", "trainee"}) {
    const std::set<std::string> german = named_in(std::string(name) + ".de.md", "fett");
    std::set<std::string> known;
    for (const std::string& control : named_in(std::string(name) + ".md", "in bold")) {
      const auto words = texts.find(control);
      if (words == texts.end()) continue;  // told by the test above
      const bool there = std::any_of(words->second.begin(), words->second.end(), [&](const std::string& w) { return german.contains(w); });
      EXPECT_TRUE(there) << name << ".de.md does not name " << control;
      known.insert(words->second.begin(), words->second.end());
    }
    for (const std::string& control : german) EXPECT_TRUE(known.contains(control)) << name << ".de.md: " << control << " is not in the English page";
  }
}

/// Lines that begin with `#`, list items, and what is given as code, of which both languages have the same.
TEST(Handbook, IsTheSameInBothLanguages) {
  for (const char* name : {"instructor", "trainee"}) {
    const std::string english = read(kRoot / "resources/handbook" / (std::string(name) + ".md"));
    const std::string german = read(kRoot / "resources/handbook" / (std::string(name) + ".de.md"));
    for (const char* begin : {"\n## ", "\n- ", "\n1. ", "\n2. ", "\n3. ", "\n4. "}) {
      const auto count = [begin](const std::string& page) {
        int n = 0;
        for (size_t at = 0; (at = page.find(begin, at)) != std::string::npos; ++at) ++n;
        return n;
      };
      EXPECT_EQ(count(german), count(english)) << name << ":" << begin;
    }
    EXPECT_EQ(between(german, "```json\n", "```"), between(english, "```json\n", "```")) << name;
    std::set<std::string> commands = between(replaced(german, "```", ""), "`", "`");
    for (const std::string& command : between(replaced(english, "```", ""), "`", "`"))
      EXPECT_TRUE(commands.contains(command)) << name << ".de.md lacks " << command;
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
