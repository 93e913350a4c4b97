// SPDX-License-Identifier: Apache-2.0
#include "record/transfer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "attempt.hpp"
#include "base/rng.hpp"
#include "record/schema.hpp"

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
  EXPECT_TRUE(same_luggage(recording.info, make_info()));
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
  EXPECT_THAT(e.error, HasSubstr("There is no attempt nobody"));
  EXPECT_FALSE(store->export_attempt(e.id, "/proc/x.swage", e.error));
  EXPECT_THAT(e.error, HasSubstr("/proc/x.swage"));
  EXPECT_FALSE(store->import_attempt(e.folder / "absent.swage", id, e.error));
  EXPECT_THAT(e.error, HasSubstr("absent.swage cannot be read: No such file"));
  spill(e.folder / "text.swage", "just some words");
  EXPECT_FALSE(store->import_attempt(e.folder / "text.swage", id, e.error));
  EXPECT_THAT(e.error, HasSubstr("is not a file of Swage attempts"));
  EXPECT_FALSE(store->import_attempt(e.folder / "a.db", id, e.error));
  EXPECT_THAT(e.error, HasSubstr("more than one attempt"));
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
  EXPECT_THAT(e.error, HasSubstr("do not fit the checksum"));
}

}  // namespace
}  // namespace swage::record::test
