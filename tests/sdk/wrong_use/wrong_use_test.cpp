// SPDX-License-Identifier: Apache-2.0
//
// Each fixture of this folder makes the mistake it is named after and must not compile, for the reason it expects; the one
// that makes none must.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "test_places.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = SWAGE_SOURCE_DIR "/tests/sdk/wrong_use";

struct Compiled {
  bool ok = false;
  std::string words;
};

Compiled compile(const fs::path& file, const std::string& flags) {
  const std::string command =
      std::string(SWAGE_COMPILER) + " -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I" +
      SWAGE_SOURCE_DIR "/framework/sdk/include " + flags + " '" + file.string() + "' 2>&1";
  Compiled result;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> part;
  for (size_t n = 0; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) result.words.append(part.data(), n);
  result.ok = pclose(pipe) == 0;
  return result;
}

/// What follows `key` on a comment line of the fixture.
std::string asked_for(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("// " + key + ": ")) return line.substr(key.size() + 5);
  return "";
}

bool says_one_of(const std::string& words, const std::string& choices) {
  size_t from = 0;
  while (true) {
    const size_t bar = choices.find('|', from);
    if (words.find(choices.substr(from, bar - from)) != std::string::npos) return true;
    if (bar == std::string::npos) return false;
    from = bar + 1;
  }
}

class WrongUse : public testing::TestWithParam<std::string> {};

TEST_P(WrongUse, does_not_compile_for_the_expected_reason) {
  const fs::path file = kFolder / (GetParam() + ".cpp");
  const std::string expected = asked_for(file, "expect");
  ASSERT_NE(expected, "") << file << " does not say what it expects";
  const Compiled result = compile(file, asked_for(file, "flags"));
  EXPECT_FALSE(result.ok) << file << " compiles";
  EXPECT_TRUE(says_one_of(result.words, expected)) << "expected: " << expected << "\n" << result.words;
}

std::vector<std::string> mistakes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".cpp" && name != "right_use" && name != "wrong_use_test")
      names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Fixtures, WrongUse, testing::ValuesIn(mistakes()),
                         [](const auto& mistake) { return mistake.param; });

TEST(RightUse, compiles) {
  const Compiled result = compile(kFolder / "right_use.cpp", "");
  EXPECT_TRUE(result.ok) << result.words;
}

}  // namespace
