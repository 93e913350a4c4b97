// SPDX-License-Identifier: Apache-2.0
//
// The Review page in the whole window, with keys and clicks.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QTableView>
#include <QTableWidget>
#include <cmath>

#include "console/widgets/plot_file.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class ReviewPages : public WindowTest {
 protected:
  void open_review() {
    attempts = sample_attempts();
    open();
    click("page_people");
    window->people_page()->select_person("Arun P.");
    window->people_page()->person()->focus_attempts();
    EXPECT_TRUE(child<QPushButton>("review")->isEnabled()) << "the newest one is chosen";
    auto* table = child<QTableView>("attempts");
    table->selectRow(0);
    QTest::keyClick(table, Qt::Key_Return);
    ASSERT_TRUE(review()->isVisible());
  }
  console::ReviewPage* review() { return window->review_page(); }
  bool arrives(uint64_t step) {
    return eventually([&] { return review()->player() && review()->player()->at() == step; });
  }
};

TEST_F(ReviewPages, EnterOpensAnAttemptWithItsTracesEventsAndMetrics) {
  open_review();
  EXPECT_TRUE(child<QLabel>("review_title")->text().contains("Arun P."));
  EXPECT_EQ(child<QTableWidget>("review_metrics")->rowCount(), 3);
  EXPECT_EQ(child<QTableWidget>("review_moments")->rowCount(), 2);  // without the lost deadline
  EXPECT_EQ(review()->review().traces.size(), 4);
  EXPECT_FALSE(review()->timeline()->grab().isNull());
  click("review_back");
  EXPECT_TRUE(window->people_page()->isVisible());
}

TEST_F(ReviewPages, AnAttemptOutOfAFileIsAnArgument) {
  launch.attempt_file = "/somewhere/one.swage";
  open();
  ASSERT_TRUE(review()->isVisible());
  EXPECT_TRUE(child<QLabel>("review_title")->text().contains("Bea L."));
  EXPECT_EQ(review()->review().traces.size(), 4);
  window->review_file("/somewhere/damaged.swage");
  EXPECT_EQ(child<QLabel>("review_problem")->text(), "/somewhere/damaged.swage is damaged and cannot be read.");
  EXPECT_FALSE(child<QPushButton>("save_swage")->isEnabled());
}

TEST_F(ReviewPages, SceneTracesAndTimeFollowOneCursor) {
  open_review();
  console::Timeline* timeline = review()->timeline();
  // a click
  QTest::mouseClick(timeline, Qt::LeftButton, {},
                    QPoint(static_cast<int>(timeline->x_of(1.0)), timeline->height() / 2));
  EXPECT_NEAR(timeline->cursor(), 1.0, 0.01);
  EXPECT_NEAR(child<QDoubleSpinBox>("review_time")->value(), 1.0, 0.01);
  EXPECT_TRUE(arrives(static_cast<uint64_t>(std::llround(timeline->cursor() * 1000))));
  // keys
  QTest::keyClick(timeline, Qt::Key_Home);
  EXPECT_TRUE(arrives(0));
  QTest::keyClick(timeline, Qt::Key_Right);
  EXPECT_TRUE(arrives(10));
  QTest::keyClick(timeline, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_TRUE(arrives(11));
  QTest::keyClick(timeline, Qt::Key_Period);
  EXPECT_TRUE(arrives(500));
  QTest::keyClick(timeline, Qt::Key_Period);
  EXPECT_TRUE(arrives(900));
  QTest::keyClick(timeline, Qt::Key_Comma);
  EXPECT_TRUE(arrives(500));
  QTest::keyClick(timeline, Qt::Key_End);
  EXPECT_TRUE(arrives(2000));
  // a typed time, and an event of the list
  child<QDoubleSpinBox>("review_time")->setValue(0.123);
  EXPECT_TRUE(arrives(123));
  auto* moments = child<QTableWidget>("review_moments");
  Q_EMIT moments->cellActivated(1, 0);
  EXPECT_TRUE(arrives(900));
}

TEST_F(ReviewPages, PlaysToTheEndAndStops) {
  open_review();
  child<QComboBox>("speed")->setCurrentIndex(5);
  EXPECT_EQ(QApplication::focusWidget(), review()->timeline());
  QTest::keyClick(review()->timeline(), Qt::Key_Space);
  EXPECT_TRUE(review()->playing());
  EXPECT_TRUE(arrives(2000));
  EXPECT_TRUE(eventually([&] { return !review()->playing(); }));
}

TEST_F(ReviewPages, WithoutThePluginTheTracesAreThereAndItSaysWhy) {
  plugin_missing = "\"org.example.clip\" is not installed.";
  open_review();
  EXPECT_TRUE(child<QLabel>("review_note")->isVisible());
  EXPECT_TRUE(child<QLabel>("review_note")->text().contains("org.example.clip"));
  EXPECT_EQ(child<QTableWidget>("review_metrics")->rowCount(), 3);
  QTest::keyClick(review()->timeline(), Qt::Key_End);
  EXPECT_DOUBLE_EQ(review()->timeline()->cursor(), 2.0);
}

TEST_F(ReviewPages, APictureThatIsNotTheAttemptSaysSo) {
  differs = 300;
  open_review();
  EXPECT_TRUE(eventually([&] { return child<QLabel>("review_note")->isVisible(); }));
  EXPECT_TRUE(child<QLabel>("review_note")->text().contains("0.30 s"));
}

TEST_F(ReviewPages, AnUnreadableAttemptSaysWhyAndNothingCanBeSaved) {
  recorded_steps = 0;
  open_review();
  EXPECT_TRUE(child<QLabel>("review_problem")->text().contains("damaged"));
  EXPECT_FALSE(child<QPushButton>("save_swage")->isEnabled());
}

TEST_F(ReviewPages, WritesCsvAndSaysWhatItCannotWrite) {
  open_review();
  const QString file = dir.filePath("signals.csv");
  EXPECT_EQ(review()->write_signals(file), QString());
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  EXPECT_EQ(written.readAll().count('\n'), 2001);
  EXPECT_EQ(review()->write_summary(dir.filePath("summary.csv")), QString());
  EXPECT_TRUE(review()->write_signals("/no/such/folder/x.csv").contains("cannot be written"));
  EXPECT_TRUE(review()->write_swage(dir.filePath("a.swage")).contains("is a fake"));
}

TEST_F(ReviewPages, ALoopGoesRoundUntilItIsLeft) {
  open_review();
  review()->go(1.0);
  EXPECT_TRUE(arrives(1000));
  QTest::keyClick(review()->timeline(), Qt::Key_L);
  EXPECT_TRUE(child<QPushButton>("review_loop")->isChecked());
  child<QComboBox>("speed")->setCurrentIndex(5);
  // the whole attempt of 2 s is in the loop: past its end the cursor is at the start again, and it plays on
  review()->go(1.9);
  review()->toggle_play();
  EXPECT_TRUE(eventually([&] { return review()->timeline()->cursor() < 0.8; }));
  EXPECT_TRUE(review()->playing());
  QTest::keyClick(review()->timeline(), Qt::Key_L);
  EXPECT_TRUE(eventually([&] { return !review()->playing(); })) << "it ends at the end";
}

TEST_F(ReviewPages, APictureOfAPlotIsAFile) {
  open_review();
  for (const char* name : {"plot.png", "plot.pdf"}) {
    const QString file = dir.filePath(QLatin1String(name));
    EXPECT_EQ(console::save_plot(*review()->timeline(), file), QString());
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_TRUE(written.read(4).contains(name[5] == 'p' && name[6] == 'n' ? "PNG" : "%PDF"));
    EXPECT_GT(written.size(), 2000);
  }
  EXPECT_TRUE(console::save_plot(*review()->timeline(), QStringLiteral("/nowhere/plot.png")).contains("/nowhere/plot.png"));
}

}  // namespace
}  // namespace swage::test
