// SPDX-License-Identifier: Apache-2.0
#include "record/transfer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <cstring>
#include <fstream>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "base/rng.hpp"
#include "record/codec.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

std::string slurp(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void spill(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// one exported attempt among two
struct Exported {
  Folder folder;
  std::string id, file, error;
  Exported() {
    record_attempt(folder / "a.db", 300, 1, "Bo");
    id = record_attempt(folder / "a.db", 1130);
    file = folder / "one.swage";
    const auto store = Store::open(folder / "a.db", error);
    EXPECT_TRUE(store->export_attempt(id, file, error)) << error;
  }
};

TEST(Transfer, OneFileHoldsEverythingOfOneAttempt) {
  Exported e;
  Recording recording;
  ASSERT_TRUE(read_recording(e.file, "", recording, e.error)) << e.error;
  expect_exact(recording, 1130);
  EXPECT_TRUE(same_attachments(recording.info, make_info()));
  EXPECT_EQ(recording.commands.size(), 4u);
  const auto db = open_for_reading(e.file, e.error);
  EXPECT_EQ(db->rows("SELECT pseudonym FROM person").size(), 1u) << "nobody else's name leaves the store";
  for (const auto& entry : std::filesystem::directory_iterator(e.folder.path()))
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("one.swage.")));
}

TEST(Transfer, ComesBackOnceHoweverOftenItIsTaken) {
  Exported e;
  const auto other = Store::open(e.folder / "b.db", e.error);
  const std::string ada = other->person("Ada").id;
  for (int i = 0; i < 2; ++i) {
    std::string id;
    ASSERT_TRUE(other->import_attempt(e.file, id, e.error)) << e.error;
    EXPECT_EQ(id, e.id);
  }
  const auto attempts = other->attempts("");
  ASSERT_EQ(attempts.size(), 1u);
  EXPECT_EQ(attempts[0].person_id, ada) << "the same name is the same person";
  EXPECT_EQ(attempts[0].metrics.size(), 2u);
  EXPECT_EQ(attempts[0].state, "complete");
  EXPECT_EQ(other->events(e.id).size(), 11u);
  Recording recording;
  ASSERT_TRUE(read_recording(e.folder / "b.db", e.id, recording, e.error)) << e.error;
  expect_exact(recording, 1130);

  // and back again it is the same file's worth
  ASSERT_TRUE(other->export_attempt(e.id, e.folder / "two.swage", e.error)) << e.error;
  ASSERT_TRUE(read_recording(e.folder / "two.swage", "", recording, e.error)) << e.error;
  expect_exact(recording, 1130);
}

TEST(Transfer, SaysWhatIsMissing) {
  Exported e;
  const auto store = Store::open(e.folder / "a.db", e.error);
  std::string id;
  EXPECT_FALSE(store->export_attempt("nobody", e.folder / "x.swage", e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kNoAttempt("nobody")));
  EXPECT_FALSE(store->export_attempt(e.id, "/proc/x.swage", e.error));
  EXPECT_THAT(e.error, HasSubstr("/proc/x.swage"));
  EXPECT_FALSE(store->import_attempt(e.folder / "absent.swage", id, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kNoPages(e.folder / "absent.swage", std::strerror(ENOENT))));
  spill(e.folder / "text.swage", "just some words");
  EXPECT_FALSE(store->import_attempt(e.folder / "text.swage", id, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kNoStoreFile(e.folder / "text.swage", "")));
  EXPECT_FALSE(store->import_attempt(e.folder / "a.db", id, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kHoldsMore()));
}

TEST(Transfer, TruncatedAndFuzzedFilesAreRefusedWithASentence) {
  Exported e;
  const std::string whole = slurp(e.file);
  base::Xoshiro256 random(11);
  int refused = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::string bytes = whole;
    if (trial % 3 == 0) bytes.resize(random() % bytes.size());
    for (uint64_t flips = trial % 3 == 1 ? 1 : random() % 40; flips > 0 && !bytes.empty(); --flips)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    const std::string file = e.folder / "fuzz.swage",
                      target = e.folder / ("t" + std::to_string(trial) + ".db");
    spill(file, bytes);
    const auto store = Store::open(target, e.error);
    std::string id;
    e.error.clear();
    if (store->import_attempt(file, id, e.error)) {
      // only bytes that mean nothing were hit
      Recording recording;
      ASSERT_TRUE(read_recording(target, id, recording, e.error)) << e.error;
      expect_exact(recording, 1130);
      EXPECT_EQ(store->attempts("")[0].score, 87.5);
      continue;
    }
    ++refused;
    EXPECT_THAT(e.error, HasSubstr("fuzz.swage")) << "trial " << trial;
    EXPECT_TRUE(e.error.ends_with(".")) << e.error;
    EXPECT_TRUE(store->attempts("").empty());
    EXPECT_TRUE(store->people().empty());
  }
  EXPECT_GT(refused, 40);
}

TEST(Transfer, LiesInsideAWellFormedFileAreFound) {
  Exported e;
  const char* lies[] = {
      "DELETE FROM chunk WHERE stream = 'hash' AND seq = 1",
      "UPDATE chunk SET n = 4000000000 WHERE stream = 'input' AND seq = 0",
      "UPDATE chunk SET n = 249 WHERE stream = 'input' AND seq = 0",
      "UPDATE chunk SET codec = 7 WHERE stream = 'signal'",
      "UPDATE chunk SET data = x'00' WHERE stream = 'command'",
      "DELETE FROM chunk WHERE stream = 'signal'",
      "UPDATE attempt SET plugins = '{'",
      "UPDATE attempt SET script = '{\"signals\": 4}'",
      "UPDATE attempt SET devices = '[\"a\", \"b\", \"c\", \"d\", \"e\", \"f\"]'",
      "UPDATE attempt SET devices = '[1]'",
  };
  const std::string file = e.folder / "lie.swage";
  for (const char* lie : lies) {
    std::filesystem::copy_file(e.file, file, std::filesystem::copy_options::overwrite_existing);
    ASSERT_TRUE(Database::open(file, Access::kWrite, e.error)->run(lie)) << lie;
    Recording recording;
    EXPECT_FALSE(read_recording(file, "", recording, e.error)) << lie;
    EXPECT_THAT(e.error, AnyOf(HasSubstr("damaged"), HasSubstr("more devices"))) << lie;
  }
  std::filesystem::copy_file(e.file, file, std::filesystem::copy_options::overwrite_existing);
  Database::open(file, Access::kWrite, e.error)->run("UPDATE attempt SET score = 100");
  std::string id;
  EXPECT_FALSE(Store::open(e.folder / "b.db", e.error)->import_attempt(file, id, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kRowsChecksum()));
}

// What a stranger can put into a file that is well-formed for SQLite.
TEST(Transfer, AViewATriggerAndAnIndexOfAStrangerAreRefused) {
  Exported e;
  const char* const endless =
      "WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n) SELECT '00000000-0000-0000-0000-000000000000'"
      " FROM n WHERE i < 0";
  const std::vector<std::vector<std::string>> crafted = {
      {"ALTER TABLE attempt RENAME TO hidden", std::string("CREATE VIEW attempt AS ") + endless},
      {"ALTER TABLE swage_schema RENAME TO hidden",
       "CREATE VIEW swage_schema AS WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n)"
       " SELECT 2 AS version, i AS since_utc FROM n WHERE i < 0"},
      {"CREATE TRIGGER t AFTER INSERT ON person BEGIN DELETE FROM attempt; END"},
      {"CREATE INDEX slow ON chunk (hex(zeroblob(100000000)))"},
      {"DROP TABLE swage_export", std::string("CREATE VIEW swage_export AS ") + endless},
      {"CREATE TABLE more (x TEXT)"},
  };
  const std::string file = e.folder / "crafted.swage";
  for (const auto& statements : crafted) {
    std::filesystem::copy_file(e.file, file, std::filesystem::copy_options::overwrite_existing);
    {
      const auto db = Database::open(file, Access::kWrite, e.error);
      db->run("PRAGMA legacy_alter_table = ON");
      for (const std::string& sql : statements) ASSERT_TRUE(db->run(sql)) << sql << db->error();
    }
    const int64_t start = base::wall_ns();
    const auto store = Store::open(e.folder / "b.db", e.error);
    std::string id;
    EXPECT_FALSE(store->import_attempt(file, id, e.error)) << statements[0];
    EXPECT_THAT(e.error, HasSubstr("crafted.swage")) << statements[0];
    EXPECT_LT(base::wall_ns() - start, 5'000'000'000) << statements[0];
  }
}

TEST(Transfer, AnIdentifierIsNoPath) {
  Exported e;
  const std::string file = e.folder / "path.swage";
  std::filesystem::copy_file(e.file, file);
  {
    const auto db = Database::open(file, Access::kWrite, e.error);
    db->run("PRAGMA foreign_keys = OFF");
    for (const char* table : {"attempt", "metric", "event", "chunk", "hand", "file"})
      ASSERT_TRUE(db->run("UPDATE " + std::string(table) + " SET attempt_id = '/etc/cron.d/swage'"));
  }
  std::string id;
  EXPECT_FALSE(Store::open(e.folder / "b.db", e.error)->import_attempt(file, id, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kStrangeId()));
}

// 4096 rows of zeros are some bytes; a file of 600 kB full of them was 6 GB in memory.
TEST(Transfer, ASmallFileDoesNotFillTheMemory) {
  Exported e;
  const std::string file = e.folder / "bomb.swage";
  std::filesystem::copy_file(e.file, file);
  {
    const auto db = Database::open(file, Access::kWrite, e.error);
    const std::vector<uint64_t> zeros(4096 * 2 * 18, 0);
    const Packed input = pack(zeros.data(), 4096, 36), hash = pack(zeros.data(), 4096, 2);
    const std::vector<float> still(4096 * 2, 0);
    const Packed signal = pack(still.data(), 4096, 2);
    ASSERT_TRUE(db->begin() && db->run("DELETE FROM chunk"));
    const auto put = [&](const char* stream, int64_t seq, const Packed& p) {
      return db->run("INSERT INTO chunk VALUES (?, ?, ?, 0, 4096, ?, ?, ?, NULL)",
                     {e.id, std::string(stream), seq, static_cast<int64_t>(p.codec), int64_t{p.crc}, p.data});
    };
    for (int64_t seq = 0; seq < 1500; ++seq)
      ASSERT_TRUE(put("hash", seq, hash) && put("input", seq, input) && put("signal", seq, signal));
    ASSERT_TRUE(db->commit());
  }
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak counts from here
  Recording recording;
  EXPECT_FALSE(read_recording(file, "", recording, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kTooLong.words(1) + "900"));
  recording = {};
  EXPECT_TRUE(check_recording(file, "", e.error)) << e.error;
  int64_t peak_kB = 0;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) peak_kB = std::atoll(line.c_str() + 6);
  EXPECT_GT(peak_kB, 0);
  EXPECT_LT(peak_kB, 1'000'000);
}

TEST(Transfer, WhatIsNoFileOrTooLargeIsNotOpened) {
  Exported e;
  const auto store = Store::open(e.folder / "b.db", e.error);
  std::string id;
  ASSERT_EQ(mkfifo((e.folder / "pipe.swage").c_str(), 0600), 0);
  for (const std::string& what : {std::string("/dev/zero"), e.folder / "pipe.swage", e.folder.path().string()}) {
    EXPECT_FALSE(store->import_attempt(what, id, e.error));
    EXPECT_THAT(e.error, HasSubstr(say::kNotAFile(what)));
  }
  std::ofstream(e.folder / "huge.swage") << "SQLite format 3";
  std::filesystem::resize_file(e.folder / "huge.swage", uint64_t{8} << 30);
  EXPECT_FALSE(store->import_attempt(e.folder / "huge.swage", id, e.error));
  EXPECT_THAT(e.error, HasSubstr(say::kTooLarge(e.folder / "huge.swage")));
}

}  // namespace
}  // namespace swage::record::test
