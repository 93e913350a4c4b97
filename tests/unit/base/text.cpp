// SPDX-License-Identifier: Apache-2.0
#include "base/text.hpp"

#include <gtest/gtest.h>

namespace swage::base {
namespace {

TEST(Text, ControlCharactersAreWrittenOut) {
  EXPECT_EQ(printable("plain\n\tµm 3.5 °"), "plain\n\tµm 3.5 °");
  EXPECT_EQ(printable("a\x1B[2Jb\x7F\rc"), "a\\x1b[2Jb\\x7f\\x0dc");
  EXPECT_EQ(printable("\xC2\x9B" "31m"), "\\x9b31m") << "the other way to begin an escape sequence";
  EXPECT_EQ(printable(std::string("\0\xC2", 2)), "\\x00\xC2");
  EXPECT_TRUE(has_control("\x1B"));
  EXPECT_FALSE(has_control("é\n"));
}

TEST(Text, IsCutBetweenCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc...");
  EXPECT_EQ(shortened("aµb", 2), "a...");
}

}  // namespace
}  // namespace swage::base
