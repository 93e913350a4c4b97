// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>

#include "attempt.hpp"
#include "postgres_server.hpp"
#include "record/identity.hpp"
#include "record/salvage.hpp"
#include "record/schema.hpp"
#include "record/school.hpp"
#include "test_places.hpp"

namespace swage::record::test {
namespace {

// Stores of earlier versions: the exported attempts, and a store of version 3 with two attempts.
TEST(SchoolUpgrade, StoresOfEveryEarlierVersionBecomeSchools) {
  for (const char* name : {"v1.swage", "v2.swage", "v3.swage", "v4.swage", "store_v3.db"}) {
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
    EXPECT_EQ(rows[0].lesson_digest.empty(), name != std::string("v4.swage")) << name << ": kept since version 4";
    Recording recording;
    ASSERT_TRUE(read_recording(path, rows.back().id, recording, error)) << name << ": " << error;
    expect_exact(recording, 300);
  }
}

// The same upgrade on a server, whose tables are those of version 3.
TEST(SchoolUpgrade, AServersStoreToo) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  const std::string where = server.make_database("old");
  std::string error;
  {
    const auto db = Database::open(where, Access::kWrite, error);
    ASSERT_TRUE(db && bring_up_to_date(*db, schema_steps().first(3), error)) << error;
    ASSERT_TRUE(db->run("INSERT INTO person (person_id, pseudonym, created_utc) VALUES (?, ?, ?)",
                        {make_id(), std::string("Ada"), utc_now()}));
  }
  const auto school = School::open(where, error);
  ASSERT_TRUE(school) << error;
  std::vector<Person> people = school->people();
  ASSERT_EQ(people.size(), 1u);
  people[0].name = "Ada Meyer";
  EXPECT_TRUE(school->change_person(people[0])) << school->error();
  const std::string id = record_attempt(where, 10, 1, "Ada Meyer");
  EXPECT_EQ(Store::open(where, error)->attempts(people[0].id).size(), 1u) << error;
}

// A school of version 4, which had no stations: on either database its people stay and the tables of later versions are there.
TEST(SchoolUpgrade, ASchoolWithoutStationsGetsTheirTables) {
  PostgresServer server;
  const Folder folder;
  std::vector<std::string> places = {folder / "a.db"};
  if (server.running()) places.push_back(server.make_database("four"));
  for (const std::string& where : places) {
    std::string error;
    const std::string id = make_id();
    {
      const auto db = Database::open(where, Access::kWrite, error);
      ASSERT_TRUE(db && bring_up_to_date(*db, schema_steps().first(4), error)) << error;
      ASSERT_TRUE(db->rows("SELECT 1 FROM station").empty() && db->trouble() != Trouble::kNone) << "not in version 4";
      ASSERT_TRUE(db->run("INSERT INTO person (person_id, pseudonym, created_utc) VALUES (?, ?, ?)",
                          {id, std::string("4F2AK"), utc_now()}) &&
                  db->run("INSERT INTO roster VALUES (?, 'Ada Meyer', 'left', '', '', ?)", {id, utc_now()}));
    }
    const auto school = School::open(where, error);
    ASSERT_TRUE(school) << error;
    const std::vector<Person> people = school->people();
    ASSERT_EQ(people.size(), 1u);
    EXPECT_EQ(people[0].name, "Ada Meyer");
    const auto db = Database::open(where, Access::kWrite, error);
    EXPECT_EQ(schema_version(*db), 6);
    for (const char* table : {"station", "station_picture", "message", "rating"}) {
      EXPECT_TRUE(db->rows("SELECT * FROM " + std::string(table)).empty());
      EXPECT_EQ(db->trouble(), Trouble::kNone) << table << ": " << db->error();
    }
    // and erasing, which empties them, works on both
    EXPECT_TRUE(school->erase_person(id)) << school->error();
  }
}

// Whatever people have edited is found again on the pages of a damaged store.
TEST(SchoolUpgrade, ADamagedSchoolIsSalvaged) {
  const Folder folder;
  const std::string path = folder / "a.db", id = record_attempt(path, 300, 1, "Ada");
  std::string error;
  {
    const auto school = School::open(path, error);
    Person bo;
    bo.name = "Bo";
    Group group{"", "Residents", "", ""};
    Course course;
    course.title = "Basic";
    LessonVersion lesson;
    ASSERT_TRUE(school->add_group(group) && school->add_person(bo) && school->save_course(course)) << school->error();
    Assignment task{"", course.id, bo.id, false, "", ""};
    Note note{"", id, 1, 0.001, "", "Mei", "x"};
    ObserverRating rating{id, "smart.efficiency", 4, "", "Mei"};
    ASSERT_TRUE(school->assign(task) && school->save_note(note) && school->save_rating(rating) && school->set_void(id, true, "why", "Mei") &&
                school->publish_lesson("a", "A", "{}", lesson) && school->log_export({bo.id}, "csv", "/x.csv"));
    Person gone;
    gone.name = "Cy";
    ASSERT_TRUE(school->add_person(gone) && school->erase_person(gone.id));
  }
  Store::open(path, error)->recover();
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file << std::string(4096, '\x55');
  }
  Salvaged out;
  ASSERT_TRUE(salvage_in_place(path, out, error)) << error;
  EXPECT_EQ(out.whole, 1u);
  const auto school = School::open(path, error);
  Person bo;
  ASSERT_TRUE(school->find_person("Bo", bo)) << school->error();
  EXPECT_EQ(school->groups().size(), 1u);
  EXPECT_EQ(school->courses().size(), 1u);
  EXPECT_EQ(school->assignments().size(), 1u);
  EXPECT_EQ(school->lessons().size(), 1u);
  EXPECT_EQ(school->notes(id).size(), 1u);
  EXPECT_EQ(school->ratings(id).size(), 1u);
  EXPECT_EQ(school->exported_files(bo.id).size(), 1u);
  const auto store = Store::open(path, error);
  EXPECT_TRUE(store->attempts("")[0].is_void);
  EXPECT_NE(store->attempts("")[0].lesson_digest, "");
  EXPECT_EQ(store->damage(), "");
  const auto db = Database::open(path, Access::kRead, error);
  EXPECT_EQ(db->rows("SELECT 1 FROM erased").size(), 1u) << "who was erased stays so";
}

}  // namespace
}  // namespace swage::record::test
