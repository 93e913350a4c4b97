// SPDX-License-Identifier: Apache-2.0
//
// Three needles on three surfaces (thesis 6.4 and appendix D), with the real physics: what the scripted hands make of them.
#include <gtest/gtest.h>

#include <string>

#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

const std::string kLesson = SWAGE_SOURCE_DIR "/lessons/series/110_insertion.json";

struct Pair {
  const char *surface, *needle;
};

LessonRun run(const Pair& pair, const std::string& hand) {
  LessonRun attempt(kLesson, hand,
                    {std::string("tissue.form=") + pair.surface, std::string("needle.arc=") + pair.needle,
                     "needle.size_of=length", "needle.size=5 mm"});
  EXPECT_EQ(attempt.problems(), "");
  if (attempt.ready()) attempt.run(60);
  return attempt;
}

class Pairs : public ::testing::TestWithParam<Pair> {};
INSTANTIATE_TEST_SUITE_P(Nine, Pairs,
                         ::testing::Values(Pair{"flat", "2/8"}, Pair{"flat", "3/8"}, Pair{"flat", "4/8"},
                                           Pair{"left slope", "2/8"}, Pair{"left slope", "3/8"},
                                           Pair{"left slope", "4/8"}, Pair{"right slope", "2/8"},
                                           Pair{"right slope", "3/8"}, Pair{"right slope", "4/8"}));

TEST_P(Pairs, TheExpertLeavesASmallWoundAndTheNoviceALargerOne) {
  const LessonRun expert = run(GetParam(), "expert"), novice = run(GetParam(), "novice");
  ASSERT_TRUE(expert.ready() && novice.ready());
  EXPECT_EQ(expert.outcome(), "passed") << expert.reason();
  EXPECT_LT(expert.metric("wound.size"), 1.3);
  EXPECT_LT(expert.metric("insert.cosine"), 0.15);
  EXPECT_EQ(expert.metric("insert.deflections"), 0);
  EXPECT_EQ(expert.metric("tissue.stray"), 0);
  EXPECT_GT(novice.metric("wound.size"), 1.5 * expert.metric("wound.size"));
  EXPECT_GT(novice.metric("insert.cosine"), 2 * expert.metric("insert.cosine"));
  EXPECT_LT(novice.verdict().score, expert.verdict().score - 20);
}

TEST(Pairs, TheClumsyHandTearsTheTissueAndIsToldSo) {
  for (const char* needle : {"2/8", "3/8", "4/8"}) {
    const LessonRun clumsy = run({"flat", needle}, "clumsy");
    ASSERT_TRUE(clumsy.ready());
    EXPECT_EQ(clumsy.reason(), "failed.torn") << needle;
  }
}

}  // namespace
}  // namespace swage::stage
