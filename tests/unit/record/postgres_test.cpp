// SPDX-License-Identifier: Apache-2.0
//
// The same store on a server. SWAGE_TEST_POSTGRES: "postgresql://user@host/database" of a database that may be filled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "attempt.hpp"
#include "record/identity.hpp"

namespace swage::record::test {
namespace {

TEST(Postgres, TheSameAttemptOnAServer) {
  const char* where = std::getenv("SWAGE_TEST_POSTGRES");
  if (where == nullptr) GTEST_SKIP() << "SWAGE_TEST_POSTGRES names no server";
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
}

TEST(Postgres, AServerThatDoesNotAnswerIsNamed) {
  std::string error;
  EXPECT_FALSE(Store::open("postgresql://nobody@/nothing?host=/nowhere", error));
  EXPECT_THAT(error, testing::HasSubstr("postgresql://nobody@/nothing?host=/nowhere cannot be opened"));
}

}  // namespace
}  // namespace swage::record::test
