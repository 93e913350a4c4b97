// SPDX-License-Identifier: Apache-2.0
//
// Lessons 132 and 133: two throws on a wound by two hands, and a surgeon's knot of three. Wound the other way the second time they are a square
// knot, the same way a granny. The thread snaps from one side of a tool to the other and a tenth of a millimetre decides to which, so a
// change of the solver may need other plans: a soak test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "pulled_knot.hpp"
#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

const std::string kLesson = SWAGE_SOURCE_DIR "/lessons/series/132_square_knot.json";
const std::string kSurgeons = SWAGE_SOURCE_DIR "/lessons/series/133_surgeons_knot.json";
constexpr double kLongest = 130;  // s, of an attempt: the expert takes 100

struct Tied {
  std::string outcome, reason;
  double score, throws, first, second, kind, sliding, passages, gap, pull;
};

Tied tie(const char* hand, bool mirror = false) {
  LessonRun attempt(kLesson, {hand, ""}, [&](auto& file) { file.mirror = mirror; });
  EXPECT_EQ(attempt.problems(), "");
  double pull = 0;  // N, that the tied knot has borne
  while (attempt.outcome() == "running" && attempt.world().time() < kLongest && !attempt.engine().hand_gone()) {
    attempt.step();
    if (attempt.signal("knot", "knot.throws") == 2) pull = std::max(pull, attempt.signal("suture", "thread.tension_grip"));
  }
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
  const auto knot = [&](const char* id) { return attempt.signal("knot", id); };
  return {attempt.outcome(),      attempt.reason(),    attempt.verdict().score, knot("knot.throws"),           knot("knot.throw_1"),
          knot("knot.throw_2"),   knot("knot.kind"),   knot("knot.sliding"),    attempt.metric("thread.passages"), attempt.metric("wound.gap"),
          pull};
}

void expect_square(const Tied& knot) {
  EXPECT_EQ(knot.outcome, "passed") << knot.reason;
  EXPECT_EQ(knot.throws, 2);
  EXPECT_EQ(knot.first * knot.second, -1);
  EXPECT_EQ(knot.kind, 2) << "square";
  EXPECT_EQ(knot.sliding, 0);
  EXPECT_EQ(knot.passages, 0);
  EXPECT_LT(knot.gap, 0.1e-3) << "m, of 0.3 mm";
  EXPECT_GT(knot.pull, 50e-3) << "N: it bears what the hands draw";
}

TEST(SquareKnot, TheExpertTiesItAndTheClumsyHandDoesNot) {
  const Tied expert = tie("expert"), clumsy = tie("clumsy");
  expect_square(expert);
  EXPECT_GT(expert.score, 95);
  EXPECT_EQ(clumsy.outcome, "failed");
  EXPECT_LT(clumsy.score, 40);
}

TEST(SquareKnot, TheLeftHandTiesItsMirrorImage) {
  const Tied right = tie("expert"), left = tie("expert", true);
  expect_square(left);
  EXPECT_NEAR(left.score, right.score, 1e-6);
}

/// Both hands of a granny in the place of the expert's.
void tie_a_granny(assembly::LessonFile& file) {
  const std::string plans = SWAGE_SOURCE_DIR "/tests/plugins/granny/";
  for (auto& device : file.devices)
    for (auto& choice : device.choices) {
      if (choice.as != "expert") continue;
      const bool right = device.name == "right_hand";
      choice.params = "{\"file\": \"" + plans + (right ? "holder" : "winder") + ".json\", \"gripper\": \"" + (right ? "holder" : "forceps") +
                      "\", \"needle\": \"suture\", \"grasp\": \"" + (right ? "tail_grasp" : "grasp") + "\"}";
    }
}

constexpr double kLoad = 0.1;  // N, that a knot is to bear
// Friction of the thread on itself at which a square knot holds and a granny does not, and the most that nylon on nylon has (0.1 to 0.3), at which
// both slip: a square knot by a tenth of its loop at 20 mN, a granny at 28 mN.
constexpr double kHolds = 0.4, kNylon = 0.3;

// wound the same way twice it is a granny: named, not passed, and it slips
TEST(Granny, IsNamedAndFailsAndSlips) {
  LessonRun granny(kLesson, {"expert", ""}, tie_a_granny);
  ASSERT_EQ(granny.problems(), "");
  granny.run(kLongest);
  EXPECT_EQ(granny.outcome(), "failed");
  EXPECT_EQ(granny.reason(), "failed.wrong");
  EXPECT_LE(granny.verdict().score, 40);
  EXPECT_EQ(granny.signal("knot", "knot.throws"), 2);
  EXPECT_EQ(granny.signal("knot", "knot.throw_1") * granny.signal("knot", "knot.throw_2"), 1);
  EXPECT_EQ(granny.signal("knot", "knot.kind"), 3) << "granny";
  EXPECT_EQ(granny.metric("thread.passages"), 0);
  const PulledKnot slips = pull_apart(granny, kHolds, kLoad);
  EXPECT_EQ(slips.problems + slips.health, "");
  EXPECT_TRUE(slips.copy.word == "1 1" || slips.copy.word == "-1 -1") << slips.copy.word;
  EXPECT_EQ(slips.reason, "failed.slipped");
  EXPECT_LT(slips.bears, 50e-3) << "N, of the 0.1 N that the square knot bears";
  EXPECT_GE(slips.slip, 0.5e-3) << "m, where the square knot slips by 0.15 mm";
}

// two throws hold 0.1 N by a friction that nylon does not have: by its own they slip as well, and want a third one
TEST(SquareKnot, HoldsByAFrictionByWhichAGrannySlips) {
  LessonRun square(kLesson, "expert");
  ASSERT_EQ(square.problems(), "");
  square.run(kLongest);
  ASSERT_EQ(square.signal("knot", "knot.throws"), 2);
  const PulledKnot holds = pull_apart(square, kHolds, kLoad), nylon = pull_apart(square, kNylon, kLoad);
  EXPECT_EQ(holds.problems + holds.health + nylon.problems + nylon.health, "");
  EXPECT_TRUE(holds.holds) << holds.reason;
  EXPECT_LT(holds.slip, 0.25e-3) << "m";
  EXPECT_EQ(nylon.reason, "failed.slipped");
  EXPECT_LT(nylon.bears, 60e-3) << "N";
}

// The double throw of a surgeon's knot closes the edges while it is drawn, and stays tied while the second one is wound. With both ends slack it
// springs open (lessons/knot/knot.md), so the edges are not asked for then.
TEST(SurgeonsKnot, ItsDoubleThrowClosesTheEdgesAndStaysTied) {
  LessonRun attempt(kSurgeons, "expert");
  ASSERT_EQ(attempt.problems(), "");
  double least = 1, most = 0;  // m, of the gap, of which 0.2 mm are open at rest; N, of the thread until the first draw
  while (attempt.outcome() == "running" && attempt.world().time() < 55) {
    attempt.step();
    const double t = attempt.world().time();
    if (t > 8 && t < 32) most = std::max(most, attempt.signal("suture", "thread.tension"));
    if (t > 33 && t < 45) least = std::min(least, attempt.metric("wound.gap"));
  }
  EXPECT_LT(most, 10e-3) << "N: nothing catches on the winder's tips and snaps over them";
  EXPECT_LT(least, 0.1e-3);
  EXPECT_EQ(attempt.signal("knot", "knot.throws"), 1);
  EXPECT_EQ(std::abs(attempt.signal("knot", "knot.throw_1")), 2);
  EXPECT_EQ(attempt.metric("thread.passages"), 0);
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
}

// Three throws by the same means.
TEST(SurgeonsKnot, TwoHandsTieIt) {
  LessonRun attempt(kSurgeons, "expert");
  ASSERT_EQ(attempt.problems(), "");
  double most = 0, stitch = 0;  // N, of the thread; N, at the tissue
  while (attempt.outcome() == "running" && attempt.world().time() < kLongest) {
    attempt.step();
    most = std::max(most, attempt.signal("suture", "thread.tension"));
    stitch = std::max({stitch, attempt.signal("left_stitch", "pull.tension_tail"), attempt.signal("right_stitch", "pull.tension_out")});
  }
  const auto knot = [&](const char* id) { return attempt.signal("knot", id); };
  EXPECT_EQ(attempt.outcome(), "passed") << attempt.reason();
  EXPECT_EQ(knot("knot.throws"), 3);
  EXPECT_EQ(std::abs(knot("knot.throw_1")), 2);
  EXPECT_EQ(knot("knot.throw_1") * knot("knot.throw_2"), -2);
  EXPECT_EQ(knot("knot.throw_2") * knot("knot.throw_3"), -1);
  EXPECT_EQ(knot("knot.kind"), 2) << "each throw is the other way round than the one before";
  EXPECT_LE(knot("knot.sliding"), 1) << "the tail runs nearly straight through the second one";
  EXPECT_GT(knot("knot.loop"), 3.5e-3) << "m, about the tissue";
  EXPECT_LT(knot("knot.loop"), 6e-3);
  EXPECT_LT(knot("knot.loosest"), 4e-3) << "m";
  EXPECT_EQ(attempt.metric("thread.passages"), 0);
  EXPECT_EQ(attempt.metric("knot.right_throws"), 3);
  EXPECT_LT(attempt.metric("wound.gap"), 0.1e-3) << "m, of 0.2 mm";
  EXPECT_EQ(attempt.metric("thread.drops"), 0);
  EXPECT_GT(most, 60e-3) << "N: it bears what the hands draw";
  EXPECT_LT(stitch, 40e-3) << "N: half of what cuts the tissue";
  EXPECT_LT(attempt.metric("tissue.cut"), 0.05e-3) << "m, of 0.3 that end the attempt";
  EXPECT_GT(attempt.verdict().score, 70) << "a turn that lies on the tips for long may be told as undone: 20 points";
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
  // by the friction that nylon has, at which two throws slip: the third one is what holds
  for (const double friction : {0.2, 0.3}) {
    const PulledKnot pulled = pull_apart(attempt, friction, kLoad);
    EXPECT_EQ(pulled.problems + pulled.health, "") << friction;
    EXPECT_TRUE(pulled.holds) << pulled.reason << ", bears " << pulled.bears << " N with friction " << friction;
    EXPECT_LT(pulled.slip, 0.25e-3) << "m, with friction " << friction;
  }
}

// it does not feel what it draws
TEST(SurgeonsKnot, TheClumsyHandDropsTheThreadOrCutsTheTissue) {
  LessonRun clumsy(kSurgeons, "clumsy");
  ASSERT_EQ(clumsy.problems(), "");
  clumsy.run(40);
  EXPECT_EQ(clumsy.outcome(), "failed");
  EXPECT_TRUE(clumsy.reason() == "failed.cut" || clumsy.reason() == "failed.dropped") << clumsy.reason();
  EXPECT_EQ(clumsy.verdict().score, 0);
}

// With a tremor of 15 um, at 0.6 of the pace. Some leave the edges closed by less than is asked for (lessons/knot/knot.md).
TEST(SurgeonsKnot, NovicesTieItAndGetFewerPoints) {
  int passed = 0;
  for (const uint64_t seed : {0u, 1u}) {
    LessonRun novice(kSurgeons, {"novice", ""}, [&](auto& file) { file.seed = seed; });
    ASSERT_EQ(novice.problems(), "");
    while (novice.outcome() == "running" && novice.world().time() < 260 && !novice.engine().hand_gone()) novice.step();
    EXPECT_EQ(novice.metric("knot.right_throws"), 3) << seed;
    EXPECT_LT(novice.verdict().score, 95) << "the expert has 99";
    if (novice.outcome() != "passed") continue;
    EXPECT_GT(novice.verdict().score, 40) << seed;
    ++passed;
  }
  EXPECT_GE(passed, 1);
}

TEST(SurgeonsKnot, TheLeftHandTiesItsMirrorImage) {
  LessonRun left(kSurgeons, {"expert", ""}, [](auto& file) { file.mirror = true; });
  ASSERT_EQ(left.problems(), "");
  left.run(kLongest);
  EXPECT_EQ(left.outcome(), "passed") << left.reason();
  EXPECT_EQ(left.metric("knot.right_throws"), 3);
  EXPECT_EQ(left.metric("thread.passages"), 0);
}

}  // namespace
}  // namespace swage::stage
