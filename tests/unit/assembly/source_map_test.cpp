// SPDX-License-Identifier: Apache-2.0
#include "assembly/source_map.hpp"

#include <gtest/gtest.h>

using namespace swage::assembly;

TEST(SourceMap, KnowsTheLineOfEveryValue) {
  const SourceMap map =
      map_source("{\n  \"a\": [1,\n    {\"b/c\": \"x\\\"}\\n\"}\n  ],\n\n  \"d\":\n true\n}");
  EXPECT_EQ(map.line_of.at(""), 1u);
  EXPECT_EQ(map.line_of.at("/a"), 2u);
  EXPECT_EQ(map.line_of.at("/a/0"), 2u);
  EXPECT_EQ(map.line_of.at("/a/1"), 3u);
  EXPECT_EQ(map.line_of.at("/a/1/b~1c"), 3u);
  EXPECT_EQ(map.line_of.at("/d"), 6u) << "the line of the key";
  EXPECT_EQ(map.line_of.size(), 6u);
  EXPECT_TRUE(map.double_keys.empty());
}

TEST(SourceMap, FindsKeysThatAreThereTwice) {
  const SourceMap map = map_source(R"({"a": 1, "b": {"c": 1, "\u0063": 2}, "a": 2})");
  ASSERT_EQ(map.double_keys.size(), 2u);
  EXPECT_EQ(map.double_keys[0], std::make_pair(std::string("/b"), std::string("c")))
      << "however it is written";
  EXPECT_EQ(map.double_keys[1], std::make_pair(std::string(""), std::string("a")));
}

TEST(SourceMap, MeasuresNestingOutsideStrings) {
  EXPECT_EQ(nesting("{\"a\": [1, {\"b\": \"[[[[\"}]}"), 3u);
  EXPECT_EQ(nesting("\"\\\"[[\""), 0u);
  EXPECT_EQ(nesting("]]]["), 1u);
  EXPECT_EQ(nesting(std::string(100000, '[')), 100000u);
}
