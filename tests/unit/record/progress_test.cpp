// SPDX-License-Identifier: Apache-2.0
//
// Which attempts count in a course, and lists of people as they are pasted.
#include "record/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "attempt.hpp"
#include "record/people_list.hpp"
#include "record/school.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

AttemptRow attempt(int day, int minute, double time, const std::string& lesson = "a") {
  AttemptRow a;
  char when[64];
  std::snprintf(when, sizeof when, "2030-01-%02dT12:%02d:00.000Z", day, minute);
  a.id = when;
  a.started_utc = when;
  a.lesson_id = lesson;
  a.mode = "test";
  a.state = "complete";
  a.outcome = "passed";
  a.metrics = {{"time", "s", time}};
  return a;
}

Course course_of(const std::string& digest = "") {
  Course c;
  c.title = "Basic";
  CourseStep step;
  step.lesson_id = "a";
  step.digest = digest;
  judge::Limit limit;
  limit.metric = "time";
  limit.most = 10;
  step.limits = {limit};
  c.steps = {step, step};
  c.steps[1].lesson_id = "b";
  return c;
}

TEST(Progress, CountsOnlyWhatProvesSomething) {
  const CourseStep step = course_of("d").steps[0];
  AttemptRow good = attempt(1, 0, 5);
  good.lesson_digest = "d";
  EXPECT_TRUE(counts(step, good));
  const auto without = [&](auto change) {
    AttemptRow a = good;
    change(a);
    return counts(step, a);
  };
  EXPECT_FALSE(without([](AttemptRow& a) { a.mode = "practice"; }));
  EXPECT_FALSE(without([](AttemptRow& a) { a.state = "aborted"; }));
  EXPECT_FALSE(without([](AttemptRow& a) { a.is_void = true; }));
  EXPECT_FALSE(without([](AttemptRow& a) { a.is_scripted = true; }));
  EXPECT_FALSE(without([](AttemptRow& a) { a.lesson_id = "b"; }));
  EXPECT_FALSE(without([](AttemptRow& a) { a.lesson_digest = "another version"; }));
}

// U13: steps that the machine lost bend times and speeds, so that nothing is proved, unless somebody who has seen it says so
TEST(Progress, AnAttemptOnASlowMachineIsFlaggedAndLeftOutOfTheRule) {
  const Folder folder;
  std::string error;
  const auto record = [&](uint64_t lost) {
    AttemptInfo info = make_info();
    info.mode = "test";
    info.realtime = true;
    for (HandInfo& h : info.hands) h.flags = 0;
    base::Problems problems;
    const auto recorder = Recorder::open(folder / "a.db", info, problems);
    for (uint64_t i = 0; i < 10; ++i) recorder->step(make_step(7, i));
    AttemptEnd end = make_end();
    end.health.executed = 10000 - lost;
    end.health.dropped = lost;
    recorder->finish(end);
    return recorder->attempt_id();
  };
  CourseStep step;
  step.lesson_id = make_info().lesson_id;
  const auto store = Store::open(folder / "a.db", error);
  AttemptRow a;
  ASSERT_TRUE(store->attempt(record(100), a));
  EXPECT_EQ(a.remark, "") << "one step in a hundred is noticed by nobody";
  EXPECT_TRUE(counts(step, a));
  EXPECT_EQ(metrics_of(step, std::span(&a, 1)).size(), 1u);
  const std::string slow = record(1000);
  ASSERT_TRUE(store->attempt(slow, a));
  EXPECT_EQ(a.remark, "at 90 % of real speed");
  EXPECT_FALSE(counts(step, a));
  EXPECT_TRUE(metrics_of(step, std::span(&a, 1)).empty()) << "and it gives no limits";
  // accepted all the same
  const auto school = School::open(folder / "a.db", error);
  ASSERT_TRUE(school->set_void(slow, false, "the pause was a nurse's call", "Mei")) << school->error();
  ASSERT_TRUE(store->attempt(slow, a));
  EXPECT_TRUE(counts(step, a));
}

TEST(Progress, GoesThroughACourseInOrder) {
  // newest first, as a store gives them
  std::vector<AttemptRow> attempts = {attempt(2, 1, 9), attempt(2, 0, 9), attempt(1, 2, 8), attempt(1, 1, 8), attempt(1, 0, 20)};
  AttemptRow practice = attempt(1, 3, 20);
  practice.mode = "practice";
  attempts.push_back(practice);
  const Course course = course_of();
  auto s = standing(course, attempts);
  EXPECT_TRUE(s[0].rule.passed);
  EXPECT_EQ(s[0].tests, 5u);
  EXPECT_EQ(s[0].practice, 1u);
  EXPECT_THAT(s[0].broken, ElementsAre(1u));
  EXPECT_TRUE(s[1].is_open) << "the step before it is passed";
  EXPECT_EQ(s[1].tests, 0u);
  // the first of the later day missed: no longer passed, and the next stays closed
  attempts[1].metrics[0].value = 11;
  s = standing(course, attempts);
  EXPECT_FALSE(s[0].rule.passed);
  EXPECT_TRUE(s[0].rule.is_earned);
  EXPECT_FALSE(s[1].is_open);
  // an attempt that is void is none
  attempts[1].is_void = true;
  EXPECT_EQ(standing(course, attempts)[0].tests, 4u);
  Course free = course;
  free.in_order = false;
  EXPECT_TRUE(standing(free, attempts)[1].is_open);
}

TEST(Progress, WithoutLimitsTheLessonsVerdictCounts) {
  CourseStep step = course_of().steps[0];
  step.limits.clear();
  AttemptRow a = attempt(1, 0, 99);
  EXPECT_TRUE(meets(step, a).all);
  a.outcome = "failed";
  EXPECT_FALSE(meets(step, a).all);
  EXPECT_EQ(metrics_of(step, std::vector<AttemptRow>{a, attempt(1, 1, 3, "b")}).size(), 1u);
}

// A needle that tore the tissue after a second was quicker than every limit of time.
TEST(Progress, AnAttemptThatFailedMeetsNoStepWhateverItsNumbersAre) {
  const CourseStep step = course_of().steps[0];
  AttemptRow a = attempt(1, 0, 1);
  EXPECT_TRUE(meets(step, a).all);
  a.outcome = "failed";
  EXPECT_FALSE(meets(step, a).all);
  EXPECT_TRUE(meets(step, a).broken.empty()) << "it broke no limit";
  EXPECT_TRUE(metrics_of(step, std::vector<AttemptRow>{a})[0].empty()) << "and it gives no limits";
  Course course = course_of();
  std::vector<AttemptRow> attempts;
  for (int day = 1; day < 3; ++day)
    for (int minute = 0; minute < 2; ++minute) attempts.push_back(attempt(day, minute, 1)), attempts.back().outcome = "failed";
  const StepStanding failed = standing(course, attempts)[0];
  EXPECT_EQ(failed.tests, 4u);
  EXPECT_FALSE(failed.rule.passed);
  for (AttemptRow& one : attempts) one.outcome = "passed";
  EXPECT_TRUE(standing(course, attempts)[0].rule.passed);
}

TEST(Progress, DaysAreThoseOfTheCalendar) {
  EXPECT_EQ(day_of("2030-01-02T00:00:00.000Z") - day_of("2030-01-01T00:00:00.000Z"), 1);
  EXPECT_EQ(day_of("2030-03-01T12:00:00.000Z") - day_of("2030-02-28T12:00:00.000Z"), 1);
  EXPECT_EQ(day_of("yesterday"), -1);
}

TEST(PeopleList, IsReadAsItIsPasted) {
  const std::vector<Person> known = {{"1", "Ada", "", 0, "A1"}};
  const std::vector<Group> groups = {{"g", "Residents", "", ""}};
  std::vector<ListedPerson> list;
  std::string error;
  ASSERT_TRUE(read_people("Ada\n\n  Bo L. \r\nBo L.\n", known, groups, list, error)) << error;
  ASSERT_EQ(list.size(), 3u);
  EXPECT_TRUE(list[0].is_there);
  EXPECT_FALSE(list[1].is_there);
  EXPECT_EQ(list[1].person.name, "Bo L.");
  EXPECT_EQ(list[1].line, 3u);
  EXPECT_TRUE(list[2].is_there) << "twice in the list";

  ASSERT_TRUE(read_people("\xEF\xBB\xBFHandedness;Name;Group\nL;\"Li; Anna\";Residents\nboth;Cy;\n;;Fellows\n;D;E;F\n", known, groups, list, error)) << error;
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].person.name, "Li; Anna");
  EXPECT_EQ(list[0].person.handedness, "left");
  EXPECT_EQ(list[0].person.group_id, "g");
  EXPECT_THAT(list[1].problem, HasSubstr(say::kNoHandedness("both")));
  EXPECT_EQ(list[2].problem, say::kNoName());
  EXPECT_THAT(list[3].problem, HasSubstr(say::kManyFields(4, 3)));
  std::vector<std::string> told;
  ASSERT_TRUE(read_people("name,shoe size\nCy,43\n", known, groups, list, error, &told)) << error;
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].person.name, "Cy");
  EXPECT_THAT(told, testing::ElementsAre(say::kColumn("shoe size")));
}

TEST(PeopleList, AHeadOfAnotherProgramIsRecognised) {
  std::vector<ListedPerson> list;
  std::vector<std::string> told;
  std::string error;
  ASSERT_TRUE(read_people("First name,Last name,Student ID,Cohort\nNova,Newcomer,77,Spring\n", {}, {}, list, error, &told)) << error;
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].person.name, "Nova Newcomer");
  EXPECT_EQ(list[0].group, "Spring");
  EXPECT_EQ(list[0].person.code, "") << "a number of a school is no code: exports would say it";
  EXPECT_THAT(told, testing::ElementsAre(say::kColumn("Student ID")));
  EXPECT_FALSE(read_people("Group,E-mail\nSpring,a@b\n", {}, {}, list, error));
  EXPECT_EQ(error, say::kHeadWithoutName("Group"));
  ASSERT_TRUE(read_people("Eva\tAutumn\tlinks\tE1\n", {}, {}, list, error)) << error;
  EXPECT_EQ(list[0].group, "Autumn");
  EXPECT_EQ(list[0].person.handedness, "left");
  EXPECT_EQ(list[0].person.code, "E1");
}

TEST(PeopleList, WindowsTextIsDecodedAndToldAndOtherTextRefused) {
  std::string text, told, error;
  ASSERT_TRUE(decode_list("name\nFrida B\xF6hm\n\x8Ei\x9E" "ek\n", text, told, error)) << error;
  EXPECT_EQ(text, "name\nFrida B\xC3\xB6hm\n\xC5\xBDi\xC5\xBE" "ek\n");
  EXPECT_EQ(told, say::kWindowsText(2));
  ASSERT_TRUE(decode_list("\xEF\xBB\xBF" "B\xC3\xB6hm", text, told, error)) << error;
  EXPECT_EQ(text, "B\xC3\xB6hm");
  EXPECT_EQ(told, "");
  EXPECT_FALSE(decode_list("Ada\nB\x81\n", text, told, error));
  EXPECT_EQ(error, say::kOtherText(2));
  EXPECT_FALSE(decode_list(std::string("A\0d\0a\0", 6), text, told, error));
}

TEST(PeopleList, IsAddedWholeOrNotAtAll) {
  const Folder folder;
  std::string error;
  const auto school = School::open(folder / "a.db", error);
  std::vector<ListedPerson> list;
  ASSERT_TRUE(read_people("name,group,handedness\nAda,Residents,left\nBo,Residents,\n,x,\n", school->people(), school->groups(), list, error));
  EXPECT_EQ(add_people(*school, list, error), -1);
  EXPECT_THAT(error, HasSubstr(say::kOfLine(4, say::kNoName())));
  EXPECT_TRUE(school->people().empty());
  list.pop_back();
  EXPECT_EQ(add_people(*school, list, error), 2) << error;
  ASSERT_EQ(school->groups().size(), 1u);
  EXPECT_EQ(school->people()[0].group_id, school->groups()[0].id);
  // the same list again adds nobody
  ASSERT_TRUE(read_people("name,group\nAda,Residents\nBo,Residents\n", school->people(), school->groups(), list, error));
  EXPECT_EQ(add_people(*school, list, error), 0);
  EXPECT_EQ(school->people().size(), 2u);
}

}  // namespace
}  // namespace swage::record::test
