// SPDX-License-Identifier: Apache-2.0
//
// Pasted lists of people, and the standing of a person.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "console/models/people_model.hpp"
#include "console/models/roster.hpp"
#include "console/models/standing.hpp"
#include "fake_store.hpp"

namespace swage::console {
namespace {

using Is = RosterLine::Is;

TEST(Roster, ALinePerPersonIsEnough) {
  const auto all = read_roster(QStringLiteral("Arun P.\n\n  Bea   L. \r\nArun P.\nchen w.\n"), {QStringLiteral("Chen W.")});
  ASSERT_EQ(all.size(), 4);
  EXPECT_EQ(all[0].name, "Arun P.");
  EXPECT_EQ(all[1].name, "Bea L.");
  EXPECT_EQ(all[0].is, Is::kNew);
  EXPECT_EQ(all[2].is, Is::kTwice);
  EXPECT_EQ(all[3].is, Is::kKnown) << "capitals make nobody new";
  EXPECT_TRUE(read_roster(QStringLiteral(" \n\n"), {}).isEmpty());
}

TEST(Roster, ColumnsAreNamedOrInTheirOrder) {
  const auto named = read_roster(QStringLiteral("id;hand;name;group\n4F2A;L;\"Doe; Jane\";Spring\n;right;Max;\n"), {});
  ASSERT_EQ(named.size(), 2);
  EXPECT_EQ(named[0].name, "Doe; Jane");
  EXPECT_EQ(named[0].code, "4F2A");
  EXPECT_EQ(named[0].hand, "left");
  EXPECT_EQ(named[0].group, "Spring");
  EXPECT_EQ(named[1].hand, "right");
  const auto bare = read_roster(QStringLiteral("Eva\tAutumn\tlinks\n"), {});
  ASSERT_EQ(bare.size(), 1);
  EXPECT_EQ(bare[0].group, "Autumn");
  EXPECT_EQ(bare[0].hand, "left");
}

TEST(Roster, AHeadOfAnotherProgramIsRecognisedAndTheRestTold) {
  QStringList left_out;
  const auto all = read_roster(QStringLiteral("First name,Last name,Student ID,Cohort\nNova,Newcomer,77,Spring\n"), {}, &left_out);
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].name, "Nova Newcomer");
  EXPECT_EQ(all[0].group, "Spring");
  EXPECT_EQ(all[0].code, "");
  EXPECT_EQ(left_out, QStringList{QStringLiteral("Student ID")});
}

TEST(Roster, WhatCannotBeAddedSaysWhy) {
  const auto all = read_roster(QStringLiteral("name,hand\nAda,both\n,left\n") + QString(100, QLatin1Char('x')) + QStringLiteral(",left"), {});
  ASSERT_EQ(all.size(), 3);
  for (const RosterLine& line : all) {
    EXPECT_EQ(line.is, Is::kFaulty);
    EXPECT_FALSE(line.says.isEmpty());
  }
  EXPECT_TRUE(all[0].says.contains("both"));
}

record::AttemptRow made(const char* utc, const char* outcome, const char* reason = "", const char* lesson = "a") {
  record::AttemptRow a;
  a.person_id = "p";
  a.lesson_id = lesson;
  a.mode = "practice";
  a.started_utc = utc;
  a.outcome = outcome;
  a.reason = reason;
  return a;
}

Standing standing(const std::vector<record::AttemptRow>& newest_first) {
  std::vector<const record::AttemptRow*> all;
  for (const record::AttemptRow& a : newest_first) all.push_back(&a);
  return standing_of(all, QDateTime::fromString(QStringLiteral("2026-11-22T10:00:00Z"), Qt::ISODate));
}

TEST(Standing, CountsWhatAPersonDid) {
  std::vector<record::AttemptRow> all = {made("2026-11-20T09:00:00Z", "passed"), made("2026-11-19T09:00:00Z", "failed"),
                                         made("2026-11-18T09:00:00Z", "passed", "", "b"), made("2026-11-17T09:00:00Z", "aborted")};
  all[2].is_void = true;
  const Standing s = standing(all);
  EXPECT_EQ(s.attempts, 2);
  EXPECT_EQ(s.passed, 1);
  EXPECT_EQ(s.lessons_passed, 1);
  EXPECT_EQ(s.days, 2);
  EXPECT_EQ(s.last, (QVector<bool>{false, true}));
  EXPECT_EQ(s.failing, 0);
  EXPECT_EQ(attention(s), 0);
}

TEST(Standing, WhoIsStuckComesBeforeWhoIsAway) {
  const std::vector<record::AttemptRow> stuck(5, made("2026-11-22T09:00:00Z", "failed", "failed.dropped"));
  const Standing s = standing(stuck);
  EXPECT_EQ(s.failing, 5);
  EXPECT_EQ(s.same_reason, "failed.dropped");
  EXPECT_TRUE(attention_words(s).contains("5 not passed in a row: Dropped")) << attention_words(s).toStdString();
  std::vector<record::AttemptRow> mixed = stuck;
  mixed[1].reason = "failed.out_of_time";
  EXPECT_LT(attention(standing(mixed)), attention(s));
  EXPECT_GT(attention(standing(mixed)), 0);
  mixed[2].lesson_id = "b";
  EXPECT_EQ(standing(mixed).failing, 2) << "of one lesson";
  const Standing away = standing({made("2026-11-10T09:00:00Z", "passed")});
  EXPECT_TRUE(attention_words(away).contains("12 days")) << attention_words(away).toStdString();
  EXPECT_GT(attention(away), 0);
  EXPECT_LT(attention(away), attention(s));
  EXPECT_EQ(attention(Standing{}), 0);
}

TEST(People, AreATableWithWhoNeedsAttention) {
  PeopleModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  std::vector<record::AttemptRow> attempts = test::sample_attempts();
  std::reverse(attempts.begin(), attempts.end());
  record::Person arun, bea;
  arun.id = "p1", arun.name = "Arun P.";
  bea.id = "p2", bea.name = "Bea L.";
  model.set_people({arun, bea}, attempts);
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(model.row_of("p2"), 1);
  EXPECT_EQ(model.names(), QStringList({"Arun P.", "Bea L."}));
  EXPECT_EQ(model.index(0, PeopleModel::kLast).data().toString().count(QStringLiteral("✓")) +
                model.index(0, PeopleModel::kLast).data().toString().count(QStringLiteral("✗")),
            kLastShown);
  EXPECT_EQ(model.index(1, PeopleModel::kPassed).data().toString(), QString()) << "what was stopped does not count";
}

}  // namespace
}  // namespace swage::console
