// SPDX-License-Identifier: Apache-2.0
#include "judge/pull_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "judge/host_events.hpp"

namespace swage::judge {
namespace {

constexpr PullRule kRule{0.1, 30};

TEST(PullRule, PointsAreLostInProportionToWhatIsMissing) {
  EXPECT_EQ(points_lost(kRule, 0.1), 0);
  EXPECT_EQ(points_lost(kRule, 0.2), 0);
  EXPECT_DOUBLE_EQ(points_lost(kRule, 0.075), 7.5);
  EXPECT_EQ(points_lost(kRule, 0), 30);
  EXPECT_EQ(points_lost(kRule, std::nan("")), 30);
  EXPECT_EQ(points_lost({0.1, 0}, 0), 0);
}

TEST(PullRule, APassedAttemptKeepsForty) {
  EXPECT_EQ(score_after_pull(kRule, 98, 0.1), 98);
  EXPECT_EQ(score_after_pull(kRule, 98, 0), 68);
  EXPECT_EQ(score_after_pull(kRule, 55, 0), 40);
  EXPECT_EQ(score_after_pull(kRule, 30, 0), 30) << "a lesson of another scale is not raised";
}

TEST(PullRule, ItsMetricsComeLast) {
  Script script;
  script.metrics = {{"lesson", "time.task", "s", ""}};
  EXPECT_EQ(declare_pull_metrics(script), 1u);
  ASSERT_EQ(script.metrics.size(), 1u + kPullMeasureCount);
  EXPECT_EQ(script.metrics[1 + kPullBears].id, "knot.bears");
  EXPECT_EQ(script.metrics[1 + kPullBears].owner, kHostOwner);
  EXPECT_EQ(script.metrics[1 + kPullPoints].id, "points.pull");
}

}  // namespace
}  // namespace swage::judge
