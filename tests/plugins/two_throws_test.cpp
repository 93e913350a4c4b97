// SPDX-License-Identifier: Apache-2.0
//
// Two throws on a wound by two hands, the second one wound the other way: a square knot. The scene and the plans in two_throws/ are one
// way of some forty that were tried, of which few tie: the thread snaps from one side of a tool to the other, and a tenth of a
// millimetre decides to which. A change of the solver may need other plans, so this is a soak test.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

struct Tied {
  double throws, first, second, kind, passages, held, pull;
};

Tied tie(const char* hand) {
  LessonRun attempt(SWAGE_SOURCE_DIR "/tests/plugins/two_throws/two_throws.json", hand);
  EXPECT_EQ(attempt.problems(), "");
  double pull = 0;
  while (attempt.outcome() == "running" && attempt.world().time() < 56) {
    attempt.step();
    if (attempt.world().time() > 52) pull = std::max(pull, attempt.signal("suture", "thread.tension"));
  }
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
  const auto knot = [&](const char* id) { return attempt.signal("knot", id); };
  return {knot("knot.throws"), knot("knot.throw_1"), knot("knot.throw_2"), knot("knot.kind"),
          attempt.signal("suture", "thread.passed") + attempt.signal("winding", "winding.passages") + knot("knot.passages"),
          attempt.signal("tail_grasp", "grasp.force"), pull};
}

TEST(TwoThrows, WoundTheOtherWayAreASquareKnot) {
  const Tied knot = tie("square");
  EXPECT_EQ(knot.throws, 2);
  EXPECT_EQ(knot.first * knot.second, -1);
  EXPECT_EQ(knot.kind, 2) << "square";
  EXPECT_EQ(knot.passages, 0);
  EXPECT_GT(knot.held, 0.2) << "N, on the tail";
  EXPECT_GT(knot.pull, 15e-3) << "N: it bears what the hands draw";
}

}  // namespace
}  // namespace swage::stage
