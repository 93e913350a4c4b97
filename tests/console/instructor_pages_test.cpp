// SPDX-License-Identifier: Apache-2.0
//
// The pages of an instructor in the whole window, with a school in a file: People, Courses, the instructor's window.
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>

#include "record/recorder.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class InstructorPages : public WindowTest {
 protected:
  void SetUp() override { with_school = true; }
  void add_chen() {
    console::RosterLine line;
    line.name = QStringLiteral("Chen W.");
    line.code = QStringLiteral("A01");
    ASSERT_TRUE(window->desk()->add_people({line}));
  }
  /// Presses Ctrl and a key, once the window has the focus again.
  void press_ctrl(Qt::Key key) {
    ASSERT_TRUE(eventually([&] {
      QApplication::setActiveWindow(window.get());
      return QApplication::activeWindow() == window.get() && !QApplication::activeModalWidget();
    }));
    QTest::keyClick(window.get(), key, Qt::ControlModifier);
  }
};

// A failure is said on the page where it happened, and nowhere else.
TEST_F(InstructorPages, AFailureOnThePeoplePageIsNotSaidOnTheCoursesPage) {
  open();
  click("page_people");
  add_chen();
  console::RosterLine twin;
  twin.name = QStringLiteral("Dora M.");
  twin.code = QStringLiteral("A01");
  EXPECT_FALSE(window->desk()->add_people({twin}));
  EXPECT_FALSE(child<QLabel>("people_problem")->isHidden());
  click("page_courses");
  EXPECT_TRUE(child<QLabel>("course_problem")->isHidden());
  EXPECT_FALSE(window->desk()->add_people({twin}));
  EXPECT_FALSE(child<QLabel>("course_problem")->isHidden());
  click("page_people");
  click("page_courses");
  EXPECT_TRUE(child<QLabel>("course_problem")->isHidden()) << "it is said once";
}

TEST_F(InstructorPages, ACodeThatIsTakenIsSaidInTheDialog) {
  open();
  click("page_people");
  add_chen();
  in_dialog("person_dialog", [](QDialog* d) {
    auto* ok = d->findChild<QPushButton*>(QStringLiteral("person_ok"));
    auto* code = d->findChild<QLineEdit*>(QStringLiteral("person_code"));
    d->findChild<QLineEdit*>(QStringLiteral("person_name_edit"))->setText(QStringLiteral("Dora M."));
    EXPECT_TRUE(ok->isEnabled());
    code->setText(QStringLiteral("A01"));
    EXPECT_FALSE(ok->isEnabled());
    EXPECT_TRUE(d->findChild<QLabel*>(QStringLiteral("person_problem"))->text().contains("code"));
    code->setText(QStringLiteral("A02"));
    EXPECT_TRUE(ok->isEnabled());
    ok->click();
  });
  click("add_person");
  EXPECT_EQ(window->people_page()->people()->rowCount(), 2);
}

TEST_F(InstructorPages, TheInstructorsWindowSaysWhoDoesWhatAndKeepsItsSize) {
  open();
  page()->show_instructor(true);
  auto* extra = child<QWidget>("instructor_window");
  const QString words = extra->findChild<QLabel*>(QStringLiteral("instructor_subject"))->text();
  EXPECT_TRUE(words.startsWith(QStringLiteral("Guest"))) << words.toStdString();
  page()->setup()->set_mode(QStringLiteral("test"));
  EXPECT_TRUE(extra->findChild<QLabel*>(QStringLiteral("instructor_subject"))->text().endsWith(QStringLiteral("Test")));
  const auto plots = extra->findChildren<console::TracePlot*>();
  ASSERT_EQ(plots.size(), 2);
  for (const auto* plot : plots) EXPECT_GE(plot->minimumHeight(), 90);
  // a long list of what is asked scrolls
  const int height = extra->height();
  auto* criteria = extra->findChild<QLabel*>(QStringLiteral("criteria"));
  ASSERT_NE(criteria, nullptr);
  criteria->setText(QStringLiteral("line<br>").repeated(80));
  criteria->show();
  QApplication::processEvents();
  EXPECT_EQ(extra->height(), height);
}

TEST_F(InstructorPages, SetupSaysWhereAttemptsAreKept) {
  launch.options.store_path = "postgresql://swage:secret@school/swage";
  launch.station = QStringLiteral("Bench 4");
  open();
  const QString words = child<QLabel>("setup_place")->text();
  EXPECT_TRUE(words.contains("Bench 4") && words.contains("school/swage")) << words.toStdString();
  EXPECT_FALSE(words.contains("secret"));
}

TEST_F(InstructorPages, LimitsFromExpertsSayWhyThereAreNone) {
  open();
  click("page_courses");
  click("first_course");
  click("add_lesson");
  click("suggest_limits");
  EXPECT_TRUE(child<QLabel>("course_problem")->text().contains("no limit yet"));
  record::Course before = window->courses_page()->course(), after = before;
  after.steps[0].limits.push_back({"force.peak", "N", 0.1, 0.91173, false, "synthetic"});
  ASSERT_TRUE(window->desk()->change_course(before, after, QStringLiteral("limit")));
  EXPECT_EQ(child<QTableWidget>("limits")->item(0, 2)->text(), QLocale().toString(0.912, 'g', 3));
  click("suggest_limits");
  EXPECT_TRUE(child<QLabel>("course_problem")->text().contains("No attempts of experts"));
  EXPECT_DOUBLE_EQ(window->courses_page()->course().steps[0].limits[0].most, 0.91173);
}

// Several people stay chosen when a course is assigned to them, so that their report is the next step.
TEST_F(InstructorPages, WhoWereChosenTogetherStayChosen) {
  open();
  click("page_people");
  for (const char* name : {"Arun P.", "Bea L.", "Chen W."}) {
    console::RosterLine line;
    line.name = QString::fromUtf8(name);
    ASSERT_TRUE(window->desk()->add_people({line}));
  }
  auto* table = child<QTableView>("people");
  table->selectAll();
  ASSERT_EQ(table->selectionModel()->selectedRows().size(), 3);
  record::Course course;
  course.title = "Basic";
  ASSERT_TRUE(window->desk()->change_course({}, course, QStringLiteral("course")));
  EXPECT_EQ(table->selectionModel()->selectedRows().size(), 3);
  window->people_page()->select_person(QStringLiteral("Bea L."));
  window->people_page()->refresh();
  EXPECT_EQ(table->selectionModel()->selectedRows().size(), 1) << "and one alone stays one";
}

// A metric stands ready for a limit, and the words about unknown ones are for a lesson that is not installed.
TEST_F(InstructorPages, AMetricStandsReadyForALimit) {
  open();
  console::CourseEditing editing(window->desk(), nullptr, [](const QString& lesson) {
    return lesson == QLatin1String("known") ? QVector<console::LessonMetric>{{"time.task", "s", SWAGE_BETTER_LOWER}, {"force.peak", "N", SWAGE_BETTER_LOWER}}
                                            : QVector<console::LessonMetric>();
  });
  console::LimitsPanel panel(&editing, nullptr);
  const auto* metric = panel.findChild<QComboBox*>(QStringLiteral("limit_metric"));
  for (const char* lesson : {"known", "absent", "known"}) {
    record::Course course;
    course.steps.resize(1);
    course.steps[0].lesson_id = lesson;
    editing.set_course(course);
    editing.set_step(0);
    panel.refresh();
    EXPECT_EQ(metric->currentData().toString(), course.steps[0].lesson_id == "known" ? "time.task" : "") << lesson;
  }
}

// A passed test by a person's own hand.
void keep_test(const std::string& store, const char* person, const char* lesson) {
  record::AttemptInfo info;
  info.person = person;
  info.lesson_id = info.lesson_title = lesson;
  info.mode = "test";
  info.device = "mouse";
  info.devices = {"hand"};
  info.hands = {{"hand", "mouse", "swage.device.mouse", "1.0.0", "{}", SWAGE_DEVICE_POINTER}};
  base::Problems problems;
  const auto recorder = record::Recorder::open(store, info, problems);
  ASSERT_TRUE(recorder);
  record::AttemptEnd end;
  end.outcome = judge::Outcome::kPassed;
  end.score = 90;
  end.simulated_s = 10;
  recorder->finish(end);
}

// A course of two lessons, one after the other, for Chen W., who is chosen on the Run page; the second lesson is chosen.
class CourseOrder : public InstructorPages {
 protected:
  void begin() {
    script.rate = 100;
    open();
    add_chen();
    record::Course course;
    course.title = "Basic";
    for (const char* lesson : {"test.grasp", "test.carry"}) {
      record::CourseStep step;
      step.lesson_id = step.title = lesson;
      step.rule.in_a_row = 1, step.rule.later_day = 0;
      course.steps.push_back(step);
    }
    ASSERT_TRUE(window->desk()->change_course({}, course, QStringLiteral("course")));
    record::School* school = window->desk()->school();
    record::Person chen;
    ASSERT_TRUE(school->find_person("Chen W.", chen));
    ASSERT_TRUE(window->desk()->assign(QString::fromStdString(school->courses().at(0).id), {chen.id}, false, {}));
    child<QComboBox>("person")->setCurrentText(QStringLiteral("Chen W."));
    page()->setup()->select_lesson(1);
    ASSERT_TRUE(wait_for_preview());
  }
  /// Presses F5 and answers the question with a button; `reason`: is typed first. Returns whether the question came.
  bool start_and_answer(const char* button, const QString& reason = {}) {
    bool asked = false;
    in_dialog("order_dialog", [&asked, button, reason](QDialog* d) {
      asked = true;
      auto* push = d->findChild<QPushButton*>(QString::fromLatin1(button));
      if (auto* why = d->findChild<QComboBox*>(QStringLiteral("order_reason"))) {
        EXPECT_FALSE(d->findChild<QPushButton*>(QStringLiteral("order_begin"))->isEnabled()) << "without a reason";
        why->setCurrentText(reason);
      }
      push->click();
    });
    press_start();
    return asked;
  }
  void press_start() {
    QApplication::setActiveWindow(window.get());  // after a dialog no window is active on the offscreen platform
    QTest::keyClick(window.get(), Qt::Key_F5);
  }
};

TEST_F(CourseOrder, ATestBeforeItsTurnNeedsAnInstructorsReasonWhichItKeeps) {
  begin();
  EXPECT_TRUE(child<QLabel>("course_not_open")->isVisible());
  EXPECT_EQ(child<QLabel>("course_not_open")->toolTip(), "Not open yet in the course “Basic”: “test.grasp” comes first (no passed Test attempt yet).");
  page()->setup()->set_mode(QStringLiteral("test"));
  EXPECT_TRUE(start_and_answer("order_cancel"));
  EXPECT_FALSE(control()->running());
  EXPECT_TRUE(start_and_answer("order_first"));
  EXPECT_FALSE(control()->running());
  EXPECT_TRUE(page()->setup()->lesson().contains("grasp"));
  EXPECT_TRUE(child<QLabel>("course_not_open")->isHidden());
  page()->setup()->select_lesson(1);
  EXPECT_TRUE(start_and_answer("order_begin", "Assessment"));
  ASSERT_TRUE(control()->running());
  ASSERT_TRUE(wait_for_end());
  ASSERT_EQ(log->noted.size(), 1u);
  EXPECT_EQ(log->noted.front(), "Opened before its turn in the course: Assessment.");
  EXPECT_TRUE(child<QLabel>("kept")->text().contains("Opened before its turn in the course: Assessment.")) << child<QLabel>("kept")->text().toStdString();
  // that of the first lesson needs no reason, and its result tells none
  page()->setup()->select_lesson(0);
  press_start();
  ASSERT_TRUE(control()->running());
  ASSERT_TRUE(wait_for_end());
  EXPECT_FALSE(child<QLabel>("kept")->text().contains("before its turn"));
}

TEST_F(CourseOrder, PracticeBeforeItsTurnIsAskedAboutOnceAndADemonstrationIsNot) {
  begin();
  page()->setup()->set_mode(QStringLiteral("demo"));
  press_start();
  ASSERT_TRUE(control()->running());
  ASSERT_TRUE(wait_for_end());
  page()->setup()->set_mode(QStringLiteral("practice"));
  EXPECT_TRUE(start_and_answer("order_begin"));
  ASSERT_TRUE(control()->running());
  ASSERT_TRUE(wait_for_end());
  EXPECT_TRUE(log->noted.empty()) << "it counts for no course";
  press_start();
  EXPECT_TRUE(control()->running()) << "asked once";
  ASSERT_TRUE(wait_for_end());
}

// From the course, given on People, over its lessons to the last test and back: the Run page tells what is asked next, and each result
// how far the person is.
TEST_F(InstructorPages, ACourseLeadsThroughItsLessonsToItsLastTest) {
  script.rate = 100;
  open();
  click("page_people");
  console::RosterLine chen;
  chen.name = "Chen W.";
  ASSERT_TRUE(window->desk()->add_people({chen}));
  click("page_courses");
  click("first_course");
  for (int step = 0; step < 2; ++step) {
    click("add_lesson");
    child<QSpinBox>("rule_in_a_row")->setValue(1);
    child<QSpinBox>("rule_later_day")->setValue(0);
  }
  click("page_people");
  in_dialog("assign_dialog", [](QDialog* d) { d->findChild<QPushButton*>(QStringLiteral("assign_ok"))->click(); });
  click("assign_course");
  click("page_run");
  EXPECT_FALSE(child<QLabel>("course_next")->isVisible()) << "a guest has no course";
  child<QComboBox>("person")->setCurrentText(QStringLiteral("Chen W."));
  const auto next = [this] { return child<QLabel>("course_next")->text().toStdString(); };
  QCoreApplication::processEvents();  // the course is read once, after the letters of a name
  EXPECT_EQ(next(), "Course 1: 0 of 2 lessons passed. Next: Grasp the needle, no passed Test attempt yet.");
  EXPECT_FALSE(child<QPushButton>("to_course_lesson")->isVisible()) << "it is chosen";
  page()->setup()->select_lesson(1);
  ASSERT_TRUE(child<QPushButton>("to_course_lesson")->isVisible());
  press_ctrl(Qt::Key_L);
  EXPECT_TRUE(eventually([&] { return page()->setup()->lesson().contains("grasp"); }));
  EXPECT_EQ(page()->setup()->mode(), "test");
  const auto pass = [this](const char* lesson) {
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_TRUE(control()->running());
    keep_test(school_file(), "Chen W.", lesson);  // what a session writes
    EXPECT_TRUE(wait_for_end());
    EXPECT_EQ(child<QLabel>("result_course")->text(), "In the course: passed.");
  };
  pass("test.grasp");
  EXPECT_EQ(next(), "Course 1: 1 of 2 lessons passed. Next: Carry and hold, no passed Test attempt yet.");
  press_ctrl(Qt::Key_Right);
  EXPECT_TRUE(page()->setup()->lesson().contains("carry"));
  EXPECT_EQ(page()->setup()->mode(), "test");
  pass("test.carry");
  EXPECT_EQ(next(), "Course 1: 2 of 2 lessons passed.");
  EXPECT_FALSE(child<QPushButton>("next_lesson")->isEnabled()) << "nothing is left";
  press_ctrl(Qt::Key_P);
  EXPECT_TRUE(eventually([&] { return window->people_page()->isVisible(); }));
  EXPECT_EQ(child<QLabel>("person_name")->text(), "Chen W.");
}

}  // namespace
}  // namespace swage::test
