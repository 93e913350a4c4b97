// SPDX-License-Identifier: Apache-2.0
#include "record/store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>

#include "attempt.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::HasSubstr;

TEST(Store, KeepsPeopleAttemptsAndMetrics) {
  const Folder folder;
  const std::string path = folder / "attempts.db";
  const std::string first = record_attempt(path, 300, 1, "Ada");
  const std::string second = record_attempt(path, 300, 2, "Ada");
  record_attempt(path, 300, 3, "Bo");

  std::string error;
  const auto store = Store::open(path, error);
  ASSERT_TRUE(store) << error;
  const auto people = store->people();
  ASSERT_EQ(people.size(), 2u);
  EXPECT_EQ(people[0].name, "Ada");
  EXPECT_EQ(people[0].attempts, 2u);
  EXPECT_EQ(store->person("Ada").id, people[0].id);
  EXPECT_EQ(store->person("Cy").attempts, 0u);
  EXPECT_EQ(store->people().size(), 3u);

  const auto attempts = store->attempts(people[0].id);
  ASSERT_EQ(attempts.size(), 2u);
  EXPECT_EQ(attempts[0].id, second);
  EXPECT_EQ(attempts[1].id, first);
  EXPECT_EQ(attempts[0].state, "complete");
  EXPECT_EQ(attempts[0].outcome, "passed");
  EXPECT_EQ(attempts[0].reason, "grasp.taken");
  EXPECT_EQ(attempts[0].score, 87.5);
  EXPECT_EQ(attempts[0].device, "swage.device.mouse");
  ASSERT_EQ(attempts[0].metrics.size(), 2u) << "a metric that was never reported has no row";
  EXPECT_EQ(attempts[0].metrics[1].id, "time");
  EXPECT_EQ(attempts[0].metrics[1].value, 0.1 + 0.2);
  EXPECT_EQ(store->attempts("").size(), 3u);
  EXPECT_EQ(store->attempts("", "swage.lesson.grasp").size(), 3u);
  EXPECT_TRUE(store->attempts("", "another").empty());

  AttemptRow row;
  ASSERT_TRUE(store->attempt(first, row));
  EXPECT_EQ(row.person_name, "Ada");
  EXPECT_EQ(row.metrics.size(), 2u);
  EXPECT_FALSE(store->attempt("nobody", row));

  const auto events = store->events(first);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].id, "grasp.taken");
  EXPECT_DOUBLE_EQ(events[0].time_s, 0.099);
}

TEST(Store, TheDeviceOfARecordedHandSaysWhichHandWasChosen) {
  const Folder folder;
  const std::string path = folder / "a.db";
  record_attempt(path, 10);
  base::Problems problems;
  AttemptInfo info = make_info();
  info.hands[0].flags = SWAGE_DEVICE_SCRIPTED;
  const auto recorder = Recorder::open(path, info, problems);
  ASSERT_TRUE(recorder);
  for (uint64_t step = 0; step < 10; ++step) recorder->step(make_step(7, step));
  recorder->finish(make_end());
  std::string error;
  const auto store = Store::open(path, error);
  ASSERT_TRUE(store) << error;
  std::vector<std::string> devices;
  for (const AttemptRow& a : store->attempts("")) devices.push_back(a.device);
  EXPECT_THAT(devices, testing::UnorderedElementsAre("swage.device.mouse", "swage.device.mouse (expert)"));
}

TEST(Store, TwoReadersAndAWriterAtOnce) {
  const Folder folder;
  const std::string path = folder / "a.db";
  std::string error;
  const auto one = Store::open(path, error), two = Store::open(path, error);
  ASSERT_TRUE(one && two) << error;
  base::Problems problems;
  auto recorder = Recorder::open(path, make_info(), problems);
  ASSERT_TRUE(recorder);
  for (uint64_t i = 0; i < 5000; ++i) {
    recorder->step(make_step(7, i));
    if (i % 500 != 0) continue;
    EXPECT_EQ(one->attempts("").size() + two->attempts("").size(), 2u);
  }
  recorder->finish(make_end());
  EXPECT_TRUE(recorder->healthy());
  EXPECT_EQ(one->attempts("")[0].state, "complete");
  EXPECT_EQ(two->attempts("")[0].state, "complete");
}

TEST(Store, AnAbandonedAttemptIsRecoveredAndALivingOneIsNot) {
  const Folder folder;
  const std::string path = folder / "a.db";
  std::string error;
  base::Problems problems;
  const auto store = Store::open(path, error);
  std::string dead;
  {
    auto recorder = Recorder::open(path, make_info(), problems);
    for (uint64_t i = 0; i < 300; ++i) recorder->step(make_step(7, i));
    dead = recorder->attempt_id();
  }
  auto alive = Recorder::open(path, make_info(), problems);
  EXPECT_EQ(store->recover(), 1);
  EXPECT_EQ(store->recover(), 0);
  AttemptRow row;
  ASSERT_TRUE(store->attempt(dead, row));
  EXPECT_EQ(row.state, "recovered");
  EXPECT_DOUBLE_EQ(row.simulated_s, 0.3);
  ASSERT_TRUE(store->attempt(alive->attempt_id(), row));
  EXPECT_EQ(row.state, "running");
}

TEST(Store, AnUnfinishedEndIsAborted) {
  const Folder folder;
  base::Problems problems;
  auto recorder = Recorder::open(folder / "a.db", make_info(), problems);
  recorder->finish({});
  std::string error;
  AttemptRow row;
  ASSERT_TRUE(Store::open(folder / "a.db", error)->attempt(recorder->attempt_id(), row));
  EXPECT_EQ(row.state, "aborted");
  EXPECT_EQ(row.outcome, "aborted");
}

TEST(Store, UpgradesStepByStepAndRefusesANewerOne) {
  const Folder folder;
  const std::string path = folder / "a.db";
  const std::string id = record_attempt(path, 300);
  std::string error;
  std::vector<Step> later(schema_steps().begin(), schema_steps().end());
  later.push_back({"ALTER TABLE attempt ADD COLUMN grade TEXT", "UPDATE attempt SET grade = 'old'"});
  {
    const auto db = Database::open(path, Access::kWrite, error);
    ASSERT_TRUE(bring_up_to_date(*db, later, error)) << error;
    EXPECT_EQ(schema_version(*db), static_cast<int>(later.size()));
    EXPECT_EQ(text(db->rows("SELECT grade FROM attempt WHERE attempt_id = ?", {id})[0][0]), "old");
  }
  EXPECT_FALSE(Store::open(path, error));
  EXPECT_THAT(error, HasSubstr(say::kNewerTables(later.size(), schema_steps().size())));
  Recording recording;
  EXPECT_FALSE(read_recording(path, id, recording, error));
  EXPECT_THAT(error, HasSubstr(say::kNewerTables(later.size(), schema_steps().size())));
}

TEST(Store, AFailedUpgradeLeavesTheStoreAsItWas) {
  const Folder folder;
  const std::string path = folder / "a.db";
  record_attempt(path, 10);
  std::string error;
  std::vector<Step> wrong(schema_steps().begin(), schema_steps().end());
  wrong.push_back({"ALTER TABLE attempt ADD COLUMN grade TEXT", "not SQL"});
  {
    const auto db = Database::open(path, Access::kWrite, error);
    EXPECT_FALSE(bring_up_to_date(*db, wrong, error));
    EXPECT_THAT(error, HasSubstr(say::kNoUpgrade.words(0)));
  }
  const auto store = Store::open(path, error);
  ASSERT_TRUE(store) << error;
  EXPECT_EQ(store->attempts("").size(), 1u);
}

TEST(Store, RefusesWhatIsNotAStore) {
  const Folder folder;
  std::string error;
  {
    FILE* file = fopen((folder / "letter.txt").c_str(), "w");
    fputs("Dear reader, this is not a database, and it is long enough to look like something.\n", file);
    fclose(file);
  }
  EXPECT_FALSE(Store::open(folder / "letter.txt", error));
  EXPECT_THAT(error, HasSubstr("letter.txt" + say::kUnusable.words(1)));
  EXPECT_FALSE(Store::open("/proc/no/such/folder/a.db", error));
  EXPECT_THAT(error, HasSubstr("/proc/no"));
  Recording recording;
  EXPECT_FALSE(read_recording(folder / "absent.db", "x", recording, error));
  EXPECT_THAT(error, HasSubstr("No such file"));
  record_attempt(folder / "a.db", 10);
  EXPECT_FALSE(read_recording(folder / "a.db", "x", recording, error));
  EXPECT_THAT(error, HasSubstr(say::kNoAttemptAtAll("x")));
}

TEST(Store, TheUsersOwnStoreFollowsXdg) {
  setenv("XDG_DATA_HOME", "/data/of/ada", 1);
  EXPECT_EQ(Store::default_path(), "/data/of/ada/swage/attempts.db");
  setenv("XDG_DATA_HOME", "relative is ignored", 1);
  setenv("HOME", "/people/ada", 1);
  EXPECT_EQ(Store::default_path(), "/people/ada/.local/share/swage/attempts.db");
  // a service has no HOME, its user has; "/" is nobody's home
  unsetenv("XDG_DATA_HOME");
  unsetenv("HOME");
  const passwd* user = getpwuid(geteuid());
  ASSERT_NE(user, nullptr);
  EXPECT_EQ(Store::default_path(), std::string(user->pw_dir) + "/.local/share/swage/attempts.db");
}

TEST(Store, SomewhereElseThanAFileOrAServerIsNoStore) {
  const Folder folder;
  std::filesystem::current_path(folder.path());
  std::string error;
  EXPECT_FALSE(Store::open("mysql://ada@host/swage", error));
  EXPECT_THAT(error, testing::StartsWith(say::kNoStoreKind("mysql")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  ASSERT_EQ(mkfifo((folder / "pipe.db").c_str(), 0600), 0);
  for (const std::string& what : {std::string("/dev/zero"), folder / "pipe.db", folder.path().string()}) {
    EXPECT_FALSE(Store::open(what, error));
    EXPECT_THAT(error, HasSubstr(say::kNotAFile(what)));
    EXPECT_FALSE(Store::open_to_read(what, error));
    EXPECT_THAT(error, HasSubstr(say::kNotAFile(what)));
  }
  std::filesystem::current_path("/");
}

TEST(Store, APasswordIsNeverShown) {
  for (const char* where : {"postgresql://ada:s3cret@host/db", "postgresql://ada:s3cret@x/db?host=/nowhere",
                            "postgresql://ada@/db?host=/nowhere&password=s3cret", "postgres://ada:s3/cr#e@host/db"}) {
    EXPECT_THAT(shown(where), testing::AllOf(HasSubstr("***"), testing::Not(HasSubstr("s3"))))
        << where;
  }
  EXPECT_EQ(shown("postgresql://ada@host:5432/db"), "postgresql://ada@host:5432/db");
  EXPECT_EQ(shown("/srv/swage/a:b@c.db"), "/srv/swage/a:b@c.db");
  std::string error;
  EXPECT_FALSE(Store::open("postgresql://ada:s3cret@/db?host=/nowhere", error));
  EXPECT_THAT(error, testing::Not(HasSubstr("s3cret")));
  EXPECT_FALSE(Store::open("postgresql://ada:s3cret@/db?host=/nowhere&encryption=off", error));
  EXPECT_THAT(error, testing::AllOf(HasSubstr("encryption" + say::kNoPartOfAddress.words(2)), testing::Not(HasSubstr("s3cret"))));
  base::Problems problems;
  setenv("XDG_DATA_HOME", "/proc/nowhere", 1);
  EXPECT_FALSE(Recorder::open("postgresql://ada:s3cret@/db?host=/nowhere", make_info(), problems));
  unsetenv("XDG_DATA_HOME");
  ASSERT_FALSE(problems.empty());
  for (const base::Problem& p : problems) EXPECT_THAT(p.where + p.message, testing::Not(HasSubstr("s3cret")));
}

}  // namespace
}  // namespace swage::record::test
