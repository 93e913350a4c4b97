// SPDX-License-Identifier: Apache-2.0
//
// The pages of an instructor in the whole window, with a school in a file: People, Courses, the instructor's window.
#include <QDialog>
#include <QLineEdit>
#include <QTimer>

#include "window_fixture.hpp"

namespace swage::test {
namespace {

class InstructorPages : public WindowTest {
 protected:
  void SetUp() override { with_school = true; }
  /// Runs `what` in the next modal dialog of that name.
  template <class Do>
  void in_dialog(const char* name, Do what) {
    auto* look = new QTimer(window.get());
    QObject::connect(look, &QTimer::timeout, look, [this, look, name, what] {
      auto* dialog = window->findChild<QDialog*>(QString::fromLatin1(name));
      if (!dialog || !dialog->isVisible()) return;
      look->stop();
      what(dialog);
    });
    look->start(10);
  }
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

}  // namespace
}  // namespace swage::test
