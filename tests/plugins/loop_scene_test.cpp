// SPDX-License-Identifier: Apache-2.0
//
// A thread wound about the tips of the other instrument by two scripted hands: what keeps it there is the pull of the hand, and nothing that was written down.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "run_lesson.hpp"
#include "test_places.hpp"
#include "two_tools.hpp"

namespace swage::stage {
namespace {

const std::string kOne = SWAGE_SOURCE_DIR "/lessons/series/130_loop.json";
/// The lesson with one turn, or with two: the same scene and hands, but that the winder goes round once more.
LessonRun loop(int turns, const char* hand, uint64_t seed = 130) {
  return LessonRun(kOne, {hand, ""}, [&](auto& file) {
    file.seed = seed;
    if (turns == 1) return;
    const auto replace = [](std::string& text, const std::string& from, const std::string& to) {
      const size_t at = text.find(from);
      if (at != std::string::npos) text.replace(at, from.size(), to);
    };
    for (const char* between : {"", " "}) {
      replace(file.lesson.params, std::string("\"turns\":") + between + "1", "\"turns\":2");
      replace(file.lesson.params, std::string("\"par_time\":") + between + "\"12 s\"", "\"par_time\":\"18 s\"");
    }
    for (auto& choice : file.devices[1].choices) replace(choice.params, "130_winder", "130_winder_double");
  });
}

class Loop : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Turns, Loop, ::testing::Values(1, 2));

TEST_P(Loop, TwoHandsWindAndKeepItDrawn) {
  LessonRun attempt = loop(GetParam(), "expert");
  ASSERT_EQ(attempt.problems(), "");
  double least_draw = 1, pull = 0;
  while (attempt.outcome() == "running" && attempt.world().time() < 40) {
    attempt.step();
    pull = std::max(pull, attempt.signal("suture", "thread.tension_first"));
    if (attempt.signal("winding", "winding.whole") == GetParam())
      least_draw = std::min(least_draw, attempt.signal("round", "contact.force"));
  }
  EXPECT_EQ(attempt.outcome(), "passed") << attempt.reason() << " in phase " << attempt.phase() << " after " << attempt.world().time()
                                         << " with " << attempt.signal("winding", "winding.turns");
  EXPECT_NEAR(attempt.metric("loop.turns"), GetParam(), 0.3);
  EXPECT_EQ(attempt.metric("loop.slips"), 0);
  EXPECT_EQ(attempt.metric("thread.passages"), 0);
  EXPECT_EQ(attempt.happened("winding.wound"), GetParam());
  EXPECT_GT(least_draw, 0.05e-3) << "it lies on the instrument";
  EXPECT_LT(pull, 20e-3);
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
}

// Expert > novice > clumsy whatever the seed.
TEST(LoopHands, ComeOutInThisOrderOverSeeds) {
  struct Played {
    std::string outcome, reason;
    double score = 0;
  };
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const auto with = [&](const char* hand) {
      LessonRun attempt = loop(1, hand, seed);
      EXPECT_EQ(attempt.problems(), "");
      attempt.run(60);
      return Played{attempt.outcome(), attempt.reason(), attempt.verdict().score};
    };
    const Played expert = with("expert"), novice = with("novice"), clumsy = with("clumsy");
    EXPECT_EQ(expert.outcome, "passed") << seed;
    EXPECT_GT(expert.score, 95) << seed;
    EXPECT_NE(clumsy.outcome, "passed") << seed;
    EXPECT_EQ(novice.outcome, "passed") << seed << " " << novice.reason;
    EXPECT_GT(expert.score, novice.score + 3) << seed;
    EXPECT_GT(novice.score, clumsy.score + 3) << seed;
  }
}

/// The expert, who opens the forceps instead of keeping the thread drawn.
std::string lets_go() {
  std::ifstream in(SWAGE_SOURCE_DIR "/lessons/hands/130_winder.json");
  std::stringstream text;
  text << in.rdbuf();
  std::string plan = text.str();
  const size_t last = plan.rfind("{ \"act\": \"wind\"");
  plan.replace(last, std::string::npos,
               R"({ "act": "wait", "time": "0.3 s" }, { "act": "open", "closure": 0.15, "time": "0.3 s" }, { "act": "wait", "time": "3 s" } ] })");
  const std::string path = ::testing::TempDir() + "swage_130_lets_go.json";
  std::ofstream(path) << plan;
  return path;
}

// let go of, the thread springs open by its own stiffness: nothing but the pull kept the turn
TEST(LoopPhysics, LetGoItSpringsOpen) {
  const std::string plan = lets_go();
  LessonRun attempt(kOne, {"expert", ""}, [&](auto& file) {
    for (auto& choice : file.devices[1].choices)
      if (choice.as == "expert")
        choice.params = "{\"file\": \"" + plan + "\", \"gripper\": \"forceps\", \"needle\": \"suture\", \"grasp\": \"grasp\"}";
  });
  ASSERT_EQ(attempt.problems(), "");
  attempt.run(40, 0.1);
  EXPECT_EQ(attempt.happened("winding.wound"), 1);
  EXPECT_EQ(attempt.happened("thread.dropped"), 1);
  EXPECT_EQ(attempt.signal("winding", "winding.whole"), 0) << attempt.signal("winding", "winding.turns");
  EXPECT_EQ(attempt.metric("thread.passages"), 0);
  EXPECT_EQ(attempt.outcome(), "running");
}

// by keys: the thread is taken and lifted, the needleholder laid on it, then the forceps go round in small steps, drawn by what is felt
TEST(LoopMouse, OneMouseAndTabAreEnough) {
  using toolkit::Vec3;
  LessonRun attempt(kOne, "mouse");
  ASSERT_EQ(attempt.problems(), "");
  TwoTools person(attempt);
  person.wait(0.3);
  person.close();  // the needleholder's tips
  person.tab();
  ASSERT_TRUE(person.lead("forceps", {0.4e-3, -8.97e-3, 6.2e-3}));
  person.close();
  ASSERT_GT(attempt.signal("grasp", "grasp.force"), 0.2);
  ASSERT_TRUE(person.lead("forceps", {0.4e-3, -5.4e-3, 11.3e-3}));
  person.tab();
  const Vec3 axis(-2.2e-3, -0.5e-3, 6.5e-3);
  ASSERT_TRUE(person.lead("holder", axis + Vec3(0, 0, 3e-3)));
  ASSERT_TRUE(person.lead("holder", axis));
  person.tab();
  double radius = 6.8e-3;
  for (double angle = 135; angle > -50 && attempt.signal("winding", "winding.whole") < 1; angle -= 15) {
    const double a = angle * std::numbers::pi / 180;
    ASSERT_TRUE(person.lead("forceps", Vec3(0.4e-3, axis.y() + radius * std::cos(a), axis.z() + radius * std::sin(a)))) << angle;
    const double draw = attempt.signal("round", "contact.force");
    radius += draw < 0.2e-3 ? 0.05e-3 : draw > 1e-3 ? -0.3e-3 : -0.1e-3;
  }
  for (int i = 0; i < 40 && attempt.outcome() == "running"; ++i) {  // a little out, a little in, until it is drawn and stays so
    const double draw = attempt.signal("round", "contact.force");
    const Vec3 out = (toolkit::vec(attempt.world().X_WB[attempt.body("forceps")].p) - axis).cwiseProduct(Vec3(0, 1, 1)).normalized();
    if (draw < 0.2e-3 || draw > 3e-3)
      person.lead("forceps", toolkit::vec(attempt.world().X_WB[attempt.body("forceps")].p) + (draw < 0.2e-3 ? 0.1e-3 : -0.1e-3) * out);
    person.wait(0.2);
  }
  person.wait(3);
  EXPECT_EQ(attempt.outcome(), "passed") << attempt.phase() << " " << attempt.signal("winding", "winding.turns");
  EXPECT_EQ(attempt.metric("thread.drops"), 0);
  EXPECT_GT(attempt.verdict().score, 60);
}

}  // namespace
}  // namespace swage::stage
