// SPDX-License-Identifier: Apache-2.0
//
// The validator finds what a strand says wrongly of itself, and nothing in one that says it rightly.
#include "program.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using ValidateStrand = Program;

TEST_F(ValidateStrand, WhatAStrandSaysWronglyIsTold) {
  enum { kGood, kNoRadius, kElsewhere, kOutside, kTilted, kNoTension, kUnsteady, kNoBody, kOneNode, kOtherLine, kBeyondLine, kWhole };
  const auto validate = [&](int fault) { return validate_fault("org.example.bad.strand", "traits", fault); };
  const Said good = validate(kGood);
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_THAT(good.out, testing::ContainsRegex("traits +success"));
  const auto expect = [&](int fault, const std::string& text) {
    const Said said = validate(fault);
    EXPECT_EQ(said.code, 1) << fault << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << fault;
  };
  expect(kNoRadius, say::kOfCall("law", say::kStrand()));
  expect(kElsewhere, say::kOfCall("place", say::kElsewhere()));
  expect(kOutside, say::kOfCall("nearest", say::kStrandRange()));
  expect(kTilted, say::kOfCall("place", say::kNotSquare()));
  expect(kNoTension, say::kOfCall("place", say::kTension()));
  expect(kUnsteady, say::kOtherBits("place"));
  expect(kNoBody, say::kOfCall("place", say::kNoBody()));
  expect(kOneNode, say::kOfCall("count", say::kFewNodes()));
  expect(kOtherLine, say::kOfCall("line", say::kOtherPlaces()));
  expect(kBeyondLine, say::kOfCall("line", say::kBeyond()));
  expect(kWhole, say::kOfCall("cut", say::kStaysWhole()));
}

}  // namespace
}  // namespace swage::tools::test
