// SPDX-License-Identifier: Apache-2.0
//
// A thread that is cut by blades, and one that is pulled until it breaks: where, at which force, and what becomes of its parts.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "thread_scene.hpp"

namespace {

using namespace swage;
using test::ThreadScene;
using toolkit::Vec3;

constexpr double kG = 9.80665;      // m/s2
constexpr double kLine = 4.333e-7;  // kg/m, of 10-0 nylon
constexpr double kLength = 20e-3, kSegment = kLength / 40;  // m

std::string hand_file(const std::string& keys) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string hand = testing::TempDir() + "cut_" + info->name() + ".json";
  std::ofstream(hand) << R"({"format": "swage-hand/1", "title": "T", "keys": [)" << keys << "]}";
  return R"({"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")" + hand + R"("}})";
}

/// A thread hangs from the origin; scissors come together around it 8 mm below, 0.6 mm behind their tips.
struct Scissors {
  std::string jaws = R"("blades": true)", keys = R"(, {"t": "0.3 s"}, {"t": "0.6 s", "closure": 0.59}, {"t": "1.8 s", "closure": 0.62}, {"t": "2 s"})";

  ThreadScene scene() const {
    const std::string at = R"("p": ["0.6 mm", 0, "-8 mm"])";
    const std::string hand =
        hand_file(R"({"t": "0 s", )" + at + R"(, "axis": [1, 0, 0], "closing": [0, 1, 0], "closure": 0})" + keys);
    return {R"({"name": "thread", "plugin": "swage.object.thread", "params": {"start": "hanging", "first": "fixed", "memory": 0,
                "strength": 0.1, "length": "20 mm", "segments": 40}},
               {"name": "scissors", "plugin": "swage.object.jaws", "follows": {"pose": "hand", "closure": "hand"},
                "pose": {)" + at + R"(, "rpy": ["-90 deg", 0, 0]}, "params": {)" + jaws + "}}",
            R"({"name": "cut", "plugin": "swage.coupling.cut", "between": ["scissors", "thread"]})", hand};
  }
};

/// Steps until a signal is no longer 0; the greatest value of another one as far as that, and in that step.
double greatest_until(ThreadScene& s, const std::string& end, const std::string& of, int steps) {
  double most = 0;
  for (int i = 0; i < steps && s.signal(end) == 0; ++i) {
    s.run(1);
    most = std::max(most, s.signal(of));
  }
  return most;
}

TEST(Cut, PartsWhatBothBladesPress) {
  ThreadScene s = Scissors().scene();
  ASSERT_TRUE(s.engine);
  s.run(300);
  const double whole = kLine * kLength * kG;
  EXPECT_NEAR(s.signal("thread.tension_first"), whole, 0.03 * whole);
  const double force = greatest_until(s, "cut.cuts", "cut.force", 1700);
  ASSERT_EQ(s.signal("cut.cuts"), 1);
  EXPECT_GE(force, 0.6 * 0.1) << "0.6 of its strength, and not before";
  EXPECT_LT(force, 0.6 * 0.1 * 1.2) << "and in that step";
  s.run(1);
  EXPECT_EQ(s.signal("thread.parted"), 1);
  int parted = -1;
  for (uint32_t j = 0; j < 40; ++j)
    if (s.chain().radius(j) == 0) parted = static_cast<int>(j);
  EXPECT_NEAR((parted + 0.5) * kSegment, 8e-3, 1.01 * kSegment) << "where the blades are";
  // they open: what is tied hangs on with its own weight, what was cut off falls
  s.run(400);
  EXPECT_EQ(s.signal("cut.cuts"), 1) << "closed blades do not go on to cut beside it";
  EXPECT_EQ(s.troubles(), "");
}

TEST(Cut, OpenedAgainThePartsGoOnByThemselves) {
  Scissors opens;
  opens.keys += R"(, {"t": "2.3 s", "closure": 0}, {"t": "2.4 s"})";
  ThreadScene s = opens.scene();
  ASSERT_TRUE(s.engine);
  s.run(3000);
  ASSERT_EQ(s.signal("cut.cuts"), 1);
  uint32_t parted = 0;
  while (parted < 39 && s.chain().radius(parted) != 0) ++parted;
  const double left = kLine * kG * (parted + 0.5) * kSegment;
  EXPECT_NEAR(s.signal("thread.tension_first"), left, 0.06 * left) << "half of the segment that was cut still hangs on";
  EXPECT_LT(s.chain().p(parted + 1).z(), -0.1) << "fell";
  EXPECT_GT(s.chain().p(parted).z(), -9e-3) << "hangs";
  EXPECT_EQ(s.troubles(), "");
}

TEST(Cut, WhatHasNoBladesHoldsIt) {
  for (const char* const jaws : {R"("blades": false)", R"("blades": true, "shear": 100)"}) {
    Scissors holder;
    holder.jaws = jaws;
    // 0.8 N, eight times what blades need; above 1 N jaws of 1e5 N/m press the thread by its radius, and it slips out
    holder.keys = R"(, {"t": "0.3 s"}, {"t": "0.8 s", "closure": 0.75}, {"t": "1 s"})";
    ThreadScene s = holder.scene();
    ASSERT_TRUE(s.engine);
    s.run(1000);
    EXPECT_GT(s.signal("cut.force"), 0.7) << jaws << ": blades would have cut";
    EXPECT_EQ(s.signal("cut.cuts"), 0) << jaws;
    EXPECT_EQ(s.signal("thread.parted"), 0) << jaws;
  }
}

/// Drawn out between a fixed end and a needle: the tension of the law EA strain, as far as its strength; then at one place nothing.
TEST(Break, WhereTheTensionPassesItsStrength) {
  constexpr double kStrength = 20e-3, kSpeed = 0.5e-3;  // N, m/s
  const std::string hand = hand_file(
      R"({"t": "0 s", "p": [0, 0, 0], "axis": [1, 0, 0], "closing": [0, 0, 1], "closure": 0}, {"t": "0.2 s"},
         {"t": "2.2 s", "p": ["-1 mm", 0, 0], "axis": [1, 0, 0], "closing": [0, 0, 1]})");
  ThreadScene s(R"({"name": "thread", "plugin": "swage.object.thread", "pose": {"p": ["-0.25 mm", 0, 0]},
                    "params": {"last": "fixed", "memory": 0, "strength": 0.02, "length": "20 mm", "segments": 40}},
                   {"name": "needle", "plugin": "swage.object.needle", "pose": {"p": ["-2.5 mm", "2.5 mm", 0], "rpy": [0, 0, "180 deg"]},
                    "params": {"arc": "4/8", "size": "5 mm"}},
                   {"name": "holder", "plugin": "swage.object.jaws", "follows": {"pose": "hand"}})",
                R"({"plugin": "test.coupling.leash", "between": ["holder", "needle"], "params": {"stiffness": "2e4 N/m"}},
                   {"name": "end", "plugin": "swage.coupling.swage", "between": ["needle", "thread"], "params": {"depth": "0.25 mm"}})",
                hand);
  ASSERT_TRUE(s.engine);
  const double tension = greatest_until(s, "thread.parted", "swage.tension", 2200);
  ASSERT_EQ(s.signal("thread.parted"), 1) << "one break, though every segment bears the same";
  // in a step the hand draws on by half a micrometre: 24 uN of 10-0 nylon, and at most three times that in the middle of its way
  EXPECT_NEAR(tension, kStrength, 0.02 * kStrength + 3 * kSpeed * 1e-3 * 0.95 / kLength);
  s.run(300);
  EXPECT_EQ(s.signal("thread.parted"), 1);
  EXPECT_LT(s.signal("swage.tension"), 0.2 * kStrength) << "slack";
  EXPECT_EQ(s.signal("swage.attached"), 1);
}

}  // namespace
