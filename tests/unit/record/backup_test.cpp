// SPDX-License-Identifier: Apache-2.0
#include "record/backup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "attempt.hpp"
#include "postgres_server.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

void expect_there(const std::string& store, const std::string& id, uint64_t steps, uint64_t seed) {
  std::string error;
  Recording recording;
  ASSERT_TRUE(read_recording(store, id, recording, error)) << error;
  expect_exact(recording, steps, seed);
  EXPECT_TRUE(same_attachments(recording.info, make_info()));
  AttemptRow row;
  const auto opened = Store::open(store, error);
  ASSERT_TRUE(opened->attempt(id, row));
  EXPECT_EQ(row.metrics.size(), 2u);
  EXPECT_EQ(row.state, "complete");
}

TEST(Backup, OneCommandOutOneCommandBackAndTwiceIsOnce) {
  const Folder folder;
  const std::string a = folder / "a.db", file = folder / "all.swage-backup", b = folder / "b.db";
  const std::string ada = record_attempt(a, 1130, 1, "Ada"), bo = record_attempt(a, 300, 2, "Bo");
  std::string error;
  Copied out;
  // somebody records meanwhile
  base::Problems problems;
  const auto running = Recorder::open(a, make_info(3, "Cy"), problems);
  for (uint64_t i = 0; i < 600; ++i) running->step(make_step(3, i));
  ASSERT_TRUE(backup_store(a, file, out, error)) << error;
  EXPECT_EQ(out.attempts, 3u);
  EXPECT_EQ(out.people, 3u);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(testing::HasSubstr("backup.")));

  // the other station knows Ada already, by another identifier
  const std::string own = record_attempt(b, 300, 4, "Ada");
  for (const uint64_t added : {3u, 0u}) {
    ASSERT_TRUE(restore_store(file, b, out, error)) << error;
    EXPECT_EQ(out.added, added);
  }
  expect_there(b, ada, 1130, 1);
  expect_there(b, bo, 300, 2);
  expect_there(b, own, 300, 4);
  const auto store = Store::open(b, error);
  EXPECT_EQ(store->people().size(), 3u);
  EXPECT_EQ(store->attempts(store->person("Ada").id).size(), 2u);
  EXPECT_EQ(store->damage(), "");
}

TEST(Backup, AFileThatCannotBeWrittenLeavesTheOldOne) {
  const Folder folder;
  record_attempt(folder / "a.db", 300);
  std::string error;
  Copied out;
  ASSERT_TRUE(backup_store(folder / "a.db", folder / "b.backup", out, error));
  EXPECT_FALSE(backup_store(folder / "a.db", "/proc/b.backup", out, error));
  EXPECT_THAT(error, testing::HasSubstr(say::kNotBackedUp(folder / "a.db", "/proc/b.backup", "")));
  EXPECT_TRUE(restore_store(folder / "b.backup", folder / "c.db", out, error)) << error;
  EXPECT_FALSE(restore_store(folder / "absent.backup", folder / "c.db", out, error));
  EXPECT_THAT(error, testing::HasSubstr("absent.backup" + say::kUnreadable.words(1)));
}

TEST(Backup, AServerGoesIntoAFileAndAFileOntoAServer) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  const Folder folder;
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  const std::string one = server.make_database("one"), two = server.make_database("two");
  const std::string id = record_attempt(one, 1130, 1);
  std::string error;
  Copied out;
  ASSERT_TRUE(backup_store(one, folder / "one.backup", out, error)) << error;
  expect_there(folder / "one.backup", id, 1130, 1);
  ASSERT_TRUE(restore_store(folder / "one.backup", two, out, error)) << error;
  EXPECT_EQ(out.added, 1u);
  expect_there(two, id, 1130, 1);
  unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace swage::record::test
