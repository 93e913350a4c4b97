// SPDX-License-Identifier: Apache-2.0
//
// The People and the Courses page on a real store, by keys and clicks.
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
#include <cstdio>
#include <ctime>

#include "record/recorder.hpp"
#include "record/synthetic.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

class SchoolPages : public WindowTest {
 protected:
  void SetUp() override { with_school = true; }
  /// Presses Ctrl and a key, once the window has the focus again.
  void press(Qt::Key key) {
    ASSERT_TRUE(eventually([&] {
      QApplication::setActiveWindow(window.get());
      return QApplication::activeWindow() == window.get() && !QApplication::activeModalWidget();
    }));
    QTest::keyClick(window.get(), key, Qt::ControlModifier);
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
  EXPECT_EQ(child<QLabel>("person_name")->text(), "Arun P.") << "the first of them is shown";
  EXPECT_FALSE(child<QLabel>("empty")->isVisible());
  auto* group = child<QComboBox>("group_filter");
  EXPECT_GE(group->findText("Spring"), 0);
  window->desk()->people_edits()->undo();
  EXPECT_EQ(people(), 0);
  window->desk()->people_edits()->redo();
  EXPECT_EQ(people(), 2);
}

// U15: pasted, typed or chosen input is discarded with the dialog
TEST_F(SchoolPages, ADialogThatIsLeftWritesNothing) {
  open();
  click("page_people");
  in_dialog("roster_dialog", [](QDialog* d) {
    d->findChild<QPlainTextEdit*>()->setPlainText(QStringLiteral("Arun P., Spring, left\nBea L., Spring\n"));
    QTest::keyClick(d, Qt::Key_Escape);
  });
  click("first_list");
  in_dialog("person_dialog", [](QDialog* d) {
    d->findChild<QLineEdit*>(QStringLiteral("person_name_edit"))->setText(QStringLiteral("Chen W."));
    QTest::keyClick(d, Qt::Key_Escape);
  });
  click("first_person");
  EXPECT_EQ(people(), 0);
  EXPECT_FALSE(window->desk()->people_edits()->canUndo());
  std::string error;
  const auto school = record::School::open(school_file(), error);
  EXPECT_TRUE(school->people().empty());
  EXPECT_TRUE(school->groups().empty()) << "nor the group of those who were not added";
  record::Person kept;
  kept.name = "Dora M.";
  ASSERT_TRUE(school->add_person(kept));
  window->people_page()->refresh();
  in_dialog("erase_dialog", [](QDialog* d) {
    d->findChild<QLineEdit*>(QStringLiteral("erase_name"))->setText(QStringLiteral("Dora M."));
    QTest::keyClick(d, Qt::Key_Escape);
  });
  click("erase_person");
  EXPECT_EQ(people(), 1);
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

TEST_F(SchoolPages, PeopleAreAddedAndTakenBackByKeysAlone) {
  open();
  QTest::keyClick(window.get(), Qt::Key_4, Qt::ControlModifier);
  ASSERT_TRUE(window->people_page()->isVisible());
  in_dialog("roster_dialog", [](QDialog* d) {
    QTest::keyClicks(d->findChild<QPlainTextEdit*>(), QStringLiteral("Arun P."));
    QTest::keyClick(d->findChild<QPlainTextEdit*>(), Qt::Key_Return);
    QTest::keyClicks(d->findChild<QPlainTextEdit*>(), QStringLiteral("Bea L."));
    auto* add = d->findChild<QPushButton*>(QStringLiteral("roster_add"));
    add->setFocus();
    QTest::keyClick(add, Qt::Key_Space);
  });
  // a shortcut of a button clicks it a tenth of a second later
  press(Qt::Key_L);
  ASSERT_TRUE(eventually([&] { return people() == 2; }));
  in_dialog("person_dialog", [](QDialog* d) {
    QTest::keyClicks(d->findChild<QLineEdit*>(QStringLiteral("person_name_edit")), QStringLiteral("Chen W."));
    QTest::keyClick(d, Qt::Key_Return);
  });
  press(Qt::Key_N);
  ASSERT_TRUE(eventually([&] { return people() == 3; }));
  press(Qt::Key_Z);
  EXPECT_EQ(people(), 2);
  press(Qt::Key_Z);
  EXPECT_EQ(people(), 0);
  press(Qt::Key_Y);
  EXPECT_EQ(people(), 2);
}

TEST_F(SchoolPages, ACourseIsGivenToTheChosenOrToAGroupAndTakenBack) {
  open();
  click("page_courses");
  click("first_course");
  click("page_people");
  console::RosterLine arun, bea;
  arun.name = "Arun P.", arun.group = "Spring";
  bea.name = "Bea L.", bea.group = "Spring";
  ASSERT_TRUE(window->desk()->add_people({arun, bea}));
  console::PeopleModel* model = window->people_page()->people();
  const auto course_of = [&](const char* name) {
    return model->index(static_cast<int>(model->names().indexOf(QLatin1String(name))), console::PeopleModel::kCourse).data().toString();
  };
  window->people_page()->select_person("Bea L.");
  in_dialog("assign_dialog", [](QDialog* d) { d->findChild<QPushButton*>(QStringLiteral("assign_ok"))->click(); });
  click("assign_course");
  EXPECT_EQ(course_of("Bea L."), "Course 1");
  EXPECT_EQ(course_of("Arun P."), "");
  window->desk()->people_edits()->undo();
  EXPECT_EQ(course_of("Bea L."), "");
  in_dialog("assign_dialog", [](QDialog* d) {
    d->findChild<QComboBox*>(QStringLiteral("assign_whom"))->setCurrentIndex(1);
    d->findChild<QCheckBox*>(QStringLiteral("assign_has_due"))->setChecked(true);
    d->findChild<QPushButton*>(QStringLiteral("assign_ok"))->click();
  });
  click("assign_course");
  EXPECT_TRUE(course_of("Bea L.").startsWith("Course 1, until ")) << course_of("Bea L.").toStdString();
  EXPECT_EQ(course_of("Arun P."), course_of("Bea L."));
  in_dialog("assign_dialog", [](QDialog* d) {
    auto* which = d->findChild<QComboBox*>(QStringLiteral("assign_which"));
    which->setCurrentIndex(which->count() - 1);
    d->findChild<QComboBox*>(QStringLiteral("assign_whom"))->setCurrentIndex(1);
    d->findChild<QPushButton*>(QStringLiteral("assign_ok"))->click();
  });
  click("assign_course");
  EXPECT_EQ(course_of("Arun P."), "");
  window->desk()->people_edits()->undo();
  EXPECT_TRUE(course_of("Arun P.").startsWith("Course 1"));
}

TEST_F(SchoolPages, ALessonIsPublishedOnceForEachText) {
  open();
  click("page_lessons");
  auto* version = child<QLabel>("lesson_version");
  ASSERT_TRUE(version->isVisible());
  EXPECT_TRUE(version->text().contains("Not published"));
  EXPECT_FALSE(child<QPushButton>("retire_lesson")->isVisible());
  press(Qt::Key_P);
  EXPECT_TRUE(eventually([&] { return version->text().startsWith("Published as version 1"); })) << version->text().toStdString();
  EXPECT_FALSE(child<QPushButton>("publish_lesson")->isEnabled()) << "the same text twice is one version";
  std::string error;
  const auto published = record::School::open(school_file(), error)->lessons(true);
  ASSERT_EQ(published.size(), 1u);
  EXPECT_EQ(published[0].digest, record::lesson_digest(published[0].text));
  click("retire_lesson");
  EXPECT_TRUE(version->text().contains("retired"));
  EXPECT_FALSE(record::School::open(school_file(), error)->lessons()[0].retired_utc.empty());
  click("retire_lesson");
  EXPECT_TRUE(record::School::open(school_file(), error)->lessons()[0].retired_utc.empty());
}

// state is not told by colour alone: the tick is visible
TEST_F(SchoolPages, ABoxOfATableThatIsCheckedShowsATick) {
  open();
  click("page_courses");
  click("first_course");
  click("add_lesson");
  record::Course before = window->courses_page()->course(), after = before;
  after.steps[0].limits.push_back({"force.peak", "N", 0.1, 0.9, true, "thesis"});
  ASSERT_TRUE(window->desk()->change_course(before, after, QStringLiteral("limit")));
  auto* limits = child<QTableWidget>("limits");
  for (const char* theme : {"light", "dark", "contrast"}) {
    window->set_theme(QString::fromLatin1(theme), QStringLiteral("thesis"));
    const console::UiTheme colours = console::UiTheme::stock(QString::fromLatin1(theme));
    limits->clearSelection();
    limits->setCurrentCell(-1, -1);
    const QImage box = limits->viewport()->grab(limits->visualItemRect(limits->item(0, 3))).toImage();
    int accent = 0, tick = 0;
    for (int x = 0; x < box.width(); ++x) {
      for (int y = 0; y < box.height(); ++y) {
        const QColor c = box.pixelColor(x, y);
        accent += c == colours["accent"];
        const QColor wanted = colours["accent_text"].lightnessF() > 0.5 ? Qt::white : Qt::black;
        tick += std::abs(c.lightnessF() - wanted.lightnessF()) < 0.1 && x < 24;
      }
    }
    EXPECT_GT(accent, 30) << theme;
    EXPECT_GT(tick, 8) << theme;
  }
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
  // 3 in a row within 30 attempts, for a trainee who succeeds half the time: 91 of 100
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

TEST_F(SchoolPages, ANewCourseIsNamedAtOnceAndItsRuleHasRoom) {
  open();
  click("page_courses");
  click("first_course");
  click("new_course");
  auto* title = child<QLineEdit>("course_title");
  EXPECT_TRUE(title->hasFocus() && title->hasSelectedText());
  QTest::keyClicks(title, QStringLiteral("Spring"));
  click("add_lesson");
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(title->text(), "Spring") << "the lesson is taken back, not the name";
  EXPECT_EQ(child<QListWidget>("steps")->count(), 0);
  click("add_lesson");
  EXPECT_GE(child<QLabel>("rule_says")->mapTo(window.get(), QPoint()).x(), 500);
  EXPECT_GT(child<QTableWidget>("limits")->width(), 400);
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

// An attempt with thirty metrics by a scripted hand, as template for a school's attempts.
std::string keep_hand(const std::string& store, double score) {
  record::AttemptInfo info;
  info.lesson_id = "org.example.a";
  info.lesson_title = "A lesson";
  info.mode = "test";
  info.device = "expert";
  info.devices = {"hand"};
  info.hands = {{"hand", "expert", "swage.device.scripted", "1.0.0", "{}", SWAGE_DEVICE_SCRIPTED}};
  for (int i = 0; i < 30; ++i) info.script.metrics.push_back({"lesson", "metric." + std::to_string(i), "1", ""});
  base::Problems problems;
  const auto recorder = record::Recorder::open(store, info, problems);
  if (!recorder) return {};
  record::AttemptEnd end;
  end.outcome = judge::Outcome::kPassed;
  end.score = score;
  end.simulated_s = 1000 / score;
  for (int i = 0; i < 30; ++i) end.metric.push_back(score + i);
  recorder->finish(end);
  return recorder->attempt_id();
}

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// A page of a school with 5 000 attempts costs at most three times a read of all of them with their 150 000 metrics. The People page
// costs one such read; it cost 3.7 when it read metrics for each list. A ratio in processor time, which other programs on the core
// at most double; the times themselves are printed.
TEST_F(SchoolPages, FiveThousandAttemptsAreNotReadForEveryList) {
  record::SyntheticSchool school;
  school.from = dir.filePath(QStringLiteral("hands.db")).toStdString();
  school.lessons = {{keep_hand(school.from, 98), {keep_hand(school.from, 60), keep_hand(school.from, 50)}}};
  school.recordings = 1;
  std::string error;
  ASSERT_TRUE(record::write_synthetic_school(school_file(), school, error)) << error;
  const auto store = record::Store::open(school_file(), error);
  ASSERT_NE(store, nullptr) << error;
  const double before = thread_ms();
  ASSERT_GE(store->attempts("").size(), 5000U);
  const double all_ms = thread_ms() - before;
  std::printf("all attempts with their metrics: %.0f ms\n", all_ms);
  open();
  for (const char* page : {"page_people", "page_courses", "page_lessons", "page_run", "page_people"}) {
    const double start = thread_ms();
    click(page);
    QApplication::processEvents();
    window->grab();
    const double ms = thread_ms() - start;
    RecordProperty(std::string(page) + "_ms", std::to_string(ms));
    std::printf("%s: %.0f ms\n", page, ms);
    EXPECT_LT(ms, 3 * all_ms) << page;
  }
  EXPECT_GT(people(), 29);
}

}  // namespace
}  // namespace swage::test
