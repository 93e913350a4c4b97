// SPDX-License-Identifier: Apache-2.0
//
// The hand with eyes: what a plan may say, and that each act ends where its word says.
#include "devices/hand/sentences.hpp"
#include "devices/skilled/sentences.hpp"
#include "devices/skilled/wrist.hpp"
#include "skilled_hand.hpp"

namespace swage::skilled {
namespace {

std::string message(const std::string& acts) {
  try {
    parse_plan(
        R"({"format": "swage-plan/1", "start": {"p": [0, 0, 0], "axis": [1, 0, 0], "closing": [0, 0, 1]}, "acts": [)" +
            acts + "]}",
        "plan.json");
  } catch (const std::runtime_error& problem) {
    return problem.what();
  }
  return "nothing was wrong";
}

TEST(Plan, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(message(R"({"act": "wait", "time": "1 s"})"), "nothing was wrong");
  EXPECT_EQ(message(R"({"act": "jump"})"),
            "plan.json #/acts/0/act: " + say::kNoAct("jump", "again, aim, answer, await, back, bring, choose, "
                                                            "close, draw, drive, move, open, reach, show, wait, wind"));
  EXPECT_EQ(message(R"({"act": "drive"})"), "plan.json #/acts/0: " + say::kMissing("angle"));
  EXPECT_EQ(message(R"({"act": "drive", "angle": "3 mm"})"),
            "plan.json #/acts/0/angle: " + hand::say::kOtherMeasure("3 mm", hand::say::kAngle()));
  EXPECT_EQ(message(R"({"act": "wait", "s": 0.5})"),
            "plan.json #/acts/0/s: " + say::kUnknownKey("time"));
  EXPECT_EQ(message(R"({"act": "wait", "time": 0})"), "plan.json #/acts/0/time: " + say::kTakesTime());
  EXPECT_EQ(message(R"({"act": "reach", "s": 2, "from": [1, 0, 0]})"),
            "plan.json #/acts/0/s: " + say::kPlaceOnNeedle());
  EXPECT_EQ(message(R"({"act": "reach", "s": 0.5, "from": [0, 0, 0]})"),
            "plan.json #/acts/0/from: " + say::kNoDirection());
  EXPECT_EQ(message(R"({"act": "wait"}, {"act": "again", "from": 1})"),
            "plan.json #/acts/1/from: " + say::kEarlierAct());
  EXPECT_EQ(message(R"({"act": "show", "mark": "m", "at": [0, 0, 0], "with": "feet", "across": [1, 0, 0]})"),
            "plan.json #/acts/0/with: " + say::kWithWhat());
  for (const char* wrong : {R"({"act": "await"})", R"({"act": "await", "of": "g", "signal": "x", "less": 1, "mark": "m", "s": 0.5})"})
    EXPECT_NE(message(wrong).find(say::kAwaited()), std::string::npos);
  EXPECT_EQ(message(R"({"act": "wind", "about": "holder", "turns": 1, "signal": "contact.force"})"),
            "plan.json #/acts/0: " + say::kDrawn());
  for (const char* wrong : {R"({"act": "wait"}, {"act": "again", "from": 0, "of": "g", "signal": "x"})",
                            R"({"act": "wait"}, {"act": "again", "from": 0, "less": 1})"})
    EXPECT_EQ(message(wrong), "plan.json #/acts/1: " + say::kGoesOn());
  EXPECT_EQ(message(R"({"act": "move", "by": ["1 mm", 0, 0], "axis": [1, 0, 0], "closing": [0, 1, 0], "roll": "90 deg"})"),
            "plan.json #/acts/0: " + say::kRollOrTurn());
  EXPECT_THROW(parse_plan("[]", "x"), std::runtime_error);
  EXPECT_THROW(load_plan("/no/such/plan.json"), std::runtime_error);
}

TEST(Wire, ItsCircleIsFoundFromTwoPlaces) {
  for (const double normal : {1.0, -1.0}) {
    Place a = Half::at(0.4), b = Half::at(0.6);
    a.normal_W *= normal;
    const Wire wire = Wire::through(a, b);
    EXPECT_NEAR(wire.radius(), Half::kRadius, 1e-15);
    EXPECT_LT(wire.centre_W.norm(), 1e-15);
    EXPECT_LT((wire.axis_W - Vec3::UnitZ()).norm(), 1e-12);
    for (const double s : {0.0, 0.3, 1.0}) {
      EXPECT_LT((wire.place(s).p_W - Half::at(s).p_W).norm(), 1e-15);
      EXPECT_LT((wire.place(s).tangent_W - Half::at(s).tangent_W).norm(), 1e-12);
    }
  }
  // a straight thing is a very large circle, not a division by zero
  const Wire straight = Wire::through({0.5, 0.01, Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ()},
                                      {0.7, 0.01, Vec3(2e-3, 0, 0), Vec3::UnitX(), Vec3::UnitZ()});
  EXPECT_NEAR(straight.place(0).p_W.x(), -5e-3, 1e-6);
}

const std::string kGrasp = R"({"act": "reach", "s": 0.6, "back": "3 mm", "from": [0, 0, 1], "time": "0.5 s"},
    {"act": "reach", "s": 0.6, "past": "0.4 mm", "from": [0, 0, 1], "time": "0.5 s"},
    {"act": "close", "force": "0.6 N", "time": "0.5 s"})";

TEST_F(SkilledHand, ReachesSquareAndClosesToTheForce) {
  make(kGrasp);
  ASSERT_EQ(bind(), SWAGE_OK);
  run();
  const Place spot = needle_at(0.6);
  EXPECT_LT((X_WT_ * Vec3(-0.4e-3, 0, 0) - spot.p_W).norm(), 1e-9);
  EXPECT_NEAR((X_WT_.q * Vec3::UnitX()).dot(spot.normal_W), -1,
              1e-9);  // along the normal of its plane, from +z
  EXPECT_NEAR(std::abs((X_WT_.q * Vec3::UnitY()).dot(spot.tangent_W)), 1, 1e-9);  // closing along its radius
  EXPECT_NEAR(force_, 0.6, 0.01);
}

TEST_F(SkilledHand, AimsAndDrivesTheNeedleThroughTheMarkAlongItself) {
  make(
      kGrasp +
      R"(, {"act": "aim", "mark": "target.point", "into": [0, 0.6, -0.8], "across": [1, 0, 0], "hover": "0.5 mm",
                      "time": "1 s"}, {"act": "drive", "angle": "60 deg", "time": "1 s"})");
  ASSERT_EQ(bind(), SWAGE_OK);
  const Vec3 mark = vec(mark_), into(0, 0.6, -0.8);
  double nearest = 1, square = 0, off_circle = 0;
  Vec3 centre = Vec3::Zero();
  bool driving = false;
  for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0;) {
    step();
    if (n_ == 2600) centre = X_WN_ * Vec3::Zero(), driving = true;
    if (!driving) continue;
    // the needle stays on its own circle all the way, and passes the mark along the direction
    off_circle = std::max(off_circle, (X_WN_ * Vec3::Zero() - centre).norm());
    const Place point = needle_at(0);
    if ((point.p_W - mark).norm() < nearest)
      nearest = (point.p_W - mark).norm(), square = -point.tangent_W.dot(into);
  }
  EXPECT_LT(off_circle, 1e-9);
  EXPECT_LT(nearest, 5e-6);  // within half the way of one step
  EXPECT_GT(square, 0.9999);
  EXPECT_NEAR(std::abs(needle_at(0).normal_W.x()), 1, 1e-9);
}

// Lifted, it comes down by as much as it begins to turn: about a lifted centre the needle would cross the surface at 0.06/2 rad
TEST_F(SkilledHand, FromAboveItComesDownAsItTurns) {
  for (const double lean : {0.0, 0.2, -0.2}) {
    make(
        kGrasp +
            R"(, {"act": "aim", "mark": "target.point", "into": [0, 0.6, -0.8], "across": [1, 0, 0], "above": "0.06 mm",
                      "time": "1 s"}, {"act": "drive", "angle": "60 deg", "time": "1 s"})",
        {{"lean", lean}});
    held_ = false;
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    run();
    // the circle crosses the plane through the mark at an angle whose cosine is its centre's height over the radius
    const Vec3 to_centre = X_WN_ * Vec3::Zero() - vec(mark_), into(0, 0.6, -0.8);
    EXPECT_NEAR(std::abs(to_centre.dot(into)), Half::kRadius * std::sin(std::abs(lean)), 1e-8) << lean;
    EXPECT_NEAR(to_centre.norm(), Half::kRadius, 1e-8) << "and at the mark";
  }
}

TEST_F(SkilledHand, AimsByWhereThePointIsAndNotByWhatTheJawsHold) {
  make(
      kGrasp +
      R"(, {"act": "aim", "mark": "target.point", "into": [0, 0.6, -0.8], "across": [1, 0, 0], "inside": "0.1 mm",
                      "time": "1 s"})");
  kink_ = 0.1;  // extrapolated from the jaws its point would be 0.2 mm off
  ASSERT_EQ(bind(), SWAGE_OK);
  run();
  const Place point = needle_at(0);
  EXPECT_NEAR(-point.tangent_W.dot(Vec3(0, 0.6, -0.8)), 1, 1e-9);
  const Vec3 way = point.p_W - vec(mark_);
  EXPECT_NEAR(way.norm(), 0.1e-3, 1e-9) << "so much inside of the mark";
  EXPECT_GT(way.dot(needle_at(0.2).p_W - point.p_W), 0) << "on the side to which it curves";
}

TEST_F(SkilledHand, ASteadyOneBringsBackANeedleThatLeavesWhereItWentIn) {
  const Vec3 drift(0, 40e-6, 0);
  // where it is swallowed up to its blunt end nothing passes any more
  for (const auto& [steady, s] : {std::pair{0.0, 0.1}, {0.2, 0.1}, {0.2, 1.0}}) {
    make(R"({"act": "drive", "angle": "0 deg", "time": "1 s"})", {{"steady", steady}});
    held_ = true;
    pierces_ = true;
    signal_ = {0, s, 1e-3, 2e-3, 3e-3};
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    const Vec3 start(8e-3, 0, 5e-3);
    X_WT_.p = start;
    X_TN_ = Pose(Vec3(0, 0, 0), Quat::Identity());
    while (n_ < 1000) {
      // the needle passes where the hand leads it, and 40 um aside
      const Vec3 at = Vec3(1e-3, 2e-3, 3e-3) + drift + X_WT_.p - start;
      for (int i = 0; i < 3; ++i) signal_[5 + static_cast<size_t>(i)] = at[i];
      step();
    }
    const Vec3 left = drift + X_WT_.p - start;
    EXPECT_NEAR(left.norm(), steady > 0 && s < 1 ? 40e-6 * std::exp(-5) : 40e-6, 0.1e-6);
  }
  pierces_ = false;
  make(kGrasp, {{"steady", 0.2}});
  EXPECT_LT(bind(), 0) << "nothing tells where it goes in";
}

TEST_F(SkilledHand, ShowsTheNeedlePointingToTheMarkWheneverThatMoves) {
  make(
      kGrasp +
      R"(, {"act": "show", "mark": "target.point", "at": [0, 0, "5 mm"], "with": "needle", "across": [0, 1, 0],
                      "time": "0.2 s"}, {"act": "again", "from": 3})");
  mark_ = {0, 0, 0};
  ASSERT_EQ(bind(), SWAGE_OK);
  while (n_ < 2500) step();
  const Pose before = X_WN_;
  while (n_ < 2600) step();
  EXPECT_EQ((X_WN_.p - before.p).norm(), 0) << "the mark has not moved yet";
  for (const double x : {0.3, -0.2}) {
    mark_ = {x, 0, -1};
    for (const int end = n_ + 250; n_ < end;) step();
    const Place point = needle_at(0);
    EXPECT_LT((point.p_W - Vec3(0, 0, 5e-3)).norm(), 1e-9);
    EXPECT_GT(-point.tangent_W.dot((vec(mark_) - Vec3(0, 0, 5e-3)).normalized()), 1 - 1e-12);
    EXPECT_NEAR(std::abs(point.normal_W.y()), 1, 1e-9);
  }
}

TEST_F(SkilledHand, AnswersOnceTheMarksPartAndToTheSideThatItSees) {
  for (const double bias : {0.0, 0.6}) {
    make(
        R"({"act": "answer", "mark": "target.point", "other": "other.point", "of": "needle", "time": "0.2 s"},
            {"act": "close", "closure": 0.65, "time": "0.1 s"})",
        {{"angle_bias", bias}});
    // its point leads up and to -y by 0.3
    const Pose X_leaning{Vec3(2e-3, 0, 0), toolkit::exp_rotation({0.5 * kPi + 0.3, 0, 0})};
    X_WN_ = X_leaning;
    two_marks_ = true;
    n_ = 0;
    held_ = true;
    other_ = mark_;
    ASSERT_EQ(bind(), SWAGE_OK);
    X_TN_ = Pose(Vec3(0, 0, 0), Quat::Identity());
    for (; n_ < 300; X_WN_ = X_leaning) step();
    EXPECT_LT((X_WT_.p - Vec3(8e-3, 0, 5e-3)).norm(), 1e-12) << "nobody has asked yet";
    other_ = {mark_.x, mark_.y - 2e-3, mark_.z};
    const Vec3 up = needle_at(0).tangent_W;
    for (const int end = n_ + 250; n_ < end; X_WN_ = X_leaning) step();
    const bool other = std::asin(-up.y()) + bias > 0;
    EXPECT_LT((X_WT_.p - vec(other ? other_ : mark_)).norm(), 1e-9);
    EXPECT_EQ(other, bias > 0 || -up.y() > 0);
  }
}

TEST_F(SkilledHand, ChoosesTheMarkThatASignalCounts) {
  for (const double which : {1.0, 2.0}) {
    make(R"({"act": "choose", "mark": "target.point", "of": "grasp", "signal": "grasp.force", "among": ["target.point", "other.point"], "time": "0.2 s"})");
    two_marks_ = true;
    other_ = {mark_.x, mark_.y - 2e-3, mark_.z};
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    while (n_ < 250) force_ = which, step();
    EXPECT_LT((X_WT_.p - vec(which == 2 ? other_ : mark_)).norm(), 1e-9) << which;
  }
}

TEST_F(SkilledHand, FlawsAreWhatTheySay) {
  for (const char* flaw : {"lean", "side_lean"}) {
    make(
        kGrasp +
            R"(, {"act": "aim", "mark": "target.point", "into": [0, 0, -1], "across": [1, 0, 0], "time": "1 s"})",
        {{flaw, 0.2}});
    held_ = false;
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    run();
    const Place point = needle_at(0);
    EXPECT_NEAR(std::acos(point.tangent_W.z()), 0.2, 1e-9) << flaw;
    EXPECT_LT((point.p_W - vec(mark_)).norm(), 1e-9);
    // in the needle's plane, which stays upright, or with it
    EXPECT_NEAR(std::abs(point.normal_W.z()), flaw == std::string("lean") ? 0 : std::sin(0.2), 1e-9);
  }
}

const std::string kAim =
    R"(, {"act": "aim", "mark": "target.point", "into": [0, 0, -1], "across": [0, 1, 0], "time": "0.5 s"})";

/// The wrist that the device has with {"wrist": right} and a range of its forearm's rotation.
Wrist right_wrist(double rotation) {
  constexpr double kDeg = kPi / 180;
  return Wrist({.forearm_W = Vec3(-1, 1, 0),
                .swing = 60 * kDeg,
                .hold = 90 * kDeg,
                .ease = 0.65,
                .range = {Wrist::Range{-rotation, rotation}, {-70 * kDeg, 80 * kDeg}, {-20 * kDeg, 30 * kDeg}}});
}

TEST_F(SkilledHand, AWristAimsAtTheMarkAndLeansByWhatItDoesNotTurn) {
  make(kGrasp + kAim);
  ASSERT_EQ(bind(), SWAGE_OK);
  run();
  const Quat one = X_WT_.q, other = toolkit::exp_rotation({0, 0, kPi}) * one;
  for (const double rotation : {179.0, 40.0}) {
    make(kGrasp + kAim, {{"wrist", 1}, {"rotation", std::vector<double>{-rotation * kPi / 180, rotation * kPi / 180}}});
    X_WN_ = {Vec3(1e-3, 0, 0), toolkit::exp_rotation({0.3, -0.2, 0.5})};
    held_ = false;
    n_ = 0;
    ASSERT_EQ(bind(), SWAGE_OK);
    run();
    const Wrist wrist = right_wrist(rotation * kPi / 180);
    const Quat asked = wrist.strain(wrist.asked(one)) <= wrist.strain(wrist.asked(other)) ? one : other;
    EXPECT_LT(X_WT_.q.angularDistance(wrist.given(asked)), 1e-9) << rotation;
    EXPECT_LT((needle_at(0).p_W - vec(mark_)).norm(), 1e-9) << "the point is where it is to go in";
    const double lean = X_WT_.q.angularDistance(asked);
    EXPECT_EQ(lean > 0.05, rotation < 100) << lean;
  }
}

TEST_F(SkilledHand, AWristNeedsAForearmAndRangesToBothSides) {
  make(kGrasp);
  Stage stage("swage.device.skilled");
  stage.configure({{"file", path_}, {"wrist", 1}, {"rotation", std::vector<double>{0.1, 0.5}}, {"forearm", std::vector<double>{0, 0, 1}}});
  EXPECT_EQ(stage.errors, (std::vector<std::string>{"forearm: " + say::kForearm(), "rotation: " + say::kRange()}));
}

TEST_F(SkilledHand, SaysWhatItCannotFind) {
  make(R"({"act": "bring", "mark": "other.point", "s": 0.5})");
  EXPECT_LT(bind(), 0);
  make(kGrasp);
  EXPECT_LT(bind(false), 0);
  make(R"({"act": "aim", "mark": "target.point", "into": "skin", "across": [1, 0, 0]})");
  EXPECT_LT(bind(), 0);
  for (const char* about : {"nobody", "needle"}) {
    make(std::string(R"({"act": "wind", "turns": 1, "about": ")") + about + "\"}");
    EXPECT_LT(bind(), 0) << about;
  }
}

TEST_F(SkilledHand, ANewAttemptBeginsAtTheBeginning) {
  make(kGrasp);
  ASSERT_EQ(bind(), SWAGE_OK);
  run();
  n_ = 0;
  held_ = false;
  step();
  EXPECT_LT((X_WT_.p - Vec3(8e-3, 0, 5e-3)).norm(), 1e-12);
  EXPECT_EQ(sample_.valid & SWAGE_VALID_DONE, 0u);
}

}  // namespace
}  // namespace swage::skilled
