// SPDX-License-Identifier: Apache-2.0
//
// The guide on the Run page: switched by a key, remembered, never in a test, noted in the attempt.
#include <algorithm>

#include "session/sentences.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class GuideOnPage : public WindowTest {
 protected:
  GuideOnPage() {
    with_expert = true;
    script.rate = 0.5;
    script.end_s = 0;
  }
  bool told(const QString& words) {
    for (int r = 0; r < page()->events()->rowCount(); ++r)
      if (page()->events()->at(r).what.contains(words) || page()->events()->at(r).means.contains(words)) return true;
    return false;
  }
};

TEST_F(GuideOnPage, IsOffUntilItIsAskedForAndThenRemembered) {
  open();
  EXPECT_FALSE(page()->guided());
  click("start");
  ASSERT_TRUE(wait_for_time(0.1));
  EXPECT_EQ(experts, 0);
  EXPECT_FALSE(log->last.display.guided);
  QTest::keyClick(window.get(), Qt::Key_F4);
  EXPECT_TRUE(page()->guided());
  ASSERT_TRUE(eventually([&] { return page()->view()->ghost_shown(); }));
  ASSERT_TRUE(eventually([&] { return std::any_of(log->noted.begin(), log->noted.end(), [](const std::string& n) {
                                 return n == "display: mono, guided";
                               }); }))
      << "in the middle of an attempt it is noted at its moment";
  QTest::keyClick(window.get(), Qt::Key_F4);
  EXPECT_FALSE(page()->view()->ghost_shown());
  EXPECT_EQ(page()->guide(), nullptr);
  QTest::keyClick(window.get(), Qt::Key_F4);
  window->close();
  window.reset();
  open();
  EXPECT_TRUE(page()->guided());
}

TEST_F(GuideOnPage, TheRecordSaysThatItWasThere) {
  launch.draws_seed = true;
  open();
  click("guide");
  click("start");
  EXPECT_TRUE(log->last.display.guided);
  EXPECT_EQ(experts, 1);
  // the same targets as the trainee's
  const auto seed = [](const session::Options& o) {
    const auto at = std::find_if(o.settings.begin(), o.settings.end(), [](const std::string& s) { return s.starts_with("seed="); });
    return at == o.settings.end() ? std::string() : *at;
  };
  EXPECT_NE(seed(log->last), "");
  EXPECT_EQ(seed(expert_options), seed(log->last));
  EXPECT_EQ(expert_options.lesson_path, log->last.lesson_path);
  ASSERT_TRUE(eventually([&] { return page()->view()->ghost_shown(); }));
  // the ghost waits: the trainee of this session is half as fast
  ASSERT_TRUE(wait_for_time(1.5));
  const console::GuidePosition at = page()->guide()->position();
  EXPECT_LE(at.shown_way_m, at.progress_way_m + console::GhostPace::kLead_m + 1e-9);
  click("stop");
  EXPECT_FALSE(page()->view()->ghost_shown()) << "gone with the attempt";
}

TEST_F(GuideOnPage, ThereIsNoneInATest) {
  open();
  click("guide");
  page()->setup()->set_mode("test");
  EXPECT_FALSE(child<QPushButton>("guide")->isEnabled());
  click("start");
  ASSERT_TRUE(wait_for_time(0.1));
  EXPECT_EQ(experts, 0);
  EXPECT_FALSE(log->last.display.guided);
  QTest::keyClick(window.get(), Qt::Key_F4);
  EXPECT_EQ(experts, 0) << "nor by its key";
  click("stop");
  page()->setup()->set_mode("practice");
  EXPECT_TRUE(page()->guided()) << "as before";
}

TEST_F(GuideOnPage, ALessonWithoutAnExpertSaysSoAndRuns) {
  no_expert = session::say::kNoHand("expert");
  open();
  click("guide");
  click("start");
  ASSERT_TRUE(wait_for_time(0.1));
  EXPECT_TRUE(told("This lesson has no hand"));
  EXPECT_FALSE(log->last.display.guided);
}

TEST_F(GuideOnPage, NobodyFollowsAnExpertWhoFails) {
  expert_passes = false;
  open();
  click("guide");
  click("start");
  ASSERT_TRUE(eventually([&] { return told("does not pass this lesson"); }));
  EXPECT_FALSE(page()->view()->ghost_shown());
}

}  // namespace
}  // namespace swage::test
