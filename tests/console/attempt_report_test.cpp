// SPDX-License-Identifier: Apache-2.0
//
// The printed report of an attempt: its metrics are marked as in the review.
#include "console/report/attempt_report.hpp"

#include <gtest/gtest.h>

#include "console/app/language.hpp"
#include "console/models/metric_limits.hpp"
#include "fake_recording.hpp"
#include "paper.hpp"
#include "window_fixture.hpp"

namespace swage::console {
namespace {

class AttemptReports : public swage::test::WindowTest {
 protected:
  AttemptReports() {
    record::AttemptRow attempt = swage::test::fake_attempt();
    attempt.metrics = {{"odd.number", "1", 3}, {"force.peak", "N", 1.6}, {"motion.path", "m", 0.1}};
    review = make_review(attempt, recording, {});
    set_limits(review, [](const std::string& metric) {
      return metric == "force.peak" ? MetricTarget{0.1, 0.9} : metric == "motion.path" ? MetricTarget{{}, 0.2} : MetricTarget{};
    });
  }

  record::Recording recording = swage::test::fake_recording(2000);
  Review review;
};

TEST_F(AttemptReports, MarkMetricsBeyondTheirLimitsAsTheReviewDoes) {
  const QVector<PrintedMetric> rows = metric_rows(review);
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].cells[1], beyond_sign(Beyond::kAbove) + QStringLiteral(" 1.60\u202fN")) << "what is beyond its limit comes first";
  EXPECT_EQ(rows[0].below, QStringLiteral("From 0.10\u202fN to 0.90\u202fN is asked"));
  EXPECT_EQ(rows[1].cells[1], "3") << "the lesson asks nothing of it";
  EXPECT_EQ(rows[1].below, "");
  EXPECT_FALSE(rows[2].cells[1].contains(beyond_sign(Beyond::kAbove))) << "within its limit";
  EXPECT_EQ(rows[2].below, "");
}

// The longest names and limits of the stock lessons in both languages; the limits are their widest.
TEST_F(AttemptReports, CutNoWord) {
  for (const char* language : {"en", "de"}) {
    ASSERT_TRUE(use_language(QString::fromLatin1(language)));
    set_limits(review, [](const std::string&) { return MetricTarget{-0.01, 0.015}; });
    review.metrics[0].name = QString::fromLatin1(language) == QLatin1String("en") ? QStringLiteral("Turns about the instrument, a whole one from 0.75")
                                                                                  : QStringLiteral("Ferner Rand, Stichabstand innen (Nadeldurchmesser)");
    EXPECT_EQ(swage::test::cut_on_paper("Arun P.", [&](Sheet& sheet) { draw_attempt(sheet, {review, recording, {}, {}, {}, {}}); }), "") << language;
  }
  use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
}

}  // namespace
}  // namespace swage::console
