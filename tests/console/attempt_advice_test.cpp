// SPDX-License-Identifier: Apache-2.0
#include "console/pages/attempt_advice.hpp"

#include <gtest/gtest.h>

namespace swage::console {
namespace {

Reading held(bool at_the_mark) {
  Reading r;
  r.held = true;
  r.spot = at_the_mark;
  return r;
}

TEST(AttemptAdvice, WhatHasFallenIsToldUntilItIsHeldAgain) {
  AttemptAdvice advice;
  EXPECT_EQ(advice.words(true), "");
  advice.hear("needle.dropped", 100);
  EXPECT_TRUE(advice.words(true).startsWith("Dropped"));
  EXPECT_TRUE(advice.hints(false, false).put_back);
  EXPECT_FALSE(advice.hints(true, false).put_back) << "a test tells no answer";
  advice.read(held(true), 100);  // the snapshot is as old as the drop
  EXPECT_TRUE(advice.words(true).startsWith("Dropped"));
  advice.read(held(true), 101);
  EXPECT_EQ(advice.words(true), "");
}

TEST(AttemptAdvice, WhatIsPutBackHasNotFallenAnyMore) {
  AttemptAdvice advice;
  advice.hear("ring.dropped", 100);
  advice.hear("host.reset", 120);
  EXPECT_EQ(advice.words(true), "");
  advice.hear("thread.slipped", 130);  // needs no reset
  EXPECT_EQ(advice.words(true), "");
}

// 118: driven in its holder, a needle runs its point into the tray and bends
TEST(AttemptAdvice, DrivingIsToldAtTheTarget) {
  AttemptAdvice advice;
  Reading away = held(true);
  away.at_target = false;
  advice.read(away, 1);
  EXPECT_FALSE(advice.hints(false, true).drive);
  Reading there = away;
  there.at_target = true;
  EXPECT_TRUE(advice.read(there, 2));
  EXPECT_TRUE(advice.hints(false, true).drive);
  advice.read(away, 3);
  EXPECT_TRUE(advice.hints(false, true).drive) << "until it was used";
}

TEST(AttemptAdvice, ABentNeedleMayBePutBack) {
  AttemptAdvice advice;
  Reading bent = held(true);
  bent.meanings = {QStringLiteral("needle.bent")};
  EXPECT_TRUE(advice.read(bent, 1));
  EXPECT_TRUE(advice.words(true).contains("F7")) << advice.words(true).toStdString();
  EXPECT_TRUE(advice.hints(false, false).put_back);
  EXPECT_FALSE(advice.hints(true, false).put_back) << "a test tells no answer";
  advice.hear("host.reset", 2);
  EXPECT_TRUE(advice.read(bent, 3)) << "the lesson remembers the bend";
  EXPECT_EQ(advice.words(true), "");
  advice.reset();
  EXPECT_TRUE(advice.read(bent, 1)) << "another attempt";
}

TEST(AttemptAdvice, WhatIsHeldAtTheWrongPlaceIsLetGoOf) {
  AttemptAdvice advice;
  EXPECT_TRUE(advice.read(held(false), 1));
  EXPECT_FALSE(advice.read(held(false), 2)) << "nothing new";
  EXPECT_TRUE(advice.words(true).contains("(B)"));
  EXPECT_TRUE(advice.words(false).startsWith("Held at the wrong place"));
  EXPECT_FALSE(advice.words(false).contains("(B)")) << "the key is the mouse's";
  EXPECT_TRUE(advice.hints(false, false).open);
  EXPECT_TRUE(advice.read(held(true), 3));
  EXPECT_EQ(advice.words(true), "");
  EXPECT_FALSE(advice.hints(false, false).open);
}

TEST(AttemptAdvice, WhoHasClosedTheJawsOnNothingIsToldHowToOpenThem) {
  AttemptAdvice advice;
  EXPECT_FALSE(advice.hints(false, false).open);
  advice.use("close");
  EXPECT_TRUE(advice.hints(false, false).open);
  EXPECT_TRUE(advice.hints(true, false).open) << "a control is no answer of a test";
  advice.read(held(true), 1);
  EXPECT_FALSE(advice.hints(false, false).open) << "they hold it";
  advice.reset();
  EXPECT_FALSE(advice.hints(false, false).open) << "of that attempt alone";
  advice.use("close");
  advice.use("open");
  EXPECT_FALSE(advice.hints(false, false).open);
}

TEST(AttemptAdvice, AControlIsToldUntilItWasUsedOnceInAnyAttempt) {
  AttemptAdvice advice;
  advice.set_used("drag");
  EXPECT_FALSE(advice.hints(false, true).drag);
  EXPECT_TRUE(advice.hints(false, true).close);
  EXPECT_FALSE(advice.hints(false, true).drive) << "nothing is held";
  advice.read(held(true), 1);
  EXPECT_TRUE(advice.hints(false, true).drive);
  EXPECT_FALSE(advice.hints(false, false).drive) << "nothing can be pierced";
  advice.use("drive");
  EXPECT_FALSE(advice.hints(false, true).drive);
  EXPECT_EQ(advice.used(), "drag drive");
  advice.reset();
  EXPECT_FALSE(advice.hints(false, true).drag) << "what was used stays known";
}

// From aside keys lead to the needle only two or three at a time.
TEST(AttemptAdvice, TheViewFromTheSideIsToldWhereANeedleIsDriven) {
  AttemptAdvice advice;
  EXPECT_EQ(advice.hints(false, true).side, 1);
  EXPECT_EQ(advice.hints(true, true).side, 1) << "a view is no answer of a test";
  EXPECT_EQ(advice.hints(false, false).side, 0) << "nothing can be pierced";
  EXPECT_EQ(advice.hints(false, true, CameraPreset::kTop).side, 3) << "F11 goes by near and orbit";
  EXPECT_EQ(advice.hints(false, true, CameraPreset::kSide).side, 0);
  advice.use("side");
  EXPECT_EQ(advice.hints(false, true).side, 0);
}

}  // namespace
}  // namespace swage::console
