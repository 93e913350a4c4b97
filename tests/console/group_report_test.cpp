// SPDX-License-Identifier: Apache-2.0
//
// How the people of a group stand, and the page about it.
#include <gtest/gtest.h>

#include <QFile>

#include "console/app/language.hpp"
#include "console/models/course_next.hpp"
#include "console/models/course_words.hpp"
#include "console/report/group_report.hpp"
#include "paper.hpp"
#include "window_fixture.hpp"

namespace swage::console {
namespace {

using swage::test::WindowTest;

record::AttemptRow attempt(const char* lesson, const char* utc, bool passed, double score, const char* mode = "test") {
  record::AttemptRow a;
  a.id = std::string(lesson) + utc;
  a.lesson_id = a.lesson_title = lesson;
  a.started_utc = utc;
  a.outcome = passed ? "passed" : "failed";
  a.reason = passed ? "" : "failed.dropped";
  a.mode = mode;
  a.state = "complete";
  a.score = score;
  return a;
}

record::Person person(const char* name) {
  record::Person p;
  p.id = p.name = name;
  p.code = std::string("C") + name;
  return p;
}

const QDateTime kNow = QDateTime::fromString(QStringLiteral("2026-03-05T12:00:00Z"), Qt::ISODate);

record::Course course() {
  record::Course c;
  c.title = "Basic";
  for (const char* lesson : {"grasp", "carry"}) {
    record::CourseStep step;
    step.lesson_id = step.title = lesson;
    step.rule.in_a_row = 2, step.rule.later_day = 0;
    c.steps.push_back(step);
  }
  return c;
}

TEST(GroupRows, OverAllLessonsOnePassedAttemptPasses) {
  const std::vector<record::AttemptRow> own = {attempt("carry", "2026-03-04T10:02:00Z", false, 0), attempt("grasp", "2026-03-04T10:01:00Z", true, 70),
                                               attempt("grasp", "2026-03-04T10:00:00Z", true, 90)};
  const GroupRow row = group_row(person("Ada"), own, nullptr, kNow);
  EXPECT_EQ(row.lessons_passed, 1);
  EXPECT_EQ(row.attempts, 3);
  EXPECT_EQ(row.passed, 2);
  ASSERT_TRUE(row.last_score.has_value());
  EXPECT_EQ(*row.last_score, 70) << "of the newest passed one: what failed has none";
  EXPECT_EQ(row.flag, "");
}

TEST(GroupRows, InACourseTheRulePassesAndOtherLessonsDoNotCount) {
  const std::vector<record::AttemptRow> own = {attempt("other", "2026-03-04T10:05:00Z", true, 99), attempt("carry", "2026-03-04T10:02:00Z", true, 60),
                                               attempt("grasp", "2026-03-04T10:01:00Z", true, 70), attempt("grasp", "2026-03-04T10:00:00Z", true, 90)};
  const record::Course basic = course();
  const GroupRow row = group_row(person("Ada"), own, &basic, kNow);
  EXPECT_EQ(row.passed_steps, (QVector<bool>{true, false})) << "one attempt of two in a row";
  EXPECT_EQ(row.lessons_passed, 1);
  EXPECT_EQ(row.attempts, 3);
  EXPECT_EQ(*row.last_score, 60);
}

// What the Run page tells of a course: the first lesson that is open and not passed, and how far its rule is met.
TEST(CourseNexts, NameTheFirstOpenLessonThatIsNotPassed) {
  record::Course basic = course();
  const CourseNext fresh = course_next(basic, {});
  EXPECT_EQ(fresh.words, "Basic: 0 of 2 lessons passed. Next: grasp, 0 of 2 Test attempts in a row.");
  EXPECT_EQ(fresh.lesson_id, "grasp");
  std::vector<record::AttemptRow> own = {attempt("grasp", "2026-03-04T10:00:00Z", true, 90), attempt("grasp", "2026-03-04T09:00:00Z", true, 90, "practice")};
  EXPECT_EQ(course_next(basic, own).steps["grasp"], "1 of 2 Test attempts in a row");
  own.push_back(attempt("grasp", "2026-03-04T10:01:00Z", true, 70));
  EXPECT_EQ(course_next(basic, own).lesson_id, "carry");
  basic.steps[0].rule.later_day = 2;
  EXPECT_EQ(course_next(basic, own).steps["grasp"], "only the first 2 Test attempts of a later day are missing, 0 done");
  EXPECT_EQ(course_next(basic, own).lesson_id, "grasp") << "the next lesson is not open yet";
  basic.steps[1].is_open = true;
  basic.steps[0].rule.later_day = 0;
  for (const char* utc : {"2026-03-04T11:00:00Z", "2026-03-04T11:01:00Z"}) own.push_back(attempt("carry", utc, true, 80));
  const CourseNext done = course_next(basic, own);
  EXPECT_EQ(done.lesson_id, "");
  EXPECT_EQ(done.words, "Basic: 2 of 2 lessons passed.");
  // a finished course gives way to one that is not
  record::Course other = course();
  other.title = "Second", other.steps[0].lesson_id = "stitch";
  EXPECT_EQ(course_next(std::vector<record::Course>{basic, other}, own)->lesson_id, "stitch");
  EXPECT_FALSE(course_next(std::vector<record::Course>{}, own));
}

// The order of a course closes what comes later, with the lesson that comes first; another course may have it open.
TEST(CourseNexts, CloseALessonUntilTheOneBeforeItIsPassed) {
  record::Course basic = course();
  basic.steps.push_back(basic.steps[1]);
  basic.steps[2].lesson_id = basic.steps[2].title = "stitch";
  std::vector<record::AttemptRow> own = {attempt("grasp", "2026-03-04T10:00:00Z", true, 90)};
  const auto closed = [&](std::vector<record::Course> courses) { return course_next(courses, own)->closed; };
  const QHash<QString, ClosedLesson> first = closed({basic});
  EXPECT_FALSE(first.contains("grasp"));
  EXPECT_EQ(first["carry"].words, "Not open yet in the course “Basic”: “grasp” comes first (1 of 2 Test attempts in a row).");
  EXPECT_EQ(first["stitch"].first, "grasp") << "what can be done now, not the lesson just before";
  EXPECT_FALSE(closed({basic}).contains("other")) << "a lesson of no course";
  record::Course free = basic;
  free.in_order = false;
  EXPECT_TRUE(closed({free}).isEmpty());
  EXPECT_TRUE(closed({basic, free}).isEmpty()) << "open in another course of the same person";
  record::Course opened = basic;
  opened.steps[1].is_open = true;
  EXPECT_FALSE(closed({opened}).contains("carry"));
  EXPECT_TRUE(closed({opened}).contains("stitch")) << "an open lesson does not open the one behind it";
  for (const char* utc : {"2026-03-04T11:00:00Z", "2026-03-04T11:01:00Z"}) own.push_back(attempt("carry", utc, true, 80));
  EXPECT_FALSE(closed({basic}).contains("carry")) << "it was passed before the course was assigned";
  own.push_back(attempt("grasp", "2026-03-04T12:00:00Z", true, 90));
  EXPECT_TRUE(closed({basic}).isEmpty());
}

TEST(CourseWords, OneIsNotToldAsSeveral) {
  judge::PassRule rule;
  rule.in_a_row = 1, rule.later_day = 0, rule.a_day = 0;
  EXPECT_EQ(rule_words(rule), "Passed when one Test attempt meets everything that is asked.");
  EXPECT_TRUE(rule_odds(rule)[2].endsWith("typically with the first attempt")) << rule_odds(rule)[2].toStdString();
  rule.in_a_row = 3, rule.later_day = 1;
  EXPECT_EQ(rule_words(rule), "Passed when 3 Test attempts in a row meet everything that is asked, and the first of a later day does so too.");
  record::AttemptRow expert;
  expert.outcome = "passed";
  judge::Limit limit;
  limit.metric = "time.task", limit.most = 5;
  EXPECT_EQ(together_words({limit}, {&expert}), "0 of 1 expert attempts pass and meet the limit.");
}

TEST(GroupRows, WhoNeedsAttentionComesFirst) {
  std::vector<record::AttemptRow> stuck;
  for (const char* utc : {"2026-03-04T10:02:00Z", "2026-03-04T10:01:00Z", "2026-03-04T10:00:00Z"}) stuck.push_back(attempt("grasp", utc, false, 0));
  QVector<GroupRow> rows = {group_row(person("Bea"), {}, nullptr, kNow), group_row(person("Ada"), {}, nullptr, kNow),
                            group_row(person("Chen"), stuck, nullptr, kNow)};
  sort_by_attention(rows);
  EXPECT_EQ(rows[0].name, "Chen");
  EXPECT_TRUE(rows[0].flag.contains("3 not passed in a row")) << rows[0].flag.toStdString();
  EXPECT_EQ(rows[1].name, "Ada");
  EXPECT_EQ(rows[2].flag, "") << "who has not begun is no alarm";
  GroupReport report{"Spring", "Basic", {"grasp", "carry"}, rows};
  report.rows[1].lessons_passed = 2;
  report.rows[1].last_score = 80, report.rows[2].last_score = 70;
  EXPECT_EQ(group_words(report), "3 people, of whom 1 need attention. 2 of 6 lessons passed. Median of the last scores: 75.");
}

class GroupReports : public WindowTest {};

// A class with codes and reasons, in both languages.
TEST_F(GroupReports, CutsNoWord) {
  for (const char* language : {"en", "de"}) {
    ASSERT_TRUE(use_language(QString::fromLatin1(language)));
    std::vector<record::AttemptRow> stuck;
    for (const char* utc : {"2026-03-04T10:02:00Z", "2026-03-04T10:01:00Z", "2026-03-04T10:00:00Z"}) stuck.push_back(attempt("grasp", utc, false, 0));
    GroupReport report{"Spring", "Basic", {"grasp", "carry"}, {}};
    const record::Course basic = course();
    for (int i = 0; i < 30; ++i) {
      record::Person one = person("Maximiliane Oberhauser");
      one.code = "7A880";
      report.rows += group_row(one, i < 6 ? stuck : std::vector<record::AttemptRow>{}, &basic, kNow);
    }
    int pages = 0;
    EXPECT_EQ(swage::test::cut_on_paper("Spring", [&](Sheet& sheet) { draw_group(sheet, report); }, &pages), "") << language;
    EXPECT_EQ(pages, 1) << language;
  }
  use_language(QStringLiteral("en"));
  QLocale::setDefault(QLocale::c());
}

TEST_F(GroupReports, IsOnePageForAClass) {
  attempts = swage::test::sample_attempts();
  open();
  click("page_people");
  std::vector<std::string> all;
  for (int i = 0; i < window->people_page()->people()->rowCount(); ++i) all.push_back(window->people_page()->people()->at(i).id);
  const QString file = dir.filePath("group.pdf");
  const record::Course basic = course();
  for (const record::Course* about : {static_cast<const record::Course*>(nullptr), &basic}) {
    ASSERT_EQ(window->people_page()->files()->write_group_to(file, all, "Everybody", about), QString());
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray text = written.readAll();
    EXPECT_TRUE(text.startsWith("%PDF"));
    EXPECT_EQ(text.count("/Type /Page\n") + text.count("/Type /Page "), 1);
  }
  EXPECT_TRUE(window->people_page()->files()->write_group_to(QStringLiteral("/nowhere/g.pdf"), all, "X", nullptr).contains("/nowhere"));
}

}  // namespace
}  // namespace swage::console
