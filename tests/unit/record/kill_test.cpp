// SPDX-License-Identifier: Apache-2.0
//
// kill -9 at a random moment of a 1 kHz recording. SWAGE_KILL_TRIALS: how often; then also how much is lost, which depends on how
// soon the machine lets the writer write.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "base/rng.hpp"
#include "postgres_server.hpp"
#include "record/schema.hpp"

namespace swage::record::test {
namespace {

struct Child {
  pid_t pid = -1;
  int out = -1;
};

Child start(const std::string& store, uint64_t seed) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const std::string seed_text = std::to_string(seed);
  const pid_t pid = fork();
  if (pid == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execl(SWAGE_RECORD_CHILD, SWAGE_RECORD_CHILD, "loop", store.c_str(), seed_text.c_str(), nullptr);
    _exit(127);
  }
  close(ends[1]);
  return {pid, ends[0]};
}

// Steps of the newest attempt that are in the store by now.
uint64_t kept_so_far(const std::string& store) {
  std::string error;
  const auto opened = open_for_reading(store, error);
  if (!opened) return 0;
  const auto rows =
      opened->rows("SELECT attempt_id FROM attempt WHERE state = 'running' ORDER BY attempt_id DESC");
  Recording recording;
  if (rows.empty() || !read_recording(store, text(rows[0][0]), recording, error)) return 0;
  return recording.step.size();
}

struct Killed {
  uint64_t handed = 0;  // steps that the child said it had given to the recorder; it may have died between the last one and saying so
  uint64_t seen = 0;    // of them in the store just before the end
};

// Lets it record until `steps` are handed over and some are in the store, and some microseconds more; then kills it.
Killed kill_after(const Child& child, const std::string& store, uint64_t steps, int64_t more_ns) {
  Killed out;
  uint64_t step = 0;
  bool killed = false;
  while (read(child.out, &step, sizeof step) == sizeof step) {
    out.handed = step + 1;
    // a look takes longer than a step: not at every one
    if (killed || out.handed < steps || out.handed % 50 != 0) continue;
    out.seen = kept_so_far(store);
    if (out.seen == 0) continue;
    base::sleep_until_ns(base::wall_ns() + more_ns);
    kill(child.pid, SIGKILL);
    killed = true;
  }
  close(child.out);
  waitpid(child.pid, nullptr, 0);
  return out;
}

int trials() {
  const char* text = std::getenv("SWAGE_KILL_TRIALS");
  return text != nullptr ? std::atoi(text) : 5;
}

bool is_soak() { return std::getenv("SWAGE_KILL_TRIALS") != nullptr; }

void kill_again_and_again(const std::string& store) {
  base::Xoshiro256 random(2024);
  uint64_t worst = 0;
  for (int trial = 0; trial < trials(); ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const uint64_t seed = 100 + static_cast<uint64_t>(trial);
    const auto [handed, seen] = kill_after(start(store, seed), store, 100 + random() % 900,
                                           static_cast<int64_t>(random() % 1'000'000));
    ASSERT_GE(handed, 100u);

    std::string error;
    const auto opened = Store::open(store, error);
    ASSERT_TRUE(opened) << error;
    EXPECT_EQ(opened->recover(), 1);
    const auto attempts = opened->attempts("");
    ASSERT_EQ(attempts.size(), static_cast<std::size_t>(trial + 1));
    EXPECT_EQ(attempts[0].state, "recovered");
    Recording recording;
    ASSERT_TRUE(read_recording(store, attempts[0].id, recording, error)) << error;
    const uint64_t kept = recording.step.size();
    expect_exact(recording, kept, seed);
    ASSERT_LE(kept, handed + 1);
    EXPECT_GE(kept, seen);
    if (is_soak()) {
      EXPECT_LE(handed, kept + 1000);
    }
    worst = std::max(worst, handed - std::min(handed, kept));

    if (is_postgres(store)) continue;
    const auto db = open_for_reading(store, error);
    EXPECT_EQ(text(db->rows("PRAGMA integrity_check")[0][0]), "ok");
  }
  testing::Test::RecordProperty("worst_loss_ms", static_cast<int>(worst));
  std::printf("worst loss in %d trials: %llu ms\n", trials(), static_cast<unsigned long long>(worst));
}

TEST(Kill, LosesNothingThatWasWrittenAndDamagesNothing) {
  const Folder folder;
  kill_again_and_again(folder / "attempts.db");
}

TEST(Kill, NeitherOnAServer) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  const Folder folder;
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  kill_again_and_again(server.make_database("killed"));
  unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace swage::record::test
