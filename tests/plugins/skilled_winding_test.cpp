// SPDX-License-Identifier: Apache-2.0
//
// The hand with eyes winds about another gripper and keeps the thread drawn.
#include "fake_objects.hpp"
#include "skilled_hand.hpp"

namespace swage::skilled {
namespace {

// five quarters of a circle about the line x through (y, z) = (0, 2 mm), from 3 mm above it to 3 mm before it
TEST_F(SkilledHand, WindsAboutAnotherGripper) {
  stage::FakeGripper other;
  other.state.tip_W = {8e-3, 0, 2e-3};
  make(R"({"act": "wind", "about": "holder", "turns": 1.25, "along": "0.4 mm", "time": "1 s"})");
  objects_[0].instance = &other.raw;
  ASSERT_EQ(bind(), SWAGE_OK);
  double off = 0;
  for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) {
    step();
    off = std::max(off, std::abs(std::hypot(X_WT_.p.y(), X_WT_.p.z() - 2e-3) - 3e-3));
  }
  EXPECT_LT(off, 1e-12);
  EXPECT_LT((X_WT_.p - Vec3(8.4e-3, -3e-3, 2e-3)).norm(), 1e-9);
  EXPECT_LT((X_WT_.q * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-9) << "it does not turn";
}

// by `in` it comes nearer on a spiral, and never into the other gripper
TEST_F(SkilledHand, ComesNearerWhileItWinds) {
  stage::FakeGripper other;
  other.state.tip_W = {8e-3, 0, 2e-3};
  for (const auto& [in, left] : {std::pair{"2 mm", 1e-3}, {"9 mm", 0.5e-3}}) {
    make(std::string(R"({"act": "wind", "about": "holder", "turns": 1.25, "in": ")") + in + R"(", "time": "1 s"})");
    objects_[0].instance = &other.raw;
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    double before = 3e-3;
    for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) {
      step();
      const double r = std::hypot(X_WT_.p.y(), X_WT_.p.z() - 2e-3);
      EXPECT_LE(r, before + 1e-12);
      before = r;
    }
    EXPECT_LT((X_WT_.p - Vec3(8e-3, -left, 2e-3)).norm(), 1e-9) << in;
  }
}

// a thread that gets shorter draws, one that gets slack is drawn
TEST_F(SkilledHand, KeepsWhatItWindsDrawn) {
  stage::FakeGripper other;
  other.state.tip_W = {8e-3, 0, 2e-3};
  for (const double pull : {0.0, 0.15, 0.3}) {
    make(R"({"act": "wind", "about": "holder", "turns": 0, "of": "grasp", "signal": "grasp.force", "more": 0.1, "less": 0.2, "by": "1 mm", "time": "1 s"})");
    objects_[0].instance = &other.raw;
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) force_ = pull, step();
    EXPECT_NEAR(X_WT_.p.z() - 2e-3, 3e-3 + (pull < 0.1 ? 1e-3 : pull > 0.2 ? -1e-3 : 0), 5e-6) << pull;
  }
}

// A taut thread of 200 N/m: a hand that went at 20 mm/s whenever it feels too little or too much would go to and fro by 20 um, a millisecond each.
TEST_F(SkilledHand, ComesToRestOnATautThread) {
  constexpr double kStiffness = 200;  // N/m
  stage::FakeGripper other;
  other.state.tip_W = {8e-3, 0, 2e-3};
  make(R"({"act": "wind", "about": "holder", "turns": 0, "of": "grasp", "signal": "grasp.force", "more": 0.0005, "less": 0.002, "by": "20 mm", "time": "2 s"})");
  objects_[0].instance = &other.raw;
  ASSERT_EQ(bind(), SWAGE_OK);
  const double taut = 5.05e-3;  // m, it begins at 5 mm
  double before = 5e-3, farthest = 0, felt = 0, most = 0;
  for (int i = 0; i < 1500; ++i) {
    force_ = felt = std::max(0.0, kStiffness * (X_WT_.p.z() - taut));
    step();
    if (i > 500) farthest = std::max(farthest, std::abs(X_WT_.p.z() - before)), most = std::max(most, felt);
    before = X_WT_.p.z();
  }
  EXPECT_LT(farthest, 2e-6);
  EXPECT_LT(most, 4e-3);
  EXPECT_GT(felt, 0);
}

// the fingers roll the tool, whose shaft keeps its direction
TEST_F(SkilledHand, RollsAboutItsOwnAxisWhileItWinds) {
  stage::FakeGripper other;
  other.state.tip_W = {8e-3, 0, 2e-3};
  make(R"({"act": "wind", "about": "holder", "turns": 0.5, "roll": "-90 deg", "time": "1 s"})");
  objects_[0].instance = &other.raw;
  ASSERT_EQ(bind(), SWAGE_OK);
  for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) step();
  // it began with its axis along -z and closing along y
  EXPECT_LT((X_WT_.q * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((X_WT_.q * Vec3::UnitZ() + Vec3::UnitX()).norm(), 1e-9);
}

// where the other one goes it goes, too, and nowhere without "follows"
TEST_F(SkilledHand, FollowsTheOtherGripperWhileItWinds) {
  for (const bool follows : {true, false}) {
    stage::FakeGripper other;
    other.state.tip_W = {8e-3, 0, 2e-3};
    make(std::string(R"({"act": "wind", "about": "holder", "turns": 0, "follows": )") + (follows ? "true" : "false") + R"(, "time": "1 s"})");
    objects_[0].instance = &other.raw;
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    step();
    const Vec3 before = X_WT_.p;
    other.state.tip_W = {9e-3, -1e-3, 2.5e-3};
    for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) step();
    EXPECT_LT((X_WT_.p - before - (follows ? Vec3(1e-3, -1e-3, 0.5e-3) : Vec3(Vec3::Zero()))).norm(), 1e-9) << follows;
  }
}

// what a look at a signal finds undone is done once more: 1 mm each time, until it has come
TEST_F(SkilledHand, DoesAgainWhatASignalSaysIsUndone) {
  for (const int times : {1, 3}) {
    make(R"({"act": "move", "by": ["1 mm", "0 mm", "0 mm"], "time": "0.1 s"},
            {"act": "again", "from": 0, "of": "grasp", "signal": "grasp.force", "less": 0.5, "time": "0.02 s"},
            {"act": "move", "by": ["0 mm", "2 mm", "0 mm"], "time": "0.1 s"})");
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;)
      force_ = X_WT_.p.x() > 8e-3 + (times - 0.5) * 1e-3 ? 1 : 0, step();
    EXPECT_LT((X_WT_.p - Vec3(8e-3 + times * 1e-3, 2e-3, 5e-3)).norm(), 1e-9) << times;
  }
}

// acts that a signal makes needless are left out: what is held is not taken once more
TEST_F(SkilledHand, LeavesOutWhatASignalSaysIsDone) {
  for (const bool done : {false, true}) {
    make(R"({"act": "again", "from": 2, "of": "grasp", "signal": "grasp.force", "more": 0.5, "time": "0.02 s"},
            {"act": "move", "by": ["1 mm", "0 mm", "0 mm"], "time": "0.1 s"},
            {"act": "move", "by": ["0 mm", "2 mm", "0 mm"], "time": "0.1 s"})");
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) force_ = done ? 1 : 0, step();
    EXPECT_LT((X_WT_.p - Vec3(done ? 8e-3 : 9e-3, 2e-3, 5e-3)).norm(), 1e-9) << done;
  }
}

// to an attitude, on the shortest turn
TEST_F(SkilledHand, TurnsWhileItMoves) {
  make(R"({"act": "move", "by": ["1 mm", "0 mm", "0 mm"], "axis": [0, 0, -1], "closing": [0, 1, 0], "time": "1 s"})");
  ASSERT_EQ(bind(), SWAGE_OK);
  for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 5000;) step();
  EXPECT_LT((X_WT_.q * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((X_WT_.q * Vec3::UnitZ() - Vec3::UnitY()).norm(), 1e-9);
}

}  // namespace
}  // namespace swage::skilled
