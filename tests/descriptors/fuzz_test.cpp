// SPDX-License-Identifier: Apache-2.0
//
// Lesson files with seeded damage: never a crash, always a scene or a sentence.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../catalogue.hpp"
#include "assembly/assemble.hpp"
#include "base/rng.hpp"
#include "test_places.hpp"

using namespace swage;

namespace fuzz_test {

using Random = base::Xoshiro256;

std::string read(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(SWAGE_SOURCE_DIR "/tests/descriptors/good/" + name).rdbuf();
  return text.str();
}

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

// what people and programs write into such files by mistake
constexpr const char* kPieces[] = {"{}",
                                   "[]",
                                   "null",
                                   "true",
                                   "-1",
                                   "1e308",
                                   "1e999",
                                   "0",
                                   "\"\"",
                                   "NaN",
                                   "\"m\"",
                                   "\"1 N\"",
                                   "[[[[[",
                                   "}}}}}",
                                   "\\",
                                   "\"",
                                   "\xFF\xFE",
                                   ",",
                                   ":",
                                   "\n",
                                   "\"name\"",
                                   "\"plugin\"",
                                   "99999999999999999999",
                                   "\"\\u0000\"",
                                   "\"needle\"",
                                   "\"1e308 mm\"",
                                   "-0.0",
                                   "[0, 0, 0]"};

void damage(std::string& text, Random& random) {
  const std::size_t at = below(random, text.size() + 1);
  const std::size_t length = below(random, 12);
  switch (below(random, 6)) {
    case 0:  // a letter
      if (at < text.size()) text[at] = static_cast<char>(random() & 0xFF);
      break;
    case 1:  // something is lost
      if (at < text.size()) text.erase(at, length);
      break;
    case 2:  // something is there twice
      text.insert(at, text.substr(std::min(text.size(), below(random, text.size() + 1)), 5 * length));
      break;
    case 3:  // the rest is lost
      if (below(random, 10) == 0) text.resize(at);
      break;
    default: {  // a value becomes another: from one colon or comma to the next comma or bracket
      const std::size_t begin = text.find_first_of(":,[", at);
      const std::size_t end = begin == std::string::npos ? begin : text.find_first_of(",]}", begin + 1);
      if (end == std::string::npos) return;
      text.replace(begin + 1, end - begin - 1, kPieces[below(random, std::size(kPieces))]);
    }
  }
}

const host::Catalogue& catalogue() {
  static const host::Catalogue& found = test::make_catalogue(SWAGE_BINARY_DIR "/plugins");
  return found;
}

// a scene, or an error with a place and a sentence
bool survives(const std::string& text, int* scenes = nullptr) {
  base::Problems problems;
  assembly::LessonFile file;
  const bool whole =
      assembly::parse_lesson(text, SWAGE_SOURCE_DIR "/tests/descriptors/good/fuzz.json", file, problems);
  if (whole == base::failed(problems)) return false;
  const bool made = assembly::assemble(file, catalogue(), {"expert", ""}, problems) != nullptr;
  if (made == base::failed(problems)) return false;
  if (made && scenes != nullptr) ++*scenes;
  for (const base::Problem& p : problems)
    if (p.where.empty() || p.message.empty()) return false;
  return true;
}

TEST(Fuzz, DamagedLessonsGiveASceneOrASentence) {
  const std::string good[] = {read("minimal.json"), read("everything.json")};
  int scenes = 0;
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    Random random(seed);
    std::string text = good[below(random, std::size(good))];
    for (std::size_t i = 0, n = 1 + below(random, 4); i < n; ++i) damage(text, random);
    ASSERT_TRUE(survives(text, &scenes)) << "seed " << seed << "\n" << text;
  }
  // some damage is harmless, most is not: both ways are walked
  EXPECT_GT(scenes, 100);
  EXPECT_LT(scenes, 2000);
}

TEST(Fuzz, TextsThatAreNoLessonsAtAll) {
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    Random random(seed);
    std::string text;
    for (std::size_t i = 0, n = below(random, 60); i < n; ++i)
      text += kPieces[below(random, std::size(kPieces))];
    ASSERT_TRUE(survives(text)) << "seed " << seed << "\n" << text;
  }
}

}  // namespace fuzz_test
