// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.knot in a scene: a thread that lies in a tie of known word is named, one that goes through itself is noticed.
#include <gtest/gtest.h>

#include <cmath>

#include "plugins/thread_scene.hpp"
#include "ties.hpp"
#include "toolkit/rod.hpp"

namespace swage::test {
namespace {

constexpr char kKnot[] = R"({"plugin": "swage.coupling.contact", "between": ["thread", "thread"],
                             "params": {"stiffness": "1e4 N/m", "friction": 0.2}},
                            {"plugin": "swage.coupling.knot", "between": ["thread", "thread"]})";

/// A soft thread that starts straight and is laid as it is wanted.
struct Laid : ThreadScene {
  int nodes;
  double edge;
  Laid(double length, int segments, const std::string& young, const std::string& couplings)
      : ThreadScene(R"({"name": "thread", "plugin": "swage.object.thread", "params": {"length": )" + std::to_string(length) +
                        R"(, "segments": )" + std::to_string(segments) + R"(, "young": ")" + young + R"("}})",
                    couplings),
        nodes(segments + 1),
        edge(length / segments) {}
  toolkit::RodState rod() {
    scene::World& world = rig->world;
    double* state = world.plugin_state.data() + world.chain[0].state;
    return {nodes, state, state + scene::chain_doubles(static_cast<uint32_t>(nodes))};
  }
  template <class Place>
  void lay(const Place& place) {
    toolkit::RodState s = rod();
    for (int i = 0; i < nodes; ++i) Eigen::Map<Vec3>(s.x + 3 * i) = place(i);
    toolkit::Rod(toolkit::RodSection::round(22e-6, 1e6, 0.39, 1140), std::vector<double>(static_cast<size_t>(nodes - 1), edge))
        .start(s);
  }
  Word word() const {
    Word out;
    for (int i = 0; i < 6; ++i)
      if (const double t = signal("knot.throw_" + std::to_string(i + 1)); t != 0) out.push_back(static_cast<int>(t));
    return out;
  }
};

constexpr double kLength = 0.2;  // m: large, so that it keeps its shape while it is read

struct Case {
  Word word;
  double core;
  int kind;
};

class KnotInScene : public testing::TestWithParam<Case> {};

TEST_P(KnotInScene, is_named) {
  const Case& c = GetParam();
  TieShape shape;
  shape.nodes = 201, shape.core = c.core;
  const auto tie = make_tie(c.word, shape, 1);
  ASSERT_TRUE(tie.has_value());
  double length = 0;
  for (size_t i = 1; i < tie->node.size(); ++i) length += (tie->node[i] - tie->node[i - 1]).norm();
  Laid s(kLength, 200, "0.001 GPa", kKnot);
  ASSERT_TRUE(s.engine);
  s.lay([&](int i) { return Vec3(kLength / length * tie->node[static_cast<size_t>(i)]); });
  // a reading takes some steps, then it settles for 50 ms
  int steps = 0;
  for (; steps < 150 && s.signal("knot.throws") == 0; ++steps) s.run(1);
  EXPECT_GE(steps, 50);
  EXPECT_EQ(s.word(), c.word);
  EXPECT_EQ(s.signal("knot.throws"), c.word.size());
  EXPECT_EQ(s.signal("knot.kind"), c.kind);
  EXPECT_EQ(s.signal("knot.sliding"), c.core > 0.5 ? c.word.size() : 0);
  EXPECT_EQ(s.signal("knot.certain"), 1);
  EXPECT_EQ(s.signal("knot.passages"), 0);
  RecordProperty("steps", steps);
}

INSTANTIATE_TEST_SUITE_P(Words, KnotInScene,
                         testing::Values(Case{{1}, 0, 1}, Case{{-1}, 0, 1}, Case{{2}, 0, 1}, Case{{1, -1}, 0, 2},
                                         Case{{-1, 1}, 0, 2}, Case{{1, 1}, 0, 3}, Case{{1, 1}, 1, 3}, Case{{2, -1, 1}, 0, 2},
                                         Case{{1, 1, -1}, 0, 4}));

/// The history: throws are told as they are tied, in their order, and as they come undone. The thread jumps from tie to tie here,
/// through itself, which is told too.
TEST(KnotHistory, is_told_throw_by_throw) {
  Laid s(kLength, 200, "0.001 GPa", kKnot);
  ASSERT_TRUE(s.engine);
  std::vector<std::pair<std::string, double>> said;
  const Word words[] = {{2}, {2, -1}, {2, -1, 1}, {2, -1}, {1}};
  for (const Word& word : words) {
    TieShape shape;
    shape.nodes = 201;
    const auto tie = make_tie(word, shape, 1);
    ASSERT_TRUE(tie.has_value());
    double length = 0;
    for (size_t i = 1; i < tie->node.size(); ++i) length += (tie->node[i] - tie->node[i - 1]).norm();
    s.lay([&](int i) { return Vec3(kLength / length * tie->node[static_cast<size_t>(i)]); });
    for (int k = 0; k < 130; ++k) {
      s.run(1);
      for (const judge::Event& e : s.engine->events())
        if (const std::string& id = s.rig->script.events[e.event].id; id != "knot.passage") said.emplace_back(id, e.value);
    }
  }
  const std::vector<std::pair<std::string, double>> expected = {
      {"knot.tied", 2},   {"knot.tied", -1},  {"knot.tied", 1}, {"knot.untied", 1},
      {"knot.untied", -1}, {"knot.untied", 2}, {"knot.tied", 1}};
  EXPECT_EQ(said, expected);
  EXPECT_GT(s.signal("knot.passages"), 0);
}

/// A loop that crosses itself at right angles; then its upper leg is laid below the lower one, as a solver that fails would have it.
TEST(KnotPassage, is_counted_once) {
  constexpr double kLeg = 6e-3, kRadius = 2e-3, kArc = 1.5 * M_PI * kRadius;
  Laid s(24e-3, 48, "0.01 GPa", kKnot);
  ASSERT_TRUE(s.engine);
  const auto lay = [&](double above) {
    s.lay([&](int i) {
      const double at = 0.5e-3 * i, up = above * std::clamp((at - kLeg) / kArc, 0.0, 1.0), turn = (at - kLeg) / kRadius;
      if (at < kLeg) return Vec3(at - kLeg + kRadius, 0, up);
      if (at < kLeg + kArc) return Vec3(kRadius + kRadius * std::sin(turn), kRadius - kRadius * std::cos(turn), up);
      return Vec3(0, kRadius - (at - kLeg - kArc), up);
    });
  };
  lay(200e-6);
  s.run(2);
  lay(100e-6);
  s.run(2);
  EXPECT_EQ(s.signal("knot.passages"), 0);
  lay(-100e-6);
  s.run(1);
  EXPECT_EQ(s.signal("knot.passages"), 1);
  EXPECT_EQ(s.signal("knot.throws"), 0);
}

}  // namespace
}  // namespace swage::test
