// SPDX-License-Identifier: Apache-2.0
//
// A needle that bends, driven into tissue, let go there, taken again and pulled through: lessons/series/110 and 115 by the scripted
// expert. When the surface gives way at 20 mN the arm springs back. With P the force, R the circle, a the angle from the grip to the
// point, the point then goes P R^3/EI (1 - cos a)^2/2 across itself (0.2 mm for a = 90 deg), as far as the tissue lets it: the wound is
// larger than a rigid needle's, and as large as a beam of 48 pieces says.
#include <gtest/gtest.h>

#include "run_lesson.hpp"

namespace swage::stage {
namespace {

using toolkit::vec;

const std::string kSeries = SWAGE_SOURCE_DIR "/lessons/series/";

LessonRun lesson(const std::string& file, const std::vector<std::string>& settings) {
  return LessonRun(kSeries + file, "expert", settings);
}

/// Of the insertion by the expert, which must pass.
double wound(const std::string& level, std::vector<std::string> settings = {}) {
  settings.push_back("needle.level=" + level);
  LessonRun run = lesson("110_insertion.json", settings);
  EXPECT_TRUE(run.ready()) << run.problems();
  if (!run.ready()) return 0;
  run.run(60);
  EXPECT_EQ(run.outcome(), "passed") << run.reason();
  EXPECT_LT(run.metric("insert.cosine"), 0.15);
  return run.metric("wound.size");
}

TEST(BendingNeedle, SpringsBackAsTheSurfaceGivesWay) {
  const double rigid = wound("rigid"), bending = wound("bending"), reference = wound("reference");
  EXPECT_LT(rigid, 1.1);
  EXPECT_GT(reference, 1.5);
  EXPECT_NEAR(bending, reference, 0.12 * reference);
}

// The needles of the study: the more of a circle, the farther round from the grip is the point, and the more it springs
TEST(BendingNeedle, EveryNeedleOfTheStudyGoesIn) {
  double before = 1.3;
  for (const char* arc : {"2/8", "3/8", "4/8"}) {
    const double now =
        wound("bending", {std::string("needle.arc=") + arc, "needle.size_of=length", "needle.size=5 mm"});
    EXPECT_GT(now, before) << arc;
    EXPECT_LT(now, 1.7) << arc;
    before = now;
  }
}

// Held by its track alone it stays: what it is tied to takes its swing within milliseconds, as it does from a rigid needle.
TEST(BendingNeedle, LetGoInTissueItComesToRestAndIsTakenAgain) {
  LessonRun run = lesson("115_stitch.json", {"needle.level=bending"});
  ASSERT_TRUE(run.ready()) << run.problems();
  const uint32_t needle = run.body("needle");
  double alone = 0, fastest = 0;  // s; m/s after a tenth of a second on its own, before the jaws come back
  while (run.world().time() < 60 && run.outcome() == "running") {
    run.step();
    const bool in_tissue = run.signal("pierce", "pierce.state") >= 2,
               held = run.signal("grasp", "grasp.held") > 0;
    alone = in_tissue && !held && run.phase() == "retake" ? alone + run.world().dt : 0;
    if (alone > 0.1 && alone < 5) fastest = std::max(fastest, vec(run.world().V_WB[needle].v).norm());
  }
  EXPECT_LT(fastest, 1e-3) << "it swings";
  EXPECT_EQ(run.outcome(), "passed") << run.reason();
}

}  // namespace
}  // namespace swage::stage
