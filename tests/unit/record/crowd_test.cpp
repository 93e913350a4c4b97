// SPDX-License-Identifier: Apache-2.0
//
// Many programs on one store, and a program that touches its store in every way. SQLite's locks on a file belong to the process
// and are lost when any descriptor of that file is closed: another program then takes the log away under an open store.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "base/rng.hpp"
#include "postgres_server.hpp"
#include "record/schema.hpp"

namespace swage::record::test {
namespace {

using testing::HasSubstr;

// Whether this process holds a lock on the file, as another process sees it.
bool is_locked(const std::string& path) {
  const pid_t child = fork();
  if (child == 0) {
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    const bool asked = file >= 0 && fcntl(file, F_GETLK, &lock) == 0;
    _exit(!asked ? 2 : lock.l_type == F_UNLCK ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) < 2);
  return WEXITSTATUS(status) == 0;
}

TEST(Crowd, NothingThatAProgramDoesDropsItsLocks) {
  const Folder folder;
  const std::string path = folder / "a.db";
  const std::string id = record_attempt(path, 300);
  std::string error;
  const auto store = Store::open(path, error);
  ASSERT_EQ(store->attempts("").size(), 1u);
  ASSERT_TRUE(is_locked(path));
  Recording recording;
  AttemptRow row;
  std::string found;
  const std::pair<const char*, std::function<void()>> touches[] = {
      {"reading a recording", [&] { read_recording(path, id, recording, error); }},
      {"opening the store again", [&] { Store::open(path, error)->attempts(""); }},
      {"opening it to be read", [&] { Store::open_to_read(path, error)->attempts(""); }},
      {"recording", [&] { record_attempt(path, 300); }},
      {"recovering", [&] { store->recover(); }},
      {"exporting", [&] { store->export_attempt(id, folder / "one.swage", error); }},
      {"importing", [&] { store->import_attempt(folder / "one.swage", found, error); }},
      {"importing itself", [&] { store->import_attempt(path, found, error); }},
      {"looking at one attempt", [&] { store->attempt(id, row); }},
  };
  for (const auto& [what, touch] : touches) {
    touch();
    EXPECT_TRUE(is_locked(path)) << what;
  }
}

struct Member {
  pid_t pid = -1;
  std::string out;  // file with what it printed
  bool killed = false;
};

Member join(const Folder& folder, const std::string& store, int number) {
  Member m;
  m.out = folder / ("said" + std::to_string(number));
  m.pid = fork();
  if (m.pid == 0) {
    const int file = ::open(m.out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    const std::string seed = std::to_string(number + 1);
    execl(SWAGE_RECORD_CHILD, SWAGE_RECORD_CHILD, "crowd", store.c_str(), seed.c_str(), nullptr);
    _exit(127);
  }
  return m;
}

// `members` programs record into one store and read it; every fifth is killed at a random moment. Whoever ended in peace must find
// its attempt whole; a lock may have been waited for in vain, but nobody may have met with damage.
void crowd(const Folder& folder, const std::string& store, int members) {
  base::Xoshiro256 random(static_cast<uint64_t>(members));
  std::vector<Member> crowd;
  for (int i = 0; i < members; ++i) crowd.push_back(join(folder, store, i));
  for (int i = 4; i < members; i += 5) {
    base::sleep_until_ns(base::wall_ns() + static_cast<int64_t>(random() % 400'000'000));
    kill(crowd[static_cast<std::size_t>(i)].pid, SIGKILL);
    crowd[static_cast<std::size_t>(i)].killed = true;
  }
  for (const Member& m : crowd) waitpid(m.pid, nullptr, 0);
  std::string error;
  // takes in what lies beside the store because it was locked for long
  const auto after = Store::open(store, error);
  ASSERT_TRUE(after) << error;
  after->recover();
  EXPECT_EQ(after->trouble(), "");
  for (const AttemptRow& a : after->attempts("")) EXPECT_NE(a.state, "running");
  EXPECT_EQ(after->damage(), "");
  int kept = 0;
  for (int i = 0; i < members; ++i) {
    const Member& m = crowd[static_cast<std::size_t>(i)];
    std::ifstream in(m.out);
    const std::string said{std::istreambuf_iterator<char>(in), {}};
    for (const char* word : {"malformed", "damaged", "not a database", "salvage", "cannot be read", "missing"})
      EXPECT_THAT(said, testing::Not(HasSubstr(word))) << "member " << i;
    if (m.killed && said.find("kept ") == std::string::npos) continue;
    ASSERT_THAT(said, HasSubstr("kept ")) << "member " << i;
    Recording recording;
    ASSERT_TRUE(read_recording(store, said.substr(said.rfind("kept ") + 5, 36), recording, error)) << error;
    expect_exact(recording, 1500, static_cast<uint64_t>(i + 1));
    ++kept;
  }
  EXPECT_GE(kept, members - members / 5);
  if (is_postgres(store)) return;
  EXPECT_EQ(text(open_for_reading(store, error)->rows("PRAGMA integrity_check")[0][0]), "ok");
}

TEST(Crowd, TwoFiveAndTwentyProgramsOnOneFile) {
  for (const int members : {2, 5, 20}) {
    const Folder folder;
    SCOPED_TRACE(members);
    crowd(folder, folder / "a.db", members);
  }
}

TEST(Crowd, TwoFiveAndTwentyProgramsOnOneServer) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  for (const int members : {2, 5, 20}) {
    const Folder folder;
    SCOPED_TRACE(members);
    setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
    crowd(folder, server.make_database("crowd" + std::to_string(members)), members);
  }
  unsetenv("XDG_DATA_HOME");
}

TEST(Crowd, WhatOthersWriteIsNoticed) {
  const Folder folder;
  const std::string path = folder / "a.db";
  std::string error;
  const auto store = Store::open(path, error);
  store->attempts("");
  store->changed();
  EXPECT_FALSE(store->changed());
  record_attempt(path, 300);
  EXPECT_TRUE(store->changed());
  EXPECT_FALSE(store->changed());
}

TEST(Crowd, WhatOthersWriteOnAServerIsNoticed) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  const Folder folder;
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  const std::string where = server.make_database("seen");
  std::string error;
  const auto store = Store::open(where, error);
  ASSERT_TRUE(store) << error;
  store->changed();
  EXPECT_FALSE(store->changed());
  record_attempt(where, 300);
  EXPECT_TRUE(store->changed());
  EXPECT_FALSE(store->changed());
  unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace swage::record::test
