// SPDX-License-Identifier: Apache-2.0
//
// The People and the Courses page on a real store, with keys and clicks.
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>

#include "window_fixture.hpp"

namespace swage::test {
namespace {

class SchoolPages : public WindowTest {
 protected:
  void SetUp() override { with_school = true; }
  /// Does something in the next modal dialog of that name.
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
  int people() { return window->people_page()->people()->rowCount(); }
  std::vector<record::Course> courses() {
    std::string error;
    return record::School::open(school_file(), error)->courses();
  }
};

TEST_F(SchoolPages, APastedListIsPreviewedAddedAndUndone) {
  open();
  click("page_people");
  EXPECT_TRUE(child<QLabel>("empty")->isVisible());
  in_dialog("roster_dialog", [](QDialog* d) {
    d->findChild<QPlainTextEdit*>()->setPlainText(QStringLiteral("Arun P., Spring, left\nBea L., Spring\nArun P.\n"));
    auto* preview = d->findChild<QTableWidget*>();
    EXPECT_EQ(preview->rowCount(), 3);
    EXPECT_TRUE(preview->item(2, 0)->text().contains("Twice"));
    auto* add = d->findChild<QPushButton*>(QStringLiteral("roster_add"));
    EXPECT_EQ(add->text(), "Add 2 people");
    add->click();
  });
  click("first_list");
  EXPECT_EQ(people(), 2);
  EXPECT_FALSE(child<QLabel>("empty")->isVisible());
  auto* group = child<QComboBox>("group_filter");
  EXPECT_GE(group->findText("Spring"), 0);
  window->desk()->people_edits()->undo();
  EXPECT_EQ(people(), 0);
  window->desk()->people_edits()->redo();
  EXPECT_EQ(people(), 2);
}

TEST_F(SchoolPages, APersonIsAddedChangedAndErasedByTypingTheName) {
  open();
  click("page_people");
  in_dialog("person_dialog", [](QDialog* d) {
    auto* ok = d->findChild<QPushButton*>(QStringLiteral("person_ok"));
    EXPECT_FALSE(ok->isEnabled());
    d->findChild<QLineEdit*>(QStringLiteral("person_name_edit"))->setText(QStringLiteral("Chen W."));
    ok->click();
  });
  click("first_person");
  ASSERT_EQ(people(), 1);
  in_dialog("person_dialog", [](QDialog* d) {
    d->findChild<QComboBox*>(QStringLiteral("person_group"))->setCurrentText(QStringLiteral("Experts"));
    d->findChild<QPushButton*>(QStringLiteral("person_ok"))->click();
  });
  click("change_person");
  EXPECT_EQ(window->people_page()->people()->index(0, console::PeopleModel::kGroup).data().toString(), "Experts");
  in_dialog("erase_dialog", [](QDialog* d) {
    auto* ok = d->findChild<QPushButton*>(QStringLiteral("erase_ok"));
    auto* name = d->findChild<QLineEdit*>(QStringLiteral("erase_name"));
    name->setText(QStringLiteral("Chen"));
    EXPECT_FALSE(ok->isEnabled());
    name->setText(QStringLiteral("Chen W."));
    ok->click();
  });
  click("erase_person");
  EXPECT_EQ(people(), 0);
}

TEST_F(SchoolPages, ACourseIsBuiltWithoutASaveButtonAndUndone) {
  open();
  click("page_courses");
  EXPECT_TRUE(child<QLabel>("no_courses")->isVisible());
  click("first_course");
  ASSERT_EQ(courses().size(), 1u);
  auto* title = child<QLineEdit>("course_title");
  title->setFocus();
  title->selectAll();
  QTest::keyClicks(title, QStringLiteral("Basic"));
  EXPECT_EQ(courses()[0].title, "Basic");
  EXPECT_EQ(title->text(), "Basic");
  click("add_lesson");
  click("add_lesson");
  ASSERT_EQ(courses()[0].steps.size(), 2u);
  const std::string second = courses()[0].steps[1].lesson_id;
  EXPECT_NE(second, courses()[0].steps[0].lesson_id);
  click("step_up");
  EXPECT_EQ(courses()[0].steps[0].lesson_id, second);
  EXPECT_EQ(child<QListWidget>("steps")->currentRow(), 0);
  child<QSpinBox>("rule_in_a_row")->setValue(3);
  child<QSpinBox>("rule_later_day")->setValue(0);
  EXPECT_EQ(courses()[0].steps[0].rule.in_a_row, 3u);
  EXPECT_TRUE(child<QLabel>("rule_says")->text().contains("3 Test attempts in a row"));
  // 3 in a row within 30 attempts, of somebody who succeeds half the time: 91 of 100
  EXPECT_TRUE(eventually([&] { return child<QLabel>("rule_odds")->text().contains(QStringLiteral("9")); }));
  const QString odds = child<QLabel>("rule_odds")->text();
  EXPECT_NEAR(odds.section(QStringLiteral("passes in "), 1).section(QLatin1Char(' '), 0, 0).toDouble(), 91, 2.5) << odds.toStdString();
  // undo, from the newest on
  child<QListWidget>("steps")->setFocus();
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(courses()[0].steps[0].rule.later_day, 2u);
  EXPECT_EQ(child<QSpinBox>("rule_later_day")->value(), 2);
  while (window->desk()->course_edits()->canUndo()) window->desk()->course_edits()->undo();
  EXPECT_TRUE(courses().empty());
  EXPECT_TRUE(child<QLabel>("no_courses")->isVisible());
}

TEST_F(SchoolPages, ANumberThatIsNoneLeavesTheLimitAsItWas) {
  open();
  click("page_courses");
  click("first_course");
  click("add_lesson");
  record::Course before = window->courses_page()->course(), after = before;
  after.steps[0].limits.push_back({"force.peak", "N", 0.1, 0.9, false, "thesis"});
  ASSERT_TRUE(window->desk()->change_course(before, after, QStringLiteral("limit")));
  auto* limits = child<QTableWidget>("limits");
  ASSERT_EQ(limits->rowCount(), 1);
  EXPECT_EQ(limits->item(0, 2)->text(), QLocale().toString(0.9, 'g', 6));
  limits->item(0, 2)->setText(QStringLiteral("much"));
  EXPECT_TRUE(child<QLabel>("course_problem")->isVisible());
  EXPECT_DOUBLE_EQ(courses()[0].steps[0].limits[0].most, 0.9);
  limits->item(0, 2)->setText(QStringLiteral("1.2"));
  EXPECT_DOUBLE_EQ(courses()[0].steps[0].limits[0].most, 1.2);
  EXPECT_EQ(courses()[0].steps[0].limits[0].source, "instructor");
  limits->item(0, 1)->setText({});
  EXPECT_TRUE(std::isinf(courses()[0].steps[0].limits[0].least));
  limits->item(0, 3)->setCheckState(Qt::Checked);
  EXPECT_TRUE(courses()[0].steps[0].limits[0].is_gate);
}

}  // namespace
}  // namespace swage::test
