// SPDX-License-Identifier: Apache-2.0
//
// A new user's first view of the window: it fits the screen, explains controls and criteria, and a test
// shows no answers. Runs on the offscreen platform without OpenGL, and under Xvfb with it.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPainter>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <algorithm>
#include <utility>

#include "console/pages/now_panel.hpp"
#include "console/view3d/overlay.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class FirstSight : public WindowTest {};

TEST_F(FirstSight, ASmallScreenHasRoomForEverything) {
  open();
  ASSERT_TRUE(wait_for_preview());
  // 1920x1080 at 200 % leaves 960x540
  for (const QSize& size : {QSize(1280, 800), QSize(960, 540)}) {
    // in steps, as when its edge is dragged: the panels become narrow first
    EXPECT_TRUE(eventually([&] {
      window->resize(size);
      return window->size() == size;
    })) << window->width() << " x " << window->height();
    ASSERT_TRUE(eventually([&] { return child<QPushButton>("view_menu")->isVisible(); }));
    for (const char* name : {"start", "pause", "stop", "help_button", "view_menu", "sound"}) {
      const auto* button = child<QPushButton>(name);
      const QRect at(button->mapTo(window.get(), QPoint()), button->size());
      EXPECT_TRUE(window->rect().contains(at)) << name << " at " << size.width();
    }
  }
  // buttons without room are in the menu, with the same function
  EXPECT_FALSE(child<QPushButton>("cues")->isVisible());
  window->resize(1440, 900);
  EXPECT_TRUE(eventually([&] { return child<QPushButton>("cues")->isVisible(); }));
}

TEST_F(FirstSight, TheFirstStartStaysOnTheScreen) {
  first_start = true;
  open();
  // The offscreen platform's screen is smaller than the window's usual size; that of Xvfb is larger.
  const QSize screen = window->screen()->availableGeometry().size();
  EXPECT_LE(window->width(), std::max(screen.width(), window->minimumSizeHint().width())) << "or START lies outside";
  EXPECT_LE(window->height(), std::max(screen.height(), window->minimumSizeHint().height()));
}

// the selected row is legible: it has pixels that contrast with its background
TEST_F(FirstSight, AnOpenedChoiceShowsWhatIsChosen) {
  open();
  click("page_setup");
  for (const char* name : {"theme", "cue_theme"}) {
    auto* choice = child<QComboBox>(name);
    choice->showPopup();
    QTest::qWait(50);
    auto* list = choice->view();
    const QRect row = list->visualRect(list->model()->index(choice->currentIndex(), 0));
    ASSERT_TRUE(list->viewport()->rect().contains(row)) << name << ": every row is seen without scrolling";
    const QImage picture = list->viewport()->grab(row).toImage();
    const int ground = qGray(picture.pixel(2, picture.height() / 2));
    int words = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) words += std::abs(qGray(picture.pixel(x, y)) - ground) > 60;
    EXPECT_GT(words, 40) << name;
    choice->hidePopup();
  }
}

TEST_F(FirstSight, AVerdictGoesWithItsLesson) {
  script.rate = 100;
  open();
  click("start");
  ASSERT_TRUE(wait_for_end());
  EXPECT_GT(page()->events()->rowCount(), 0);
  child<QListView>("lessons")->setCurrentIndex(child<QListView>("lessons")->model()->index(1, 0));
  EXPECT_EQ(page()->events()->rowCount(), 0);
  EXPECT_FALSE(page()->result()->isVisible());
}

TEST_F(FirstSight, AResultLeadsToTheReviewAndTheNextLesson) {
  script.rate = 100;
  open();
  click("start");
  ASSERT_TRUE(wait_for_end());
  const QString before = page()->setup()->lesson();
  click("next_lesson");
  EXPECT_NE(page()->setup()->lesson(), before);
  EXPECT_FALSE(page()->result()->isVisible());
}

TEST_F(FirstSight, StartSaysThatAnAttemptWaits) {
  run_to(0.5);
  EXPECT_EQ(child<QPushButton>("start")->text(), "Running…");
  QTest::keyClick(window.get(), Qt::Key_F6);
  EXPECT_EQ(child<QPushButton>("start")->text(), "Paused");
}

TEST_F(FirstSight, ATestShowsNoAnswersButInTheInstructorsWindow) {
  script.rate = 20;
  script.end_s = 0;
  open();
  child<QAbstractButton>("test")->click();
  click("start");
  ASSERT_TRUE(wait_for_time(6));
  EXPECT_FALSE(child<console::ForceMeter>("force_meter")->isVisible());
  EXPECT_FALSE(child<QTableView>("events")->isVisible());
  EXPECT_TRUE(page()->legend()->active().isEmpty());
  ask_for_readings(true);
  auto* own = window->findChild<console::InstructorWindow*>();
  ASSERT_NE(own, nullptr);
  EXPECT_TRUE(own->isVisible());
  EXPECT_TRUE(eventually([&] { return !own->legend()->active().isEmpty(); }));
  EXPECT_TRUE(eventually([&] { return own->now()->meter()->value().value_or(0) > 0.1; }));
  click("stop");
  EXPECT_TRUE(child<QTableView>("events")->isVisible()) << "afterwards all is told";
}

TEST_F(FirstSight, ControlsAreToldUntilTheyWereUsed) {
  run_to(0.2);
  QTest::keyClick(page()->view(), Qt::Key_Space);
  EXPECT_TRUE(page()->used_controls().contains("close"));
  EXPECT_FALSE(page()->used_controls().contains("drag"));
  window->close();
  window.reset();
  open();
  EXPECT_TRUE(page()->used_controls().contains("close")) << "remembered";
}

// the label of a mark near the lower edge is drawn above the hint
TEST(Hint, LeavesTheLabelsOfThePictureToBeRead) {
  constexpr int kWidth_px = 640, kHeight_px = 300;
  const auto ui = console::UiTheme::stock(QStringLiteral("light"));
  const QString text = QStringLiteral("Hold Space: close the jaws, B: open them");
  const auto rows = [&](const auto& paint) {  // the highest and the lowest line drawn in the middle
    QImage picture(kWidth_px, kHeight_px, QImage::Format_RGB32);
    picture.fill(Qt::black);
    QPainter painter(&picture);
    paint(painter);
    painter.end();
    int high = kHeight_px, low = 0;
    for (int y = 0; y < kHeight_px; ++y)
      if (qGray(picture.pixel(kWidth_px / 2 + 30, y)) > 40) high = std::min(high, y), low = y;
    return std::pair{high, low};
  };
  const int hint = rows([&](QPainter& p) { console::Overlay(p, QRectF(0, 0, kWidth_px, kHeight_px), ui).hint(text, 0, kWidth_px); }).first;
  const int label = rows([&](QPainter& p) {
                      const double below = console::Overlay::hint_height(text, p.font(), 0, kWidth_px);
                      console::CueStyle style;
                      style.text = QStringLiteral("Loose first throw");
                      console::Overlay(p, QRectF(0, 0, kWidth_px, kHeight_px - below), ui).target_word({kWidth_px / 2.0, kHeight_px - 30.0}, 10, style);
                    }).second;
  EXPECT_GT(hint, kHeight_px - 60);
  EXPECT_GT(label, kHeight_px / 2);
  EXPECT_LT(label, hint);
}

// the hint is drawn beside the inset, neither over it nor cut off
TEST(Hint, StaysBesideAnInsetInAsManyLinesAsItNeeds) {
  constexpr int kInset_px = 320, kHeight_px = 200;
  const auto lowest = [](double right, const QString& text) {
    QImage picture(640, kHeight_px, QImage::Format_RGB32);
    picture.fill(Qt::black);
    QPainter painter(&picture);
    console::Overlay(painter, picture.rect(), console::UiTheme::stock(QStringLiteral("light"))).hint(text, 0, right);
    painter.end();
    int rows = 0;
    for (int y = 0; y < kHeight_px; ++y) {
      bool drawn = false;
      for (int x = 0; x < picture.width(); ++x) {
        const bool here = qGray(picture.pixel(x, y)) > 40;
        EXPECT_FALSE(here && x >= right) << x << " " << y;
        drawn = drawn || here;
      }
      rows += drawn;
    }
    return rows;
  };
  const QString part = QStringLiteral("Drag, or A D W S Q E: move"), both = part + QString::fromUtf16(console::kHintGap) + part;
  const int one = lowest(kInset_px, part);
  EXPECT_GT(one, 10);
  EXPECT_EQ(lowest(640, both), one);
  EXPECT_GT(lowest(kInset_px, both), 2 * one - 2);
}

TEST_F(FirstSight, TheRightColumnNeedsNoScrollBarWhileALessonRuns) {
  run_to(0.3);
  EXPECT_TRUE(eventually([&] {
    window->resize(1276, 776);  // the area inside a window frame of 1280x800
    return window->size() == QSize(1276, 776);
  }));
  QTest::keyClick(window.get(), Qt::Key_F6);
  auto* now = window->findChild<console::NowPanel*>();
  QWidget* up = now;
  while (up && !qobject_cast<QScrollArea*>(up)) up = up->parentWidget();
  auto* column = qobject_cast<QScrollArea*>(up);
  ASSERT_NE(column, nullptr);
  console::Reading reading;
  reading.phase = QStringLiteral("Bring its point to the mark, perpendicular to the tissue, and hold it there until the ring is closed.");
  for (const char* name : {"Grasp attempts", "Drops", "Regrasps", "Resets"}) reading.counts.append({QString::fromLatin1(name), QStringLiteral("0")});
  now->show_reading(reading, 12);
  QTest::qWait(50);
  EXPECT_EQ(column->verticalScrollBar()->maximum(), 0);
}

// with two mouse devices Tab switches the instrument; with one it moves the focus, as everywhere
TEST_F(FirstSight, TabHandsOverWhereTheMouseLeadsTwo) {
  for (const bool two : {true, false}) {
    script.two_hands = two;
    run_to(0.2);
    page()->view()->setFocus();
    log->pointer.clear();
    QTest::keyClick(page()->view(), Qt::Key_Tab);
    const bool told = std::any_of(log->pointer.begin(), log->pointer.end(), [](const swage_pointer& p) { return (p.keys >> 46 & 1) != 0; });
    EXPECT_EQ(told, two);
    EXPECT_EQ(page()->view()->hasFocus(), two);
    window->close();
    window.reset();
  }
}

TEST_F(FirstSight, TheTraineesViewIsSetUpAndRemembered) {
  open();
  click("trainee_options");
  auto* form = window->findChild<console::TraineeSettings*>(QStringLiteral("trainee_settings"));
  ASSERT_NE(form, nullptr);
  EXPECT_EQ(window->trainee(), nullptr) << "settings come first";
  QTest::mouseClick(form->findChild<QPushButton*>(QStringLiteral("trainee_toggle")), Qt::LeftButton);
  ASSERT_NE(window->trainee(), nullptr);
  EXPECT_TRUE(window->trainee()->isVisible());
  form->findChild<QComboBox*>(QStringLiteral("trainee_layout"))->setCurrentIndex(1);
  form->findChild<QDoubleSpinBox*>(QStringLiteral("trainee_eyes"))->setValue(30);
  EXPECT_EQ(form->look().stereo.layout, console::StereoLayout::kOverUnder);
  // it receives what the instructor's view receives, and the keys of the window work there, too
  QTest::keyClick(window.get(), Qt::Key_F5);
  EXPECT_TRUE(window->trainee()->view()->instrument());
  QTest::keyClick(window.get(), Qt::Key_F9);
  EXPECT_EQ(window->trainee(), nullptr);
  window->close();
  window.reset();
  open();
  click("trainee_button");
  ASSERT_NE(window->trainee(), nullptr) << "the button does what F9 does";
  click("trainee_button");
  EXPECT_EQ(window->trainee(), nullptr);
  click("trainee_options");
  form = window->findChild<console::TraineeSettings*>(QStringLiteral("trainee_settings"));
  EXPECT_EQ(form->look().stereo.layout, console::StereoLayout::kOverUnder);
  EXPECT_FLOAT_EQ(form->look().stereo.rig.eye_distance_mm, 30);
}

// The record of an attempt begins with the display settings, and notes their changes.
TEST_F(FirstSight, AnAttemptSaysHowItWasSeen) {
  script.rate = 1;
  script.end_s = 0;
  open();
  click("start");
  EXPECT_EQ(log->last.display, (record::Display{"mono"}));
  control()->stop();
  click("trainee_button");
  console::TraineeLook look;
  look.stereo.layout = console::StereoLayout::kLines;
  look.stereo.mirror = console::Mirror::kUpDown;
  look.stereo.rig.swapped = true;
  window->trainee()->show_as(look);
  click("start");
  EXPECT_EQ(log->last.display, (record::Display{"lines", true, true, "up_down", 0}));
  ASSERT_TRUE(wait_for_time(0.1));
  EXPECT_TRUE(log->noted.empty()) << log->noted.front();
  look.stereo.layout = console::StereoLayout::kLeftEye;
  window->trainee()->show_as(look);
  ASSERT_TRUE(eventually([&] { return log->noted.size() == 1; }));
  EXPECT_EQ(log->noted[0], "display: left, mirrored up_down");
  click("trainee_button");
  ASSERT_TRUE(eventually([&] { return log->noted.size() == 2; }));
  EXPECT_EQ(log->noted[1], "display: mono");
  control()->stop();
  look.stereo.layout = console::StereoLayout::kSideBySide;
  look.stereo.rig.eye_distance_mm = 0;
  click("trainee_button");
  window->trainee()->show_as(look);
  click("start");
  EXPECT_FALSE(log->last.display.stereo) << "eyes that are nowhere apart see one picture";
}

// The running suture has seventeen cues.
TEST_F(FirstSight, TheLegendHasRoomForSeventeenCues) {
  open();
  console::CueLegend* legend = page()->legend();
  const QStringList seventeen = {"target.near", "insert.good", "insert.angle_off", "needle.stuck", "tissue.tear", "grip.too_hard", "target.done",
                                 "suture.swage_held", "suture.tail_good", "target.point", "tail.point", "exit.point", "needle.bent", "tissue.deflected",
                                 "needle.dropped", "target.left", "thread.taut"};
  QList<QRect> rows;
  const auto shown = [&] {
    legend->set_meanings(seventeen);  // the page may still set those of the lesson
    rows.clear();
    for (const QWidget* row : legend->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (!row->accessibleName().isEmpty() && row->isVisible()) rows += row->geometry();
    return rows.size() == 17;
  };
  ASSERT_TRUE(eventually(shown)) << rows.size() << " rows";
  for (int i = 0; i < rows.size(); ++i) {
    EXPECT_TRUE(legend->rect().contains(rows[i])) << "row " << i;
    for (int k = 0; k < i; ++k) EXPECT_FALSE(rows[i].intersects(rows[k])) << "rows " << k << " and " << i;
  }
}

// Readings and plots belong to a lesson: without one there are none.
TEST(Now, ShowsNoReadingsWithoutALesson) {
  console::NowPanel now;
  now.set_themes(console::UiTheme::stock("light"), console::CueTheme::stock("safe"));
  const auto* plots = now.findChild<QPushButton*>("lower_0");
  EXPECT_FALSE(now.meter()->isVisibleTo(&now));
  EXPECT_FALSE(plots->isVisibleTo(&now));
  for (const QFrame* part : now.findChildren<QFrame*>()) EXPECT_FALSE(part->property("card").toBool() && part->isVisibleTo(&now)) << "an empty card";
  now.set_scene(console::Reader(snapshot::SceneCard{}), {0.3, 0.7}, "Look at it.", {});
  EXPECT_FALSE(plots->isVisibleTo(&now)) << "nothing to plot: what may be adjusted is there";
  EXPECT_TRUE(now.findChild<QPushButton*>("lower_1")->isChecked());
  snapshot::SceneCard card;
  card.script.signals = {{"grasp", "grasp.force", "N", ""}};
  now.set_scene(console::Reader(card), {0.3, 0.7}, "Grasp it.", {});
  EXPECT_TRUE(plots->isVisibleTo(&now));
  EXPECT_TRUE(plots->isChecked());
  now.set_readings_hidden(true);
  EXPECT_FALSE(plots->isVisibleTo(&now)) << "a test";
}

// The maximum of a quarter of a second is shown beside the lesson's limit; it is hidden with the other readings in a test.
TEST(Now, TellsTheTensionOfTheThreadBesideItsLimit) {
  console::NowPanel now;
  now.set_themes(console::UiTheme::stock("light"), console::CueTheme::stock("safe"));
  const auto* told = now.findChild<QLabel*>("thread_tension");
  snapshot::SceneCard card;
  card.script.signals = {{"swaged", "swage.tension", "N", ""}};
  console::Criteria asked;
  asked.max_tension_N = 5e-3;
  now.set_scene(console::Reader(card), {0.3, 0.7}, "Draw it.", asked);
  now.set_running(true);
  EXPECT_TRUE(told->isVisibleTo(&now));
  const auto text_at = [&](double time_s, double tension_N) {
    console::Reading r;
    r.tension = tension_N;
    now.show_reading(r, time_s);
    return told->text().replace(QChar(0x202f), ' ');
  };
  EXPECT_EQ(text_at(1, 2e-3), "2.0 mN of 5.0 mN");
  EXPECT_EQ(text_at(1.1, 7e-3), "2.0 mN of 5.0 mN") << "not yet";
  EXPECT_EQ(text_at(1.3, 1e-3), "▲ 7.0 mN, over 5.0 mN") << "a jerk is not missed";
  EXPECT_EQ(text_at(0.1, 3e-3), "3.0 mN of 5.0 mN") << "another attempt";
  now.set_readings_hidden(true);
  EXPECT_FALSE(told->isVisibleTo(&now)) << "a test";
  asked.max_tension_N = 0;
  now.set_scene(console::Reader(card), {0.3, 0.7}, "Draw it.", asked);
  EXPECT_EQ(text_at(2, 2e-3), "2.0 mN");
  EXPECT_EQ(text_at(3, 0), "0.0 mN") << "one unit whatever the value is";
}

// All texts of a legend have one size: smaller if one of them does not fit its line.
TEST(Legend, WritesAllItsWordsSmallerWhereOneIsTooLong) {
  console::CueLegend legend;
  legend.set_themes(console::UiTheme::stock("light"), console::CueTheme::stock("safe"));
  legend.set_meanings({"grasp.good", "grasp.too_tight"});
  const auto long_words_at = [&legend](int width) {
    legend.resize(width, 140);
    legend.show();
    return legend.has_long_words();
  };
  EXPECT_TRUE(long_words_at(260));
  EXPECT_FALSE(legend.cut_words().isEmpty());
  EXPECT_FALSE(long_words_at(1200));
  EXPECT_TRUE(legend.cut_words().isEmpty());
}

// The line on cues is shown for a lesson without cues, and not without a lesson.
TEST(Legend, SpeaksOfNoCuesOnlyOfALesson) {
  console::CueLegend legend;
  legend.set_themes(console::UiTheme::stock("light"), console::CueTheme::stock("safe"));
  const auto says_none = [&] {
    for (const QLabel* label : legend.findChildren<QLabel*>())
      if (!label->isHidden() && label->text().contains("no cues")) return true;
    return false;
  };
  EXPECT_FALSE(says_none());
  legend.set_meanings({});
  EXPECT_TRUE(says_none());
  legend.set_meanings({"grasp.good"});
  EXPECT_FALSE(says_none());
}

}  // namespace
}  // namespace swage::test
