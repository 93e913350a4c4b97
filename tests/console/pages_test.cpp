// SPDX-License-Identifier: Apache-2.0
//
// The whole window, by keys and clicks. Runs on the offscreen platform without OpenGL, and under Xvfb with it.
#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSlider>
#include <QTableView>
#include <QTimer>
#include <algorithm>
#include <set>

#include "window_fixture.hpp"

namespace swage::test {
namespace {

using console::RunControl;

class Pages : public WindowTest {};

TEST_F(Pages, FirstLessonRunsWithOneKeyAndNothingTyped) {
  open();
  ASSERT_TRUE(wait_for_preview());
  EXPECT_EQ(child<QLabel>("lesson_title")->text(), "Grasp the needle");
  QTest::keyClick(window.get(), Qt::Key_F5);
  EXPECT_EQ(control()->state(), RunControl::State::kRunning);
  EXPECT_EQ(log->started, 1);
  EXPECT_EQ(log->last.person, "Guest");
  EXPECT_EQ(log->last.device, "mouse");
  EXPECT_EQ(log->last.mode, "practice");
  EXPECT_TRUE(QString::fromStdString(log->last.lesson_path).endsWith("010_grasp.json"));
}

TEST_F(Pages, TwoClicksChooseAndStart) {
  open();
  auto* list = child<QListView>("lessons");
  const QRect second = list->visualRect(list->model()->index(1, 0));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, second.center());
  click("start");
  ASSERT_EQ(log->started, 1);
  EXPECT_TRUE(QString::fromStdString(log->last.lesson_path).endsWith("020_carry.json"));
  EXPECT_FALSE(child<QPushButton>("start")->isEnabled());
}

TEST_F(Pages, KeysPauseResetMarkAndStop) {
  script.end_s = 0;
  open();
  for (const char* name : {"pause", "reset", "mark", "stop"}) EXPECT_FALSE(child<QPushButton>(name)->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_F5);
  ASSERT_TRUE(wait_for_time(0.1));
  QTest::keyClick(window.get(), Qt::Key_F6);
  EXPECT_EQ(control()->state(), RunControl::State::kPaused);
  EXPECT_EQ(log->paused, 1);
  QTest::keyClick(window.get(), Qt::Key_F6);
  EXPECT_EQ(log->resumed, 1);
  QTest::keyClick(window.get(), Qt::Key_F7);
  EXPECT_EQ(log->reset, 1);  // the needle, not the jaws
  QTest::keyClick(window.get(), Qt::Key_F8);
  EXPECT_EQ(log->marked, 1);
  EXPECT_EQ(page()->events()->at(page()->events()->rowCount() - 1).what, "Mark");
  QTest::keyClick(window.get(), Qt::Key_F5, Qt::ShiftModifier);
  EXPECT_EQ(log->stopped, 1);
  EXPECT_EQ(control()->state(), RunControl::State::kFinished);
  EXPECT_EQ(page()->result()->outcome(), "Stopped");
  EXPECT_TRUE(child<QPushButton>("start")->isEnabled());
}

// the needle of the fake scene is an arc of 1.9 mm about the z axis through (0, -1.9) mm, a wire's radius high until it is
// lifted
TEST_F(Pages, ADriveTellsTheMouseTheNeedlesCircleFirst) {
  run_to(4.2);
  ASSERT_EQ(log->changed.size(), 0U);
  QTest::keyPress(page()->view(), Qt::Key_T);
  ASSERT_EQ(log->changed.size(), 1U);
  EXPECT_EQ(log->changed[0].rfind("hand {\"circle_axis\":[", 0), 0U) << log->changed[0];
  EXPECT_EQ(log->changed[0].find("[0.0,0.0,0.0]"), std::string::npos) << "there is a needle at the tips";
  ASSERT_FALSE(log->pointer.empty());
  EXPECT_NE(log->pointer.back().keys & uint64_t{1} << ('t' - 'a'), 0U);
  QTest::keyRelease(page()->view(), Qt::Key_T);
  EXPECT_EQ(log->changed.size(), 1U) << "once for each drive";
  QTest::keyPress(page()->view(), Qt::Key_G);
  QTest::keyRelease(page()->view(), Qt::Key_G);
  EXPECT_EQ(log->changed.size(), 2U);
  // other keys move the focus as usual
  QTest::keyClick(page()->view(), Qt::Key_W);
  EXPECT_EQ(log->changed.size(), 2U);
}

TEST_F(Pages, NumbersArrive) {
  run_to(6);
  ASSERT_TRUE(eventually([&] { return child<console::ForceMeter>("force_meter")->value().value_or(0) > 0.4; }));
  EXPECT_NEAR(child<console::ForceMeter>("force_meter")->value().value_or(0), 0.6, 0.2);
}

TEST_F(Pages, EventsAndResultArrive) {
  script.rate = 100;
  open();
  click("start");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(page()->result()->outcome(), "✓ Passed");
  EXPECT_EQ(page()->result()->reason(), "Held long enough");
  EXPECT_EQ(page()->events()->rowCount(), 3);
  EXPECT_TRUE(page()->result()->isVisible());
  // again, at once
  QTest::keyClick(window.get(), Qt::Key_F5);
  EXPECT_EQ(log->started, 2);
  EXPECT_EQ(page()->events()->rowCount(), 0);
  EXPECT_FALSE(page()->result()->isVisible());
}

TEST_F(Pages, NotMetSaysWhy) {
  script.rate = 200;
  script.pass = false;
  open();
  click("start");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(page()->result()->outcome(), "✗ Not passed");
  EXPECT_EQ(page()->result()->reason(), "The time is over");
}

TEST_F(Pages, ALessonThatCannotRunSaysWhereAndTheWindowGoesOn) {
  script.refuse = "\"swage.jaw\" is not installed. Nearest: \"swage.jaws\".";
  open();
  auto* problem = child<QLabel>("problem");
  ASSERT_TRUE(eventually([&] { return problem->isVisible(); }));
  EXPECT_TRUE(problem->text().contains("swage.jaws"));
  EXPECT_TRUE(problem->text().contains("010_grasp.json"));
  EXPECT_FALSE(child<QPushButton>("start")->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_F5);
  EXPECT_EQ(control()->state(), RunControl::State::kIdle);
  script.refuse.clear();
  QTest::keyClick(window.get(), Qt::Key_F5);  // checks the lesson again
  EXPECT_EQ(control()->state(), RunControl::State::kRunning);
  EXPECT_FALSE(problem->isVisible());
}

TEST_F(Pages, AStoreThatCannotBeWrittenDoesNotStopTheLesson) {
  script.refuse_record = "The disk is full.";
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  auto* offer = child<QPushButton>("run_unrecorded");
  EXPECT_FALSE(offer->isVisible());
  click("start");
  EXPECT_EQ(control()->state(), RunControl::State::kIdle);
  auto* problem = child<QLabel>("problem");
  EXPECT_TRUE(problem->text().contains("The disk is full."));
  ASSERT_TRUE(offer->isVisible());
  click("run_unrecorded");
  ASSERT_EQ(control()->state(), RunControl::State::kRunning);
  EXPECT_EQ(log->last.store_path, ":none:");
  EXPECT_FALSE(offer->isVisible());
  EXPECT_TRUE(problem->isVisible());
  EXPECT_TRUE(problem->text().contains("NOT RECORDED"));
  EXPECT_TRUE(problem->text().contains("The disk is full."));
  ASSERT_TRUE(eventually([&] { return child<QLabel>("recording")->text().contains("Not recorded"); }));
  click("stop");
  EXPECT_TRUE(child<QLabel>("kept")->text().contains("Not recorded"));
  // a lesson that cannot run is not offered
  script.refuse = "\"swage.jaw\" is not installed.";
  click("start");
  EXPECT_FALSE(offer->isVisible());
}

TEST_F(Pages, ModesDecideDeviceStoreAndCues) {
  open();
  child<QAbstractButton>("demo")->click();
  click("start");
  EXPECT_EQ(log->last.mode, "demo");
  EXPECT_EQ(log->last.device, "expert");
  EXPECT_EQ(log->last.store_path, ":none:");
  EXPECT_FALSE(page()->view()->instrument());
  click("stop");
  child<QAbstractButton>("test")->click();
  EXPECT_FALSE(child<QPushButton>("cues")->isEnabled());
  click("start");
  EXPECT_EQ(log->last.mode, "test");
  EXPECT_EQ(log->last.store_path, "");
}

TEST_F(Pages, NameLessonAndThemeAreRemembered) {
  open();
  child<QComboBox>("person")->lineEdit()->setText("Arun P.");
  child<QListView>("lessons")->setCurrentIndex(child<QListView>("lessons")->model()->index(1, 0));
  click("page_setup");
  auto* theme = child<QComboBox>("theme");
  theme->setFocus();
  QTest::keyClick(theme, Qt::Key_Down);
  EXPECT_EQ(window->ui_theme(), "dark");
  window->close();
  window.reset();
  open();
  EXPECT_EQ(page()->setup()->person(), "Arun P.");
  EXPECT_TRUE(page()->setup()->lesson().endsWith("020_carry.json"));
  EXPECT_EQ(window->ui_theme(), "dark");
}

TEST_F(Pages, ClosingDuringARunStopsIt) {
  script.end_s = 0;
  open();
  click("start");
  ASSERT_TRUE(wait_for_time(0.05));
  window->close();
  EXPECT_EQ(log->stopped, 1);
  window.reset();
}

TEST_F(Pages, EveryControlHasANameAndTheKeyboardReachesAll) {
  open();
  int controls = 0;
  for (QWidget* w : window->findChildren<QWidget*>()) {
    const bool control = qobject_cast<QAbstractButton*>(w) || qobject_cast<QComboBox*>(w) || qobject_cast<QListView*>(w) ||
                         qobject_cast<QTableView*>(w) || qobject_cast<console::SceneView*>(w);
    if (!control || w->objectName().startsWith("qt_") || !qobject_cast<QWidget*>(w->parent())) continue;
    if (w->inherits("QTableCornerButton") || w->inherits("QComboBoxListView")) continue;
    ++controls;
    QAccessibleInterface* a = QAccessible::queryAccessibleInterface(w);
    ASSERT_NE(a, nullptr);
    EXPECT_FALSE(a->text(QAccessible::Name).isEmpty()) << w->metaObject()->className() << " " << w->objectName().toStdString();
  }
  EXPECT_GT(controls, 15);

  // Tab visits every enabled control of the page; in a group of exclusive buttons it stops at the checked one,
  // and the arrow keys reach the others
  QSet<QWidget*> reached;
  QWidget* const first = child<QComboBox>("person");
  first->setFocus();
  QWidget* at = first;
  do {
    at = at->nextInFocusChain();
    if (at->isVisible() && at->isEnabled() && (at->focusPolicy() & Qt::TabFocus)) reached += at;
  } while (at != first);
  for (const char* name : {"lessons", "start", "device", "view_side", "cues", "scene_view", "page_run", "page_setup"}) {
    EXPECT_TRUE(reached.contains(child<QWidget>(name))) << name;
  }
}

TEST_F(Pages, HelpPausesTheRunAndListsTheKeys) {
  script.end_s = 0;
  open();
  click("start");
  bool seen = false;
  QTimer look;
  look.start(10);
  QObject::connect(&look, &QTimer::timeout, [&] {
    auto* dialog = window->findChild<QDialog*>(QStringLiteral("help"));
    if (!dialog) return;
    for (QLabel* label : dialog->findChildren<QLabel*>()) seen |= label->text().contains("F8");
    dialog->accept();
  });
  QTest::keyClick(window.get(), Qt::Key_F1);
  EXPECT_TRUE(seen);
  EXPECT_EQ(log->paused, 1) << "a held key must not go on while it is read";
  EXPECT_EQ(control()->state(), RunControl::State::kRunning) << "the lesson goes on afterwards";
}

TEST_F(Pages, AfterACrashItSaysWhatWasKept) {
  to_recover = 1;
  open();
  EXPECT_TRUE(child<QLabel>("loop_health")->text().contains("1 attempt")) << child<QLabel>("loop_health")->text().toStdString();
}

TEST_F(Pages, TheLeftHandGetsEveryLessonMirroredAndItIsRemembered) {
  open();
  click("start");
  const auto mirrored = [this] {
    const auto& all = log->last.settings;
    return std::find(all.begin(), all.end(), "mirror=true") != all.end();
  };
  EXPECT_FALSE(mirrored());
  click("stop");
  child<QAbstractButton>("left_handed")->click();
  click("start");
  EXPECT_TRUE(mirrored());
  EXPECT_FALSE(child<QAbstractButton>("left_handed")->isEnabled());
  window->close();
  window.reset();
  open();
  EXPECT_TRUE(page()->setup()->left_handed());
}

TEST_F(Pages, ALongTitleEndsInAnEllipsis) {
  open();
  ASSERT_TRUE(wait_for_preview());
  auto* title = child<QLabel>("lesson_title");
  title->setText(QString(40, QLatin1Char('W')));
  title->grab();
  EXPECT_EQ(title->toolTip(), title->text()) << "what is cut is said as a tip";
  title->setText(QStringLiteral("W"));
  title->grab();
  EXPECT_TRUE(title->toolTip().isEmpty());
}

TEST_F(Pages, EveryAttemptDrawsItsOwnSeedUnlessOneIsGiven) {
  open();
  std::set<std::vector<std::string>> drawn;
  for (int i = 0; i < 3; ++i) {
    click("start");
    ASSERT_EQ(log->last.settings.size(), 1U);
    EXPECT_EQ(log->last.settings[0].rfind("seed=", 0), 0U);
    drawn.insert(log->last.settings);
    click("stop");
  }
  EXPECT_GT(drawn.size(), 1U);
  window->close();
  window.reset();
  launch.draws_seed = false;
  launch.options.settings = {"seed=7"};
  open();
  click("start");
  EXPECT_EQ(log->last.settings, std::vector<std::string>{"seed=7"});
}

TEST_F(Pages, TheLegendNamesEveryCueAndShowsWhatIsOn) {
  script.rate = 20;
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  console::CueLegend* legend = page()->legend();
  EXPECT_EQ(legend->meanings(), QStringList({"grasp.wrong", "grasp.tips_only", "grasp.point_only", "grasp.good",
                                             "grip.too_hard", "region.target"}));
  click("start");
  ASSERT_TRUE(eventually([&] { return legend->active() == QStringList{"grasp.good"}; }));
  click("stop");
  EXPECT_TRUE(legend->active().isEmpty());
}

TEST_F(Pages, InATestThePictureIsBareAndSilent) {
  script.rate = 20;
  script.end_s = 0;
  open();
  child<QAbstractButton>("test")->click();
  click("start");
  ASSERT_TRUE(wait_for_time(6));
  EXPECT_FALSE(page()->view()->cues_shown());
  EXPECT_EQ(page()->speaker().written(), 0U);
}

TEST_F(Pages, SoundIsMutedAndRemembered) {
  open();
  EXPECT_TRUE(page()->sound_on());
  click("sound");
  child<QSlider>("volume")->setValue(30);
  window->close();
  window.reset();
  open();
  EXPECT_FALSE(page()->sound_on());
  EXPECT_EQ(child<QSlider>("volume")->value(), 30);
  EXPECT_FALSE(child<QSlider>("volume")->isEnabled());
}

TEST_F(Pages, WhatTheMachineDidIsForTheInstructorsDetail) {
  script.with_gap = true;
  script.rate = 100;
  open();
  click("start");
  ASSERT_TRUE(wait_for_end());
  auto* table = child<QTableView>("events");
  EXPECT_EQ(page()->events()->rowCount(), 4);
  EXPECT_EQ(table->model()->rowCount(), 3);
  click("detail");
  EXPECT_EQ(table->model()->rowCount(), 4);
}

TEST_F(Pages, WithoutOpenGlTheViewSaysSoAndTheRestWorks) {
  open();
  if (page()->view()->gl().ok) GTEST_SKIP() << "this machine has OpenGL";
  ASSERT_TRUE(wait_for_preview());
  click("start");
  ASSERT_TRUE(wait_for_time(0.2));
  EXPECT_FALSE(page()->view()->gl().why.isEmpty());
  EXPECT_FALSE(window->grab().isNull());
}

// must be the last test: a program that was told to quit opens no more dialogs
TEST_F(Pages, ASignalEndsTheAttemptAsStopDoes) {
  run_to(0.1);
  window->leave();
  EXPECT_EQ(log->stopped, 1);
  EXPECT_EQ(control()->state(), RunControl::State::kFinished);
  // the program was told to quit, and opens no dialog until its event loop runs again
  QTimer::singleShot(0, qApp, [] { QCoreApplication::exit(); });
  QCoreApplication::exec();
}

}  // namespace
}  // namespace swage::test
