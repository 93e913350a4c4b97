// SPDX-License-Identifier: Apache-2.0
#include "console/models/metric_titles.hpp"

#include <gtest/gtest.h>

#include "console/models/words.hpp"

namespace swage::console {
namespace {

TEST(MetricTitles, AreWordsAndAShareIsTold) {
  EXPECT_EQ(metric_title("practice.different"), "Different things held");
  EXPECT_EQ(metric_title("time.idle"), "Idle time");
  EXPECT_EQ(quantity_text(0.125, metric_unit("time.idle", "1")),
            QStringLiteral("12.5%1%").arg(QChar(0x202f)));
  EXPECT_EQ(metric_unit("grasp.drops", "1"), "1") << "a count is no share";
  EXPECT_EQ(metric_unit("force.peak", "N"), "N");
}

TEST(MetricTitles, AStrangersMetricIsToldFromItsId) {
  EXPECT_EQ(metric_title("knot.turns_tied"), "Knot turns tied");
  EXPECT_EQ(metric_unit("knot.turns_tied", "1"), "1");
}

}  // namespace
}  // namespace swage::console
