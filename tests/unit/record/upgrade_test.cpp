// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "attempt.hpp"
#include "record/school.hpp"
#include "test_places.hpp"

namespace swage::record::test {
namespace {

// Stores of earlier versions: the exported attempts, and a store of version 3 with two attempts.
TEST(SchoolUpgrade, StoresOfEveryEarlierVersionBecomeSchools) {
  for (const char* name : {"v1.swage", "v2.swage", "v3.swage", "store_v3.db"}) {
    const Folder folder;
    const std::string path = folder / "a.db";
    std::filesystem::copy_file(std::string(SWAGE_SOURCE_DIR) + "/tests/attempts/" + name, path);
    std::filesystem::permissions(path, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::string error;
    const std::size_t attempts = name == std::string("store_v3.db") ? 2 : 1;
    {
      // before: only looked at
      const auto old = Store::open_to_read(path, error);
      ASSERT_TRUE(old) << name << ": " << error;
      EXPECT_EQ(old->attempts("").size(), attempts) << old->trouble();
      EXPECT_EQ(old->people().size(), 1u) << old->trouble();
      EXPECT_EQ(old->trouble(), "");
    }
    const auto school = School::open(path, error);
    ASSERT_TRUE(school) << name << ": " << error;
    std::vector<Person> people = school->people();
    ASSERT_EQ(people.size(), 1u) << name;
    EXPECT_EQ(people[0].code, "Ada");
    EXPECT_EQ(people[0].name, "Ada") << "who has no name is called by the code";
    people[0].name = "Ada Meyer";
    ASSERT_TRUE(school->change_person(people[0])) << school->error();
    const auto store = Store::open(path, error);
    EXPECT_EQ(store->damage(), "") << name;
    const auto rows = store->attempts(people[0].id);
    ASSERT_EQ(rows.size(), attempts) << name;
    EXPECT_EQ(rows[0].person_name, "Ada Meyer");
    EXPECT_EQ(rows[0].person_code, "Ada");
    EXPECT_EQ(rows[0].lesson_digest, "") << "nobody kept one then";
    Recording recording;
    ASSERT_TRUE(read_recording(path, rows.back().id, recording, error)) << name << ": " << error;
    expect_exact(recording, 300);
  }
}

}  // namespace
}  // namespace swage::record::test
