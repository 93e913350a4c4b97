// SPDX-License-Identifier: Apache-2.0
//
// Information shown during an attempt, after it, and hidden in a test. Runs on the offscreen platform without OpenGL, and
// under Xvfb with it.
#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QScreen>
#include <QTest>
#include <QTimer>

#include "console/models/attempts_model.hpp"
#include "console/models/standing.hpp"
#include "console/models/variant.hpp"
#include "console/pages/now_panel.hpp"
#include "console/widgets/parts.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class AttemptOnPage : public WindowTest {
 protected:
  /// A test without an end, begun with the readings open.
  void begin_test() {
    script.rate = 20;
    script.end_s = 0;
    open();
    ASSERT_TRUE(wait_for_preview());
    page()->show_instructor(true);
    child<QAbstractButton>("test")->click();
    click("start");
  }
  QString task_line() { return window->findChild<console::NowPanel*>()->findChild<QLabel*>(QStringLiteral("task_line"))->text(); }
  const console::ViewWords& words() { return page()->view()->words(); }
  void choose_lesson(int row) {
    auto* lessons = child<QListView>("lessons");
    lessons->setCurrentIndex(lessons->model()->index(row, 0));
  }
};

// The phase "Hold it" begins when position, tips and force are right: in a test its title would reveal the answer.
TEST_F(AttemptOnPage, InATestTheTaskLineTellsNoPhase) {
  script.rate = 20;
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  const QString task = page()->setup()->task();
  ASSERT_FALSE(task.isEmpty());
  ASSERT_FALSE(task.contains("Hold it"));
  child<QAbstractButton>("test")->click();
  click("start");
  ASSERT_TRUE(wait_for_time(6));
  EXPECT_EQ(task_line(), task);
  EXPECT_EQ(words().task, page()->setup()->summary()) << "the trainee's view";
  ask_for_readings(true);
  auto* own = window->findChild<console::InstructorWindow*>();
  ASSERT_NE(own, nullptr);
  EXPECT_TRUE(eventually([&] { return own->now()->findChild<QLabel*>(QStringLiteral("task_line"))->text() == "Hold it"; }));
  EXPECT_EQ(task_line(), task);
  click("stop");
  child<QAbstractButton>("practice")->click();
  click("start");
  ASSERT_TRUE(wait_for_time(6));
  EXPECT_TRUE(eventually([&] { return task_line() == "Hold it" && words().task == "Hold it"; })) << "in practice it helps";
}

// On the only screen the readings are shown after a question, and then nobody takes the attempt for a clean test.
TEST_F(AttemptOnPage, InATestTheReadingsAreNotOpenUnnoticed) {
  script.rate = 20;
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  page()->show_instructor(true);
  EXPECT_TRUE(page()->instructor_shown()) << "nothing runs";
  child<QAbstractButton>("test")->click();
  EXPECT_FALSE(child<QPushButton>("forces")->isEnabled());
  EXPECT_FALSE(child<QPushButton>("detail")->isEnabled());
  click("start");
  EXPECT_FALSE(page()->instructor_shown()) << "the trainee would see it";
  ask_for_readings(false);
  EXPECT_FALSE(page()->instructor_shown());
  EXPECT_FALSE(child<QPushButton>("instructor")->isChecked());
  ask_for_readings(true);
  ASSERT_TRUE(page()->instructor_shown());
  ASSERT_FALSE(log->noted.empty());
  EXPECT_TRUE(log->noted.front().find("readings were open") != std::string::npos);
  click("stop");
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(child<QLabel>("kept")->text().contains("readings were open")) << child<QLabel>("kept")->text().toStdString();
  click("start");
  click("stop");
  ASSERT_TRUE(wait_for_end());
  EXPECT_FALSE(child<QLabel>("kept")->text().contains("readings were open")) << "of that attempt alone";
}

TEST_F(AttemptOnPage, InATestReadingsThatComeOntoTheTraineesScreenAreClosedAndTold) {
  begin_test();
  if (HasFatalFailure()) return;
  auto* readings = child<QWidget>("instructor_window");
  readings->show();  // as when it is dragged back
  EXPECT_TRUE(eventually([&] { return !readings->isVisible(); }));
  EXPECT_FALSE(child<QPushButton>("instructor")->isChecked());
  ASSERT_EQ(log->noted.size(), 1u);
  EXPECT_NE(log->noted.front().find("readings were open"), std::string::npos);
  ask_for_readings(true);
  ASSERT_TRUE(page()->instructor_shown());
  ASSERT_TRUE(wait_for_time(control()->newest()->time_s + 2));
  EXPECT_TRUE(page()->instructor_shown()) << "agreed to";
  EXPECT_EQ(log->noted.size(), 1u) << "told once";
  click("stop");
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(child<QLabel>("kept")->text().contains("readings were open")) << child<QLabel>("kept")->text().toStdString();
}

// Run with a second screen by console.two_screens.
class TwoScreens : public AttemptOnPage {
 protected:
  void begin_test() {
    if (QGuiApplication::screens().size() < 2) GTEST_SKIP() << "there is one screen";
    AttemptOnPage::begin_test();
    if (HasFatalFailure()) return;
    readings = child<QWidget>("instructor_window");
    ASSERT_TRUE(wait_for_time(2));
    ASSERT_TRUE(readings->isVisible()) << "the trainee does not see it";
    ASSERT_NE(readings->screen(), window->screen());
    ASSERT_TRUE(log->noted.empty()) << log->noted.front();
  }
  void expect_told() {
    EXPECT_TRUE(eventually([&] { return !readings->isVisible(); }));
    ASSERT_FALSE(log->noted.empty());
    EXPECT_NE(log->noted.front().find("readings were open"), std::string::npos);
    click("stop");
    ASSERT_TRUE(wait_for_end());
    EXPECT_TRUE(child<QLabel>("kept")->text().contains("readings were open"));
  }
  QWidget* readings = nullptr;
};

TEST_F(TwoScreens, ReadingsThatAreDraggedBackAreClosedAndTold) {
  begin_test();
  if (IsSkipped() || HasFatalFailure()) return;
  readings->setScreen(window->screen());
  readings->move(window->screen()->geometry().topLeft() + QPoint(50, 50));
  expect_told();
}

TEST_F(TwoScreens, ReadingsOnTheScreenThatTheTraineeGetsAreClosedAndTold) {
  begin_test();
  if (IsSkipped() || HasFatalFailure()) return;
  QScreen* other = readings->screen();
  QTest::keyClick(window.get(), Qt::Key_F9);
  ASSERT_NE(window->trainee(), nullptr);
  window->trainee()->setScreen(other);
  window->trainee()->move(other->geometry().topLeft() + QPoint(60, 60));
  expect_told();
}

TEST_F(AttemptOnPage, TheClockGoesWithItsLesson) {
  script.rate = 100;
  open();
  click("start");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(words().clock, "00:12");
  EXPECT_FALSE(words().banner.isEmpty());
  choose_lesson(1);
  EXPECT_EQ(words().clock, "");
  EXPECT_EQ(words().banner, "");
}

// A lesson whose work lies under its instrument cannot be done from above.
TEST_F(AttemptOnPage, AViewIsNotCarriedOverToTheNextLesson) {
  open();
  ASSERT_TRUE(wait_for_preview());
  const auto is_from_above = [this] {
    page()->view()->camera().jump();
    return page()->view()->camera().up().z() < 0.5F;
  };
  page()->look(console::CameraPreset::kTop);
  EXPECT_TRUE(is_from_above());
  choose_lesson(1);
  EXPECT_TRUE(eventually([&] { return !is_from_above(); }));
}

// By keys the view is changed while they lead the instrument: the keyboard stays with the picture.
TEST_F(AttemptOnPage, AKeyGoesFromViewToView) {
  script.end_s = 0;
  open();
  ASSERT_TRUE(wait_for_preview());
  click("start");
  ASSERT_TRUE(wait_for_time(0.05));
  console::OrbitCamera& camera = page()->view()->camera();
  const auto seen = [&] {
    camera.jump();
    return camera.q_WC();
  };
  std::vector<QQuaternion> views;
  for (const console::CameraPreset preset : {console::CameraPreset::kSide, console::CameraPreset::kTop, console::CameraPreset::kNear, console::CameraPreset::kOrbit}) {
    page()->look(preset);
    views.push_back(seen());
  }
  ASSERT_NE(views[0], views[3]);
  page()->view()->setFocus();
  for (const QQuaternion& view : views) {
    QTest::keyClick(page()->view(), Qt::Key_F11);
    EXPECT_LT((seen() - view).length(), 1e-4F);
    EXPECT_TRUE(page()->view()->hasFocus());
  }
  page()->look(console::CameraPreset::kTop);
  EXPECT_EQ(child<QPushButton>("view_side")->toolTip(), "Side view; F11 goes on from Top to Near") << "from the view that is shown now";
}

// A lesson that cannot run leaves no old scene, and the Lessons page shows the reason as well.
TEST_F(AttemptOnPage, ALessonThatCannotRunIsNotOffered) {
  open();
  ASSERT_TRUE(wait_for_preview());
  script.refuse = "\"swage.jaw\" is not installed.";
  choose_lesson(1);
  ASSERT_TRUE(eventually([&] { return child<QLabel>("problem")->isVisible(); }));
  EXPECT_EQ(child<QLabel>("lesson_title")->text(), child<QListView>("lessons")->currentIndex().data().toString());
  EXPECT_EQ(task_line(), page()->setup()->task());
  click("page_lessons");
  auto* lessons = child<QListView>("all_lessons");
  lessons->setCurrentIndex(lessons->model()->index(1, 0));
  EXPECT_TRUE(eventually([&] { return child<QLabel>("lesson_asked")->text().contains("is not installed"); }));
  EXPECT_FALSE(child<QPushButton>("practise_lesson")->isEnabled());
  script.refuse.clear();
  lessons->setCurrentIndex(lessons->model()->index(0, 0));
  EXPECT_TRUE(child<QPushButton>("practise_lesson")->isEnabled());
}

// The criteria stay visible beside the results.
TEST_F(AttemptOnPage, AResultTellsWhatWasAsked) {
  console::ResultPanel panel;
  console::Criteria asked;
  asked.pass = {"Hold it for ten seconds."};
  asked.limits = {"At most two drops."};
  panel.set_criteria(asked);
  const auto* told = panel.findChild<QLabel*>("result_criteria");
  session::Result result;
  result.outcome = judge::Outcome::kFailed;
  panel.show_result(result, {}, true);
  EXPECT_TRUE(told->isVisibleTo(&panel));
  EXPECT_TRUE(told->text().contains("Hold it for ten seconds.") && told->text().contains("At most two drops.")) << told->text().toStdString();
  panel.set_criteria({});
  EXPECT_FALSE(told->isVisibleTo(&panel));
}

// The bench gave 100 of 100 to a spectator.
TEST_F(AttemptOnPage, ADemonstrationLeavesNoScore) {
  open();
  console::AttemptOptions options(*page()->setup());
  page()->setup()->set_mode(QStringLiteral("practice"));
  EXPECT_NE(options.attempt({}, {}).store_path, ":none:");
  options.set_show(true);
  EXPECT_EQ(options.attempt({}, {}).mode, "demo");
  EXPECT_EQ(options.attempt({}, {}).store_path, ":none:");
  console::ResultPanel panel;
  session::Result result;
  result.outcome = judge::Outcome::kPassed;
  result.score = 100;
  result.attempt_id = "a1";
  panel.show_seen(result);
  EXPECT_FALSE(panel.outcome().contains("Passed")) << panel.outcome().toStdString();
  for (const QLabel* label : panel.findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains("100")) << label->text().toStdString();
  EXPECT_FALSE(panel.findChild<QPushButton*>("to_review")->isEnabled());
}

TEST(Attempts, ARecordedHandIsNobodysProgress) {
  std::vector<record::AttemptRow> all(3);
  for (record::AttemptRow& a : all) {
    a.person_id = "p", a.lesson_id = "a", a.mode = "practice", a.outcome = "passed";
    a.started_utc = "2026-11-20T09:00:00Z";
  }
  all[0].is_scripted = true;
  all[0].started_utc = "2026-11-21T09:00:00Z";
  all[1].mode = "hand";
  std::vector<const record::AttemptRow*> newest_first;
  for (const record::AttemptRow& a : all) newest_first.push_back(&a);
  const console::Standing s = console::standing_of(newest_first, QDateTime::fromString(QStringLiteral("2026-11-22T10:00:00Z"), Qt::ISODate));
  EXPECT_EQ(s.attempts, 1);
  EXPECT_EQ(s.passed, 1);
  EXPECT_EQ(s.last.size(), 1);
  EXPECT_EQ(s.days, 2) << "a hand that played yesterday is not a day of practice";
  console::AttemptsModel model;
  model.set_attempts({all.begin(), all.end()});
  QStringList modes;
  for (int row = 0; row < model.rowCount(); ++row) modes += model.index(row, console::AttemptsModel::kMode).data().toString();
  EXPECT_EQ(modes.count("Recorded hand, not counted"), 2) << modes.join(", ").toStdString();
  EXPECT_EQ(modes.count("Practice"), 1);
  // which one, where the store tells it; a device of a person may have brackets too
  all[0].device = "swage.device.skilled (novice)";
  all[2].device = "swage.device.arm (left)";
  model.set_attempts({all.begin(), all.end()});
  EXPECT_EQ(model.index(0, console::AttemptsModel::kMode).data().toString(), "Recorded hand: novice");
  EXPECT_EQ(model.index(0, console::AttemptsModel::kMode).data(Qt::ToolTipRole).toString(), "An attempt by a recorded hand counts for nobody.");
  EXPECT_EQ(model.index(2, console::AttemptsModel::kMode).data().toString(), "Practice");
}

// Typing a name changes it with each letter, and each course is read from the store.
TEST_F(AttemptOnPage, TheCourseOfAPersonIsReadOnce) {
  open();
  auto* person = child<QComboBox>("person");
  person->addItem(QStringLiteral("Ben"));
  QStringList read;
  window->run_page()->set_course_finder([&](const QString& name) -> std::optional<console::CourseNext> {
    read += name;
    return {};
  });
  person->lineEdit()->selectAll();
  QTest::keyClicks(person->lineEdit(), QStringLiteral("Be"));
  QCoreApplication::processEvents();
  EXPECT_EQ(read, QStringList{person->currentText()}) << read.join(", ").toStdString();
}

class OwnLessonOnPage : public WindowTest {
 protected:
  void SetUp() override {
    qputenv("XDG_DATA_HOME", dir.filePath("data").toUtf8());
    QFile base(QStringLiteral(SWAGE_SOURCE_DIR "/tests/console/lessons/") +
               QDir(QStringLiteral(SWAGE_SOURCE_DIR "/tests/console/lessons")).entryList({QStringLiteral("*.json")}, QDir::Files).first());
    mine = console::save_variant({base.fileName(), "Mine", "", "", {}}, console::own_lessons_folder());
    ASSERT_EQ(mine.problem, "");
  }
  void TearDown() override {
    window.reset();
    qunsetenv("XDG_DATA_HOME");
  }
  /// Answers the question whether the lesson is to be deleted.
  void remove(bool yes) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      answer.stop();
      asked = box->objectName();
      for (QAbstractButton* b : box->buttons())
        if ((box->buttonRole(b) == QMessageBox::DestructiveRole) == yes) return b->click();
    });
    answer.start(10);
    click("delete_lesson");
  }
  console::Saved mine;
  QString asked;
};

// A lesson just saved is in the list under any search; and the keys of the page work in the search field, too.
TEST_F(OwnLessonOnPage, IsSeenWhateverIsSearchedFor) {
  launch.options.lesson_path = mine.path.toStdString();
  open();
  click("page_lessons");
  auto* words = child<QLineEdit>("lesson_search");
  words->setText(QStringLiteral("zebra"));
  window->lessons_page()->select(mine.path);
  EXPECT_EQ(words->text(), "");
  EXPECT_EQ(window->lessons_page()->lesson(), mine.path);
  QKeyEvent edit(QEvent::ShortcutOverride, Qt::Key_E, Qt::ControlModifier);
  edit.ignore();  // initial state in Qt: a receiver accepts the key
  QApplication::sendEvent(words, &edit);
  EXPECT_FALSE(edit.isAccepted()) << "the line of text does not keep Ctrl+E";
}

TEST_F(OwnLessonOnPage, IsDeletedOnlyWhenThatWasMeant) {
  launch.options.lesson_path = mine.path.toStdString();
  open();
  ASSERT_TRUE(wait_for_preview());
  auto* lessons = child<QListView>("lessons");
  int row = -1;
  for (int i = 0; i < lessons->model()->rowCount(); ++i)
    if (lessons->model()->index(i, 0).data(console::LessonsModel::kTitle).toString() == "Mine") row = i;
  ASSERT_GE(row, 0);
  lessons->setCurrentIndex(lessons->model()->index(row == 0 ? 1 : 0, 0));
  EXPECT_FALSE(child<QPushButton>("delete_lesson")->isVisible()) << "a lesson of the series stays";
  lessons->setCurrentIndex(lessons->model()->index(row, 0));
  ASSERT_TRUE(eventually([&] { return child<QPushButton>("delete_lesson")->isVisible() && child<QPushButton>("delete_lesson")->isEnabled(); }));
  remove(false);
  EXPECT_EQ(asked, "delete_question");
  EXPECT_TRUE(QFile::exists(mine.path));
  const int all = lessons->model()->rowCount();
  remove(true);
  EXPECT_FALSE(QFile::exists(mine.path));
  EXPECT_EQ(lessons->model()->rowCount(), all - 1);
  EXPECT_FALSE(child<QPushButton>("delete_lesson")->isVisible());
}

}  // namespace
}  // namespace swage::test
