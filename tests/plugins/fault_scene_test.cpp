// SPDX-License-Identifier: Apache-2.0
//
// Lesson 134 in the real host: what is said of each knot is what it does when it is pulled, the hands come out in order, and nothing tells
// the answer before it was given.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "run_lesson.hpp"
#include "scene/chain.hpp"
#include "test_places.hpp"
#include "toolkit/knot/reader.hpp"

namespace swage::stage {
namespace {

const std::string kLesson = SWAGE_SOURCE_DIR "/lessons/series/134_find_the_fault.json";
constexpr double kLongest = 90;  // s, of an attempt

/// The knot in the k-th place has the shape shapes[k], from 1 on.
LessonRun with_shapes(const std::string& hand, const std::string& shapes, bool mirror = false) {
  return LessonRun(kLesson, {hand, ""}, [&](assembly::LessonFile& file) {
    file.mirror = mirror;
    for (auto& object : file.objects)
      if (object.name.starts_with("knot_")) {
        auto params = nlohmann::ordered_json::parse(object.params);
        params["shape"] = shapes[static_cast<size_t>(object.name.back() - '1')] - '0';
        object.params = params.dump();
      }
  });
}

/// Throws of a thread whose ends are led away, as they are read off it: "1 -1".
std::string word(const LessonRun& run, uint32_t thread) {
  const scene::ChainView chain(run.world(), run.world().chain[thread]);
  std::vector<toolkit::Vec3> line;
  for (uint32_t i = 0; i < chain.vertices(); ++i) line.push_back(chain.p(i));
  toolkit::KnotThread knot;
  toolkit::KnotReader reader;
  toolkit::KnotName name;
  if (!knot.begin(line.front().data(), static_cast<int>(line.size()))) return "?";
  while (!reader.read(knot, 100000, name)) {}
  std::string out = name.certain ? "" : "?";
  for (int i = 0; i < name.word.throws; ++i) {
    const toolkit::KnotThrow& t = name.word.tied[static_cast<size_t>(i)];
    out += (out.empty() ? "" : " ") + std::to_string(t.sign * t.turns);
  }
  return out;
}

TEST(FindTheFault, TheSquareKnotHoldsAndTheOthersGiveWay) {
  LessonRun run = with_shapes("expert", "1234");
  ASSERT_EQ(run.problems(), "");
  run.step();
  const char* const words[] = {"1 -1", "1 1", "1 1", "1 -1"};
  for (uint32_t k = 0; k < 4; ++k) EXPECT_EQ(word(run, k), words[k]) << k;
  run.run(kLongest);
  EXPECT_EQ(run.outcome(), "passed") << run.reason();
  EXPECT_EQ(run.metric("fault.right"), 4);
  EXPECT_GT(run.verdict().score, 95);
  EXPECT_GE(run.metric("pull.square_bears"), 0.095) << "N";
  EXPECT_LT(run.metric("pull.square_opens"), 2e-3) << "m";
  for (const char* knot : {"granny", "sliding", "loose"}) {
    EXPECT_LT(run.metric(std::string("pull.") + knot + "_bears"), 0.08) << "N, " << knot;
    EXPECT_GE(run.metric(std::string("pull.") + knot + "_opens"), 3e-3) << "m, " << knot;
  }
  EXPECT_EQ(run.happened("fault.held"), 1);
  EXPECT_EQ(run.happened("fault.gave_way"), 3);
  EXPECT_EQ(word(run, 0), "1 -1") << "after the pull";
  for (int k = 1; k <= 4; ++k) EXPECT_EQ(run.signal("knot_" + std::to_string(k), "thread.passed"), 0) << k;
  EXPECT_EQ(run.engine().quarantined(), 0u);
}

TEST(FindTheFault, KnotsAreDrawnAnewWithEachSeedAndNothingElseTellsThem) {
  std::set<std::string> drawn;
  for (uint64_t seed = 0; seed < 6; ++seed) {
    LessonRun run(kLesson, {"mouse", ""}, [&](assembly::LessonFile& file) { file.seed = seed; });
    ASSERT_EQ(run.problems(), "");
    for (int i = 0; i < 3; ++i) run.step();
    std::string shapes;
    for (int k = 1; k <= 4; ++k) shapes += std::to_string(static_cast<int>(run.signal("knot_" + std::to_string(k), "thread.shape")));
    drawn.insert(shapes);
    EXPECT_EQ(shapes.find_first_not_of("1234"), std::string::npos) << shapes;
    for (int k = 1; k <= 4; ++k) EXPECT_EQ(run.cue("knot_" + std::to_string(k)), "") << k;
    EXPECT_EQ(run.happened("fault.answered"), 0);
  }
  EXPECT_GE(drawn.size(), 4u);
}

}  // namespace
}  // namespace swage::stage
