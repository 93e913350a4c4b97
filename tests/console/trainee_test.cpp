// SPDX-License-Identifier: Apache-2.0
//
// A trainee alone at the window: keyboard focus, hints and advice, and leaving the program. Runs on the offscreen
// platform without OpenGL, and under Xvfb with it.
#include <QAbstractButton>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QTableView>
#include <QTimer>
#include <algorithm>
#include <memory>

#include "console/app/language.hpp"
#include "console/models/metric_titles.hpp"
#include "console/pages/now_panel.hpp"
#include "console/pages/result_panel.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

using console::RunControl;

class Trainee : public WindowTest {
 protected:
  /// Presses a button of the next question of this name; counts the questions.
  void answer(const char* question, QMessageBox::ButtonRole role) {
    auto* timer = new QTimer(&timers);
    QObject::connect(timer, &QTimer::timeout, timer, [this, timer, name = QString::fromLatin1(question), role] {
      auto* box = window ? window->findChild<QMessageBox*>(name) : nullptr;
      if (!box || !box->isVisible()) return;
      timer->stop();
      ++asked;
      said = box->text();
      for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == role) return button->click();
    });
    timer->start(10);
  }
  const QWidget* focus() { return window->focusWidget(); }
  QString advice() { return child<QLabel>("advice")->isVisible() ? child<QLabel>("advice")->text() : QString(); }

  QObject timers;
  int asked = 0;
  QString said;
};

// A key that moves the instrument must not edit the person's name.
TEST_F(Trainee, TheKeyboardBeginsAtStartAndNotInTheName) {
  for (int launched = 0; launched < 2; ++launched) {
    open();
    ASSERT_TRUE(wait_for_preview());
    EXPECT_EQ(focus(), child<QPushButton>("start"));
    QTest::keyClick(window->focusWidget(), Qt::Key_A);
    EXPECT_EQ(page()->setup()->person(), "Guest");
    // from another page and back
    QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
    QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);
    EXPECT_EQ(focus(), child<QPushButton>("start"));
    // and from the name, once it is there
    child<QComboBox>("person")->setFocus();
    QTest::keyClick(child<QComboBox>("person")->lineEdit(), Qt::Key_Return);
    EXPECT_TRUE(eventually([&] { return focus() == child<QPushButton>("start"); }));
    EXPECT_EQ(log->started, 0) << "this Enter was for the name";
    window->close();
    window.reset();
  }
}

TEST_F(Trainee, NobodyIsAddedUnasked) {
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  child<QComboBox>("person")->lineEdit()->setText("Guesta");
  answer("new_trainee", QMessageBox::RejectRole);
  QTest::keyClick(window.get(), Qt::Key_F5);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(said.contains("Guesta")) << said.toStdString();
  EXPECT_EQ(log->started, 0);
  EXPECT_EQ(focus(), child<QComboBox>("person")) << "to be put right";
  answer("new_trainee", QMessageBox::AcceptRole);
  click("start");
  EXPECT_EQ(asked, 2);
  ASSERT_EQ(log->started, 1);
  EXPECT_EQ(log->last.person, "Guesta");
  window->activateWindow();  // a platform without a window manager leaves no window active after a dialog
  ASSERT_TRUE(eventually([&] { return window->isActiveWindow(); }));
  QTest::keyClick(window.get(), Qt::Key_F5);
  EXPECT_EQ(log->started, 1) << "one key does not end an attempt";
  EXPECT_TRUE(child<QLabel>("problem")->isVisible()) << "and says so";
  EXPECT_TRUE(child<QLabel>("problem")->text().contains("Shift+F5")) << child<QLabel>("problem")->text().toStdString();
  click("stop");
  EXPECT_FALSE(child<QLabel>("problem")->isVisible());
  click("start");
  EXPECT_EQ(log->started, 2) << "once agreed to, it is known";
  EXPECT_EQ(asked, 2);
}

// The name stays in the roster; the code, which exports say, is a made one.
TEST_F(Trainee, WhoIsNewGetsAMadeCode) {
  script.end_s = 0;
  with_school = true;
  open();
  ASSERT_TRUE(wait_for_preview());
  child<QComboBox>("person")->lineEdit()->setText("Nova Newcomer");
  answer("new_trainee", QMessageBox::AcceptRole);
  click("start");
  ASSERT_EQ(log->started, 1);
  std::string error;
  const auto school = record::School::open(school_file(), error);
  ASSERT_TRUE(school) << error;
  record::Person person;
  ASSERT_TRUE(school->find_person("Nova Newcomer", person)) << school->error();
  EXPECT_EQ(person.name, "Nova Newcomer");
  EXPECT_FALSE(person.code.empty());
  EXPECT_EQ(person.code.find("Nova"), std::string::npos) << person.code;
  click("stop");
  click("start");
  EXPECT_EQ(log->started, 2);
  EXPECT_EQ(school->people().size(), 1u) << "entered once";
}

TEST_F(Trainee, NobodyIsAskedForWhoIsKnownOrWhenNothingIsKept) {
  attempts = sample_attempts();
  open();
  ASSERT_TRUE(wait_for_preview());
  auto* person = child<QComboBox>("person");
  ASSERT_GT(person->count(), 1);
  person->setCurrentText(person->itemText(1));
  click("start");
  EXPECT_EQ(log->started, 1);
  click("stop");
  person->lineEdit()->setText("Guesta");
  child<QAbstractButton>("demo")->click();
  click("start");
  EXPECT_EQ(log->started, 2) << "a demonstration is kept for nobody";
}

TEST_F(Trainee, EnterPressesTheButtonThatHasTheKeyboard) {
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  QTest::keyClick(window->focusWidget(), Qt::Key_Return);
  EXPECT_EQ(log->started, 1);
  EXPECT_EQ(focus(), page()->view());
  child<QPushButton>("stop")->setFocus();
  QTest::keyClick(window->focusWidget(), Qt::Key_Enter);
  EXPECT_EQ(log->stopped, 1);
}

// T with empty jaws drives nothing: its hint is shown when the needle is held, and until then the control does not count as used.
TEST_F(Trainee, AControlIsToldWhenItIsNeededAndUntilItWasUsed) {
  script.with_grasp = true;
  script.rate = 1.5;
  script.end_s = 0;
  open();
  click("start");
  ASSERT_TRUE(wait_for_time(0.1));
  const auto hints = [&] { return page()->view()->control_hints(); };
  EXPECT_TRUE(hints().drag && hints().close);
  EXPECT_FALSE(hints().drive || hints().open || hints().put_back);
  QTest::keyClick(page()->view(), Qt::Key_T);
  EXPECT_FALSE(page()->used_controls().contains("drive"));
  // from 4 s on the needle is held, at the wrong place
  ASSERT_TRUE(eventually([&] { return hints().drive; }));
  ASSERT_TRUE(eventually([&] { return hints().open; }));
  EXPECT_TRUE(advice().contains("open the jaws (B)")) << advice().toStdString();
  QTest::keyClick(page()->view(), Qt::Key_B);
  EXPECT_TRUE(page()->used_controls().contains("open"));
  EXPECT_FALSE(hints().open);
  QTest::keyClick(page()->view(), Qt::Key_T);
  EXPECT_TRUE(page()->used_controls().contains("drive"));
  EXPECT_FALSE(hints().drive);
  // at the right place there is no advice
  ASSERT_TRUE(eventually([&] { return advice().isEmpty(); }));
}

// as in 131, where a thread lies in tissue: keys go along no needle
TEST_F(Trainee, WithoutANeedleNobodyIsSentToTheSide) {
  script.with_grasp = true;
  script.end_s = 0;
  open();
  for (const bool needle : {true, false}) {
    script.with_needle = needle;
    click("start");
    ASSERT_TRUE(wait_for_time(0.1));
    EXPECT_EQ(page()->view()->control_hints().side > 0, needle);
    click("stop");
  }
}

TEST_F(Trainee, AfterADropItIsSaidHowTheNeedleComesBack) {
  script.with_grasp = true;
  script.drop_s = 4.5;
  script.rate = 20;
  script.end_s = 0;
  open();
  click("start");
  ASSERT_TRUE(eventually([&] { return advice().contains("F7"); }));
  EXPECT_TRUE(page()->view()->control_hints().put_back);
  QTest::keyClick(window.get(), Qt::Key_F7);
  ASSERT_TRUE(eventually([&] { return advice().isEmpty(); }));
  EXPECT_FALSE(page()->view()->control_hints().put_back);
  // a test shows no answers, but its counts are shown after Stop
  click("stop");
  child<QAbstractButton>("test")->click();
  click("start");
  ASSERT_TRUE(wait_for_time(6));
  EXPECT_EQ(advice(), QString());
  EXPECT_FALSE(page()->view()->control_hints().put_back);
}

TEST(TraineePanel, RulesAreReadDuringAnAttemptAndInATest) {
  console::NowPanel now;
  now.set_themes(console::UiTheme::stock("light"), console::CueTheme::stock("safe"));
  console::Criteria asked;
  asked.pass = {"Hold it for 3 s."};
  asked.limits = {"At most 2 drops."};
  asked.max_time_s = 60;
  snapshot::SceneCard card;
  card.script.signals = {{"grasp", "grasp.force", "N", ""}};
  now.set_scene(console::Reader(card), {0.3, 0.7}, "Grasp it.", asked);
  const auto* rules = now.findChild<QLabel*>("criteria");
  auto* fold = now.findChild<QPushButton*>("rules");
  EXPECT_TRUE(rules->isVisibleTo(&now));
  EXPECT_FALSE(fold->isVisibleTo(&now));
  for (const bool test : {false, true}) {
    now.set_readings_hidden(test);
    now.set_running(true);
    EXPECT_FALSE(rules->isVisibleTo(&now));
    ASSERT_TRUE(fold->isVisibleTo(&now));
    fold->click();
    EXPECT_TRUE(rules->isVisibleTo(&now));
    EXPECT_TRUE(rules->text().contains("At most 2 drops."));
    fold->click();
    EXPECT_FALSE(rules->isVisibleTo(&now));
    fold->click();
    now.set_running(false);
    EXPECT_FALSE(fold->isChecked()) << "the next attempt begins with the readings";
  }
  EXPECT_EQ(fold->shortcut(), QKeySequence(Qt::Key_F2));
  // the last seconds are highlighted
  const auto* left = now.findChild<QLabel*>("time_left");
  now.show_reading({}, 30);
  EXPECT_FALSE(left->text().startsWith(QStringLiteral("▲")));
  now.show_reading({}, 50);
  EXPECT_TRUE(left->text().startsWith(QStringLiteral("▲")));
}

TEST(TraineePanel, AStoppedAttemptTellsItsFaults) {
  session::Result result;
  result.outcome = judge::Outcome::kAborted;
  result.metrics = {{"time.task", "s", "", 12.0}, {"grasp.drops", "1", "", 1.0}, {"grasp.regrasps", "1", "", 0.0}};
  snapshot::SceneCard card;
  card.metrics.resize(3);
  card.metrics[0].rank = 1;
  for (const size_t i : {1u, 2u}) card.metrics[i].show = SWAGE_SHOW_COUNT, card.metrics[i].better = SWAGE_BETTER_LOWER;
  const auto told = [&](const char* metric) {
    console::ResultPanel panel;
    panel.show_result(result, card, true);
    const auto all = panel.findChildren<QLabel*>();
    return std::any_of(all.begin(), all.end(), [&](const QLabel* l) { return l->isVisibleTo(&panel) && l->accessibleName() == console::metric_title(metric); });
  };
  EXPECT_TRUE(told("grasp.drops"));
  EXPECT_FALSE(told("grasp.regrasps")) << "there was none";
  result.outcome = judge::Outcome::kPassed;
  EXPECT_FALSE(told("grasp.drops")) << "points tell it";
}

TEST(TraineePanel, PointsForTimeAreToldBesideTheTimeThatCostThem) {
  session::Result result;
  result.outcome = judge::Outcome::kPassed;
  result.metrics = {{"time.task", "s", "", 29.6}, {"points.time", "1", "", 14.6}};
  snapshot::SceneCard card;
  card.metrics.resize(2);
  card.metrics[0].rank = 1;
  card.metrics[1].show = SWAGE_SHOW_POINTS;
  console::ResultPanel panel;
  const auto told = [&] {
    panel.show_result(result, card, true);
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->text().contains("free")) return label->text().replace(QChar(0x202f), ' ').toStdString();
    return std::string();
  };
  EXPECT_EQ(told(), "") << "where the lesson says none";
  panel.set_targets({{"time.task", {{}, 15}}});
  EXPECT_NE(told().find("29.6 s active, 15.0 s free"), std::string::npos) << told();
}

TEST_F(Trainee, ATestIsNotClosedUnasked) {
  script.end_s = 0;
  open();
  child<QAbstractButton>("test")->click();
  click("start");
  ASSERT_TRUE(wait_for_time(0.05));
  answer("stop_and_close", QMessageBox::RejectRole);
  window->close();
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(window->isVisible());
  EXPECT_EQ(control()->state(), RunControl::State::kRunning) << "it goes on";
  EXPECT_EQ(log->stopped, 0);
  answer("stop_and_close", QMessageBox::AcceptRole);
  window->close();
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(window->isVisible());
  EXPECT_EQ(log->stopped, 1);
}

TEST_F(Trainee, WhatBecameOfPracticeIsSaidAtTheNextStart) {
  script.end_s = 0;
  const auto noticed = [&] {
    const auto all = window->findChildren<QLabel*>();
    return std::any_of(all.begin(), all.end(), [](const QLabel* l) { return l->isVisible() && l->text().contains("kept as stopped"); });
  };
  open();
  EXPECT_FALSE(noticed());
  click("start");
  ASSERT_TRUE(wait_for_time(0.05));
  window->close();
  EXPECT_EQ(log->stopped, 1);
  window.reset();
  open();
  EXPECT_TRUE(noticed());
  window->close();
  window.reset();
  open();
  EXPECT_FALSE(noticed()) << "once";
}

// Ctrl is held during a drag that turns the view, and Q moves the instrument.
TEST_F(Trainee, TheKeyThatQuitsAsksWhileALessonRuns) {
  script.end_s = 0;
  open();
  click("start");
  ASSERT_TRUE(wait_for_time(0.05));
  answer("stop_and_close", QMessageBox::RejectRole);
  QTest::keyClick(window.get(), Qt::Key_Q, Qt::ControlModifier);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(window->isVisible());
  click("stop");
  QApplication::setActiveWindow(window.get());  // offscreen no window manager restores the focus after a dialog
  QTest::keyClick(window.get(), Qt::Key_Q, Qt::ControlModifier);
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(window->isVisible());
}

TEST_F(Trainee, TheLanguageIsChosenOnTheSetupPage) {
  open();
  QTest::keyClick(window.get(), Qt::Key_6, Qt::ControlModifier);
  auto* language = child<QComboBox>("language");
  ASSERT_TRUE(language->isVisible());
  EXPECT_EQ(language->currentData().toString(), "") << "that of the system";
  language->setFocus();
  QTest::keyClick(language, Qt::Key_End);
  EXPECT_EQ(language->currentText(), "Deutsch");
  window->close();
  window.reset();
  const console::Settings settings(launch.settings_file);
  EXPECT_EQ(console::wanted_language({"swage-console"}, settings), "de");
  EXPECT_EQ(console::wanted_language({"swage-console", "--language", "en"}, settings), "en") << "who says so now has it so";
  EXPECT_EQ(console::wanted_language({"swage-console", "--screenshot", "f.png"}, settings), "");
  open();
  EXPECT_EQ(child<QComboBox>("language")->currentText(), "Deutsch");
}

TEST_F(Trainee, ASmallScreenHasTheGuideTheCuesAndWhatHappened) {
  open();
  ASSERT_TRUE(wait_for_preview());
  const QSize size(1016, 730);  // the area inside a window frame of 1024x768
  ASSERT_TRUE(eventually([&] {
    window->resize(size);
    return window->size() == size;
  })) << window->width() << " x " << window->height();
  QTest::qWait(50);
  for (const QWidget* part : std::initializer_list<const QWidget*>{child<QPushButton>("guide"), child<QPushButton>("stop"), child<QPushButton>("start"),
                                                                   child<QTableView>("events"), page()->legend()}) {
    EXPECT_TRUE(part->isVisible()) << part->objectName().toStdString();
    EXPECT_TRUE(window->rect().contains(QRect(part->mapTo(window.get(), QPoint()), part->size()))) << part->objectName().toStdString();
  }
  EXPECT_GT(page()->view()->height(), 300);
  EXPECT_TRUE(child<QPushButton>("stop")->text().contains("Shift+F5"));
}

}  // namespace
}  // namespace swage::test
