// SPDX-License-Identifier: Apache-2.0
//
// The pages of an instructor in the whole window, with a school in a file: People, Courses, the instructor's window.
#include <QDialog>
#include <QLineEdit>
#include <QTableWidget>
#include <QTimer>

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

}  // namespace
}  // namespace swage::test
