// SPDX-License-Identifier: Apache-2.0
//
// The validator finds what a strand says wrongly of itself, and nothing in one that says it rightly.
#include "program.hpp"
#include "test_places.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using ValidateStrand = Program;

TEST_F(ValidateStrand, WhatAStrandSaysWronglyIsTold) {
  enum { kGood, kNoRadius, kElsewhere, kOutside, kTilted, kNoTension, kUnsteady, kNoBody, kOneNode, kOtherLine, kBeyondLine, kWhole };
  const auto validate = [&](int fault) {
    write("strand.json", R"({ "format": "swage-lesson/1", "id": "org.example.strand", "title": "Strand",
      "requires": { "org.example.bad.strand": "^1", "swage.lesson.look": "^1" },
      "objects": [ { "name": "strand", "plugin": "org.example.bad.strand", "params": { "fault": )" + std::to_string(fault) + R"( } } ],
      "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "1 s" } } })");
    const std::string bundle = SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_solvers/org.example.bad.strand";
    return swage({"validate", bundle, "--only", "traits", "--strictness", "10", "--with", path("strand.json")});
  };
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
