// SPDX-License-Identifier: Apache-2.0
#include "host/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "host/sentences.hpp"

using namespace swage::host;

namespace {

std::string refusal(const char* text, const char* si) {
  double value = -7;
  std::string error;
  EXPECT_FALSE(parse_quantity(text, si, "Wire diameter", value, error)) << text;
  EXPECT_EQ(value, -7) << "a refused text must not touch the value";
  return error;
}

double read(const char* text, const char* si) {
  double value = 0;
  std::string error;
  EXPECT_TRUE(parse_quantity(text, si, "Wire diameter", value, error)) << error;
  return value;
}

}  // namespace

TEST(Units, ReadsEveryUnitOfTheTable) {
  struct Case {
    const char *text, *si;
    double value;
  };
  const Case cases[] = {
      {"1.5 m", "m", 1.5},
      {"2.6 mm", "m", 2.6e-3},
      {"100 um", "m", 1e-4},
      {"2 s", "s", 2},
      {"5 ms", "s", 5e-3},
      {"0.6 N", "N", 0.6},
      {"40 mN", "N", 0.04},
      {"1 rad", "rad", 1},
      {"180 deg", "rad", std::numbers::pi},
      {"2 kg", "kg", 2},
      {"3 g", "kg", 3e-3},
      {"0.4 mg", "kg", 0.4e-6},
      {"7 Pa", "Pa", 7},
      {"7 kPa", "Pa", 7e3},
      {"7 MPa", "Pa", 7e6},
      {"200 GPa", "Pa", 2e11},
      {"50 Hz", "Hz", 50},
      {"1 m/s", "m/s", 1},
      {"20 mm/s", "m/s", 0.02},
      {"3 rad/s", "rad/s", 3},
      {"90 deg/s", "rad/s", std::numbers::pi / 2},
      {"9.81 m/s2", "m/s2", 9.81},
      {"10 N/m", "N/m", 10},
      {"4 N*s/m", "N*s/m", 4},
      {"1 N*m", "N*m", 1},
      {"2 mN*mm", "N*m", 2e-6},
      {"7850 kg/m3", "kg/m3", 7850},
      {"60 1/m", "1/m", 60},
      {"0.3 1", "1", 0.3},
      {"50 %", "1", 0.5},
      {"0.3", "1", 0.3},
  };
  for (const Case& c : cases) EXPECT_NEAR(read(c.text, c.si), c.value, 1e-15 * std::abs(c.value)) << c.text;
}

TEST(Units, ReadsNumbersAsPeopleWriteThem) {
  EXPECT_EQ(read("  2 mm ", "m"), 2e-3);
  EXPECT_EQ(read("2mm", "m"), 2e-3);
  EXPECT_EQ(read("-1e-3 m", "m"), -1e-3);
  EXPECT_EQ(read("+3 m", "m"), 3);
}

TEST(Units, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("0.1 N", "m"), say::kOtherDimension("0.1 N", "a force", "Wire diameter", measure_of("m")));
  EXPECT_EQ(refusal("0.1", "m"), say::kHasNoUnit("0.1", "Wire diameter", measure_of("m")));
  EXPECT_EQ(refusal("0.1 mmm", "m"),
            say::kUnknownUnit("0.1 mmm", "mmm", "Wire diameter", measure_of("m")));
  EXPECT_EQ(refusal("thin", "m"),
            say::kNotANumber("thin", "Wire diameter", measure_of("m")));
  EXPECT_EQ(refusal("3 mm", "1"), say::kOtherDimension("3 mm", "a length", "Wire diameter", measure_of("1")));
  EXPECT_EQ(refusal("1e308 GPa", "Pa"), say::kTooLargeNumber("1e308 GPa"));
}

TEST(Units, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "nan m", "inf m", "-inf m", "+-1 m", "0x10 m", "1,5 mm", "1e m", "mm"})
    EXPECT_FALSE(refusal(text, "m").empty()) << text;
}

TEST(Units, AnglesAndFrequenciesAreNotPureNumbers) {
  EXPECT_NE(refusal("90 deg", "1"), "");
  EXPECT_NE(refusal("3 rad/s", "Hz"), "");
}

TEST(Units, WritesWhatItReads) {
  EXPECT_EQ(format_quantity(2.6e-3, "mm"), "2.6 mm");
  EXPECT_EQ(format_quantity(1e-4, "mm"), "0.1 mm");
  EXPECT_EQ(format_quantity(std::numbers::pi / 2, "deg"), "90 deg");
  EXPECT_EQ(format_quantity(0.5, "1"), "0.5");
  EXPECT_EQ(format_quantity(0.5, "%"), "50 %");
}
