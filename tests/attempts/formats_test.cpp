// SPDX-License-Identifier: Apache-2.0
//
// Attempts written by earlier versions stay readable.
#include <gtest/gtest.h>

#include <fstream>

#include "attempt.hpp"
#include "record/schema.hpp"
#include "test_places.hpp"

namespace swage::record::test {
namespace {

class Formats : public testing::TestWithParam<int> {
 protected:
  std::string file() const {
    return std::string(SWAGE_SOURCE_DIR) + "/tests/attempts/v" + std::to_string(GetParam()) + ".swage";
  }
};

TEST_P(Formats, IsReadBitForBit) {
  ASSERT_TRUE(std::ifstream(file()).good()) << file() << " is missing: README.md says how it is made";
  Recording recording;
  std::string error;
  ASSERT_TRUE(read_recording(file(), "", recording, error)) << error;
  expect_exact(recording, 300);
  EXPECT_EQ(recording.info.person, "Ada");
  EXPECT_EQ(recording.info.plugins, make_info().plugins);
  // hands and files are carried since version 2
  EXPECT_TRUE(same_attachments(recording.info, GetParam() >= 2 ? make_info() : AttemptInfo()));
  ASSERT_EQ(recording.commands.size(), 1u);
  EXPECT_EQ(recording.commands[0].number[3], 1e-300);
  EXPECT_EQ(recording.events.size(), 3u);
}

TEST_P(Formats, IsTakenIntoAStoreOfToday) {
  const Folder folder;
  std::string error, id;
  const auto store = Store::open(folder / "a.db", error);
  ASSERT_TRUE(store->import_attempt(file(), id, error)) << error;
  AttemptRow row;
  ASSERT_TRUE(store->attempt(id, row));
  EXPECT_EQ(row.state, "complete");
  EXPECT_EQ(row.score, 87.5);
  EXPECT_EQ(row.metrics.size(), 2u);
  // and goes out again as a file of today
  ASSERT_TRUE(store->export_attempt(id, folder / "again.swage", error)) << error;
  Recording again;
  ASSERT_TRUE(read_recording(folder / "again.swage", "", again, error)) << error;
  expect_exact(again, 300);
}

INSTANTIATE_TEST_SUITE_P(EveryVersion, Formats,
                         testing::Range(1, static_cast<int>(schema_steps().size()) + 1));

}  // namespace
}  // namespace swage::record::test
