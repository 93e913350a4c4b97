// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.knot in a scene: a thread that lies in a tie of known word is named, one that goes through itself is noticed.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "plugins/thread_scene.hpp"
#include "ties.hpp"
#include "toolkit/knot/writhe.hpp"
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
  Laid(double length, int segments, const std::string& young, const std::string& couplings, const std::string& beside = "",
       const std::string& ends = "", const std::string& devices = "")
      : ThreadScene(R"({"name": "thread", "plugin": "swage.object.thread", "params": {"length": )" + std::to_string(length) +
                        R"(, "segments": )" + std::to_string(segments) + R"(, "young": ")" + young + "\"" + ends + "}}" + (beside.empty() ? "" : ", " + beside),
                    couplings, devices),
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

/// Where a square knot lies on a thread whose second throw stands off the first one by `spacing` radii of the winding.
struct Lies {
  double from = 0, to = 0, loosest = 0, unit = 0;  // m; unit: a radius
};

Lies square_knot(double spacing) {
  TieShape shape;
  shape.nodes = 201, shape.spacing = spacing;
  const auto tie = make_tie({1, -1}, shape, 1);
  if (!tie) return ADD_FAILURE(), Lies();
  double length = 0;
  for (size_t i = 1; i < tie->node.size(); ++i) length += (tie->node[i] - tie->node[i - 1]).norm();
  Laid s(kLength, 200, "0.001 GPa", kKnot);
  if (!s.engine) return ADD_FAILURE(), Lies();
  s.lay([&](int i) { return Vec3(kLength / length * tie->node[static_cast<size_t>(i)]); });
  s.run(130);
  EXPECT_EQ(s.word(), Word({1, -1}));
  return {s.signal("knot.from"), s.signal("knot.to"), s.signal("knot.loosest"), kLength / length};
}

TEST(KnotPlaces, AThrowThatStandsOffTakesTheWayToTheOneBefore) {
  // from where on the spacing is more than a throw is long
  const Lies near = square_knot(8), far = square_knot(12);
  EXPECT_NEAR(far.loosest / far.unit - near.loosest / near.unit, 4, 1.5) << "a stick of three nodes is 1.4 long";
  for (const Lies& knot : {near, far}) {
    EXPECT_GT(knot.from, 0);
    EXPECT_LT(knot.to, kLength);
    EXPECT_GT(knot.to - knot.from, 2 * knot.loosest) << "both strands, and the loop";
    EXPECT_NEAR(knot.from, kLength - knot.to, 0.05 * kLength) << "both ends are alike";
  }
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

/// Linking number of the centre line with a line on its surface, both closed far away: a whole number, the sum of twist and writhe. No
/// motion of the thread changes it but a passage, which changes it by 2.
double self_linking(const toolkit::RodState& s) {
  constexpr double kBeside = 1e-6, kFar = 0.2;  // m
  std::vector<Vec3> line, beside;
  const int last = s.n - 1;
  for (int i = 0; i <= last; ++i) {
    const Vec3 d = (s.material(std::max(0, i - 1)) + s.material(std::min(last - 1, i))).normalized();
    line.push_back(s.node(i));
    beside.push_back(s.node(i) + kBeside * d);
  }
  const Vec3 out = line.back() - line[static_cast<size_t>(last - 1)], in = line[0] - line[1];
  const Vec3 away[] = {kFar * out.normalized(), kFar * (out.normalized() + in.normalized() + Vec3(0, 0, 3)), kFar * in.normalized()};
  for (auto* of : {&line, &beside}) {
    const Vec3 first = of->front(), end = of->back();
    of->push_back(end + away[0]), of->push_back(0.5 * (first + end) + away[1]), of->push_back(first + away[2]);
  }
  return toolkit::linking(line.front().data(), static_cast<int>(line.size()), beside.front().data(), static_cast<int>(beside.size()));
}

/// A loop that crosses itself, both ends held, is thrown on itself: its self-linking number stays, step by step. Laid through itself it
/// jumps by 2, and that is a passage.
TEST(KnotGuard, SelfLinkingIsConstantButForPassages) {
  constexpr double kLeg = 6e-3, kRadius = 2e-3, kArc = 1.5 * M_PI * kRadius;
  Laid s(24e-3, 48, "0.01 GPa", kKnot, "", R"(, "first": "fixed", "last": "fixed")");
  ASSERT_TRUE(s.engine);
  const auto lay = [&](double above) {
    s.lay([&](int i) {
      const double at = 0.5e-3 * i, up = above * std::clamp((at - kLeg) / kArc, 0.0, 1.0), turn = (at - kLeg) / kRadius;
      if (at < kLeg) return Vec3(at - kLeg + kRadius, 0, up);
      if (at < kLeg + kArc) return Vec3(kRadius + kRadius * std::sin(turn), kRadius - kRadius * std::cos(turn), up);
      return Vec3(0, kRadius - (at - kLeg - kArc), up);
    });
  };
  lay(60e-6);
  const toolkit::RodState rod = s.rod();
  for (int i = 13; i < 47; ++i) rod.v[3 * i + 2] = -0.3 * std::min(1.0, (i - 12) / 19.0);  // the upper leg comes down on the lower one
  const double before = self_linking(rod);
  EXPECT_NEAR(before, std::round(before), 1e-6);
  double pressed = 0;
  for (int k = 0; k < 60; ++k) {
    s.run(1);
    ASSERT_NEAR(self_linking(s.rod()), before, 1e-6) << k;
    pressed = std::max(pressed, s.signal("contact.force"));
  }
  EXPECT_GT(pressed, 0) << "they touch";
  EXPECT_EQ(s.signal("knot.passages"), 0);

  lay(60e-6);
  s.run(1);
  const double above = self_linking(s.rod()), passages = s.signal("knot.passages");
  lay(-60e-6);
  s.run(1);
  EXPECT_NEAR(std::abs(self_linking(s.rod()) - above), 2, 1e-6);
  EXPECT_EQ(s.signal("knot.passages"), passages + 1);
}

/// Thrown on itself it goes through itself in the free motion of a step, before the contact has stopped it: that is no passage.
TEST(KnotPassage, InFreeMotionIsNotCounted) {
  constexpr double kLeg = 6e-3, kRadius = 2e-3, kArc = 1.5 * M_PI * kRadius;
  for (const double speed : {0.025, 0.03, 0.035, 0.05, 0.1, 0.12, 0.15, 0.2, 0.3, 0.5}) {  // m/s; a step of 1 ms at the first is a diameter of the thread
    Laid s(24e-3, 48, "0.01 GPa", kKnot);
    ASSERT_TRUE(s.engine);
    s.lay([&](int i) {
      const double at = 0.5e-3 * i, up = 60e-6 * std::clamp((at - kLeg) / kArc, 0.0, 1.0), turn = (at - kLeg) / kRadius;
      if (at < kLeg) return Vec3(at - kLeg + kRadius, 0, up);
      if (at < kLeg + kArc) return Vec3(kRadius + kRadius * std::sin(turn), kRadius - kRadius * std::cos(turn), up);
      return Vec3(0, kRadius - (at - kLeg - kArc), up);
    });
    const toolkit::RodState rod = s.rod();
    for (int i = 13; i < 47; ++i) rod.v[3 * i + 2] = -speed * std::min(1.0, (i - 12) / 19.0);
    const double before = self_linking(rod);
    int told = 0;
    double pressed = 0;
    for (int k = 0; k < 60; ++k) {
      s.run(1);
      pressed = std::max(pressed, s.signal("contact.force"));
      for (const judge::Event& e : s.engine->events()) told += s.rig->script.events[e.event].id == "knot.passage";
    }
    EXPECT_GT(pressed, 0) << "they touch";
    EXPECT_NEAR(self_linking(s.rod()), before, 0.2) << "nothing went through";
    EXPECT_EQ(s.signal("knot.passages"), 0) << speed;
    EXPECT_EQ(told, 0) << speed;
  }
}

/// Closed jaws along x with their tips in the origin, and a thread wound about them 2 mm behind the tips.
struct Wound : Laid {
  static constexpr char kJaws[] = R"({"name": "holder", "plugin": "swage.object.jaws", "follows": {"pose": "hand", "closure": "hand"}})";
  static constexpr char kWinding[] = R"({"plugin": "swage.coupling.contact", "between": ["holder", "thread"]}, {"plugin": "swage.coupling.winding", "between": ["holder", "thread"], "params": {"places": 49}})";
  explicit Wound(double closure = 0.7) : Laid(24e-3, 48, "0.01 GPa", std::string(kKnot) + "," + kWinding, kJaws, "", hand(closure)) {}
  static std::string hand(double closure) {
    const std::string path = ::testing::TempDir() + "swage_winding_hand.json";
    std::ofstream(path) << R"({"format": "swage-hand/1", "title": "Rests", "keys": [
        {"t": 0, "p": [0, 0, 0], "axis": [1, 0, 0], "closing": [0, 0, 1], "closure": )" << closure << "}]}";
    return R"({"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")" + path + R"("}})";
  }
  /// The thread comes from -y below, goes round so many times and leaves to +y.
  void lay_turns(double turns, double behind = 2e-3) {
    const double wound = 12e-3, radius = turns == 0 ? 0 : wound / (2 * M_PI * std::abs(turns));
    lay([&](int i) {
      const double s = 0.5e-3 * i - 6e-3;
      if (turns == 0) return Vec3(-behind, s, -1e-3);
      const double a = s / radius * (turns < 0 ? -1 : 1), in = std::clamp(s, 0.0, wound);
      const double x = -behind - 0.05e-3 * in / wound;
      if (s < 0) return Vec3(x, (turns < 0 ? -1 : 1) * s, -radius);
      if (s > wound) return Vec3(x, (turns < 0 ? -1 : 1) * (s - wound), -radius);
      return Vec3(x, radius * std::sin(a), -radius * std::cos(a));
    });
  }
};

// whole turns of a thread about closed jaws, right-handed about the way to the tips; beyond the tips it is not wound
TEST(WindingInScene, IsTold) {
  for (const double turns : {1.0, 2.0, -1.0, 0.0}) {
    Wound s;
    ASSERT_TRUE(s.engine);
    s.lay_turns(turns);
    s.run(1);
    EXPECT_NEAR(s.signal("winding.turns"), turns, turns == 0 ? 0.5 : 0.55) << turns;
    EXPECT_EQ(s.signal("winding.whole"), turns) << turns;
    EXPECT_EQ(s.signal("winding.passages"), 0);
    EXPECT_NEAR(s.signal("winding.behind"), 2e-3, 0.2e-3);
  }
  Wound off;
  ASSERT_TRUE(off.engine);
  off.lay_turns(2, -2e-3);
  off.run(1);
  EXPECT_EQ(off.signal("winding.turns"), 0);
}

// laid from one side of the jaws to the other within a step, as a solver that fails would have it
TEST(WindingInScene, APassageThroughTheInstrumentIsToldOnce) {
  Wound s;
  ASSERT_TRUE(s.engine);
  const auto beside = [&](double z) { s.lay([&](int i) { return Vec3(-2e-3, 0.5e-3 * i - 12.1e-3, z); }); };
  beside(2e-3);
  s.run(1);
  beside(1.8e-3);
  s.run(1);
  EXPECT_EQ(s.signal("winding.passages"), 0);
  const double before = s.signal("winding.turns");
  beside(-1.8e-3);
  s.run(1);
  EXPECT_EQ(s.signal("winding.passages"), 1);
  EXPECT_NEAR(std::abs(s.signal("winding.turns") - before), 1, 0.2);
  int told = 0;
  for (const judge::Event& e : s.engine->events()) told += s.rig->script.events[e.event].id == "winding.passage";
  EXPECT_EQ(told, 1);
}

// jaws open by 9 deg to either side are 1.25 mm from the middle 2 mm behind their tips: what goes from one side to the other between them
// goes through no jaw, what leaves to above goes through the upper one
TEST(WindingInScene, BetweenOpenJawsThereIsNoPassage) {
  Wound s(0);
  ASSERT_TRUE(s.engine);
  const auto beside = [&](double z) { s.lay([&](int i) { return Vec3(-2e-3, 0.5e-3 * i - 12.1e-3, z); }); };
  s.run(300);  // they open
  beside(0.3e-3);
  s.run(1);
  const double before = s.signal("winding.passages");
  beside(-0.3e-3);
  s.run(1);
  EXPECT_EQ(s.signal("winding.passages"), before);
  beside(1e-3);
  s.run(1);
  EXPECT_EQ(s.signal("winding.passages"), before);
  beside(2e-3);
  s.run(1);
  EXPECT_EQ(s.signal("winding.passages"), before + 1);
}

}  // namespace
}  // namespace swage::test
