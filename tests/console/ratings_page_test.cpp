// SPDX-License-Identifier: Apache-2.0
//
// The Review page beyond measurements: points lost, the scales of surgeons, an instructor's own rating, and keys in its
// tables; on a real store.
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QUndoStack>
#include <algorithm>

#include "console/app/language.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/pages/comparison.hpp"
#include "console/pages/rating_panel.hpp"
#include "console/widgets/parts.hpp"
#include "record/recorder.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

void learn_points() {
  host::PluginInfo plugin;
  const auto add = [&](const char* id, const char* title, int32_t show) {
    host::MetricInfo m;
    m.id = id;
    m.title = title;
    m.show = show;
    plugin.metrics.push_back(m);
  };
  add("points.time", "Time", SWAGE_SHOW_POINTS);
  add("task.success", "Passed", SWAGE_SHOW_YES_NO);
  console::learn_metric_labels({plugin});
}

class RatingPages : public WindowTest {
 protected:
  void SetUp() override {
    with_school = true;
    learn_points();
  }
  std::string keep(double points_lost) {
    record::AttemptInfo info;
    info.person = "Arun P.";
    info.lesson_id = "swage.series.grasp";
    info.lesson_title = "Grasp the needle";
    info.mode = "practice";
    info.script.metrics = {{"lesson", "points.time", "1", ""}, {"lesson", "task.success", "1", ""}, {"lesson", "force.peak", "N", ""}};
    base::Problems problems;
    const auto recorder = record::Recorder::open(school_file(), info, problems);
    if (!recorder) return {};
    record::AttemptEnd end;
    end.outcome = judge::Outcome::kPassed;
    end.score = 100 - points_lost;
    end.simulated_s = 2;
    end.metric = {points_lost, 1, 0.5};
    recorder->finish(end);
    return recorder->attempt_id();
  }
  void open_attempt(const std::string& id) {
    open();
    click("page_review");
    std::string error;
    store = record::Store::open(school_file(), error);
    ASSERT_TRUE(review()->open(store, QString::fromStdString(id))) << error;
  }
  std::vector<record::ObserverRating> kept(const std::string& id) {
    std::string error;
    return record::School::open(school_file(), error)->ratings(id);
  }
  console::ReviewPage* review() { return window->review_page(); }
  std::shared_ptr<record::Store> store;
};

TEST_F(RatingPages, PointsLostStandBelowAHeadingOfTheirOwn) {
  open_attempt(keep(3));
  auto* metrics = child<QTableWidget>("review_metrics");
  ASSERT_EQ(metrics->rowCount(), 4) << "two measurements, the heading, what it cost";
  EXPECT_EQ(metrics->item(0, 0)->text(), "Passed");
  EXPECT_EQ(metrics->item(2, 0)->text(), "Points lost, of 100");
  EXPECT_EQ(metrics->item(3, 0)->text(), "Time");
  EXPECT_EQ(metrics->item(3, 1)->text(), "−3.0");
}

TEST_F(RatingPages, AScaleSaysThatItIsComputedAndOfHowManyItems) {
  open_attempt(keep(3));
  const QString words = child<QLabel>("computed_smart")->text();
  EXPECT_TRUE(words.startsWith("Computed from metrics: 4.6 of 5, the mean of 2 of 9 items")) << words.toStdString();
  EXPECT_TRUE(words.contains("not decided by the program are not counted"));
  const console::RatedScale& smart = *std::find_if(review()->review().scales.begin(), review()->review().scales.end(),
                                                   [](const console::RatedScale& s) { return s.id == "smart"; });
  EXPECT_TRUE(smart.source.contains("from memory")) << "the source is told as the scale's file has it";
}

// what a scale assumes is told in the reader's language, only the citation stays
TEST(GermanRatings, TellTheirSourceInGerman) {
  ASSERT_TRUE(console::use_language(QStringLiteral("de")));
  const QVector<console::RatedScale> scales = console::rated_scales("passed", {}, {});
  console::use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
  ASSERT_FALSE(scales.isEmpty());
  for (const console::RatedScale& scale : scales) {
    EXPECT_TRUE(scale.source.contains("angenommen")) << scale.source.toStdString();
    EXPECT_FALSE(scale.source.contains("assumed")) << scale.source.toStdString();
  }
}

// why the host ended an attempt (framework/session/run_result.cpp)
TEST(GermanRatings, TellWhyAnAttemptEnded) {
  const std::vector<std::string> ids = {"stopped", "time.limit", "hand.ended", "host.quarantined", "host.impossible"};
  std::vector<QString> english;
  for (const std::string& id : ids) english.push_back(console::said_id(id));
  ASSERT_TRUE(console::use_language(QStringLiteral("de")));
  for (size_t i = 0; i < ids.size(); ++i) EXPECT_NE(console::said_id(ids[i]), english[i]) << ids[i];
  console::use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
}

TEST_F(RatingPages, AnInstructorsRatingIsKeptBesideTheComputedOneAndUndone) {
  const std::string id = keep(3);
  open_attempt(id);
  auto* box = child<QComboBox>("rate_smart.efficiency");
  ASSERT_TRUE(box->isEnabled());
  const auto choose = [&](const QString& points) {
    box->setCurrentIndex(box->findText(points));
    Q_EMIT box->activated(box->currentIndex());
  };
  choose("3");
  ASSERT_EQ(kept(id).size(), 1U);
  EXPECT_EQ(kept(id)[0].points, 3);
  EXPECT_EQ(kept(id)[0].item, "smart.efficiency");
  EXPECT_TRUE(child<QLabel>("given_smart")->text().startsWith("Instructor's rating: 3.0 of 5, the mean of 1 of 9"));
  EXPECT_TRUE(child<QLabel>("computed_smart")->text().contains("4.6 of 5")) << "the computed mean is as it was";
  choose("5");
  EXPECT_EQ(kept(id)[0].points, 5);
  const QString pdf = dir.filePath("rated.pdf"), csv = dir.filePath("rated.csv");
  EXPECT_EQ(review()->exports()->write_report(pdf), QString());
  EXPECT_GT(QFileInfo(pdf).size(), 5000);
  EXPECT_EQ(review()->exports()->write_summary(csv), QString());
  QFile written(csv);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray text = written.readAll();
  EXPECT_TRUE(text.contains("rating_by_instructor,\"smart.efficiency\",,5,")) << text.toStdString();
  EXPECT_TRUE(text.contains("rating,\"smart.efficiency\",,4.2,"));
  // undo to 3, then to no rating; and a rating is removed by hand as well
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(kept(id).size(), 1U);
  EXPECT_EQ(kept(id)[0].points, 3);
  EXPECT_EQ(box->currentText(), "3");
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(kept(id).empty());
  EXPECT_EQ(box->currentText(), "–");
  choose("2");
  choose("–");
  EXPECT_TRUE(kept(id).empty());
}

TEST_F(RatingPages, ThePlaceOfAnAttemptIsFoundByTheBeginningOfItsId) {
  const std::string id = keep(3);
  open_attempt(id.substr(0, id.size() - 2));
  EXPECT_EQ(review()->review().attempt.id, id);
  EXPECT_FALSE(review()->open(store, "ffffffff"));
}

TEST_F(RatingPages, ComparedMetricsStandBesideEachOther) {
  const std::string other = keep(7), id = keep(3);
  open_attempt(id);
  auto* metrics = child<QTableWidget>("review_metrics");
  EXPECT_TRUE(metrics->isColumnHidden(3));
  ASSERT_TRUE(review()->compare(QString::fromStdString(other)));
  EXPECT_FALSE(metrics->isColumnHidden(3));
  EXPECT_EQ(metrics->item(3, 1)->text(), "−3.0");
  EXPECT_EQ(metrics->item(3, 3)->text(), "−7.0");
  review()->end_comparison();
  EXPECT_TRUE(metrics->isColumnHidden(3));
}

TEST_F(RatingPages, NothingToCompareWithIsSaid) {
  open_attempt(keep(3));
  bool said = false;
  auto* look = new QTimer(window.get());
  QObject::connect(look, &QTimer::timeout, look, [&, look] {
    auto* dialog = window->findChild<QDialog*>(QStringLiteral("compare_dialog"));
    if (!dialog || !dialog->isVisible()) return;
    look->stop();
    said = dialog->findChild<QLabel*>(QStringLiteral("compare_none")) != nullptr;
    EXPECT_FALSE(dialog->findChild<QPushButton*>(QStringLiteral("compare_ok"))->isEnabled());
    dialog->reject();
  });
  look->start(10);
  review()->ask_compare();
  EXPECT_TRUE(said);
}

TEST_F(RatingPages, KeysWorkInTheTablesToo) {
  open_attempt(keep(3));
  auto* metrics = child<QTableWidget>("review_metrics");
  ASSERT_TRUE(eventually([&] {
    QApplication::setActiveWindow(window.get());
    metrics->setFocus();
    return QApplication::focusWidget() == metrics;
  }));
  QTest::keyClick(metrics, Qt::Key_Space);
  EXPECT_TRUE(review()->playing());
  QTest::keyClick(metrics, Qt::Key_Space);
  EXPECT_FALSE(review()->playing());
}

TEST_F(RatingPages, TabReachesEveryControlOfThePage) {
  open_attempt(keep(3));
  ASSERT_TRUE(eventually([&] {
    QApplication::setActiveWindow(window.get());
    review()->setFocus();
    return QApplication::focusWidget() == review()->timeline();
  }));
  QStringList names;
  for (int i = 0; i < 80; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    if (QApplication::focusWidget() == review()->timeline()) break;
    names += QApplication::focusWidget()->objectName();
  }
  for (const char* name : {"review_back", "review_note_button", "review_compare", "save_report", "review_export", "play", "speed",
                           "review_time", "review_orbit", "review_forces", "review_metrics"})
    EXPECT_TRUE(names.contains(QLatin1String(name))) << name << " of " << names.join(' ').toStdString();
}

// A jump is quicker than its picture: playback begins at the cursor, not at the time of the picture.
TEST_F(RatingPages, PlayingAfterAJumpBeginsAtTheCursor) {
  recorded_steps = 60'000;
  open_attempt(keep(3));
  review()->go(50);
  review()->toggle_play();
  EXPECT_TRUE(eventually([&] { return review()->player()->at() > 1000; }));
  EXPECT_GE(review()->timeline()->cursor(), 50);
  EXPECT_TRUE(review()->playing());
}

// Two attempts side by side stay so while the first is rated, and the row above the pictures says whose is which.
TEST_F(RatingPages, ARatingLeavesTheComparison) {
  const std::string other = keep(10), first = keep(3);
  open_attempt(first);
  ASSERT_TRUE(review()->compare(QString::fromStdString(other)));
  ASSERT_TRUE(review()->timeline()->has_other());
  EXPECT_TRUE(child<QLabel>("other_title")->text().startsWith("Right: ") && child<QLabel>("other_title")->text().contains("; Arun P., ")) << child<QLabel>("other_title")->text().toStdString();
  EXPECT_EQ(review()->comparison()->ghost_name(), "Other attempt") << "the same person";
  const std::string item = review()->review().scales[0].items[0].id;
  ASSERT_TRUE(window->desk()->rate(first, item, 3));
  EXPECT_EQ(kept(first).size(), 1u);
  EXPECT_TRUE(review()->comparing());
  EXPECT_TRUE(review()->timeline()->has_other());
}

// Either picture says that it is not yet where the cursor is.
TEST_F(RatingPages, BothPicturesSayThatTheyAreOnTheWay) {
  recorded_steps = 60'000;
  const std::string other = keep(10), first = keep(3);
  open_attempt(first);
  ASSERT_TRUE(review()->compare(QString::fromStdString(other)));
  review()->go(50);
  ASSERT_TRUE(eventually([&] { return review()->view()->words().clock.contains("on the way to 00:50"); }));
  EXPECT_TRUE(eventually([&] { return review()->comparison()->view()->words().clock.contains("on the way to"); }))
      << review()->comparison()->view()->words().clock.toStdString();
}

// On a projector of 1024 x 768 each title of a tab can be read, and the choice of another attempt is not wider than its dialog.
class GermanReview : public RatingPages {
 protected:
  void SetUp() override {
    ASSERT_TRUE(console::use_language(QStringLiteral("de")));
    RatingPages::SetUp();
  }
  void TearDown() override {
    window.reset();
    console::use_language(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }
};

TEST_F(GermanReview, NoTitleOfATabIsCutAt1024) {
  const std::string other = keep(10), first = keep(3);
  open_attempt(first);
  auto* tabs = child<QTabWidget>("review_tabs");
  window->resize(1024, 768);
  for (int i = 0; i < tabs->count(); ++i) tabs->setTabVisible(i, true);
  QEvent style(QEvent::StyleChange);
  QApplication::sendEvent(tabs->parentWidget(), &style);
  ASSERT_TRUE(review()->compare(QString::fromStdString(other)));
  const QTabBar* bar = tabs->tabBar();
  EXPECT_TRUE(eventually([&] { return bar->width() >= bar->sizeHint().width(); })) << bar->width() << " of " << bar->sizeHint().width() << " px";
  EXPECT_LE(review()->minimumSizeHint().width(), 1000) << "or the page is to be scrolled sideways";
}

// The verdict of the other attempt can be read without its tooltip.
TEST_F(GermanReview, TheOtherVerdictIsWholeAt1024) {
  const std::string other = keep(10), first = keep(3);
  open_attempt(first);
  ASSERT_TRUE(eventually([&] {
    window->resize(1024, 768);
    return window->size() == QSize(1024, 768);
  }));
  ASSERT_TRUE(review()->compare(QString::fromStdString(other)));
  const auto* title = dynamic_cast<console::ElidedLabel*>(child<QLabel>("other_title"));
  ASSERT_NE(title, nullptr);
  const QString verdict = review()->comparison()->review().verdict();
  ASSERT_TRUE(verdict.contains("Bestanden")) << verdict.toStdString();
  const auto shown = [&] { return title->lines(title->width()).join(QLatin1Char(' ')); };
  EXPECT_TRUE(eventually([&] { return shown().contains(verdict); })) << shown().toStdString() << " in " << title->width() << " px";
  EXPECT_GE(title->height(), title->heightForWidth(title->width()));
}

}  // namespace
}  // namespace swage::test
