// SPDX-License-Identifier: Apache-2.0
//
// U11: which way a metric is better is declared once, in its card, and limits, bars and curves all follow it. For every metric of one
// lesson of each kind the expert hand is not worse than the worst of three novice hands; a direction that is the wrong way round fails.
#include <gtest/gtest.h>
#include <swage/abi/lesson_card.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

class Directions : public testing::TestWithParam<const char*> {};

LessonRun play(const std::string& hand, const std::string& seed) {
  LessonRun run(std::string(SWAGE_SOURCE_DIR "/lessons/series/") + Directions::GetParam() + ".json", hand, {"seed=" + seed});
  EXPECT_EQ(run.problems(), "");
  if (run.ready()) run.run(120);
  return run;
}

TEST_P(Directions, TheExpertIsWorseInNoMetricThanTheWorstNovice) {
  const LessonRun expert = play("expert", "1");
  ASSERT_TRUE(expert.ready());
  ASSERT_EQ(expert.outcome(), "passed");
  const LessonRun novices[] = {play("novice", "1"), play("novice", "2"), play("novice", "3")};
  const snapshot::SceneCard& card = expert.rig().card;
  int compared = 0;
  for (size_t i = 0; i < card.metrics.size(); ++i) {
    const std::string& id = card.script.metrics[i].id;
    const snapshot::CardMetric& m = card.metrics[i];
    EXPECT_FALSE(m.formula.empty()) << id;
    const double own = expert.metric(id);
    if (!std::isfinite(own) || (m.better != SWAGE_BETTER_LOWER && m.better != SWAGE_BETTER_HIGHER)) continue;
    double least = INFINITY, most = -INFINITY;
    for (const LessonRun& n : novices) {
      const double value = n.metric(id);
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (least > most) continue;  // no novice came so far
    ++compared;
    // equal to a part in a hundred: what both do alike, as the seconds of one plan, is not judged
    const double tie = 1e-2 * std::max(std::abs(own), std::max(std::abs(least), std::abs(most)));
    if (m.better == SWAGE_BETTER_LOWER) {
      EXPECT_LE(own, most + tie) << id << ": expert " << own << ", novices to " << most;
    } else {
      EXPECT_GE(own, least - tie) << id << ": expert " << own << ", novices from " << least;
    }
  }
  std::printf("%s: %d of %zu metrics compared\n", GetParam(), compared, card.metrics.size());
  EXPECT_GE(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(OneOfEachKind, Directions,
                         testing::Values("020_grasp_basic", "031_grasp_advanced_1_three_eighths", "040_grasp_advanced_2",
                                         "045_pass_the_needle", "055_ring_on_hoop", "110_insertion", "120_angles"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace swage::stage
