// SPDX-License-Identifier: Apache-2.0
//
// The same store on a server of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "postgres_server.hpp"
#include "record/identity.hpp"
#include "record/sentences.hpp"
#include "record/sql.hpp"

namespace swage::record::test {
namespace {

// compiling took 250 ms of a list of people that was read in 10
TEST(Postgres, AServerCompilesNoStatement) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  std::string error;
  const auto db = Database::open(server.make_database("jit"), Access::kWrite, error);
  ASSERT_TRUE(db) << error;
  const std::vector<Row> setting = db->rows("SHOW jit");
  ASSERT_EQ(setting.size(), 1u);
  EXPECT_EQ(text(setting[0][0]), "off");
}

TEST(Postgres, TheSameAttemptOnAServer) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  const std::string where = server.make_database("one");
  const Folder folder;
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  std::string error;
  const auto store = Store::open(where, error);
  ASSERT_TRUE(store) << error;

  const std::string name = "Ada " + make_id();
  const std::string id = record_attempt(where, 1130, 7, name);
  const auto attempts = store->attempts(store->person(name).id);
  ASSERT_EQ(attempts.size(), 1u);
  EXPECT_EQ(attempts[0].state, "complete");
  EXPECT_EQ(attempts[0].metrics[1].value, 0.1 + 0.2);
  Recording recording;
  ASSERT_TRUE(read_recording(where, id, recording, error)) << error;
  expect_exact(recording, 1130);
  EXPECT_EQ(recording.info.lesson_title, make_info().lesson_title);

  // from the server into a file, from the file into a local store, and the other way round
  ASSERT_TRUE(store->export_attempt(id, folder / "one.swage", error)) << error;
  const auto local = Store::open(folder / "a.db", error);
  std::string same;
  ASSERT_TRUE(local->import_attempt(folder / "one.swage", same, error)) << error;
  ASSERT_TRUE(store->import_attempt(folder / "one.swage", same, error)) << error;
  EXPECT_EQ(same, id);
  const std::string mine = record_attempt(folder / "a.db", 600, 9, name);
  ASSERT_TRUE(local->export_attempt(mine, folder / "two.swage", error)) << error;
  ASSERT_TRUE(store->import_attempt(folder / "two.swage", same, error)) << error;
  ASSERT_TRUE(read_recording(where, mine, recording, error)) << error;
  expect_exact(recording, 600, 9);

  // a program that died is told from one that lives
  base::Problems problems;
  Recorder::open(where, make_info(1, name), problems).reset();
  const auto alive = Recorder::open(where, make_info(2, name), problems);
  EXPECT_EQ(store->recover(), 1);
  unsetenv("XDG_DATA_HOME");
}

// Eight stations that are switched on at once find a new database.
TEST(Postgres, ManyStationsMakeTheTablesTogether) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  for (int round = 0; round < 3; ++round) {
    const std::string where = server.make_database("fresh" + std::to_string(round));
    std::vector<pid_t> stations;
    for (int i = 0; i < 8; ++i) {
      stations.push_back(fork());
      if (stations.back() != 0) continue;
      std::string error;
      const bool good = Store::open(where, error) != nullptr;
      if (!good) std::fprintf(stderr, "%s\n", error.c_str());
      _exit(good ? 0 : 1);
    }
    for (const pid_t station : stations) {
      int status = 0;
      waitpid(station, &status, 0);
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "round " << round;
    }
  }
}

class FrozenServer : public testing::Test {
 protected:
  FrozenServer() {
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    if (server_.running()) where_ = server_.make_database("frozen");
  }
  ~FrozenServer() override { unsetenv("XDG_DATA_HOME"); }
  // 1 kHz, as a lesson does
  void record(Recorder& recorder, uint64_t from, uint64_t to) {
    int64_t deadline = base::wall_ns();
    for (uint64_t i = from; i < to; ++i) {
      recorder.step(make_step(7, i));
      base::sleep_until_ns(deadline += 1'000'000);
    }
  }
  Folder folder_;
  PostgresServer server_;
  std::string where_;
};

double seconds_since(int64_t start) { return 1e-9 * static_cast<double>(base::wall_ns() - start); }

TEST_F(FrozenServer, CostsNoStepAndNoMinute) {
  if (!server_.running()) GTEST_SKIP() << server_.why_not();
  AttemptInfo info = make_info();
  info.realtime = true;
  base::Problems problems;
  const auto recorder = Recorder::open(where_, info, problems);
  ASSERT_TRUE(recorder);
  record(*recorder, 0, 600);
  server_.freeze(true);
  record(*recorder, 600, 5600);
  EXPECT_EQ(recorder->dropped(), 0u);
  EXPECT_FALSE(recorder->healthy());
  int64_t start = base::wall_ns();
  recorder->finish(make_end());
  EXPECT_LT(seconds_since(start), 5.0);
  EXPECT_EQ(recorder->kept().where, Kept::Where::kBeside);
  EXPECT_EQ(recorder->kept().missing_steps, 0u);
  const base::Problems said = recorder->problems();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_THAT(said[0].message, testing::StartsWith(say::kStoreFails(say::kNoAnswer(say::kServerSilent()))));

  start = base::wall_ns();
  std::string error;
  EXPECT_FALSE(Store::open(where_, error));
  EXPECT_LT(seconds_since(start), 5.0);
  EXPECT_THAT(error, testing::HasSubstr(say::kCheckServer()));

  // it thaws: the attempt comes in, whole, and once
  server_.freeze(false);
  for (int i = 0; i < 2; ++i) {
    const auto store = Store::open(where_, error);
    ASSERT_TRUE(store) << error;
    EXPECT_EQ(store->attempts("").size(), 1u);
    EXPECT_EQ(store->attempts("")[0].state, "complete");
  }
  EXPECT_FALSE(std::filesystem::exists(recorder->kept().file));
  Recording recording;
  ASSERT_TRUE(read_recording(where_, recorder->attempt_id(), recording, error)) << error;
  expect_exact(recording, 5600);
}

TEST_F(FrozenServer, AListThatIsNotAnsweredIsNotAnEmptyOne) {
  if (!server_.running()) GTEST_SKIP() << server_.why_not();
  record_attempt(where_, 300);
  std::string error;
  const auto store = Store::open(where_, error);
  ASSERT_EQ(store->attempts("").size(), 1u);
  server_.freeze(true);
  const int64_t start = base::wall_ns();
  EXPECT_TRUE(store->attempts("").empty());
  EXPECT_LT(seconds_since(start), 5.0);
  EXPECT_THAT(store->trouble(), testing::HasSubstr(say::kServerSilent()));
}

// A station whose server is away from the start goes on by itself, and brings its attempts in later, once.
TEST_F(FrozenServer, AStationWithoutItsServerGoesOnAndBringsItsAttemptsInLater) {
  if (!server_.running()) GTEST_SKIP() << server_.why_not();
  server_.crash();
  std::vector<std::string> ids;
  for (int i = 0; i < 2; ++i) {
    base::Problems problems;
    const auto recorder = Recorder::open(where_, make_info(), problems);
    ASSERT_TRUE(recorder);
    EXPECT_FALSE(recorder->healthy());
    for (uint64_t step = 0; step < 600; ++step) recorder->step(make_step(7, step));
    recorder->finish(make_end());
    EXPECT_EQ(recorder->kept().where, Kept::Where::kBeside);
    ids.push_back(recorder->attempt_id());
  }
  ASSERT_TRUE(server_.start());
  std::string error;
  const auto store = Store::open(where_, error);
  ASSERT_TRUE(store) << error;
  EXPECT_EQ(store->attempts("").size(), 2u);
  for (const std::string& id : ids) {
    Recording recording;
    ASSERT_TRUE(read_recording(where_, id, recording, error)) << error;
    expect_exact(recording, 600);
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
    EXPECT_NE(entry.path().extension(), ".journal") << entry.path();
}

TEST(Postgres, AServerThatDoesNotAnswerIsNamed) {
  std::string error;
  EXPECT_FALSE(Store::open("postgresql://nobody@/nothing?host=/nowhere", error));
  EXPECT_THAT(error, testing::HasSubstr("postgresql://nobody@/nothing?host=/nowhere" + say::kNotOpened.words(1)));
}

}  // namespace
}  // namespace swage::record::test
