// SPDX-License-Identifier: Apache-2.0
//
// Hands on file: reading, messages, minimum-jerk motion, tremor.
#include "hand/hand.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hand/sentences.hpp"
#include "hand/tremor.hpp"

namespace swage::hand {
namespace {

Hand keys(const std::string& list) {
  return parse_hand(R"({"format": "swage-hand/1", "title": "t", "keys": [)" + list + "]}", "hand.json");
}

std::string message(const std::string& list) {
  try {
    keys(list);
  } catch (const std::runtime_error& problem) {
    return problem.what();
  }
  return "nothing was wrong";
}

TEST(HandFile, UnitsAndWhatIsLeftOut) {
  const Hand hand = keys(R"({"t": "0 s", "p": ["-12 mm", "500 um", 0.006], "closure": 0.25},
                            {"t": "1500 ms", "rpy": ["0 deg", "90 deg", "0 deg"]})");
  ASSERT_EQ(hand.keys.size(), 2u);
  EXPECT_LT((hand.keys[0].X_WT.p - Vec3(-12e-3, 0.5e-3, 6e-3)).norm(), 1e-18);
  EXPECT_DOUBLE_EQ(hand.keys[1].t, 1.5);
  EXPECT_EQ(hand.keys[1].X_WT.p, hand.keys[0].X_WT.p);
  EXPECT_EQ(hand.keys[1].closure, 0.25);
  // pitched by 90 deg about y, the x axis looks down
  EXPECT_LT((hand.keys[1].X_WT.q * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_FALSE(hand.has_grip);
}

TEST(HandFile, AxisAndClosing) {
  const Hand hand = keys(R"({"t": 0, "p": [0, 0, 0], "axis": [0, 0, -2], "closing": [1, 0, 5]})");
  const Quat q = hand.keys[0].X_WT.q;
  EXPECT_LT((q * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((q * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((q * Vec3::UnitY() - (q * Vec3::UnitZ()).cross(q * Vec3::UnitX())).norm(), 1e-12);
}

TEST(HandFile, RollPitchYawTurnAboutFixedAxesInThisOrder) {
  const Hand hand = keys(R"({"t": 0, "p": [0, 0, 0], "rpy": ["90 deg", "0 deg", "90 deg"]})");
  // y rolls up to z and stays there; x yaws to y
  EXPECT_LT((hand.keys[0].X_WT.q * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((hand.keys[0].X_WT.q * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-12);
}

TEST(HandFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, "3 N"]})"),
            "hand.json #/keys/0/p/2: " + say::kOtherMeasure("3 N", say::kLength()));
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, "3"]})"),
            "hand.json #/keys/0/p/2: " + say::kOtherMeasure("3", say::kLength()));
  EXPECT_EQ(message(R"({"t": 1, "p": [0, 0, 0]}, {"t": 1})"),
            "hand.json #/keys/1: " + say::kTimesRise());
  EXPECT_EQ(message(R"({"t": 0})"), "hand.json #/keys/0: " + say::kNoPlace());
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0], "closure": 1.5})"),
            "hand.json #/keys/0: " + say::kClosure());
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0], "axis": [1, 0, 0]})"),
            "hand.json #/keys/0: " + say::kTogether());
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0], "axis": [1, 0, 0], "closing": [2, 0, 0]})"),
            "hand.json #/keys/0: " + say::kSameDirection());
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0], "closed": 1})"),
            "hand.json #/keys/0/closed: " + say::kKeyHas());
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0]}, {"t": 1, "p": [0, 0, 0],
                        "turn": {"about": [0, 0, 0], "axis": [0, 0, 1], "angle": 1}})"),
            "hand.json #/keys/1: " + say::kTurnOr("p"));
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0]}, {"t": 1, "turn": {"about": [0, 0, 0], "angle": 1}})"),
            "hand.json #/keys/1/turn: " + say::kTurn());
  EXPECT_EQ(message(R"({"t": 0, "p": [0, 0, 0], "turn": {}})"),
            "hand.json #/keys/0/turn: " + say::kFirstTurns());
  EXPECT_THROW(parse_hand("{}", "x"), std::runtime_error);
  EXPECT_THROW(parse_hand("{", "x"), std::runtime_error);
  EXPECT_THROW(load_hand("/no/such/file.json"), std::runtime_error);
}

TEST(HandFile, SamplesComeOutAsTheyWentIn) {
  const Hand hand = parse_hand(R"({"format": "swage-hand/1",
      "samples": [[0, 0.1, 0.2, 0.3, 0.6, 0, 0.8, 0, 0.4, 1.5], [0.001, 0.11, 0.2, 0.3, 1, 0, 0, 0, 0.5, 1.6]]})",
                               "x");
  EXPECT_TRUE(hand.sampled);
  EXPECT_TRUE(hand.has_grip);
  const Moment m = hand.at(0.0005, Between::kHold);
  EXPECT_EQ(m.X_WT.p, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(m.X_WT.q.coeffs(), Quat(0.6, 0, 0.8, 0).coeffs());
  EXPECT_EQ(m.closure, 0.4);
  EXPECT_EQ(hand.at(0.001, Between::kHold).grip, 1.6);
  EXPECT_NEAR(hand.at(0.0005, Between::kLinear).X_WT.p.x(), 0.105, 1e-15);
}

TEST(Motion, RestsInEveryKeyAndMovesAsTheFormulaSays) {
  const Hand hand = keys(R"({"t": 1, "p": [0, 0, 0], "rpy": [0, 0, 0], "closure": 0},
                            {"t": 3, "p": ["10 mm", 0, 0], "rpy": [0, 0, 1.0], "closure": 1})");
  const auto at = [&](double t) { return hand.at(t, Between::kMinimumJerk); };
  EXPECT_EQ(at(0).X_WT.p, Vec3::Zero());
  EXPECT_EQ(at(9).X_WT.p, Vec3(10e-3, 0, 0));
  EXPECT_NEAR(at(2).X_WT.p.x(), 5e-3, 1e-15);
  EXPECT_NEAR(at(1.5).X_WT.p.x(), 10e-3 * (10.0 / 64 - 15.0 / 256 + 6.0 / 1024), 1e-15);
  EXPECT_NEAR(at(1).v_W.norm() + at(3 - 1e-9).v_W.norm(), 0, 1e-9);
  EXPECT_NEAR(at(2).v_W.x(), 1.875 * 10e-3 / 2, 1e-12);  // peak of the minimum-jerk profile
  EXPECT_NEAR(at(2).closure, 0.5, 1e-12);
}

// the whole point of a turn: it keeps its distance from the line all the way, and three quarters of a circle are no shortcut
TEST(Motion, ATurnStaysOnItsCircle) {
  const Hand hand = keys(R"({"t": 0, "p": ["3 mm", "1 mm", 0], "rpy": [0, 0, 0]},
      {"t": 1, "turn": {"about": ["1 mm", "1 mm", "5 mm"], "axis": [0, 0, 2], "angle": "270 deg"}, "closure": 0.5})");
  for (const double t : {0.2, 0.5, 0.8}) {
    const Moment m = hand.at(t, Between::kMinimumJerk);
    EXPECT_NEAR((m.X_WT.p - Vec3(1e-3, 1e-3, 0)).norm(), 2e-3, 1e-15);
    EXPECT_NEAR(m.v_W.norm(), 2e-3 * m.w_W.norm(), 1e-15);
  }
  const Moment half = hand.at(0.5, Between::kMinimumJerk), end = hand.at(1, Between::kMinimumJerk);
  EXPECT_LT((half.X_WT.q * Vec3::UnitX() - Vec3(std::cos(2.356194490192345), std::sin(2.356194490192345), 0))
                .norm(),
            1e-12);
  EXPECT_LT((end.X_WT.p - Vec3(1e-3, -1e-3, 0)).norm(), 1e-15);
  EXPECT_EQ(end.closure, 0.5);
}

TEST(Motion, VelocitiesAreDerivatives) {
  const Hand hand = keys(R"({"t": 0, "p": [0, 0, 0], "rpy": [0.1, 0.2, 0.3]},
                            {"t": 2, "p": ["4 mm", "-3 mm", "1 mm"], "rpy": [-1, 0.4, 2]},
                            {"t": 3, "turn": {"about": ["1 mm", 0, 0], "axis": [1, 2, -1], "angle": "100 deg"}})");
  const double h = 1e-6;
  for (const double t : {0.3, 0.9, 1.7, 2.2, 2.6}) {
    const Moment a = hand.at(t - h, Between::kMinimumJerk), b = hand.at(t + h, Between::kMinimumJerk);
    const Moment m = hand.at(t, Between::kMinimumJerk);
    EXPECT_LT((m.v_W - (b.X_WT.p - a.X_WT.p) / (2 * h)).norm(), 1e-9);
    EXPECT_LT((m.w_W - toolkit::log_rotation(b.X_WT.q * a.X_WT.q.conjugate()) / (2 * h)).norm(), 1e-6);
  }
}

TEST(Tremor, HasTheAskedSizeAndBand) {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Tremor tremor;
  tremor.draw(38e-6, 8, 12, uniform);

  // size over 100 s, and how much of the power of one axis lies outside 7.5 to 12.5 Hz
  double square = 0;
  double inside = 0, all = 0;
  const int n = 100000;
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i) {
    Vec3 p, v;
    tremor.at(i * 1e-3, p, v);
    square += p.squaredNorm() / n;
    x[static_cast<size_t>(i)] = p.x();
    all += p.x() * p.x() / n;
  }
  EXPECT_NEAR(std::sqrt(square), 38e-6, 0.05 * 38e-6);
  for (double f = 7.5; f <= 12.5; f += 0.01) {
    double c = 0, s = 0;
    for (int i = 0; i < n; i += 10) {
      c += x[static_cast<size_t>(i)] * std::cos(2 * std::numbers::pi * f * i * 1e-3);
      s += x[static_cast<size_t>(i)] * std::sin(2 * std::numbers::pi * f * i * 1e-3);
    }
    inside += 2 * (c * c + s * s) / (n / 10.0) / (n / 10.0);
  }
  EXPECT_NEAR(inside / all, 1, 0.05);
}

TEST(Tremor, VelocityIsTheDerivativeAndSeedsDiffer) {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Tremor one, other;
  one.draw(38e-6, 8, 12, uniform);
  other.draw(38e-6, 8, 12, uniform);
  Vec3 a, b, v, ignored;
  one.at(0.2 - 1e-6, a, ignored);
  one.at(0.2 + 1e-6, b, ignored);
  one.at(0.2, ignored, v);
  EXPECT_LT((v - (b - a) / 2e-6).norm(), 1e-6 * v.norm() + 1e-9);
  other.at(0.2, b, ignored);
  EXPECT_GT((b - a).norm(), 1e-6);
}

}  // namespace
}  // namespace swage::hand
