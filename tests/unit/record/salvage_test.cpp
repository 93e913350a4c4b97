// SPDX-License-Identifier: Apache-2.0
#include "record/salvage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "attempt.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::HasSubstr;

void overwrite(const std::string& path, std::streamoff at, const std::string& bytes) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(at);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

struct Two {
  Folder folder;
  std::string path = folder / "a.db", first, second, error;
  Two() : first(record_attempt(path, 1130, 1, "Ada")), second(record_attempt(path, 600, 2, "Bo")) {}
  void expect_whole(const std::string& id, uint64_t steps, uint64_t seed) {
    Recording recording;
    ASSERT_TRUE(read_recording(path, id, recording, error)) << error;
    expect_exact(recording, steps, seed);
    EXPECT_TRUE(same_attachments(recording.info, make_info()));
    AttemptRow row;
    const auto store = Store::open(path, error);
    ASSERT_TRUE(store && store->attempt(id, row)) << error;
    EXPECT_EQ(row.score, 87.5);
    EXPECT_EQ(row.metrics.size(), 2u);
    EXPECT_EQ(row.state, "complete");
  }
};

// The header and the list of tables are all on the first page: without it SQLite opens nothing.
TEST(Salvage, AStoreWithoutItsFirstPageComesBackWhole) {
  Two two;
  overwrite(two.path, 0, std::string(4096, '\x55'));
  EXPECT_FALSE(Store::open(two.path, two.error));
  EXPECT_THAT(two.error, HasSubstr("swage attempts salvage --store " + two.path));
  Salvaged out;
  ASSERT_TRUE(salvage_in_place(two.path, out, two.error)) << two.error;
  EXPECT_EQ(out.whole, 2u);
  EXPECT_EQ(out.shortened, 0u);
  EXPECT_TRUE(std::filesystem::exists(out.damaged));
  two.expect_whole(two.first, 1130, 1);
  two.expect_whole(two.second, 600, 2);
  const auto store = Store::open(two.path, two.error);
  EXPECT_EQ(store->people().size(), 2u);
  EXPECT_EQ(store->events(two.first).size(), 11u);
  EXPECT_EQ(store->damage(), "");
}

TEST(Salvage, WhatLiesInTheLogIsTakenToo) {
  Two two;
  const auto reader = Database::open(two.path, Access::kRead, two.error);
  ASSERT_TRUE(reader->begin() || reader->run("BEGIN"));
  ASSERT_EQ(reader->rows("SELECT COUNT(*) FROM attempt").size(), 1u);  // the log cannot be emptied now
  const std::string third = record_attempt(two.path, 300, 3, "Cy");
  std::filesystem::copy_file(two.path, two.folder / "copy.db");
  std::filesystem::copy_file(two.path + "-wal", two.folder / "copy.db-wal");
  overwrite(two.folder / "copy.db", 0, std::string(100, '\0'));
  Salvaged out;
  ASSERT_TRUE(salvage(two.folder / "copy.db", two.folder / "new.db", out, two.error)) << two.error;
  EXPECT_EQ(out.whole, 3u);
  Recording recording;
  ASSERT_TRUE(read_recording(two.folder / "new.db", third, recording, two.error)) << two.error;
  expect_exact(recording, 300, 3);
}

// A chunk in the middle is lost: the recording ends before it, the result stays.
TEST(Salvage, ARecordingEndsWhereAChunkIsLost) {
  Two two;
  {
    const auto db = Database::open(two.path, Access::kWrite, two.error);
    ASSERT_TRUE(db->run("UPDATE chunk SET data = x'00' WHERE stream = 'input' AND seq = 2 AND attempt_id = ?",
                        {two.first}));
  }
  overwrite(two.path, 0, std::string(100, '\0'));
  Salvaged out;
  ASSERT_TRUE(salvage_in_place(two.path, out, two.error)) << two.error;
  EXPECT_EQ(out.whole, 1u);
  EXPECT_EQ(out.shortened, 1u);
  two.expect_whole(two.first, 500, 1);
  two.expect_whole(two.second, 600, 2);
  bool told = false;
  for (const EventRow& e : Store::open(two.path, two.error)->events(two.first)) told |= e.id == "salvaged";
  EXPECT_TRUE(told);
}

TEST(Salvage, RefusesWhatIsInUseAndWhatIsNothing) {
  Two two;
  {
    std::ofstream(two.folder / "letter.db") << std::string(9000, 'x');
  }
  Salvaged out;
  EXPECT_FALSE(salvage_in_place(two.folder / "letter.db", out, two.error));
  EXPECT_THAT(two.error, HasSubstr(say::kNothingLeft(two.folder / "letter.db")));
  EXPECT_TRUE(std::filesystem::exists(two.folder / "letter.db"));
  EXPECT_FALSE(std::filesystem::exists(two.folder / "letter.db.salvaging"));
  EXPECT_FALSE(salvage(two.path, two.path, out, two.error));
  EXPECT_THAT(two.error, HasSubstr(say::kThereAlready(two.path)));
}

}  // namespace
}  // namespace swage::record::test
