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

LessonRun lesson(const std::string& file, const std::string& level) {
  return LessonRun(kSeries + file, {"expert", ""}, [&](assembly::LessonFile& read) {
    const std::string text = "needle.level=" + level;
    assembly::Setting setting;
    EXPECT_TRUE(assembly::parse_setting(text, setting));
    base::Problems problems;
    read = {};
    EXPECT_TRUE(assembly::read_lesson_file(kSeries + file, {&setting, 1}, read, problems));
  });
}

double wound(const std::string& level) {
  LessonRun run = lesson("110_insertion.json", level);
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

// Held by its track alone it stays: what it is tied to takes its swing within milliseconds, as it does from a rigid needle.
TEST(BendingNeedle, LetGoInTissueItComesToRestAndIsTakenAgain) {
  LessonRun run = lesson("115_stitch.json", "bending");
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
