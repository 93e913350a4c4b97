// SPDX-License-Identifier: Apache-2.0
//
// Volts to millimetres, travel to force, and the file that keeps both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "sensor/bench.hpp"
#include "sensor/calibration.hpp"
#include "sensor/calibration_file.hpp"
#include "sensor/sentences.hpp"
#include "temp_folder.hpp"
#include "toolkit/sentences.hpp"

namespace swage::sensor {
namespace {

using testing::HasSubstr;

// 13 points over 6 mm of a sensor with 1 V/mm, 0.4 % of non-linearity and 2 mV of noise
std::vector<BenchPoint> bench(uint32_t seed, double first = 0, int n = 13) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 2e-3);
  std::vector<BenchPoint> out;
  for (int i = 0; i < n; ++i) {
    const double mm = first + 0.5 * i;
    const double volts = mm - 3 + 0.024 * std::sin(2 * std::numbers::pi * mm / 6) + noise(random);
    out.push_back({volts, 1e-3 * mm});
  }
  return out;
}

TEST(Displacement, AStraightLineIsFoundToTheLastBit) {
  std::vector<BenchPoint> points;
  for (int i = 12; i >= 0; --i) points.push_back({-3 + 0.5 * i, 0.5e-3 * i});
  Displacement fit;
  ASSERT_EQ(fit_displacement(points, {}, fit), "");
  EXPECT_NEAR(fit.slope, 1e-3, 1e-15);
  EXPECT_NEAR(fit.offset, 3e-3, 1e-15);
  EXPECT_LT(fit.worst, 1e-15);
  EXPECT_NEAR(fit.length(0.25), 3.25e-3, 1e-15);
}

TEST(Displacement, ResidualsAreThoseOfTheSensor) {
  for (uint32_t seed = 1; seed <= 50; ++seed) {
    Displacement fit;
    ASSERT_EQ(fit_displacement(bench(seed), {}, fit), "");
    EXPECT_EQ(std::count_if(fit.points.begin(), fit.points.end(), [](const auto& p) { return p.used; }), 13);
    EXPECT_LT(fit.worst, 45e-6) << "24 um of non-linearity and some noise";
    EXPECT_GT(fit.worst, 10e-6);
    EXPECT_NEAR(fit.slope, 1e-3, 0.02e-3);
  }
}

TEST(Displacement, TheIrregularBeginningIsLeftOut) {
  // as in the thesis: the bench goes over 10 mm, the sensor has 8: its first two millimetres give next to nothing
  std::vector<BenchPoint> points = bench(3, 2, 17);
  for (const double mm : {0.0, 0.5, 1.0, 1.5}) points.push_back({-1.05 + 0.03 * mm, 1e-3 * mm});
  Displacement fit;
  ASSERT_EQ(fit_displacement(points, {}, fit), "");
  ASSERT_EQ(fit.points.size(), 21u);
  for (const BenchPoint& p : fit.points) EXPECT_EQ(p.used, p.length_m > 1.8e-3) << p.length_m;
  EXPECT_LT(fit.worst, 45e-6);
  // and an irregular end as well
  for (BenchPoint& p : points) p.length_m = 10e-3 - p.length_m;
  ASSERT_EQ(fit_displacement(points, {}, fit), "");
  EXPECT_LT(fit.slope, 0) << "it may be mounted the other way round";
  EXPECT_EQ(std::count_if(fit.points.begin(), fit.points.end(), [](const auto& p) { return p.used; }), 17);
}

TEST(Displacement, WhatIsNoSensorIsRefused) {
  Displacement fit;
  std::vector<BenchPoint> points = bench(1);
  for (std::size_t i = 0; i < points.size(); i += 3) points[i].volts += 0.2;
  EXPECT_THAT(fit_displacement(points, {}, fit), HasSubstr(say::kNoLine.words(2) + "0.06 mm"));
  points = bench(1);
  for (BenchPoint& p : points) p.volts *= 2;
  EXPECT_THAT(fit_displacement(points, {}, fit), HasSubstr(say::kOtherSlope.words(1) + "1" + say::kOtherSlope.words(2)));
  FitLimits any;
  any.nominal = 0;
  EXPECT_EQ(fit_displacement(points, any, fit), "") << "where the data sheet is not known";
  EXPECT_THAT(fit_displacement(bench(1, 0, 6), {}, fit), HasSubstr(say::kFewPoints.words(0) + "7" + say::kFewPoints.words(1)));
  points = bench(1);
  points[4].volts = std::nan("");
  EXPECT_THAT(fit_displacement(points, {}, fit), HasSubstr(say::kNoPoint()));
  points = bench(1);
  points[4].length_m = points[5].length_m;
  EXPECT_THAT(fit_displacement(points, {}, fit), HasSubstr(say::kSameLength.words(0)));
  for (BenchPoint& p : points = bench(1)) p.volts = 1;
  EXPECT_NE(fit_displacement(points, {}, fit), "") << "a cable that is off";
}

// a handle that is met softly and stops hard: 0.2 N at contact, 10 N at the stop after 2 mm
double holder(double s) { return 0.2 + 9.8 * (0.25 * s / 2e-3 + 0.75 * std::pow(s / 2e-3, 4)); }

MonotoneCurve table(int n) {
  std::vector<MonotoneCurve::Point> points;
  for (int i = 0; i < n; ++i) points.push_back({2e-3 * i / (n - 1), holder(2e-3 * i / (n - 1))});
  MonotoneCurve curve;
  EXPECT_EQ(curve.set(points), "");
  return curve;
}

TEST(Curve, IsMonotoneMeetsItsPointsAndBeatsStraightLines) {
  double worst[2] = {};
  int which = 0;
  for (const int n : {7, 11}) {
    const MonotoneCurve curve = table(n);
    double straight = 0, last = -1;
    for (double s = 0; s <= 2e-3; s += 1e-6) {
      const double f = curve.value(s), x = s / 2e-3 * (n - 1);
      const int i = std::min(n - 2, static_cast<int>(x));
      const auto& p = curve.points();
      const double line = p[static_cast<std::size_t>(i)].y + (x - i) * (p[static_cast<std::size_t>(i) + 1].y - p[static_cast<std::size_t>(i)].y);
      worst[which] = std::max(worst[which], std::abs(f - holder(s)));
      straight = std::max(straight, std::abs(line - holder(s)));
      EXPECT_GE(f, last);
      last = f;
    }
    EXPECT_LT(worst[which], 0.35 * straight) << n;
    for (const auto& p : curve.points()) EXPECT_NEAR(curve.value(p.x), p.y, 1e-12);
    ++which;
  }
  EXPECT_LT(worst[1], 0.5 * worst[0]) << "more points, nearer";
  EXPECT_LT(worst[1], 0.06) << "N of 10";
}

TEST(Curve, NeverLeavesItsPointsAndItsSlopeIsItsSlope) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> step(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<MonotoneCurve::Point> points{{0, 0.2}};
    for (int i = 0; i < 8; ++i)
      points.push_back({points.back().x + 1e-4 + 1e-3 * step(random), points.back().y + (random() % 3 == 0 ? 0 : 4 * step(random))});
    MonotoneCurve curve;
    ASSERT_EQ(curve.set(points), "");
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      for (double t = 0.01; t < 1; t += 0.01) {
        const double x = points[i].x + t * (points[i + 1].x - points[i].x), d = 1e-7;
        EXPECT_GE(curve.value(x), points[i].y - 1e-12);
        EXPECT_LE(curve.value(x), points[i + 1].y + 1e-12);
        EXPECT_NEAR(curve.slope(x), (curve.value(x + d) - curve.value(x - d)) / (2 * d), 1e-2 + 1e-4 * curve.slope(x));
      }
    }
    EXPECT_EQ(curve.value(-1), 0.2) << "before its first point it stays";
    EXPECT_EQ(curve.value(1), points.back().y);
  }
}

TEST(Curve, AWrongTableIsRefused) {
  MonotoneCurve curve;
  EXPECT_NE(curve.set({{0, 1}}), "");
  EXPECT_THAT(curve.set({{0, 0}, {1, 2}, {1, 3}}), HasSubstr(say::kTravelFalls.words(0)));
  EXPECT_THAT(curve.set({{0, 0}, {1, 2}, {2, 1}}), HasSubstr(say::kForceFalls.words(0)));
  EXPECT_THAT(curve.set({{0, 0}, {1, std::nan("")}}), HasSubstr(say::kForceNoNumber()));
  EXPECT_TRUE(curve.empty());
}

Calibration holder_calibration() {
  Calibration c;
  c.serial = "A1", c.name = "DVRT 8 mm", c.date = "2026-11-22", c.by = "Ada", c.expires = "2027-11-22";
  EXPECT_EQ(fit_displacement(bench(1), {}, c.displacement), "");
  c.force = table(7);
  c.geometry = {40e-3, 40e-3, 10e-3};
  c.poses = {5e-3, 2e-3, 0.5e-3};
  c.poses_date = "2026-11-23";
  return c;
}

TEST(HandleModel, WhatIsHeldShiftsTheContact) {
  // a needle of 0.1 mm, 10 mm from the pivot: 0.30, 0.40, 0.60 mm of travel for swivels at 30, 40, 60 mm
  Calibration c = holder_calibration();
  for (const auto& [a, shift] : {std::pair{30e-3, 0.30e-3}, {40e-3, 0.40e-3}, {60e-3, 0.60e-3}}) {
    c.geometry = {a, a, 10e-3};
    Handle handle;
    handle.set(c, 0.6, {0.1e-3, 10e-3});
    EXPECT_NEAR(handle.contact() - c.poses.closed, shift, 0.01e-3) << a;
    EXPECT_EQ(handle.at(handle.contact() + 1e-6).force, 0);
    EXPECT_NEAR(handle.at(handle.contact() - 0.5e-3).force, holder(0.5e-3) - holder(0), 0.05);
    handle.set(c, 0.6, {0, 10e-3});
    EXPECT_NEAR(handle.contact(), c.poses.closed, 1e-15) << "empty jaws meet where they were calibrated";
  }
}

TEST(HandleModel, ClosureGoesFromOpenOverMeetingToSqueezed) {
  const Calibration c = holder_calibration();
  Handle handle;
  handle.set(c, 0.6, {0.1e-3, 10e-3});
  EXPECT_NEAR(handle.at(c.poses.open).closure, 0, 1e-12);
  EXPECT_NEAR(handle.at(c.poses.closed).closure, 0.6, 1e-12);
  EXPECT_NEAR(handle.at(c.poses.squeezed).closure, 1, 1e-12);
  EXPECT_EQ(handle.at(c.poses.open + 1e-3).closure, 0);
  EXPECT_EQ(handle.at(c.poses.squeezed - 1e-3).closure, 1);
  // a millimetre of sensor is 0.025 rad: one bit of twelve (2.4 um) are 61 urad
  Calibration plain = c;
  plain.geometry = {};
  Handle linear;
  linear.set(plain, 0.6, {0.1e-3, 10e-3});
  EXPECT_NEAR(linear.at(3.5e-3).closure, 0.3, 1e-12);
  EXPECT_NEAR(handle.at(3.5e-3).closure, 0.3, 5e-3) << "the triangle is nearly straight over 3 mm";
  EXPECT_NEAR(linear.contact(), c.poses.closed, 1e-15) << "without the triangle nothing is shifted";
  double last = -1;
  for (double d = 5e-3; d > 0.5e-3; d -= 1e-5) {
    EXPECT_GT(handle.at(d).closure, last);
    last = handle.at(d).closure;
  }
}

// the tips of a holder whose joint takes a part of the force: 5 mN lost, then a fifth of the handle's that grows to a quarter
double tips(double handle_N) { return std::max(0.0, 0.2 * handle_N + 0.005 * handle_N * handle_N - 0.005); }

TEST(Tips, AreACurveOfTheHandlesForceFromNothingOn) {
  std::vector<MonotoneCurve::Point> points;
  for (const double f : {10.0, 0.5, 1.0, 2.0, 4.0, 7.0}) points.push_back({f, tips(f)});  // in any order
  MonotoneCurve curve;
  ASSERT_EQ(set_tip(points, curve), "");
  EXPECT_EQ(curve.points().front().x, 0);
  EXPECT_EQ(curve.value(0), 0);
  // error of a monotone cubic between points 3 N apart of a parabola with y'' = 0.01 /N: below h^2 y''/8 = 11 mN, that of a straight line
  for (double f = 0.5; f <= 10; f += 0.01) EXPECT_NEAR(curve.value(f), tips(f), 11e-3) << f;
  EXPECT_THAT(set_tip({{1, 0.2}, {2, 0.1}}, curve), HasSubstr(say::kTipFalls("2")));
  EXPECT_THAT(set_tip({{-1, 0}, {2, 0.1}}, curve), HasSubstr(say::kPressesNothing()));
  for (const std::size_t n : {0u, 4u, 12u}) EXPECT_NE(check_table_size(n), "") << n;
  for (const std::size_t n : {5u, 11u}) EXPECT_EQ(check_table_size(n), "") << n;

  Calibration c = holder_calibration();
  ASSERT_EQ(set_tip(points, c.tip), "");
  Handle handle;
  handle.set(c, 0.6, {0, 10e-3});
  const Handle::Grip grip = handle.at(c.poses.closed - 0.8e-3);
  EXPECT_GT(grip.force, 0.5);
  EXPECT_NEAR(grip.tip, tips(grip.force), 11e-3);
  EXPECT_EQ(handle.at(c.poses.closed + 1e-4).tip, 0) << "nothing presses before the jaws meet";
}

TEST(Tips, ACheckOnAGaugeHoldsToTenPercent) {
  EXPECT_EQ(check_tip({0.6, 0.6, ""}), "");
  EXPECT_EQ(check_tip({0.6, 0.6 * 1.0999, ""}), "");
  EXPECT_EQ(check_tip({0.6, 0.6 * 0.9001, ""}), "");
  EXPECT_THAT(check_tip({0.6, 0.67, ""}), HasSubstr(say::kTipOff("0.60", "0.67", "12", "10")));
  EXPECT_NE(check_tip({0.6, 0.53, ""}), "");
  Calibration c = holder_calibration();
  c.check = {0.6, 0.75, "2026-11-23"};
  EXPECT_THAT(calibration_trouble(c, "A1", "2026-11-23"), HasSubstr("25" + say::kTipOff.words(3)));
  c.check.measured = 0.58;
  EXPECT_EQ(calibration_trouble(c, "A1", "2026-11-23"), "");
}

// what the wizard of the console makes of its rows
TEST(Drafts, PosesAndForcesOfASessionNeedNoBench) {
  const test::TempFolder folder;
  Calibration stored = holder_calibration();
  ASSERT_EQ(save_calibration(folder / "a.json", stored), "");
  const auto volts = [&](double length) { return (length - stored.displacement.offset) / stored.displacement.slope; };
  Draft draft;
  draft.by = "Mei";
  EXPECT_EQ(draft.begin_from(folder / "a.json"), "");
  Calibration c;
  draft.pose_volts = {volts(5.1e-3), volts(2.05e-3), volts(0.5e-3)};
  ASSERT_EQ(draft.finish("2026-11-25", c), "");
  EXPECT_NEAR(c.poses.closed, 2.05e-3, 1e-12);
  EXPECT_EQ(c.poses_date, "2026-11-25");
  EXPECT_EQ(c.date, stored.date) << "the bench is that of before";
  EXPECT_EQ(c.force.points().size(), 7u) << "and so are the forces";
  draft.pose_volts[0] = volts(9e-3);
  EXPECT_THAT(draft.finish("2026-11-25", c), HasSubstr(say::kOtherHolder.words(4)));
  draft.pose_volts[0] = volts(5.1e-3);

  // five forces of the handle with those of the tips, and a check
  for (std::size_t i = 0; i < 5; ++i) {
    const double s = 0.25e-3 * static_cast<double>(i);
    draft.force_rows[i] = {holder(s), tips(holder(s) - holder(0)), volts(2.05e-3 - s)};
  }
  draft.force_rows[4].volts.reset();
  EXPECT_THAT(draft.finish("2026-11-25", c), HasSubstr(say::kTipCount(4)));
  draft.force_rows[4].volts = volts(2.05e-3 - 1e-3);
  ASSERT_EQ(draft.finish("2026-11-25", c), "");
  EXPECT_EQ(c.force.points().size(), 5u);
  EXPECT_NEAR(c.force.value(0.5e-3), holder(0.5e-3), 1e-9);
  EXPECT_NEAR(c.tip.value(holder(0.5e-3) - holder(0)), tips(holder(0.5e-3) - holder(0)), 1e-9);
  EXPECT_FALSE(c.check.known());
  draft.check_volts = volts(2.05e-3 - 0.75e-3);
  ASSERT_EQ(draft.finish("2026-11-25", c), "");
  EXPECT_EQ(c.check.wanted, 0.6);
  EXPECT_NEAR(c.check.measured, tips(holder(0.75e-3) - holder(0)), 1e-9);
  draft.pose_volts[1].reset();
  draft.rows()[0].volts = 0.1;
  EXPECT_THAT(draft.finish("2026-11-25", c), HasSubstr(say::kNoFit())) << "a bench that has begun is made to its end";
}

TEST(Poses, AreCheckedAgainstThemselvesAndThoseOfBefore) {
  EXPECT_EQ(check_poses({5e-3, 2e-3, 0.5e-3}, {}), "");
  EXPECT_EQ(check_poses({0.5e-3, 2e-3, 5e-3}, {}), "") << "mounted the other way round";
  EXPECT_THAT(check_poses({5e-3, 5e-3, 4e-3}, {}), HasSubstr(say::kSamePoses.words(0)));
  EXPECT_THAT(check_poses({5e-3, 2e-3, 3e-3}, {}), HasSubstr(say::kSqueezedBack.words(0)));
  EXPECT_THAT(check_poses({std::nan(""), 2e-3, 3e-3}, {}), HasSubstr(say::kPoseNoNumber()));
  EXPECT_EQ(check_poses({5.1e-3, 2e-3, 0.6e-3}, {5e-3, 2e-3, 0.5e-3}), "");
  EXPECT_THAT(check_poses({6e-3, 2e-3, 0.5e-3}, {5e-3, 2e-3, 0.5e-3}), HasSubstr(say::kOtherHolder.words(4)));
  EXPECT_EQ(check_geometry({40e-3, 40e-3, 10e-3}, {5e-3, 2e-3, 0.5e-3}), "");
  EXPECT_THAT(check_geometry({4e-3, 4e-3, 10e-3}, {5e-3, 2e-3, 0.5e-3}), HasSubstr(say::kNoTriangle.words(2)));
}

TEST(CalibrationFile, ComesBackAsItWas) {
  const test::TempFolder folder;
  Calibration c = holder_calibration();
  ASSERT_EQ(set_tip({{1, 0.2}, {5, 1}}, c.tip), "");
  c.check = {0.6, 0.58, "2026-11-24"};
  c.zero_date = "2026-11-25", c.gauge_zero = 0.25;
  ASSERT_EQ(save_calibration(folder / "deeper/a.json", c), "");
  Calibration back;
  ASSERT_EQ(load_calibration(folder / "deeper/a.json", back), "");
  EXPECT_EQ(back.serial, "A1");
  EXPECT_EQ(back.by, "Ada");
  EXPECT_EQ(back.expires, "2027-11-22");
  EXPECT_EQ(back.poses_date, "2026-11-23");
  EXPECT_EQ(back.displacement.slope, c.displacement.slope);
  EXPECT_EQ(back.displacement.worst, c.displacement.worst);
  ASSERT_EQ(back.displacement.points.size(), 13u);
  EXPECT_EQ(back.displacement.points[3].residual_m, c.displacement.points[3].residual_m);
  EXPECT_EQ(back.force.value(1.1e-3), c.force.value(1.1e-3));
  EXPECT_EQ(back.tip.value(2.5), c.tip.value(2.5));
  EXPECT_EQ(back.check.measured, 0.58);
  EXPECT_EQ(back.check.date, "2026-11-24");
  EXPECT_EQ(back.geometry.gap, c.geometry.gap);
  EXPECT_EQ(back.poses.squeezed, c.poses.squeezed);
  EXPECT_EQ(back.zero_date, "2026-11-25");
  EXPECT_EQ(back.gauge_zero, 0.25);
}

TEST(CalibrationFile, EachFaultHasItsSentence) {
  const test::TempFolder folder;
  const std::string path = folder / "a.json";
  const std::string good = R"({"format":"swage-calibration/1","serial":"A1","date":"2026-11-22","expires":"2027-11-22",
    "displacement":{"slope":0.001,"offset":0,"worst":0,"rms":0})";
  const auto load = [&](const std::string& text) {
    std::ofstream(path) << text;
    Calibration c;
    return load_calibration(path, c);
  };
  EXPECT_EQ(load(good + "}"), "");
  EXPECT_THAT(load("no"), HasSubstr(say::kNoJson()));
  EXPECT_THAT(load("{}"), HasSubstr("format"));
  EXPECT_THAT(load(good + R"(,"color":1})"), HasSubstr(say::kUnknown("color")));
  EXPECT_THAT(load(good + R"(,"force":[[0,1],[1,0]]})"), HasSubstr(say::kForceFalls.words(0)));
  EXPECT_THAT(load(good + R"(,"force":[[0,"x"],[1,0]]})"), HasSubstr(say::kRows("force", 2)));
  EXPECT_THAT(load(good + R"(,"poses":{"open":1,"closed":1,"squeezed":1}})"), HasSubstr(say::kSamePoses.words(0)));
  EXPECT_THAT(load(good + R"(,"geometry":{"a":1}})"), HasSubstr(say::kNumber("geometry/", "b")));
  EXPECT_THAT(load(good + R"(,"geometry":[1]})"), HasSubstr(say::kObject("geometry")));
  EXPECT_THAT(load(R"({"format":"swage-calibration/1","date":"22.11.2026"})"), HasSubstr(say::kNoDate("22.11.2026")));
  EXPECT_THAT(load(R"({"format":"swage-calibration/1"})"), HasSubstr(say::kMissing()));
  EXPECT_THAT(load(R"({"format":"swage-calibration/1","displacement":{"slope":0,"offset":0,"worst":0,"rms":0}})"),
              HasSubstr(say::kNoSlope()));
  Calibration c;
  EXPECT_THAT(load_calibration(folder / "none.json", c), HasSubstr(toolkit::say::kNoFile()));
  EXPECT_THAT(save_calibration("/proc/none/a.json", holder_calibration()), HasSubstr(say::kNotWritten.words(1)));
}

TEST(CalibrationFile, ExpiresAndBelongsToOneSensor) {
  const Calibration c = holder_calibration();
  EXPECT_EQ(calibration_trouble(c, "A1", "2027-11-22"), "");
  EXPECT_THAT(calibration_trouble(c, "A1", "2027-11-23"), HasSubstr(say::kExpired.words(1) + "2027-11-22"));
  EXPECT_THAT(calibration_trouble(c, "B2", "2026-11-23"), HasSubstr(say::kOtherSensor("A1", "B2")));
  EXPECT_EQ(days_after("2026-11-22", 365), "2027-11-22");
  EXPECT_EQ(days_after("2028-02-28", 1), "2028-02-29");
  EXPECT_EQ(days_after("yesterday", 1), "");
  EXPECT_EQ(days_between("2026-11-22", "2027-11-22"), 365);
  EXPECT_EQ(days_between("2028-02-28", "2028-03-01"), 2);
  EXPECT_EQ(calibration_path("../../etc/passwd"), "");
  EXPECT_EQ(calibration_path(".."), "");
  EXPECT_THAT(calibration_path("A1"), HasSubstr("swage/calibrations/A1.json"));
}

}  // namespace
}  // namespace swage::sensor
