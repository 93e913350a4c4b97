// SPDX-License-Identifier: Apache-2.0
#include "console/models/metric_titles.hpp"

#include <gtest/gtest.h>

#include "console/models/words.hpp"

namespace swage::console {
namespace {

host::MetricInfo labelled(const char* id, const char* title, int32_t show) {
  host::MetricInfo m;
  m.id = id;
  m.title = title;
  m.show = show;
  return m;
}

void learn() {
  host::PluginInfo one, two;
  one.metrics = {labelled("time.idle", "Idle time", SWAGE_SHOW_SHARE), labelled("grasp.drops", "Drops", SWAGE_SHOW_COUNT),
                 labelled("task.success", "Passed", SWAGE_SHOW_YES_NO)};
  two.metrics = {labelled("grasp.drops", "Falls", SWAGE_SHOW_QUANTITY), labelled("knot.turns", "", SWAGE_SHOW_COUNT)};
  learn_metric_labels({one, two});
}

TEST(MetricTitles, AreThoseOfTheCardsAndAShareIsTold) {
  learn();
  EXPECT_EQ(metric_title("time.idle"), "Idle time");
  EXPECT_EQ(metric_title("grasp.drops"), "Drops") << "the first label stays";
  EXPECT_EQ(quantity_text(0.125, metric_unit("time.idle", "1")),
            QStringLiteral("12.5%1%").arg(QChar(0x202f)));
  EXPECT_EQ(quantity_text(1, metric_unit("task.success", "1")), "yes");
  EXPECT_EQ(quantity_text(0, metric_unit("task.success", "1")), "no");
  EXPECT_EQ(metric_unit("grasp.drops", "1"), "1") << "a count is no share";
}

TEST(MetricTitles, AMetricWithoutLabelIsToldFromItsId) {
  learn();
  EXPECT_EQ(metric_title("knot.turns_tied"), "Knot turns tied");
  EXPECT_EQ(metric_title("knot.turns"), "Knot turns");
  EXPECT_EQ(metric_unit("knot.turns_tied", "1"), "1");
  EXPECT_EQ(metric_unit("force.peak", "N"), "N");
}

}  // namespace
}  // namespace swage::console
