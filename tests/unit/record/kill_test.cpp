// SPDX-License-Identifier: Apache-2.0
//
// kill -9 at a random moment of a 1 kHz recording. SWAGE_KILL_TRIALS: how often (10).
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "base/rng.hpp"
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

// lets it record for `steps` steps and some microseconds more, kills it, and returns how many steps it had handed over
uint64_t kill_after(const Child& child, uint64_t steps, int64_t more_ns) {
  uint64_t step = 0, handed = 0;
  while (read(child.out, &step, sizeof step) == sizeof step) {
    handed = step + 1;
    if (handed != steps) continue;
    base::sleep_until_ns(base::wall_ns() + more_ns);
    kill(child.pid, SIGKILL);
  }
  close(child.out);
  waitpid(child.pid, nullptr, 0);
  return handed;
}

int trials() {
  const char* text = std::getenv("SWAGE_KILL_TRIALS");
  return text != nullptr ? std::atoi(text) : 10;
}

TEST(Kill, LosesAtMostOneSecondAndDamagesNothing) {
  const Folder folder;
  const std::string store = folder / "attempts.db";
  base::Xoshiro256 random(2024);
  uint64_t worst = 0;
  for (int trial = 0; trial < trials(); ++trial) {
    const uint64_t seed = 100 + static_cast<uint64_t>(trial);
    const uint64_t handed =
        kill_after(start(store, seed), 100 + random() % 900, static_cast<int64_t>(random() % 1'000'000));
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
    ASSERT_LE(kept, handed);
    EXPECT_LE(handed - kept, 1000u);
    worst = std::max(worst, handed - kept);

    const auto db = open_for_reading(store, error);
    EXPECT_EQ(text(db->rows("PRAGMA integrity_check")[0][0]), "ok");
  }
  RecordProperty("worst_loss_ms", static_cast<int>(worst));
  std::printf("worst loss in %d trials: %llu ms\n", trials(), static_cast<unsigned long long>(worst));
}

}  // namespace
}  // namespace swage::record::test
