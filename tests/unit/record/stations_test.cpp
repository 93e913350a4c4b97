// SPDX-License-Identifier: Apache-2.0
//
// The stations of a school on a server of the test's own: two, ten at once, one that is killed, one whose server freezes.
#include "record/stations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "postgres_server.hpp"
#include "record/identity.hpp"
#include "record/schema.hpp"
#include "record/school.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::HasSubstr;
using Kind = StationMessage::Kind;

constexpr int64_t kSecond_ns = 1'000'000'000;

class StationsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!server_.running()) GTEST_SKIP() << server_.why_not();
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    where_ = server_.make_database("school");
  }
  void TearDown() override { unsetenv("XDG_DATA_HOME"); }
  std::unique_ptr<Stations> enter(const std::string& wanted, std::string* got = nullptr) {
    std::string error, name;
    auto stations = Stations::open(where_, error);
    EXPECT_TRUE(stations) << error;
    if (stations) {
      EXPECT_TRUE(stations->enter(wanted, make_id(), name)) << stations->error();
    }
    if (got != nullptr) *got = name;
    return stations;
  }
  static StationNow running(const std::string& person, const std::string& attempt = "") {
    StationNow now;
    now.state = StationState::kRunning;
    now.person = person;
    now.lesson_id = "swage.series.grasp";
    now.lesson_title = "Grasp the needle";
    now.mode = "practice";
    now.phase = "Carry the needle";
    now.cues = {"grasp.good", "target.near"};
    now.attempt_id = attempt;
    now.step = 42000;
    now.time_s = 42;
    now.score = 61.5;
    now.force_N = 0.58;
    now.late = 3;
    now.recorded = true;
    return now;
  }
  Folder folder_;
  PostgresServer server_;
  std::string where_;
};

TEST(StationsOnAFile, SayWhatToSet) {
  const Folder folder;
  std::string error;
  EXPECT_FALSE(Stations::open(folder / "a.db", error));
  EXPECT_THAT(error, HasSubstr("--store postgresql://user@host/database?sslmode=verify-full"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.db")) << "asking makes no store";
}

TEST_F(StationsTest, EachSeesWhatTheOtherDoes) {
  const auto table = enter("Table 1"), desk = enter("Desk");
  record_attempt(where_, 10, 7, "Ada");  // the store knows her
  ASSERT_TRUE(table->say(running("Ada"))) << table->error();
  std::vector<StationNow> all;
  ASSERT_TRUE(desk->all(all)) << desk->error();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].station, "Desk");
  EXPECT_EQ(all[0].state, StationState::kIdle);
  const StationNow& n = all[1];
  EXPECT_EQ(n.station, "Table 1");
  EXPECT_EQ(n.state, StationState::kRunning);
  EXPECT_EQ(n.person, "Ada");
  EXPECT_EQ(n.phase, "Carry the needle");
  EXPECT_EQ(n.cues, (std::vector<std::string>{"grasp.good", "target.near"}));
  EXPECT_EQ(n.step, 42000u);
  EXPECT_EQ(n.score, 61.5);
  EXPECT_EQ(n.force_N, 0.58);
  EXPECT_EQ(n.late, 3u);
  EXPECT_TRUE(n.recorded);
  EXPECT_LT(n.silent_s, kLost_s);
  // what is not said is not a number, and no name is kept in the row
  EXPECT_TRUE(std::isnan(all[0].force_N));
  std::string error;
  const auto db = Database::open(where_, Access::kRead, error);
  for (const Row& r : db->rows("SELECT * FROM station"))
    for (const Value& v : r) EXPECT_NE(text(v), "Ada");
  // closed is told, and is not lost
  ASSERT_TRUE(table->leave());
  ASSERT_TRUE(desk->all(all));
  EXPECT_EQ(all[1].state, StationState::kClosed);
  EXPECT_EQ(all[1].person, "");
}

TEST_F(StationsTest, OneNameIsOfOneProgram) {
  std::string a, b, c;
  const auto first = enter("Table 1", &a), second = enter("Table 1", &b);
  EXPECT_EQ(a, "Table 1");
  EXPECT_EQ(b, "Table 1 2");
  // the same program on another connection, as after a server that was frozen
  std::string error, again;
  const auto early = Stations::open(where_, error), later = Stations::open(where_, error);
  const std::string program = make_id();
  ASSERT_TRUE(early->enter("Desk", program, again) && later->enter("Desk", program, again));
  EXPECT_EQ(again, "Desk");
  ASSERT_TRUE(later->leave() && later->forget("Desk"));
  ASSERT_TRUE(first->leave());
  const auto third = enter("Table 1", &c);
  EXPECT_EQ(c, "Table 1") << "whose program was closed";
  std::vector<StationNow> all;
  ASSERT_TRUE(third->all(all));
  EXPECT_EQ(all.size(), 2u);
}

TEST_F(StationsTest, MessagesComeWithTheirReceipts) {
  const auto desk = enter("Desk"), table = enter("Table 1");
  StationMessage words{"", "Table 1", "", Kind::kWords, "Take the tips", "", "", 0, false};
  StationMessage lesson{"", "Table 1", "", Kind::kLesson, "swage.series.carry", "Carry and hold", "", 0, false};
  ASSERT_TRUE(desk->send(words) && desk->send(lesson)) << desk->error();
  std::vector<StationMessage> in, sent;
  ASSERT_TRUE(table->inbox(in));
  ASSERT_EQ(in.size(), 2u);
  EXPECT_EQ(in[0].body, "Take the tips");
  EXPECT_EQ(in[0].from, "Desk");
  EXPECT_EQ(in[1].title, "Carry and hold");
  ASSERT_TRUE(table->tell_shown(in[0].id) && table->tell_answer(in[0].id, "read") && table->tell_shown(in[1].id));
  ASSERT_TRUE(desk->sent(sent));
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_TRUE(sent[0].shown && sent[1].shown);
  EXPECT_EQ(sent[1].answer, "read");
  EXPECT_EQ(sent[0].answer, "") << "the newest is first, and unanswered";
  ASSERT_TRUE(table->inbox(in));
  EXPECT_EQ(in.size(), 1u);
  ASSERT_TRUE(desk->inbox(in));
  EXPECT_TRUE(in.empty()) << "what is for another";
}

TEST_F(StationsTest, APictureIsOneRow) {
  const auto desk = enter("Desk"), table = enter("Table 1");
  std::string png(100000, '\0');
  for (std::size_t i = 0; i < png.size(); ++i) png[i] = static_cast<char>(i * 7);
  ASSERT_TRUE(table->show_picture("old") && table->show_picture(png)) << table->error();
  std::string got;
  double age_s = -1;
  ASSERT_TRUE(desk->picture("Table 1", got, age_s));
  EXPECT_EQ(got, png);
  EXPECT_GE(age_s, 0);
  EXPECT_LT(age_s, kLost_s);
  ASSERT_TRUE(desk->picture("Desk", got, age_s));
  EXPECT_EQ(got, "");
  ASSERT_TRUE(table->leave() && desk->picture("Table 1", got, age_s));
  EXPECT_EQ(got, "") << "who has gone shows nothing";
}

TEST_F(StationsTest, AMarkIsPinnedToTheRunningAttempt) {
  const auto desk = enter("Desk"), table = enter("Table 1");
  base::Problems problems;
  const auto recorder = Recorder::open(where_, make_info(), problems);
  ASSERT_TRUE(recorder);
  double time_s = 0;
  EXPECT_FALSE(desk->mark("Table 1", "", "Desk", time_s));
  EXPECT_EQ(desk->error(), say::kNothingRuns("Table 1"));
  ASSERT_TRUE(table->say(running("Ada", recorder->attempt_id())));
  const int64_t said = base::wall_ns();
  ASSERT_TRUE(desk->mark("Table 1", "tips too far", "Desk", time_s)) << desk->error();
  const double since_s = 1e-9 * static_cast<double>(base::wall_ns() - said);
  EXPECT_GE(time_s, 40.0) << "two seconds before";
  EXPECT_LE(time_s, 40.0 + since_s + 0.1) << "and no later than the station's clock can be";
  recorder->finish(make_end());
  std::string error;
  const auto school = School::open(where_, error);
  const std::vector<Note> notes = school->notes(recorder->attempt_id());
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].text, "tips too far");
  EXPECT_EQ(notes[0].made_by, "Desk");
  EXPECT_NEAR(notes[0].time_s, time_s, 1e-6);
  EXPECT_NEAR(static_cast<double>(notes[0].step), 1000 * time_s, 1);
  // an attempt that is kept at its station is not there yet
  ASSERT_TRUE(table->say(running("Ada", "0190a000-0000-7000-8000-000000000000")));
  EXPECT_FALSE(desk->mark("Table 1", "", "Desk", time_s));
  EXPECT_THAT(desk->error(), HasSubstr(say::kKeptThere("Table 1")));
}

TEST_F(StationsTest, WhatIsErasedIsNoLongerSaid) {
  const auto table = enter("Table 1");
  record_attempt(where_, 10, 7, "Ada");
  ASSERT_TRUE(table->say(running("Ada")) && table->show_picture("png"));
  std::string error;
  const auto school = School::open(where_, error);
  Person ada;
  ASSERT_TRUE(school->find_person("Ada", ada) && school->erase_person(ada.id)) << school->error();
  std::vector<StationNow> all;
  ASSERT_TRUE(table->all(all));
  EXPECT_EQ(all[0].person, "");
  std::string png;
  double age_s = 0;
  ASSERT_TRUE(table->picture("Table 1", png, age_s));
  EXPECT_EQ(png, "");
}

// Ten stations speak as fast as the server takes it, for as many beats as half an hour of a school has; an eleventh looks on.
TEST_F(StationsTest, TenStationsAreSeenAndTheTableStaysSmall) {
  constexpr int kStations = 10, kBeats = 3600;
  const auto desk = enter("Desk");
  std::vector<std::thread> tables;
  std::atomic<int> refused{0};
  for (int i = 0; i < kStations; ++i)
    tables.emplace_back([&, i] {
      const auto table = enter("Table " + std::to_string(i));
      for (int beat = 0; beat < kBeats / kStations; ++beat) {
        StationNow now = running("Guest");
        now.time_s = 0.5 * beat;
        refused += table->say(now) ? 0 : 1;
      }
    });
  std::vector<StationNow> all;
  for (int look = 0; look < 20; ++look) ASSERT_TRUE(desk->all(all)) << desk->error();
  for (std::thread& t : tables) t.join();
  EXPECT_EQ(refused, 0);
  ASSERT_TRUE(desk->all(all));
  ASSERT_EQ(all.size(), 1u + kStations);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_EQ(all[i].time_s, 0.5 * (kBeats / kStations - 1));
  std::string error;
  const auto db = Database::open(where_, Access::kRead, error);
  // Rows that are written over are room for the next. At full speed ten writers keep each other from clearing a page; as the beats of a
  // school come, one after the other, what there is suffices.
  const auto bytes = [&] { return integer(db->rows("SELECT pg_total_relation_size('station')")[0][0]); };
  const int64_t before = bytes();
  for (int beat = 0; beat < kBeats; ++beat) ASSERT_TRUE(desk->say(running("Guest"))) << desk->error();
  EXPECT_LT(bytes(), before + 64 * 1024);
  EXPECT_EQ(integer(db->rows("SELECT COUNT(*) FROM station")[0][0]), 1 + kStations);
}

TEST_F(StationsTest, OneThatIsKilledIsLostAfterFiveSeconds) {
  const pid_t child = fork();  // before this program has a thread of its own
  if (child == 0) {
    std::string error, name;
    const auto table = Stations::open(where_, error);
    if (!table || !table->enter("Table 1", make_id(), name)) _exit(2);
    for (;;) {
      table->say(running("Guest"));
      base::sleep_until_ns(base::wall_ns() + static_cast<int64_t>(kBeat_s * kSecond_ns));
    }
  }
  const auto desk = enter("Desk");
  std::vector<StationNow> all;
  const auto table = [&]() -> const StationNow* {
    EXPECT_TRUE(desk->all(all)) << desk->error();
    for (const StationNow& n : all)
      if (n.station == "Table 1") return &n;
    return nullptr;
  };
  const int64_t patience = base::wall_ns() + 60 * kSecond_ns;
  while ((!table() || table()->state != StationState::kRunning) && base::wall_ns() < patience)
    base::sleep_until_ns(base::wall_ns() + kSecond_ns / 20);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(table());
  EXPECT_FALSE(table()->lost()) << table()->silent_s;
  while (!table()->lost() && base::wall_ns() < patience) base::sleep_until_ns(base::wall_ns() + kSecond_ns / 20);
  EXPECT_TRUE(table()->lost());
  EXPECT_GT(table()->silent_s, kLost_s) << "not before";
  EXPECT_EQ(table()->state, StationState::kRunning) << "it never said that it ended";
  // its name is free again for the program that starts there next
  std::string name;
  const auto again = enter("Table 1", &name);
  EXPECT_EQ(name, "Table 1");
  ASSERT_TRUE(desk->forget("Table 1"));
  EXPECT_FALSE(table());
}

TEST_F(StationsTest, AFrozenServerIsGivenUp) {
  const auto table = enter("Table 1");
  server_.freeze(true);
  const int64_t start = base::wall_ns();
  EXPECT_FALSE(table->say(running("Guest")));
  EXPECT_TRUE(table->lost());
  // The store waits 3 s for an answer; 6 s or more would mean that it waited twice.
  EXPECT_LT(base::wall_ns() - start, 6 * kSecond_ns);
  server_.freeze(false);
}

}  // namespace
}  // namespace swage::record::test
